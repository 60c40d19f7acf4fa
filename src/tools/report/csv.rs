//! `csv/<case>.csv`: all numbers behind the plots, each in the shortest digits that read back as the same number.
use super::{summary, Curve, Report, ReportError, Writer};
use std::path::Path;

pub(super) struct Csv;

const HEAD: [&str; 5] = ["answer", "time_s", "overlap_m", "force_N", "error"];

impl Writer for Csv {
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError> {
        let folder = dir.join("csv");
        std::fs::create_dir(&folder).map_err(|e| ReportError::io(&folder, e))?;
        for (case, id) in report.cases.iter().zip(summary::ids(report)) {
            if case.curves.is_empty() {
                continue;
            }
            let path = folder.join(format!("{id}.csv"));
            table(&path, &case.curves).map_err(|e| ReportError::io(&path, e.into()))?;
        }
        Ok(())
    }
}

fn table(path: &Path, curves: &[Curve]) -> Result<(), csv::Error> {
    let mut out = csv::Writer::from_path(path)?;
    out.write_record(HEAD)?;
    for curve in curves {
        let columns = [&curve.time, &curve.overlap, &curve.force, &curve.error];
        for row in 0..columns.map(Vec::len).into_iter().max().unwrap_or(0) {
            let [time, overlap, force, error] = columns.map(|c| c.get(row));
            out.serialize((&curve.answer, time, overlap, force, error))?;
        }
    }
    out.flush()?;
    Ok(())
}
