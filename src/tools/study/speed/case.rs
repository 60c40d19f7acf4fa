//! A case: how two bodies meet, and what is measured of them.
use crate::study::collision::{Collision, Outcome};
use crate::study::matter::Matter;

/// What is measured of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Normal velocity after over before.
    Restitution,
    /// Spin of i afterwards.
    Spin,
    /// How far it rolls until it rests.
    Distance,
}

impl Measure {
    /// Its value in an outcome.
    pub fn of(self, o: &Outcome) -> f64 {
        match self {
            Measure::Restitution => o.restitution,
            Measure::Spin => o.spin,
            Measure::Distance => o.distance,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Measure::Restitution => "restitution",
            Measure::Spin => "final spin",
            Measure::Distance => "distance rolled",
        }
    }
}

/// One kind of impact.
#[derive(Clone, Debug)]
pub struct Case {
    /// Short name, unique.
    pub name: &'static str,
    /// One line for people.
    pub title: &'static str,
    /// Laws and numbers.
    pub matter: Matter,
    /// How the bodies meet.
    pub collision: Collision,
    /// What is measured.
    pub measure: Measure,
}
