//! Error and cost of a method over its step.
use super::case::{Case, Measure};
use super::costs::{self, Cost};
use super::methods::{Method, Runner};
use super::truth::Truth;
use crate::report::page::Spread;
use crate::study::collision::Outcome;

/// Steps per contact.
pub const STEPS: [f64; 10] = [12.0, 25.0, 50.0, 100.0, 200.0, 400.0, 800.0, 1600.0, 3200.0, 6400.0];

/// A method on a case.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The method.
    pub method: Method,
    /// The points, from few steps to many.
    pub points: Vec<Point>,
}

/// A method on a case with one step.
#[derive(Clone, Debug)]
pub struct Point {
    /// Steps per contact; for the adaptive method, one over its tolerance.
    pub n: f64,
    /// Relative error of what the case measures: the mean over the phases of first touch, with the tenth and ninetieth
    /// percentile.
    pub error: Spread,
    /// Mean relative errors of restitution, peak force, duration and spin, and of the force history in the mean square;
    /// NaN where the method does not give the quantity or the truth is zero.
    pub errors: [f64; 5],
    /// Time per contact \[s\].
    pub cost: Cost,
}

/// The names of [`Point::errors`].
pub const ERRORS: [&str; 5] =
    ["restitution", "peak force", "contact time", "final spin", "force history (L2)"];

/// Whether a case is run with this many steps. A rolling sphere takes hundreds of periods, and very short steps show nothing new.
pub fn worth(case: &Case, n: f64) -> bool {
    case.collision.rest.is_none() || n <= 1600.0
}

/// Phases of first touch within a step. They are multiples of the golden section, so that they and the ends of the contacts spread
/// evenly.
pub fn phases(count: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(move |k| {
        let more = (k as f64 * 0.618_033_988_749_895).fract();
        ((k as f64 + 0.5) / count as f64, more)
    })
}

/// The curve of a method that does not run in LIGGGHTS; `None` if it cannot do the case.
pub fn ours(method: Method, case: &Case, truth: &Truth, count: usize, rounds: usize) -> Option<Curve> {
    let mut runner = Runner::new(method, case, truth)?;
    let aims: Vec<f64> = match method {
        Method::Adaptive => (4..=10).map(|p| 10f64.powi(p)).collect(),
        _ => STEPS.into_iter().filter(|n| worth(case, *n)).collect(),
    };
    // These methods begin exactly at first touch, so there are no phases.
    let once = matches!(method, Method::Adaptive | Method::Located);
    // A rolling sphere has no first touch, so the length of the step is varied instead.
    let count = match () {
        _ if once => 1,
        _ if case.collision.rest.is_some() => 4,
        // A case that ends exactly after a given time has no phases at all.
        _ if case.collision.row().is_some() && case.measure == Measure::Spin => 1,
        _ => count,
    };
    let points = aims.into_iter().map(|n| {
        let outcomes: Vec<Outcome> =
            phases(count).map(|(before, more)| runner.run(at(n, more, once), before, true)).collect();
        // Short contacts are repeated; of long ones only a part is timed.
        let timed = (20_000.0 / n).clamp(1.0, 200.0) as usize;
        let cost = costs::time(rounds, timed as f64, || {
            phases(timed).for_each(|(before, more)| {
                std::hint::black_box(runner.run(at(n, more, once), before, false));
            });
        });
        judge(case, truth, n, &outcomes, cost)
    });
    Some(Curve { method, points: points.collect() })
}

/// Steps per contact for a phase.
fn at(n: f64, more: f64, once: bool) -> f64 {
    if once {
        n
    } else {
        n + more
    }
}

/// A point from the outcomes of all phases.
pub fn judge(case: &Case, truth: &Truth, n: f64, outcomes: &[Outcome], cost: Cost) -> Point {
    let relative = |got: f64, expected: f64| ((got - expected) / expected).abs();
    let mean = |f: &dyn Fn(&Outcome) -> f64| outcomes.iter().map(f).sum::<f64>() / outcomes.len() as f64;
    let t = &truth.outcome;
    let given = |x: f64| if x == 0.0 { f64::NAN } else { x };
    // After rolling to rest there is no spin to which an error could be relative.
    let spin = if case.measure == Measure::Distance { 0.0 } else { t.spin };
    let errors = [
        mean(&|o| {
            relative(o.restitution, if case.collision.slide == 0.0 { truth.value } else { t.restitution })
        }),
        mean(&|o| relative(given(o.peak), t.peak)),
        mean(&|o| relative(given(o.duration), t.duration)),
        mean(&|o| relative(o.spin, given(spin))),
        mean(&|o| history(truth, o)),
    ];
    let mut each: Vec<f64> = outcomes.iter().map(|o| relative(case.measure.of(o), truth.value)).collect();
    each.sort_by(f64::total_cmp);
    let at = |q: f64| each[((each.len() - 1) as f64 * q).round() as usize];
    let error = Spread { at: each.iter().sum::<f64>() / each.len() as f64, low: at(0.1), high: at(0.9) };
    Point { n, error, errors, cost }
}

/// The root mean square of the force error over that of the force.
fn history(truth: &Truth, o: &Outcome) -> f64 {
    let f = &o.force;
    if f.len() < 2 {
        return f64::NAN;
    }
    let step = |k: usize| 0.5 * (f[(k + 1).min(f.len() - 1)].0 - f[k.saturating_sub(1)].0);
    let (mut off, mut all) = (0.0, 0.0);
    for (k, (time, force)) in f.iter().enumerate() {
        let expected = truth.force(*time);
        off += (force - expected).powi(2) * step(k);
        all += expected.powi(2) * step(k);
    }
    (off / all).sqrt()
}

impl Curve {
    /// The power of the step with which the error falls: a fit from this number of steps per contact to where round-off and the error of
    /// the truth dominate; `None` with fewer than three points.
    pub fn order(&self, from: f64, floor: f64) -> Option<f64> {
        let clean = |p: &&Point| p.n >= from && p.error.at < 2e-2 && p.error.at > 5.0 * floor;
        let points: Vec<_> = self.points.iter().filter(clean).map(|p| (p.n.ln(), p.error.at.ln())).collect();
        let n = points.len() as f64;
        if n < 3.0 || self.method == Method::Adaptive {
            return None;
        }
        let (mx, my) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
        let (xy, xx) =
            points.iter().fold((0.0, 0.0), |(a, b), p| (a + (p.0 - mx) * (p.1 - my), b + (p.0 - mx).powi(2)));
        Some(-xy / xx)
    }

    /// The steps and time that an error takes; between two points, logarithms are interpolated linearly.
    pub fn reach(&self, target: f64) -> Option<Reach> {
        let good = |p: &Point| p.error.at <= target;
        // The last point above the error counts: from there on it stays below.
        let k = self.points.iter().rposition(|p| !good(p)).map_or(0, |k| k + 1);
        let there = self.points.get(k)?;
        let Some(before) = k.checked_sub(1).map(|k| &self.points[k]) else {
            return Some(Reach { n: there.n, cost: there.cost.at, at_most: true });
        };
        let part = (before.error.at / target).ln() / (before.error.at / there.error.at).ln();
        let mix = |a: f64, b: f64| (a.ln() + (b / a).ln() * part).exp();
        Some(Reach { n: mix(before.n, there.n), cost: mix(before.cost.at, there.cost.at), at_most: false })
    }
}

/// The steps and time that an error takes.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// Steps per contact; of the adaptive method, one over its tolerance.
    pub n: f64,
    /// Time per contact \[s\].
    pub cost: f64,
    /// Whether the coarsest step that was tried is good enough already.
    pub at_most: bool,
}
