//! Bulk observables of two decks of a scene, each run once or with several seeds, and how far they are apart.
use super::rules::BULK;
use crate::probe::{Bulk, Sample};
use serde::Serialize;

/// A run is cut into this many parts of equal time, over which means are taken.
const PARTS: usize = 4;
/// Moments at which histories are compared.
const MOMENTS: usize = 200;
/// If the mass of a scene changes by less than this fraction, nothing flows out of it.
const FLOWS: f64 = 0.05;

/// A bulk observable of two decks.
#[derive(Clone, Debug, Serialize)]
pub struct Observable {
    /// Which quantity.
    pub name: &'static str,
    /// What the difference is taken of, and relative to what.
    pub meaning: &'static str,
    /// The difference; of several runs, that of their means.
    pub difference: f64,
    /// The difference that chance alone makes: between as many runs of the deck with these seeds and as many with others.
    /// `None` where the deck ran once.
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

/// Compares the runs of two decks, both with the same seeds; `other` is one more run of the first deck.
pub fn compare(deck: &[&Bulk], advised: &[&Bulk], other: Option<&Bulk>) -> Vec<Observable> {
    let scatter = match (deck, other) {
        ([one], Some(other)) => vec![(1.0, differences(&[one], &[other]))],
        _ => halves(deck),
    };
    let found = differences(deck, advised).into_iter().map(|(name, meaning, difference)| {
        let of = |(by, all): &(f64, Vec<Difference>)| all.iter().find(|d| d.0 == name).map(|d| by * d.2);
        let each: Vec<_> = scatter.iter().filter_map(of).collect();
        let mean = each.iter().sum::<f64>() / each.len() as f64;
        Observable { name, meaning, difference, scatter: (!each.is_empty()).then_some(mean) }
    });
    found.collect()
}

/// The scatter of the mean of all runs: half of the runs are compared with the other half, in as many ways as there are runs.
/// Each half has half the runs, so its mean scatters more than that of all; the result is scaled down for that.
fn halves(runs: &[&Bulk]) -> Vec<(f64, Vec<Difference>)> {
    let (n, half) = (runs.len(), runs.len() / 2);
    if half == 0 {
        return Vec::new();
    }
    let by = (half as f64 / n as f64).sqrt();
    let turned = |k: usize| [&runs[k..], &runs[..k]].concat();
    (0..n).map(turned).map(|r| (by, differences(&r[..half], &r[half..2 * half]))).collect()
}

/// Name, meaning, size.
type Difference = (&'static str, &'static str, f64);

fn differences(a: &[&Bulk], b: &[&Bulk]) -> Vec<Difference> {
    let [a, b] = [a, b].map(Runs::new);
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
        let gone = |run: &Runs<'_>, t: f64| (run.at(0.0, mass) - run.at(t, mass)).abs();
        all.push((
            "mass discharged",
            "mean of |difference| over time, over the mean",
            apart(&a, &b, |run, t| gone(run, t)),
        ));
    }
    if !a.walls().is_empty() {
        all.push((
            "force on walls",
            "of four parts of the run and all walls: sum of |difference| over the sum",
            walls(&a, &b),
        ));
    }
    all
}

/// Runs of a deck, with the length of the first \[s\].
struct Runs<'a> {
    of: &'a [&'a Bulk],
    end: f64,
}

impl Runs<'_> {
    fn new<'a>(of: &'a [&'a Bulk]) -> Runs<'a> {
        Runs { of, end: of.first().and_then(|r| r.samples.last()).map_or(0.0, |s| s.time) }
    }

    /// The mean of a quantity at a time \[s\].
    fn at(&self, t: f64, of: impl Fn(&Sample) -> f64) -> f64 {
        self.of.iter().map(|run| at(run, t, &of)).sum::<f64>() / self.of.len() as f64
    }

    fn samples(&self) -> impl Iterator<Item = &Sample> {
        self.of.iter().flat_map(|run| &run.samples)
    }

    /// The wall fixes, which are the same in all runs.
    fn walls(&self) -> &[String] {
        self.of.first().map_or(&[], |run| &run.walls)
    }
}

/// A quantity of a run at a time \[s\], linear between samples.
fn at(run: &Bulk, t: f64, of: impl Fn(&Sample) -> f64) -> f64 {
    let all = &run.samples;
    let k = all.partition_point(|s| s.time <= t);
    match (k.checked_sub(1).map(|k| &all[k]), all.get(k)) {
        (Some(a), Some(b)) => of(a) + (of(b) - of(a)) * (t - a.time) / (b.time - a.time),
        (Some(s), None) | (None, Some(s)) => of(s),
        (None, None) => f64::NAN,
    }
}

