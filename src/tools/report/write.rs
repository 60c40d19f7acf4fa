//! The report in all its formats.
use super::folder::{place, Kind, ReportError, Writer};
use super::{csv::Csv, html::Html, json, json::Json, junit::Junit, markdown::Markdown, Report};
use std::path::Path;

const WRITERS: [&dyn Writer; 5] = [&Html, &Markdown, &Json, &Junit, &Csv];

const REPORT: Kind = Kind {
    ours: &["index.html", "report.md", "report.json", "junit.xml", "csv"],
    format: json::FORMAT,
    what: "report",
};

/// Writes all formats into the folder `dir`, which appears only when everything in it is complete.
///
/// An earlier report of ours is replaced; any other folder that is not empty is refused and left as it is.
pub fn write_all(report: &Report, dir: &Path) -> Result<(), ReportError> {
    place(dir, &REPORT, |fresh| WRITERS.iter().try_for_each(|w| w.write(report, fresh)))
}

/// Says early, before hours of runs, whether [`write_all`] would refuse this folder.
pub fn check_target(dir: &Path) -> Result<(), ReportError> {
    REPORT.check(dir)
}
