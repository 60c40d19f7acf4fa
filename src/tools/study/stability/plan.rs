//! A field of outcomes, and how it is planned.
use super::row::Row;
use rayon::prelude::*;

/// A field of outcomes: steps across, a parameter up.
#[derive(Clone, Debug)]
pub struct Field {
    /// Short name, unique.
    pub name: &'static str,
    /// Its title, one line.
    pub title: &'static str,
    /// The law that it is about.
    pub law: &'static str,
    /// The parameter, with its unit.
    pub label: &'static str,
    /// Whether its values are spaced evenly in their logarithm.
    pub log: bool,
    /// The range of steps, in units of the row.
    pub range: (f64, f64),
    /// The rows, beginning with the smallest parameter.
    pub rows: Vec<Row>,
}

pub(super) type Build = Box<dyn Fn(f64) -> Row + Sync>;

/// A field before it is built.
pub(super) struct Plan {
    pub name: &'static str,
    pub title: &'static str,
    pub law: &'static str,
    pub label: &'static str,
    pub log: bool,
    pub range: (f64, f64),
    pub values: Vec<f64>,
    pub build: Build,
}

impl Plan {
    pub fn build(self) -> Field {
        let Plan { name, title, law, label, log, range, .. } = self;
        let rows = self.values.par_iter().map(|v| (self.build)(*v)).collect();
        Field { name, title, law, label, log, range, rows }
    }
}

/// Values from `low` to `high`, evenly spaced or in their logarithm.
pub(super) fn values(low: f64, high: f64, n: usize, log: bool) -> Vec<f64> {
    let at = |t: f64| if log { low * (high / low).powf(t) } else { low + (high - low) * t };
    (0..n).map(|k| at(k as f64 / (n - 1) as f64)).collect()
}
