//! The reference of a case: a closed form where there is one, a converged solution elsewhere.
use super::bonds;
use super::case::{Case, Measure};
use crate::study::adaptive::{impact, Aim};
use crate::study::bonded::{run as run_row, whole, Look};
use crate::study::collision::Outcome;
use crate::study::modes::stiffness;
use granlaw::model::Kind;
use granlaw::pair::run;
use std::f64::consts::PI;

/// The reference, and how wrong it may be itself.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The converged solution, with its force history.
    pub outcome: Outcome,
    /// The measured quantity.
    pub value: f64,
    /// Where it comes from.
    pub source: &'static str,
    /// Its own relative error: for a closed form, the difference of the converged solution from it; otherwise the difference between
    /// that and a solution with ten times the tolerance.
    pub error: f64,
}

/// Relative tolerance per step of the converged solutions. With a smaller one, round-off of the extrapolation weights dominates.
const TOLERANCE: f64 = 1e-11;
/// Steps per period of the normal spring, for the converged solutions in fixed steps.
const FINE: f64 = 20_000.0;

impl Truth {
    /// The reference of a case.
    ///
    /// # Panics
    /// If the laws refuse the case, which is a bug of it.
    pub fn of(case: &Case) -> Truth {
        if let Measure::Distance = case.measure {
            return rolled(case);
        }
        if let Some((value, period)) = bonds::closed_form(case) {
            return bonded(case, value, period);
        }
        let solve = |tolerance, duration, longest, with_force| {
            let mut chain = case.matter.chain().expect("a sound case");
            impact(&mut chain, &case.collision, &Aim { tolerance, duration, longest, with_force }).0
        };
        let duration = solve(1e-4, period(case), 0.1, false).duration;
        let (fine, other) =
            (solve(TOLERANCE, duration, 0.01, false), solve(10.0 * TOLERANCE, duration, 0.02, false));
        // Short steps, so that forces in between can be interpolated linearly.
        let dense = solve(1e-9, duration, 1.0 / 4000.0, true);
        let outcome = Outcome { force: dense.force, peak: dense.peak, ..fine.clone() };
        let measured = case.measure.of(&fine);
        match closed_form(case) {
            Some(value) => {
                let error = ((measured - value) / value).abs();
                Truth { outcome, value, source: "closed form", error }
            }
            None => {
                let error = ((measured - case.measure.of(&other)) / measured).abs();
                Truth { outcome, value: measured, source: "converged solution", error }
            }
        }
    }

    /// Normal force \[N\] at a time since first touch \[s\].
    pub fn force(&self, time: f64) -> f64 {
        let f = &self.outcome.force;
        let k = f.partition_point(|(t, _)| *t <= time);
        if k == 0 || k == f.len() || time > self.outcome.duration {
            return 0.0;
        }
        let ((t0, f0), (t1, f1)) = (f[k - 1], f[k]);
        f0 + (f1 - f0) * (time - t0) / (t1 - t0)
    }
}

/// The reference of a row of bonds, which has a closed form. Its error is taken to be the difference from our own solution, which is an
/// upper bound. Single swings of two spheres are solved adaptively, all others in fine fixed steps.
fn bonded(case: &Case, value: f64, period: f64) -> Truth {
    let bonded = case.collision.row().expect("a row");
    let mut chain = case.matter.chain().expect("a sound case");
    let once = case.measure == Measure::Restitution;
    let dt = period / FINE;
    let fine = match once {
        true => run_row(
            &mut chain,
            &case.collision,
            &bonded,
            (dt, 3 * FINE as u64),
            Look::Once { with_force: true },
        ),
        false => {
            let steps = whole(bonds::swings(case) * FINE);
            let dt = bonds::swings(case) * period / (steps - 1) as f64;
            let o = run_row(&mut chain, &case.collision, &bonded, (dt, steps), Look::End);
            Outcome { duration: period, ..o }
        }
    };
    let best = if once && bonded.beads == 2 {
        let aim = Aim { tolerance: TOLERANCE, duration: fine.duration, longest: 0.01, with_force: false };
        case.measure.of(&impact(&mut chain, &case.collision, &aim).0)
    } else {
        case.measure.of(&fine)
    };
    Truth { outcome: fine, value, source: "closed form", error: ((best - value) / value).abs() }
}

/// The reference for rolling to rest: LIGGGHTS's scheme in fine steps.
fn rolled(case: &Case) -> Truth {
    let roll = |n: f64| {
        let mut chain = case.matter.clone().timed().chain().expect("a sound case");
        let dt = period(case) / n;
        let time = case.collision.rest.map_or(0.0, |r| r.time);
        let start = case.collision.start(dt, 0.0, (time / dt) as u64);
        let mut last = start.bodies;
        run(&mut chain, &start, |s| last = s.bodies);
        case.collision.judge(&last)
    };
    let (fine, coarse) = (roll(FINE), roll(0.5 * FINE));
    let error = ((fine.distance - coarse.distance) / fine.distance).abs();
    let outcome = Outcome { duration: period(case), ..fine };
    Truth { value: outcome.distance, outcome, source: "fine steps of LIGGGHTS's scheme", error }
}

/// Half a period of the loading stiffness \[s\]: how long a contact lasts, to within a factor of two.
pub fn period(case: &Case) -> f64 {
    PI * (case.collision.meff() / stiffness(&case.matter, &case.collision)).sqrt()
}

/// The closed form of the restitution, if there is one.
fn closed_form(case: &Case) -> Option<f64> {
    let value = |name| case.matter.value(name).expect("a value of the case");
    if case.measure != Measure::Restitution {
        return None;
    }
    match case.matter.laws[0] {
        (Kind::Normal, "hooke" | "hertz") => Some(value("coefficientRestitution")),
        (Kind::Normal, "hooke/hysteresis") if value("coefficientRestitution") == 1.0 => {
            Some(hysteresis(case))
        }
        _ => None,
    }
}

/// Energy balance of Luding's loop (arXiv:1503.03720), without dashpot.
fn hysteresis(case: &Case) -> f64 {
    let value = |name| case.matter.value(name).expect("a value of the case");
    let reff = if case.collision.wall { case.collision.radius } else { 0.5 * case.collision.radius };
    let (ratio, kc) = (value("coefficientMaxElasticStiffness"), value("coefficientAdhesionStiffness"));
    let limit = ratio / (ratio - 1.0) * value("coefficientPlasticityDepth") * 2.0 * reff;
    let depth =
        case.collision.speed * (case.collision.meff() / stiffness(&case.matter, &case.collision)).sqrt();
    let lost = |k2: f64| (1.0 - 1.0 / k2) + kc * k2 / (k2 + kc) * (1.0 - 1.0 / k2).powi(2);
    let square = if depth < limit {
        let k2 = 1.0 + (ratio - 1.0) * depth / limit;
        1.0 - lost(k2)
    } else {
        1.0 - (limit / depth).powi(2) * lost(ratio)
    };
    square.sqrt()
}
