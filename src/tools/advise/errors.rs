//! The errors of a chain on contacts that are repeated.
use super::loaded::Held;
use super::simulated::Rebound;
use crate::probe::{Impact, Pressed};
use serde::Serialize;

/// From a number of contacts, how many standard errors are added to their mean error.
pub type Sure = fn(usize) -> f64;

/// The errors of a chain on a class of contacts: the mean over the contacts, plus a margin for how far that mean may be off
/// ([`Sure`]), so that other contacts of the class can be expected to do no worse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Normal speed afterwards over that before, absolute.
    pub restitution: f64,
    /// Contact time, relative.
    pub time: f64,
    /// Surface speed by spin afterwards, over the speed of the impact.
    pub spin: f64,
    /// Square root of overlap over R* under a load: the coordination number of a packing goes with it.
    pub overlap: f64,
    /// Tangential force that is borne at rest, over the normal load.
    pub shear: f64,
    /// Torque against rolling or torsion, over the normal load times R*.
    pub torque: f64,
    /// Attraction that is borne, over the normal load.
    pub tension: f64,
}

impl Errors {
    fn all(&mut self) -> [&mut f64; 7] {
        let Errors { restitution, time, spin, overlap, shear, torque, tension } = self;
        [restitution, time, spin, overlap, shear, torque, tension]
    }

    /// The errors of one contact: the mean of two runs that began at different moments of a step.
    pub(super) fn halfway([mut a, mut b]: [Errors; 2]) -> Errors {
        a.all().into_iter().zip(b.all()).for_each(|(a, b)| *a = 0.5 * (*a + *b));
        a
    }

    /// The errors of many contacts; `sure` gives the margin.
    pub(super) fn mean(mut of: Vec<Errors>, sure: Sure) -> Errors {
        let (n, factor) = (of.len() as f64, sure(of.len()));
        let mut mean = Errors::default();
        for (k, out) in mean.all().into_iter().enumerate() {
            let values: Vec<f64> = of.iter_mut().map(|e| *e.all()[k]).collect();
            let m = values.iter().sum::<f64>() / n;
            let square = values.iter().map(|x| (x - m) * (x - m)).sum::<f64>();
            // One contact alone shows no scatter; `rules::sure` says what is done then. Without a margin its error is taken as it is.
            let alone = if factor > 1.0 { m } else { 0.0 };
            *out = m + factor * if n > 1.0 { (square / (n - 1.0) / n).sqrt() } else { alone };
        }
        mean
    }

    /// The largest error with its name; that of contact time is divided by `time` first.
    pub fn worst(&self, time: f64) -> (&'static str, f64) {
        let all = [
            ("restitution", self.restitution),
            ("contact time", self.time / time),
            ("spin", self.spin),
            ("overlap under load", self.overlap),
            ("shear held at rest", self.shear),
            ("torque against rolling", self.torque),
            ("attraction borne", self.tension),
        ];
        let worst =
            |a: (&'static str, f64), b: (&'static str, f64)| if worse(a.1, b.1) > a.1 { b } else { a };
        let found = all.into_iter().fold(("", 0.0), worst);
        if found.0 == "contact time" {
            (found.0, self.time)
        } else {
            found
        }
    }

    /// Whether all errors are within the accuracy; that of contact time may be `time` times as large.
    pub fn within(&self, accuracy: f64, time: f64) -> bool {
        let rest = [self.restitution, self.spin, self.overlap, self.shear, self.torque, self.tension];
        rest.iter().all(|e| *e <= accuracy) && self.time <= accuracy * time
    }
}

/// The larger of the two; NaN counts as larger than any number.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

/// The errors of one impact, against the truth.
pub(super) fn wrong(i: &Impact, truth: &Rebound, got: &Rebound) -> Errors {
    let speed = i.v[0].hypot(i.slip);
    let spin = |k: usize| (got.spin[k] - truth.spin[k]).norm() * i.partners.radius[k] / speed;
    let time = match (truth.time.is_finite(), got.time.is_finite()) {
        (true, true) => (got.time / truth.time - 1.0).abs(),
        (false, false) => 0.0,
        // Only one of the two sticks.
        _ => 1.0,
    };
    Errors {
        restitution: (got.restitution - truth.restitution).abs(),
        time,
        spin: worse(spin(0), spin(1)),
        ..Errors::default()
    }
}

/// The errors of one load, against the truth.
pub(super) fn astray(l: &Pressed, truth: &Held, got: &Held) -> Errors {
    let torque = |k: usize| (got.torque[k] - truth.torque[k]).abs();
    let root = |h: &Held| (h.overlap / l.partners.reff()).sqrt();
    Errors {
        overlap: (root(got) - root(truth)).abs(),
        shear: (got.shear - truth.shear).abs(),
        torque: worse(torque(0), torque(1)),
        tension: (got.tension - truth.tension).abs(),
        ..Errors::default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::rules::sure;
    use super::*;

    #[test]
    fn few_contacts_are_taken_with_caution() {
        let of = |sizes: &[f64], sure: Sure| {
            let one = |x: &f64| Errors { spin: *x, ..Errors::default() };
            Errors::mean(sizes.iter().map(one).collect(), sure).spin
        };
        let twelve: Vec<_> = (0..12).map(|k| if k % 2 == 0 { 0.01 } else { 0.02 }).collect();
        // Standard deviation 0.005 √(12/11), and √12 contacts.
        let off = 0.005 * (12.0f64 / 11.0).sqrt() / 12f64.sqrt();
        assert!((of(&twelve, |_| 1.0) - (0.015 + off)).abs() < 1e-12);
        assert!((of(&twelve, sure) - (0.015 + (1.0 + 2f64.sqrt() * 1.796) * off)).abs() < 1e-12);
        // Two contacts say little about the scatter, and one even less.
        assert!((of(&[0.01, 0.02], sure) - (0.015 + (1.0 + 2f64.sqrt() * 6.314) * 0.005)).abs() < 1e-12);
        assert!(of(&[0.01], sure) > 0.1 && of(&[0.01], |_| 1.0) == 0.01);
        // Errors of zero stay zero.
        assert_eq!((of(&[0.0], sure), of(&[0.0; 5], sure)), (0.0, 0.0));
        assert!((1..40).all(|n| sure(n + 1) <= sure(n) && sure(n) > 3.0));
    }
}
