//! Adaptive extrapolation: the converged solution with which the other methods are compared.
//!
//! Each step is computed in one, two, … six parts, and a combination of the six answers cancels the errors of order two to six. The
//! estimated error is the difference from the combination of five of them, or a hundredth of that from the combination of four if that is
//! larger, as at a kink the first two may agree by chance. It decides on the length of the step. Steps end exactly at the turning
//! point and at last touch; at other kinks the estimate shortens the step until they do no harm.
use super::collision::{Collision, Outcome};
use super::motion::{Instant, Motion};
use granlaw::chain::Chain;
use granlaw::model::Body;
use nalgebra::{DMatrix, DVector, Vector3};

/// Levels of extrapolation.
const LEVELS: usize = 6;
/// After this many evaluations of the laws a contact counts as one that does not end; the finest takes about a tenth of that.
const MOST: u64 = 5_000_000;

/// The accuracy to reach.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    /// Error per step, relative to speed, depth and spin of the contact.
    pub tolerance: f64,
    /// About how long the contact lasts \[s\].
    pub duration: f64,
    /// Longest step, over `duration`.
    pub longest: f64,
    /// Whether forces are kept.
    pub with_force: bool,
}

/// Integrates the contact. Returns the outcome and the number of evaluations of the laws.
pub fn impact(chain: &mut Chain, collision: &Collision, aim: &Aim) -> (Outcome, u64) {
    let start = collision.start(aim.duration, 0.0, 0);
    let mut solver = Solver::new(Motion::new(chain, &start, collision), collision, aim);
    let outcome = solver.run(start.bodies);
    (outcome, solver.motion.calls)
}

struct Solver<'a> {
    motion: Motion<'a>,
    collision: &'a Collision,
    aim: &'a Aim,
    /// Weights of the answers in 1, 2, … parts: for all levels, for one less and for two less.
    weights: [DVector<f64>; 3],
}

impl<'a> Solver<'a> {
    fn new(motion: Motion<'a>, collision: &'a Collision, aim: &'a Aim) -> Solver<'a> {
        Solver {
            motion,
            collision,
            aim,
            weights: [weights(LEVELS), weights(LEVELS - 1), weights(LEVELS - 2)],
        }
    }

    fn run(&mut self, bodies: [Body; 2]) -> Outcome {
        let Aim { tolerance, duration, longest, with_force } = *self.aim;
        let mut at = self.motion.touch(bodies);
        let mut seen = Outcome::default();
        let mut h = 1e-3 * duration * longest.min(1.0);
        let shortest = 1e-13 * duration;
        while at.time < 100.0 * duration && at.vn.is_finite() && self.motion.calls < MOST {
            seen.peak = seen.peak.max(at.response.fn_);
            if with_force {
                seen.force.push((at.time, at.response.fn_));
            }
            h = h.min(longest * duration).max(shortest);
            let (end, error) = self.step(&at, h);
            let factor = (0.9 * (tolerance / error.max(1e-3 * tolerance)).powf(1.0 / 6.0)).clamp(0.1, 3.0);
            if error > tolerance && h > shortest {
                h *= factor.min(0.7);
                continue;
            }
            if self.motion.overlap(&end.bodies) < 0.0 && at.time > 0.0 {
                at = self.meet(&at, h, |s, i| s.motion.overlap(&i.bodies));
                seen.duration = at.time;
                seen.parted = true;
                break;
            }
            at = match self.motion.inward(&at) > 0.0 && self.motion.inward(&end) < 0.0 {
                true => self.meet(&at, h, |s, i| s.motion.inward(i)),
                false => end,
            };
            h *= factor;
        }
        let Outcome { peak, duration, parted, force, .. } = seen;
        Outcome { peak, duration, parted, force, ..self.collision.judge(&at.bodies) }
    }

    /// One step, extrapolated, and its estimated error.
    fn step(&mut self, from: &Instant, h: f64) -> (Instant, f64) {
        let answers: Vec<Instant> = (1..=LEVELS)
            .map(|n| {
                let mut at = from.clone();
                (0..n).for_each(|_| at = self.motion.step(&at, h / n as f64));
                at
            })
            .collect();
        let rows: Vec<Vec<f64>> = answers.iter().map(flat).collect();
        let mix = |w: &DVector<f64>, k: usize| w.iter().zip(&rows).map(|(w, r)| w * r[k]).sum::<f64>();
        let best: Vec<f64> = (0..rows[0].len()).map(|k| mix(&self.weights[0], k)).collect();
        let scales = self.scales();
        let off = |k: usize| {
            let [_, less, least] = self.weights.each_ref().map(|w| mix(w, k));
            (best[k] - less).abs().max(0.01 * (less - least).abs()) / scales(k)
        };
        let error = (0..best.len()).map(off).fold(0.0, f64::max);
        let mut end = answers.into_iter().next_back().expect("some levels");
        restore(&best, &mut end);
        end.vn = self.motion.normal_velocity(&end.bodies);
        (end, error)
    }

    /// The scale of each number of [`flat`]: a length, a velocity or a spin. Forces do not count.
    fn scales(&self) -> impl Fn(usize) -> f64 + 'static {
        let speed = self.collision.speed.hypot(self.collision.slide);
        let (depth, radius) = (speed * self.aim.duration, self.collision.radius);
        move |k: usize| match k {
            0..=8 => f64::INFINITY,
            9..=26 => match k % 9 {
                0..=2 => depth,
                3..=5 => speed,
                _ => speed / radius,
            },
            _ => depth,
        }
    }

