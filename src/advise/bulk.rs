//! Bulk observables of two runs of a scene, and how far they are apart.
use super::rules::BULK;
use crate::probe::{Bulk, Sample};
use serde::Serialize;

/// Into so many parts of equal time a run is cut for means over time.
const PARTS: usize = 4;
/// Moments at which histories are compared.
const MOMENTS: usize = 200;
/// A scene whose mass changes by less than this part of it does not flow.
const FLOWS: f64 = 0.05;

/// A bulk observable of two runs.
#[derive(Clone, Debug, Serialize)]
pub struct Observable {
    /// What.
    pub name: &'static str,
    /// How its difference is meant.
    pub meaning: &'static str,
    /// The difference.
    pub difference: f64,
    /// The difference between two runs of the deck with other seeds; `None` where there was no second.
    pub scatter: Option<f64>,
}

impl Observable {
    /// Whether it is within a bound; NaN is not.
    pub fn within(&self, bound: f64) -> bool {
        self.difference <= bound
    }
}

/// The bound unless asked otherwise.
pub fn bound() -> f64 {
    BULK
}

/// Everything that can be compared of two runs; `other` is a run of the first with another seed.
pub fn compare(deck: &Bulk, advised: &Bulk, other: Option<&Bulk>) -> Vec<Observable> {
    let scatter: Vec<_> = other.map(|o| differences(deck, o)).unwrap_or_default();
    let found = differences(deck, advised).into_iter().map(|(name, meaning, difference)| Observable {
        name,
        meaning,
        difference,
        scatter: scatter.iter().find(|s| s.0 == name).map(|s| s.2),
    });
    found.collect()
}

fn differences(a: &Bulk, b: &Bulk) -> Vec<(&'static str, &'static str, f64)> {
    let end = |r: &Bulk| r.samples.last().map_or(0.0, |s| s.time);
    let (a, b) = (Run { of: a, end: end(a) }, Run { of: b, end: end(b) });
    let mut all = vec![
        (
            "kinetic energy",
            "mean of |difference| over time, over the mean",
            history(&a, &b, |s| s.kinetic + s.rotational),
        ),
        (
            "centre of mass",
            "mean of |difference| over time, over the largest extent of the scene along that axis",
            centre(&a, &b),
        ),
        (
            "coordination number",
            "of four parts of the run: sum of |difference| over the sum",
            coordination(&a, &b),
        ),
    ];
    let mass = |s: &Sample| s.mass;
    let first = a.at(0.0, mass);
    if (a.at(a.end, mass) - first).abs() > FLOWS * first {
        let gone = |run: &Run<'_>, t: f64| (run.at(0.0, mass) - run.at(t, mass)).abs();
        all.push((
            "mass discharged",
            "mean of |difference| over time, over the mean",
            apart(&a, &b, |run, t| gone(run, t)),
        ));
    }
    if !a.of.walls.is_empty() {
        all.push((
            "force on walls",
            "of four parts of the run and all walls: sum of |difference| over the sum",
            walls(&a, &b),
        ));
    }
    all
}

/// A run with its length \[s\].
struct Run<'a> {
    of: &'a Bulk,
    end: f64,
}

impl Run<'_> {
    /// A quantity at a time \[s\], linear between samples.
    fn at(&self, t: f64, of: impl Fn(&Sample) -> f64) -> f64 {
        let all = &self.of.samples;
        let k = all.partition_point(|s| s.time <= t);
        match (k.checked_sub(1).map(|k| &all[k]), all.get(k)) {
            (Some(a), Some(b)) => of(a) + (of(b) - of(a)) * (t - a.time) / (b.time - a.time),
            (Some(s), None) | (None, Some(s)) => of(s),
            (None, None) => f64::NAN,
        }
    }
}

/// Mean of |difference| over time, over the mean of the first.
fn apart(a: &Run<'_>, b: &Run<'_>, of: impl Fn(&Run<'_>, f64) -> f64) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    for k in 0..=MOMENTS {
        let part = k as f64 / MOMENTS as f64;
        let (x, y) = (of(a, part * a.end), of(b, part * b.end));
        sum += (x - y).abs();
        whole += x.abs();
    }
    sum / whole
}

fn history(a: &Run<'_>, b: &Run<'_>, of: impl Fn(&Sample) -> f64 + Copy) -> f64 {
    apart(a, b, |run, t| run.at(t, of))
}

fn centre(a: &Run<'_>, b: &Run<'_>) -> f64 {
    let axis = |d: usize| {
        let mut sum = 0.0;
        for k in 0..=MOMENTS {
            let at = |run: &Run<'_>| {
                let t = run.end * k as f64 / MOMENTS as f64;
                run.at(t, |s| if s.mass > 0.0 { s.moment[d] / s.mass } else { 0.0 })
            };
            sum += (at(a) - at(b)).abs() / (MOMENTS + 1) as f64;
        }
        let extent = a.of.samples.iter().map(|s| s.high[d] - s.low[d]).fold(0.0, f64::max);
        sum / extent
    };
    (0..3).map(axis).fold(0.0, worse)
}

