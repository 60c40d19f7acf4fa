//! The outcome at one step and one parameter, over many phases of first touch and a few speeds.
use crate::study::collision::Outcome;

/// The class of a cell, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// The error of the measured quantity is below 1 %; of a speed that should become zero, less than 1e-4 is left.
    Fine,
    /// The error is below 10 %, or less than 1 % is left.
    Rough,
    /// The error is larger.
    Wrong,
    /// Energy comes from nothing, and LIGGGHTS's own check would have warned.
    Creates,
    /// Energy comes from nothing and LIGGGHTS's own check is silent.
    CreatesSilently,
    /// The energy grows more than a hundredfold, or is not finite.
    BlowsUp,
}

impl Class {
    /// All of them, from good to bad.
    pub const ALL: [Class; 6] =
        [Class::Fine, Class::Rough, Class::Wrong, Class::Creates, Class::CreatesSilently, Class::BlowsUp];

    /// Whether energy comes from nothing.
    pub fn creates(self) -> bool {
        self >= Class::Creates
    }
}

/// The outcome of a cell in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Mean error of the measured quantity.
    pub error: f64,
    /// Largest energy afterwards over that before.
    pub energy: f64,
    /// Fraction of the contacts that parted although they should stick, or the other way round.
    pub astray: f64,
    /// Fraction of the contacts without any evaluation on the way out; NaN where this was not observed.
    pub missed: f64,
    /// Whether all numbers stayed finite.
    pub finite: bool,
}

/// From this ratio of the energy to that before, energy counts as created; it is far above round-off.
pub const CREATED: f64 = 1.01;

impl Found {
    /// The result from the outcomes of all phases, with the error of each and whether it stuck or parted wrongly.
    pub fn of(outcomes: &[Outcome], judge: impl Fn(usize, &Outcome) -> (f64, bool)) -> Found {
        let n = outcomes.len() as f64;
        let judged: Vec<(f64, bool)> = outcomes.iter().enumerate().map(|(k, o)| judge(k, o)).collect();
        Found {
            error: judged.iter().map(|(e, _)| e).sum::<f64>() / n,
            energy: outcomes.iter().map(|o| o.energy).fold(0.0, f64::max),
            astray: judged.iter().filter(|(_, astray)| *astray).count() as f64 / n,
            missed: f64::NAN,
            finite: outcomes.iter().all(|o| o.finite),
        }
    }

    /// The class, by two limits of the error and one of the energy; `warned` says whether LIGGGHTS's own check would have
    /// warned.
    pub fn class(&self, (fine, rough): (f64, f64), created: f64, warned: bool) -> Class {
        match () {
            _ if !self.finite || self.energy > 100.0 || !self.error.is_finite() => Class::BlowsUp,
            _ if self.energy > created && warned => Class::Creates,
            _ if self.energy > created => Class::CreatesSilently,
            _ if self.error < fine => Class::Fine,
            _ if self.error < rough => Class::Rough,
            _ => Class::Wrong,
        }
    }
}
