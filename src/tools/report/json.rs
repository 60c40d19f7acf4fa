//! `report.json`: the typed report with its verdicts, for programs. The types say what each field means.
use super::{folder, summary, About, Case, Counts, Outcome, Report, ReportError, Writer};
use serde::Serialize;
use std::path::Path;

/// The first field of the file; it also tells our report folders from others.
pub(super) const FORMAT: &str = "granlaw-report/1";

pub(super) struct Json;

#[derive(Serialize)]
struct Document<'a> {
    format: &'static str,
    exit_code: u8,
    headline: String,
    counts: Counts,
    about: &'a About,
    cases: Vec<Judged<'a>>,
}

#[derive(Serialize)]
struct Judged<'a> {
    /// Unique in the report; names the CSV file and the anchor in the page.
    id: String,
    verdict: Outcome,
    #[serde(flatten)]
    case: &'a Case,
}

impl Writer for Json {
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError> {
        let judged = |(case, id)| Judged { id, verdict: Case::verdict(case), case };
        let document = Document {
            format: FORMAT,
            exit_code: report.exit_code(),
            headline: summary::headline(report),
            counts: report.counts(),
            about: &report.about,
            cases: report.cases.iter().zip(summary::ids(report)).map(judged).collect(),
        };
        let mut json = serde_json::to_string_pretty(&document).map_err(|e| ReportError::Format(e.into()))?;
        json.push('\n');
        folder::save(&dir.join("report.json"), &json)
    }
}
