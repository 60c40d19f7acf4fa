//! Stability: fields of outcomes over the step and one parameter of a law, with the borders of theory, and runs of LIGGGHTS
//! itself on both sides of the borders that we find.
mod bonds;
mod cell;
mod fields;
mod in_liggghts;
mod mapped;
mod page;
mod plan;
mod row;

pub use cell::{Class, Found};
pub use fields::{field, fields, names};
pub use in_liggghts::{agreement, ask, choose, onset, Agreement, Asked, Place};
pub use mapped::{Mapped, Study};
pub use plan::Field;
pub use row::{Row, Scene};

use super::in_liggghts::Bench;
use super::Options;
use crate::report::page::Page;
use rayon::iter::Either;
use rayon::prelude::*;

/// Runs the study; `done` is called with each part that is finished.
pub fn run(options: &Options, done: &(dyn Fn(&str) + Sync)) -> Study {
    let (columns, phases) = if options.full { (96, 64) } else { (60, 24) };
    let mut study = Study { mapped: Vec::new(), trouble: Vec::new() };
    for field in fields(options) {
        let (low, high) = field.range;
        let steps: Vec<f64> =
            (0..columns).map(|k| low * (high / low).powf(f64::from(k) / f64::from(columns - 1))).collect();
        let places: Vec<(&Row, f64)> =
            field.rows.iter().flat_map(|r| steps.iter().map(move |s| (r, *s))).collect();
        let cells = places.par_iter().map(|(row, step)| row.at(*step, phases)).collect();
        let onset = field.rows.par_iter().map(|row| in_liggghts::onset(&field, row, phases)).collect();
        done(field.name);
        study.mapped.push(Mapped { field, steps, cells, onset, asked: Vec::new() });
    }
    if let Ok(bench) = &options.bench {
        let rows = if options.full { 8 } else { 3 };
        for mapped in &mut study.mapped {
            let points = choose(&mapped.field, &mapped.onset, rows, phases);
            study.trouble.extend(mapped.ask(bench, points, phases));
            done(&format!("{} in LIGGGHTS", mapped.field.name));
        }
    }
    study
}

impl Mapped {
    /// Runs LIGGGHTS at some places. Returns a sentence if some of these runs failed.
    fn ask(&mut self, bench: &Bench, places: Vec<Place>, phases: usize) -> Option<String> {
        let answer = |place| match ask(bench, &self.field, place, phases) {
            Ok(asked) => Either::Left(asked),
            Err(e) => Either::Right(e),
        };
        let (asked, failed): (Vec<_>, Vec<_>) = places.into_par_iter().partition_map(answer);
        self.asked = asked;
        let first = failed.first()?;
        Some(format!("{}: {} runs of LIGGGHTS failed: {first}", self.field.name, failed.len()))
    }
}

/// The study as a document.
pub fn page(study: &Study, options: &Options) -> Page {
    page::page(study, options)
}