/// Contacts per particle, each counted for both partners, of each part of a run.
fn coordination(a: &Run<'_>, b: &Run<'_>) -> f64 {
    let parts = |run: &Run<'_>| {
        (0..PARTS)
            .map(|k| {
                let [from, to] = [k, k + 1].map(|k| run.end * k as f64 / PARTS as f64);
                let change = |of: &dyn Fn(&Sample) -> f64| run.at(to, of) - run.at(from, of);
                let particles =
                    0.5 * (run.at(from, |s| s.particles as f64) + run.at(to, |s| s.particles as f64));
                2.0 * change(&|s| s.contacts as f64) / change(&|s| s.step as f64) / particles.max(1.0)
            })
            .collect::<Vec<_>>()
    };
    over(parts(a), parts(b))
}

/// Mean force of every wall along every axis, of each part of a run \[N\].
fn walls(a: &Run<'_>, b: &Run<'_>) -> f64 {
    let mut sum = [0.0, 0.0];
    for (w, name) in a.of.walls.iter().enumerate() {
        let Some(v) = b.of.walls.iter().position(|n| n == name) else { return f64::INFINITY };
        for k in 0..PARTS {
            let force = |run: &Run<'_>, wall: usize| {
                let [from, to] = [k, k + 1].map(|k| run.end * k as f64 / PARTS as f64);
                let push = |d: usize, t: f64| run.at(t, |s| s.walls.get(wall).map_or(0.0, |w| w[d]));
                [0, 1, 2].map(|d| (push(d, to) - push(d, from)) / (to - from))
            };
            let (x, y) = (force(a, w), force(b, v));
            sum[0] += (0..3).map(|d| (x[d] - y[d]).powi(2)).sum::<f64>().sqrt();
            sum[1] += x.iter().map(|f| f * f).sum::<f64>().sqrt();
        }
    }
    sum[0] / sum[1]
}

fn over(a: Vec<f64>, b: Vec<f64>) -> f64 {
    let apart: f64 = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).sum();
    apart / a.iter().sum::<f64>()
}

/// The larger; NaN is worse than anything.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run of steps of `dt`, with its quantities `by` times as large as they were.
    fn run(dt: f64, by: f64) -> Bulk {
        let sample = |k: u32| {
            let t = 0.01 * f64::from(k);
            let left = 1.0 - 0.05 * t;
            Sample {
                step: (t / dt) as i64,
                time: t,
                particles: 100,
                mass: left,
                kinetic: by * (1.0 + t),
                moment: [0.0, 0.0, by * 0.5 * left],
                low: [-1.0; 3],
                high: [1.0; 3],
                contacts: (by * 150.0 * t / dt) as u64,
                walls: vec![[0.0, 0.0, by * 9.81 * t]],
                ..Sample::default()
            }
        };
        Bulk { walls: vec!["wall floor".into()], samples: (0..=200).map(sample).collect() }
    }

    #[test]
    fn other_steps_alone_change_nothing_and_every_fault_is_seen() {
        for o in compare(&run(1e-5, 1.0), &run(7e-5, 1.0), None) {
            assert!(o.difference < 1e-4 && o.within(BULK), "{o:?}");
        }
        let wrong = compare(&run(1e-5, 1.0), &run(7e-5, 1.05), None);
        let of =
            |name: &str| wrong.iter().find(|o| o.name == name).unwrap_or_else(|| panic!("{name}")).difference;
        for name in ["kinetic energy", "coordination number", "force on walls"] {
            assert!((of(name) - 0.05).abs() < 1e-3, "{name} {}", of(name));
        }
        // The centre is 0.025 higher in an extent of 2.
        assert!((of("centre of mass") - 0.0125).abs() < 1e-4);
        assert!(of("mass discharged") < 1e-4);
        let mut slow = run(1e-5, 1.0);
        slow.samples.iter_mut().for_each(|s| s.mass = 1.0 - 0.9 * (1.0 - s.mass));
        let found = compare(&run(1e-5, 1.0), &slow, Some(&run(1e-5, 1.0)));
        let flow = found.iter().find(|o| o.name == "mass discharged").unwrap();
        assert!((flow.difference - 0.1).abs() < 1e-6 && flow.scatter == Some(0.0), "{flow:?}");
        assert!(!flow.within(BULK));
    }

    #[test]
    fn nothing_to_compare_is_not_within() {
        assert!(compare(&Bulk::default(), &Bulk::default(), None).iter().all(|o| !o.within(BULK)));
    }
}
