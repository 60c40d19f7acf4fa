//! What is asked for.
use super::rules::ACCURACY;
use serde::Serialize;

/// What is asked for.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Options {
    /// Largest error of restitution (absolute), contact time (relative) and spin (over the impact speed), of every
    /// important class; under a load, of overlap (square root over R*), of shear force and attraction (over the load) and of torque
    /// (over load times R*).
    pub accuracy: f64,
    /// The error of contact times may be this many times as large; 1 for the same accuracy.
    pub time: f64,
}

impl Default for Options {
    fn default() -> Options {
        Options { accuracy: ACCURACY, time: 1.0 }
    }
}
