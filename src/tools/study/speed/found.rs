//! The results of the study.
use super::case::Case;
use super::costs::Cost;
use super::curves::Curve;
use super::methods::Method;
use super::truth::Truth;

/// The results for one case.
#[derive(Debug)]
pub struct Found {
    /// The case.
    pub case: Case,
    /// The reference.
    pub truth: Truth,
    /// One curve per method.
    pub curves: Vec<Curve>,
}

/// The whole study.
#[derive(Debug)]
pub struct Study {
    /// Case by case.
    pub found: Vec<Found>,
    /// Cost of a contact in one step inside LIGGGHTS \[s\], by law and method.
    pub per_step: Vec<PerStep>,
    /// The largest difference between LIGGGHTS and our own integration of the same collisions, relative to what was measured;
    /// `None` without LIGGGHTS.
    pub apart: Option<f64>,
    /// What LIGGGHTS could not do.
    pub trouble: Vec<String>,
}

/// The cost of one evaluation of a contact in LIGGGHTS.
#[derive(Clone, Debug)]
pub struct PerStep {
    /// The normal law.
    pub law: &'static str,
    /// The method.
    pub method: Method,
    /// LIGGGHTS's Pair time per contact and step \[s\].
    pub cost: Cost,
}
