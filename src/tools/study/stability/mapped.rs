//! What was found.
use super::cell::Found;
use super::live::Asked;
use super::plan::Field;

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
