//! What was found.
use super::case::Case;
use super::costs::Cost;
use super::curves::Curve;
use super::methods::Method;
use super::truth::Truth;

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
    pub per_step: Vec<PerStep>,
    /// The largest difference between LIGGGHTS and our own integration of the same shots, relative to what was measured;
    /// `None` without LIGGGHTS.
    pub apart: Option<f64>,
    /// What LIGGGHTS could not do.
    pub trouble: Vec<String>,
}

/// What one evaluation of a contact costs in LIGGGHTS.
#[derive(Clone, Debug)]
pub struct PerStep {
    /// The normal law.
    pub law: &'static str,
    /// Who computes it.
    pub method: Method,
    /// LIGGGHTS's Pair time per contact and step \[s\].
    pub cost: Cost,
}