/// Mean of |difference| over time, over the mean of the first.
fn apart(a: &Runs<'_>, b: &Runs<'_>, of: impl Fn(&Runs<'_>, f64) -> f64) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    for k in 0..=MOMENTS {
        let part = k as f64 / MOMENTS as f64;
        let (x, y) = (of(a, part * a.end), of(b, part * b.end));
        sum += (x - y).abs();
        whole += x.abs();
    }
    sum / whole
}

fn history(a: &Runs<'_>, b: &Runs<'_>, of: impl Fn(&Sample) -> f64 + Copy) -> f64 {
    apart(a, b, |run, t| run.at(t, of))
}

fn centre(a: &Runs<'_>, b: &Runs<'_>) -> f64 {
    let axis = |d: usize| {
        let mut sum = 0.0;
        for k in 0..=MOMENTS {
            let at = |run: &Runs<'_>| {
                let t = run.end * k as f64 / MOMENTS as f64;
                run.at(t, |s| if s.mass > 0.0 { s.moment[d] / s.mass } else { 0.0 })
            };
            sum += (at(a) - at(b)).abs() / (MOMENTS + 1) as f64;
        }
        let extent = a.samples().map(|s| s.high[d] - s.low[d]).fold(0.0, f64::max);
        sum / extent
    };
    (0..3).map(axis).fold(0.0, worse)
}

/// Contacts per particle, each counted for both partners, of each part of a run.
fn coordination(a: &Runs<'_>, b: &Runs<'_>) -> f64 {
    let parts = |run: &Runs<'_>| {
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
fn walls(a: &Runs<'_>, b: &Runs<'_>) -> f64 {
    let mut sum = [0.0, 0.0];
    for (w, name) in a.walls().iter().enumerate() {
        let Some(v) = b.walls().iter().position(|n| n == name) else { return f64::INFINITY };
        for k in 0..PARTS {
            let force = |run: &Runs<'_>, wall: usize| {
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

/// The larger of the two; NaN counts as larger than any number.
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
        for o in compare(&[&run(1e-5, 1.0)], &[&run(7e-5, 1.0)], None) {
            assert!(o.difference < 1e-4 && o.within(BULK), "{o:?}");
        }
        let wrong = compare(&[&run(1e-5, 1.0)], &[&run(7e-5, 1.05)], None);
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
        let found = compare(&[&run(1e-5, 1.0)], &[&slow], Some(&run(1e-5, 1.0)));
        let flow = found.iter().find(|o| o.name == "mass discharged").unwrap();
        assert!((flow.difference - 0.1).abs() < 1e-6 && flow.scatter == Some(0.0), "{flow:?}");
        assert!(!flow.within(BULK));
    }

    #[test]
    fn means_over_seeds_tell_a_bias_from_scatter() {
        // Each run is up to 10 % off, their mean is not; one that is 5 % off is.
        let deck = [0.9, 1.1, 1.05, 0.95, 1.02, 0.98].map(|by| run(1e-5, by));
        let same = [1.1, 0.92, 0.96, 1.03, 0.97, 1.02].map(|by| run(7e-5, by));
        let more = [1.1, 0.92, 0.96, 1.03, 0.97, 1.02].map(|by| run(7e-5, 1.05 * by));
        let energy = |other: &[Bulk; 6]| {
            let found = compare(&deck.each_ref(), &other.each_ref(), None);
            found.into_iter().find(|o| o.name == "kinetic energy").expect("it is there")
        };
        assert!(energy(&same).difference < 1e-6 && (energy(&more).difference - 0.05).abs() < 1e-6);
        // One run differs from the mean of many by 7 % (standard deviation), two means of six by √(2/6) of that, 4 %; the mean
        // size of that is 0.8 times as large. Runs that lie next to each other here make up for each other, hence the room.
        let scatter = energy(&same).scatter.expect("six runs scatter");
        assert!((0.01..0.05).contains(&scatter), "{scatter}");
        assert!(compare(&[&deck[0]], &[&same[0]], None)[0].scatter.is_none());
    }

    #[test]
    fn nothing_to_compare_is_not_within() {
        assert!(compare(&[&Bulk::default()], &[&Bulk::default()], None).iter().all(|o| !o.within(BULK)));
    }
}
