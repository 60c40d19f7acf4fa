//! Speed against accuracy: every method on every case, its error against the truth and its cost.
mod bonds;
mod case;
mod cases;
mod claims;
mod costs;
mod curves;
mod found;
mod in_liggghts;
mod methods;
mod page;
mod truth;

pub use case::{Case, Measure};
pub use cases::cases;
pub use claims::{claims, Claim};
pub use costs::{time, Cost};
pub use curves::{ours as curve, Curve, Point, Reach};
pub use found::{Found, PerStep, Study};
pub use methods::Method;
pub use truth::Truth;

use super::Options;
use crate::report::page::Page;

/// Runs the study; `done` is called with each part that is finished.
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
        in_liggghts::add(bench, &mut study, phases, options.full, done);
    }
    study
}

/// The study as a document.
pub fn page(study: &Study, options: &Options) -> Page {
    page::page(study, options)
}
