//! What is found at one step and one parameter, over many phases of first touch and a few speeds.
use crate::study::shot::Outcome;

/// The outcome of a cell, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// The measured quantity is off by less than 1 %; of a speed that should be zero, 1e-4 is left.
    Fine,
    /// By less than 10 %; 1 % is left.
    Rough,
    /// By more.
    Wrong,
    /// Energy comes from nothing where LIGGGHTS's own check would have warned.
    Creates,
    /// Energy comes from nothing and LIGGGHTS's own check is silent.
    CreatesSilently,
    /// More than a hundred times the energy, or no number at all.
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

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Mean error of the measured quantity.
    pub error: f64,
    /// Largest energy afterwards over that before.
    pub energy: f64,
    /// Share of the contacts that parted where they should stick, or stick where they should part.
    pub astray: f64,
    /// Share of the contacts without any evaluation on the way out; NaN where nobody looked.
    pub missed: f64,
    /// Whether all numbers stayed finite.
    pub finite: bool,
}

/// Energy over that before from which on it counts as created: far more than round-off.
pub const CREATED: f64 = 1.01;

impl Found {
    /// From the outcomes of all phases, with the error of each and whether it went astray.
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

    /// The outcome by two limits of the error and one of the energy; `warned`: LIGGGHTS's own check would have said
    /// something.
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