    /// The first instant within a step `h` at which `sign` is below zero after it was above.
    fn meet(&mut self, from: &Instant, h: f64, sign: impl Fn(&Solver<'_>, &Instant) -> f64) -> Instant {
        let (mut low, mut high) = (0.0, h);
        let mut beyond = None;
        let (mut f_low, mut f_high) = (sign(self, from), f64::NAN);
        for round in 0..80 {
            // The method of false position, with a bisection in every third round so that neither end gets stuck.
            let part = if f_high.is_nan() || round % 3 == 2 { 0.5 } else { f_low / (f_low - f_high) };
            let middle = low + (high - low) * part.clamp(1e-3, 1.0 - 1e-3);
            let (at, _) = self.step(from, middle);
            let f = sign(self, &at);
            if f < 0.0 {
                (high, f_high, beyond) = (middle, f, Some(at));
            } else {
                (low, f_low) = (middle, f);
            }
            if high - low <= 1e-15 * h.max(from.time) {
                break;
            }
        }
        beyond.unwrap_or_else(|| self.step(from, h).0)
    }
}

/// Weights of the answers in 1, 2, … `n` parts that cancel the powers 2 to n of the length of a part.
fn weights(n: usize) -> DVector<f64> {
    let power = |row: usize| if row == 0 { 0 } else { row as i32 + 1 };
    let matrix = DMatrix::from_fn(n, n, |row, k| (1.0 / (k + 1) as f64).powi(power(row)));
    let one = DVector::from_fn(n, |row, _| if row == 0 { 1.0 } else { 0.0 });
    matrix.lu().solve(&one).expect("different parts")
}

/// All numbers of an instant: forces, bodies, history.
fn flat(at: &Instant) -> Vec<f64> {
    let three = |v: Vector3<f64>| [v.x, v.y, v.z];
    let acts = [at.response.force, at.response.torque_i, at.response.torque_j];
    let bodies = at.bodies.iter().flat_map(|b| [b.x, b.v, b.omega]);
    acts.into_iter().chain(bodies).flat_map(three).chain(at.history.iter().copied()).collect()
}

fn restore(row: &[f64], at: &mut Instant) {
    let s = &mut at.response;
    let acts = [&mut s.force, &mut s.torque_i, &mut s.torque_j];
    let bodies = at.bodies.iter_mut().flat_map(|b| [&mut b.x, &mut b.v, &mut b.omega]);
    acts.into_iter().chain(bodies).zip(row.chunks(3)).for_each(|(v, n)| v.copy_from_slice(n));
    at.history.copy_from_slice(&row[27..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_cancel_what_they_say() {
        let w = weights(6);
        let sum = |p: i32| w.iter().enumerate().map(|(k, w)| w / ((k + 1) as f64).powi(p)).sum::<f64>();
        assert!((sum(0) - 1.0).abs() < 1e-9);
        (2..=6).for_each(|p| assert!(sum(p).abs() < 1e-9, "{p}"));
        assert!(sum(1).abs() > 1e-3 && sum(7).abs() > 1e-6);
    }
}
