//! Two settings by which laws raise the order of LIGGGHTS's time integration from the inside.
//!
//! LIGGGHTS evaluates a contact at the end of a step with the velocities of its middle, and the force then acts for a
//! whole step. That is second order in the step for springs, and first order as soon as there is a dashpot or a shear
//! history.
//!
//! `centredDamping on`: the dashpot is meant to see the velocity at the end of the step, `v + F dt/2m`, hence
//! - (T1) `F = (F_el − γ v)/(1 + γ dt/2m)`; m is m* along the normal and m*/(1 + 5/2 λ²) sideways, where solid spheres
//!   turn under a lever of λ radii
//!
//! `touchFraction on`: surfaces meet and part between two steps. Let s be the steps since they met, or until they will
//! part, by the overlap and the velocity. Evaluations with s < 2 are weighted so that their sum is the integral from
//! s = 0, whatever s the first one finds. No weight jumps, so it does no harm that s is known to first order only.
//! - (T2) a force that grows with s: `(1+s)/2` for s < 1
//! - (T3) one that is there at once: `3s/2` for s < 1, `2 − s/2` for s < 2
//! - (T4) one that grows with s^¼: `c s` for s < 1, `A + B s + C/s + D/s³ − c (s−1) (1−1/s)^¼` for s < 2
//!
//! (T4): samples at s, s+1, … of s^p exceed their integral by the zeta function ζ(−p, s) (I. Navot, J. Math. Phys. 40
//! (1961) 271), here in its asymptotic series; (T2) and (T3) are p = 1 and p = 0.
//!
//! Both are exact for a contact alone; forces of other contacts and gravity act within the step unseen.
use crate::lane::Lane;
use crate::model::{Call, Pair, Surface};

/// Which of the two settings are on.
#[derive(Clone, Copy, Debug)]
pub struct Timing {
    centred: bool,
    fraction: bool,
}

/// How a force begins at first touch and ends at last.
#[derive(Clone, Copy, Debug)]
pub enum Onset {
    /// With its full size (T3).
    AtOnce,
    /// With the fourth root of the time (T4).
    FourthRoot,
}

/// Steps since the surfaces met and until they part; infinite where they do neither soon.
#[derive(Clone, Copy, Debug)]
pub struct Ends<L> {
    /// Since they met.
    pub since: L,
    /// Until they part.
    pub left: L,
}

impl Timing {
    /// As the deck has them.
    pub fn new(pair: &Pair<'_>) -> Timing {
        Timing { centred: pair.on("centredDamping"), fraction: pair.on("touchFraction") }
    }

    /// Whether there is anything to do: a set-up evaluation sees the velocities of the step's end already.
    #[inline(always)]
    pub fn acts(&self, call: &Call) -> bool {
        call.update && (self.centred || self.fraction)
    }

    /// Whether the first and last steps are weighted.
    pub fn fraction(&self) -> bool {
        self.fraction
    }

    /// The factor of (T1) for a dashpot γ \[N s/m\] on a mass \[kg\].
    #[inline(always)]
    pub fn centring<L: Lane>(&self, call: &Call, gamma: L, mass: L) -> L {
        let one = L::splat(1.0);
        if self.centred {
            one / (one + gamma * L::splat(0.5 * call.dt) / mass)
        } else {
            one
        }
    }

    /// Where the contact is between its ends, under a normal force `fn_` \[N\].
    #[inline(always)]
    pub fn ends<L: Lane>(&self, call: &Call, x: &Surface<L>, fn_: L, meff: L) -> Ends<L> {
        let (dt, far, zero) = (L::splat(call.dt), L::splat(f64::INFINITY), L::splat(0.0));
        if !self.fraction {
            return Ends { since: far, left: far };
        }
        let after = x.vn + fn_ * dt / meff;
        Ends {
            since: L::select(zero.gt(x.vn), -x.deltan / (x.vn * dt), far),
            left: L::select(after.gt(zero), x.deltan / (after * dt), far),
        }
    }

    /// Normal force of a spring \[N\] and a dashpot γ \[N s/m\]: as it is at the end of the step, and as it acts over it.
    #[inline(always)]
    pub fn normal<L: Lane>(
        &self,
        call: &Call,
        x: &Surface<L>,
        meff: L,
        spring: L,
        gamma: L,
        onset: Onset,
    ) -> (L, L) {
        let factor = self.centring(call, gamma, meff);
        let (spring, dashpot) = (spring * factor, -gamma * x.vn * factor); // (T1)
        let now = spring + dashpot;
        let ends = self.ends(call, x, now, meff);
        let acts = match onset {
            Onset::AtOnce => spring * ends.growing() + dashpot * ends.at_once(),
            // The spring of such a law grows with s^(3/2): the plain sum is better than second order.
            Onset::FourthRoot => spring + dashpot * fourth_root(ends.since) * fourth_root(ends.left),
        };
        (now, acts)
    }
}

