//! Stability: fields of outcomes over the step and one parameter of a law, the borders that theory draws, and LIGGGHTS
//! itself asked on both sides of the borders that we find.
mod cell;
mod fields;
mod live;
mod page;
mod row;

pub use cell::{Class, Found};
pub use fields::{field, fields, names, Field};
pub use live::{agreement, ask, choose, onset, Agreement, Asked, Place};
pub use row::{Row, Scene};

use super::live::Bench;
use crate::liggghts::RunError;
use crate::report::page::Page;
use rayon::prelude::*;

/// What to study.
#[derive(Debug)]
pub struct Options {
    /// Names of the maps; all of them if there are none.
    pub only: Vec<String>,
    /// Finer maps, more phases, more points in LIGGGHTS.
    pub full: bool,
    /// LIGGGHTS and plugin, or why there is none.
    pub bench: Result<Bench, RunError>,
    /// The command line, for the page.
    pub command: String,
}

/// A field with what was found in it.
#[derive(Debug)]
pub struct Mapped {
    /// The field.
    pub field: Field,
    /// Steps over the unit of the row.
    pub steps: Vec<f64>,
    /// What was found, row by row.
    pub cells: Vec<Found>,
    /// The first step of each row, over its unit, at which energy is created; `None` where it never is.
    pub onset: Vec<Option<f64>>,
    /// What LIGGGHTS was asked.
    pub asked: Vec<Asked>,
}

/// The whole study.
#[derive(Debug)]
pub struct Study {
    /// Field by field.
    pub mapped: Vec<Mapped>,
    /// What LIGGGHTS could not do.
    pub trouble: Vec<String>,
}

/// Do it; `done` hears of every field.
pub fn run(options: &Options, done: &(dyn Fn(&str) + Sync)) -> Study {
    let (columns, phases) = if options.full { (96, 64) } else { (60, 24) };
    let mut study = Study { mapped: Vec::new(), trouble: Vec::new() };
    for field in fields(options.full, &options.only) {
        let (low, high) = field.range;
        let steps: Vec<f64> =
            (0..columns).map(|k| low * (high / low).powf(f64::from(k) / f64::from(columns - 1))).collect();
        let places: Vec<(&Row, f64)> =
            field.rows.iter().flat_map(|r| steps.iter().map(move |s| (r, *s))).collect();
        let cells = places.par_iter().map(|(row, step)| row.at(*step, phases)).collect();
        let onset = field.rows.par_iter().map(|row| live::onset(&field, row, phases)).collect();
        done(field.name);
        study.mapped.push(Mapped { field, steps, cells, onset, asked: Vec::new() });
    }
    if let Ok(bench) = &options.bench {
        let rows = if options.full { 8 } else { 3 };
        for mapped in &mut study.mapped {
            let points = choose(&mapped.field, &mapped.onset, rows, phases);
            let answers: Vec<_> =
                points.into_par_iter().map(|p| ask(bench, &mapped.field, p, phases)).collect();
            let mut failed = Vec::new();
            for answer in answers {
                match answer {
                    Ok(asked) => mapped.asked.push(asked),
                    Err(e) => failed.push(e),
                }
            }
            if let Some(e) = failed.first() {
                study.trouble.push(format!(
                    "{}: {} runs of LIGGGHTS failed: {e}",
                    mapped.field.name,
                    failed.len()
                ));
            }
            done(&format!("{} in LIGGGHTS", mapped.field.name));
        }
    }
    study
}

/// The study as a document.
pub fn page(study: &Study, options: &Options) -> Page {
    page::page(study, options)
}
