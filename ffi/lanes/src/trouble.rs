//! What keeps a pass from being carried out.
use thiserror::Error;

/// Why a pass was not carried out.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Trouble {
    /// An array is missing, or an index leads out of its array.
    #[error("{0}")]
    Arrays(&'static str),
    /// A contact with NaN or infinite kinematics; its forces were not added.
    #[error("a contact is not finite")]
    NonFinite(NonFinite),
}

/// A contact that is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NonFinite {
    /// The particles, as indices into the arrays.
    pub i: usize,
    pub j: usize,
    /// Overlap \[m\] and normal velocity \[m/s\].
    pub deltan: f64,
    pub vn: f64,
}