impl<L: Lane> Ends<L> {
    /// (T2) at both ends.
    #[inline(always)]
    pub fn growing(&self) -> L {
        growing(self.since) * growing(self.left)
    }

    /// (T3) at both ends.
    #[inline(always)]
    pub fn at_once(&self) -> L {
        at_once(self.since) * at_once(self.left)
    }
}

/// The mass of (T1) sideways \[kg\], of solid spheres of one density.
#[inline(always)]
pub fn turning<L: Lane>(call: &Call, x: &Surface<L>, meff: L) -> L {
    let half = L::splat(0.5) * x.deltan;
    let (ri, rj) = (x.cri + half, x.crj + half);
    let square = |a: L| a * a;
    let mut lever = square(x.cri / ri);
    if !call.is_wall {
        let (mi, mj) = (ri * square(ri), rj * square(rj));
        lever = (mj * lever + mi * square(x.crj / rj)) / (mi + mj);
    }
    meff / (L::splat(1.0) + L::splat(2.5) * lever)
}

/// (T2).
#[inline(always)]
pub fn growing<L: Lane>(s: L) -> L {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    L::select(one.gt(s), half + half * s, one)
}

/// (T3).
#[inline(always)]
pub fn at_once<L: Lane>(s: L) -> L {
    let (one, two, half) = (L::splat(1.0), L::splat(2.0), L::splat(0.5));
    let second = L::select(two.gt(s), two - half * s, one);
    L::select(one.gt(s), L::splat(1.5) * s, second)
}

/// 1 − ζ(−1/4).
const FIRST: f64 = 1.320_451_264_220;
/// Of the series, C = 1/48 and D = −7/15360 as they are; A and B join the pieces at s = 1 and s = 2.
const SERIES: [f64; 4] = [0.5001442860276666, 0.7999293740256668, 1.0 / 48.0, -7.0 / 15360.0];

/// (T4).
#[inline(always)]
fn fourth_root<L: Lane>(s: L) -> L {
    let [a, b, c, d] = SERIES.map(L::splat);
    let (one, two, first) = (L::splat(1.0), L::splat(2.0), L::splat(FIRST));
    let second = a + b * s + c / s + d / (s * s * s) - first * (s - one) * (one - one / s).sqrt().sqrt();
    L::select(one.gt(s), first * s, L::select(two.gt(s), second, one))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Weighted samples of s^p at `s`, `s + 1`, … up to a far end, less the integral: zero for the right weights.
    fn excess(weight: fn(f64) -> f64, p: f64, s: f64) -> f64 {
        let n = 2000;
        let sum: f64 = (0..n).map(|k| s + f64::from(k)).map(|t| weight(t) * t.powf(p)).sum();
        // The far end by the trapezoidal rule with its first correction.
        let end = s + f64::from(n - 1);
        let integral = end.powf(p + 1.0) / (p + 1.0);
        sum - 0.5 * end.powf(p) - integral - p * end.powf(p - 1.0) / 12.0
    }

    #[test]
    fn weighted_samples_sum_to_the_integral() {
        for k in 1..=100 {
            let s = f64::from(k) / 100.0;
            assert!(excess(at_once, 0.0, s).abs() < 1e-10, "{s}");
            // The trapezoidal rule is exact for a straight line: what was taken off at the far end remains. Round-off.
            assert!((excess(growing, 1.0, s) + 1.0 / 12.0).abs() < 1e-6, "{s}");
            // The next term of the asymptotic series.
            assert!(excess(fourth_root, 0.25, s).abs() < 1e-3, "{s}: {}", excess(fourth_root, 0.25, s));
            assert!(excess(|_| 1.0, 0.25, s).abs() > 1e-3 || (0.4..0.6).contains(&s), "{s}");
        }
    }

    #[test]
    fn no_weight_jumps() {
        for weight in [growing, at_once, fourth_root] {
            for s in [1.0f64, 2.0] {
                approx::assert_relative_eq!(
                    weight(s * (1.0 - 1e-12)),
                    weight(s * (1.0 + 1e-12)),
                    epsilon = 1e-8
                );
            }
        }
    }
}
