//! The results of the study.
use super::cell::Found;
use super::in_liggghts::Asked;
use super::plan::Field;

/// A field with its results.
#[derive(Debug)]
pub struct Mapped {
    /// The field.
    pub field: Field,
    /// The steps, in units of the row.
    pub steps: Vec<f64>,
    /// The results, row by row.
    pub cells: Vec<Found>,
    /// The first step of each row, in its units, at which energy is created; `None` where it never is.
    pub onset: Vec<Option<f64>>,
    /// The places at which LIGGGHTS was run.
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
