//! Speed against accuracy: every method on every case, its error against the truth and its cost.
mod bonds;
mod cases;
mod claims;
mod costs;
mod curves;
mod live;
mod methods;
mod page;
mod truth;

pub use cases::{cases, Case, Measure};
pub use claims::{claims, Claim};
pub use costs::{time, Cost};
pub use curves::{ours as curve, Curve, Point, Reach};
pub use methods::Method;
pub use truth::{stiffness, Truth};

use super::Options;
use crate::report::page::Page;

/// What was found for one case.
#[derive(Debug)]
pub struct Found {
    /// The case.
    pub case: Case,
    /// What it is held against.
    pub truth: Truth,
    /// One curve per method.
    pub curves: Vec<Curve>,
}

/// The whole study.
#[derive(Debug)]
pub struct Study {
    /// Case by case.
    pub found: Vec<Found>,
    /// Cost of a contact in one step inside LIGGGHTS \[s\], by case and who computes it.
    pub per_step: Vec<live::PerStep>,
    /// The largest difference between LIGGGHTS and our own integration of the same shots, relative to what was measured;
    /// `None` without LIGGGHTS.
    pub apart: Option<f64>,
    /// What LIGGGHTS could not do.
    pub trouble: Vec<String>,
}

/// Do it; `done` hears of every case.
pub fn run(options: &Options, done: &(dyn Fn(&str) + Sync)) -> Study {
    let (phases, rounds) = if options.full { (128, 9) } else { (48, 5) };
    let mut found = Vec::new();
    for case in cases().into_iter().filter(|c| options.wants(c.name)) {
        let truth = Truth::of(&case);
        let curves =
            methods::OURS.iter().filter_map(|m| curves::ours(*m, &case, &truth, phases, rounds)).collect();
        done(case.name);
        found.push(Found { case, truth, curves });
    }
    let mut study = Study { found, per_step: Vec::new(), apart: None, trouble: Vec::new() };
    if let Ok(bench) = &options.bench {
        live::add(bench, &mut study, phases, options.full, done);
    }
    study
}

/// The study as a document.
pub fn page(study: &Study, options: &Options) -> Page {
    page::page(study, options)
}
