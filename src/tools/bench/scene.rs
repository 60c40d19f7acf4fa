//! What is measured: decks, the sides that run them, and the times of their runs.
use super::account::Account;
use crate::codes::lammps::Lammps;
use crate::codes::Times;
use crate::report::page::Spread;
use crate::report::Outcome;
use std::fmt;
use std::path::PathBuf;
use std::time::Duration;

/// What is to be measured.
#[derive(Clone, Debug)]
pub struct Options {
    /// Decks and folders of decks.
    pub decks: Vec<PathBuf>,
    /// Number of rounds; in each, every side runs every deck once.
    pub pairs: usize,
    /// The numbers of MPI ranks to run on.
    pub ranks: Vec<usize>,
    /// Widths of the batched path that are measured as sides of their own.
    pub lanes: Vec<u32>,
    /// LAMMPS, for decks that have a `.lammps` file beside them.
    pub lammps: Option<Lammps>,
    /// How long a run may take.
    pub limit: Duration,
    /// The command line.
    pub command: String,
}

/// Who runs a deck.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// LIGGGHTS alone.
    Stock,
    /// The Rust laws, one call per contact.
    Contact,
    /// The Rust laws, all contacts of a step in one call, as wide as the processor allows.
    Batched,
    /// The same with a certain width.
    Lanes(u32),
    /// LAMMPS with a law of its own on the same scene.
    Lammps,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Side::Stock => f.write_str("stock"),
            Side::Contact => f.write_str("contact"),
            Side::Batched => f.write_str("batched"),
            Side::Lanes(n) => write!(f, "batched, {n} wide"),
            Side::Lammps => f.write_str("LAMMPS"),
        }
    }
}

/// A deck on some number of ranks, and the times of its runs.
#[derive(Clone, Debug)]
pub struct Scene {
    /// File name of the deck without its extension.
    pub name: String,
    /// Its title.
    pub title: String,
    /// MPI ranks.
    pub ranks: usize,
    /// One entry per side, stock first.
    pub sides: Vec<Timed>,
    /// Steps, spheres and rebuilds of the measured run; nothing before the first run.
    pub(super) clock: Option<Times>,
    /// The counts that the batched path prints at its end.
    pub(super) account: Option<Account>,
    /// The name that the batched path gives its width.
    pub(super) lanes: Option<String>,
}

/// The runs of a side.
#[derive(Clone, Debug)]
pub struct Timed {
    /// Which side.
    pub side: Side,
    /// LIGGGHTS's Pair time of each round \[s\], an average over the ranks.
    pub pair: Vec<f64>,
    /// Its Loop time \[s\].
    pub whole: Vec<f64>,
    /// Whether it ran and wrote the same dumps as stock.
    pub outcome: Outcome,
}

impl Scene {
    /// The name, with the number of ranks if there are several.
    pub fn label(&self) -> String {
        match self.ranks {
            1 => self.name.clone(),
            n => format!("{}, {n} ranks", self.name),
        }
    }

    /// The runs of a side, if it has any.
    pub fn side(&self, side: Side) -> Option<&Timed> {
        self.sides.iter().find(|t| t.side == side && !t.pair.is_empty())
    }

    /// Contacts that are evaluated in a step, all ranks together; a contact across ranks counts for both.
    pub fn contacts(&self) -> Option<f64> {
        self.account.map(|a| a.contacts as f64 / a.passes as f64)
    }

    /// Memory that the batched path needs beside LIGGGHTS's own arrays \[B per neighbour\].
    pub fn memory(&self) -> Option<f64> {
        self.account.filter(|a| a.neighbours > 0).map(|a| a.bytes as f64 / a.neighbours as f64)
    }

    /// Processor time per contact \[ns\].
    pub fn per_contact(&self, timed: &Timed) -> Option<Spread> {
        let clock = self.clock?;
        let contacts = self.contacts().filter(|n| *n > 0.0)? * clock.steps as f64;
        quartiles(timed.pair.iter().map(|t| t * 1e9 * self.ranks as f64 / contacts))
    }

    /// Pair and Loop time of a side over those of another, round by round.
    pub fn ratios(&self, timed: &Timed, of: Side) -> Option<(Spread, Spread)> {
        let of = self.side(of)?;
        let by_round = |a: &[f64], b: &[f64]| quartiles(a.iter().zip(b).map(|(a, b)| a / b));
        Some((by_round(&timed.pair, &of.pair)?, by_round(&timed.whole, &of.whole)?))
    }
}

/// The median, and the quartiles as its range.
pub(super) fn quartiles(values: impl Iterator<Item = f64>) -> Option<Spread> {
    let mut sorted: Vec<_> = values.collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let at = |share: f64| {
        let x = share * last as f64;
        let (low, high) = (sorted[x.floor() as usize], sorted[x.ceil() as usize]);
        low + x.fract() * (high - low)
    };
    Some(Spread { at: at(0.5), low: at(0.25), high: at(0.75) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_and_quartiles() {
        let q = |v: &[f64]| quartiles(v.iter().copied());
        assert_eq!(q(&[]), None);
        assert_eq!(q(&[3.0]), Some(Spread { at: 3.0, low: 3.0, high: 3.0 }));
        assert_eq!(q(&[4.0, 1.0, 2.0, 3.0, 5.0]), Some(Spread { at: 3.0, low: 2.0, high: 4.0 }));
        assert_eq!(q(&[1.0, 2.0]), Some(Spread { at: 1.5, low: 1.25, high: 1.75 }));
    }

    #[test]
    fn ratios_are_those_of_the_same_round() {
        let timed = |side, pair: &[f64]| Timed {
            side,
            pair: pair.to_vec(),
            whole: pair.iter().map(|t| 2.0 * t).collect(),
            outcome: Outcome::Agreed,
        };
        // A machine that gets slower: a ratio of times from different rounds would be wrong.
        let scene = Scene {
            name: "x".into(),
            title: String::new(),
            ranks: 2,
            sides: vec![timed(Side::Stock, &[1.0, 2.0, 8.0]), timed(Side::Batched, &[0.25, 0.5, 2.0])],
            clock: Some(Times { pair: 1.0, whole: 2.0, steps: 10, particles: 5, builds: 0 }),
            account: Some(Account { passes: 11, contacts: 1100, neighbours: 0, bytes: 0 }),
            lanes: None,
        };
        let (pair, whole) = scene.ratios(&scene.sides[1], Side::Stock).unwrap();
        assert_eq!((pair, whole), (Spread::exact(0.25), Spread::exact(0.25)));
        // 1 s on each of two ranks for 100 contacts in each of 10 steps.
        assert_eq!(scene.per_contact(&scene.sides[0]).unwrap().low, 3e6);
        assert!(scene.ratios(&scene.sides[1], Side::Lammps).is_none());
    }
}
