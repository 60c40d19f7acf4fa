//! Units, and the values that a quantity may take.
use std::fmt;

/// A unit with the powers of its dimensions, so that a law can be tested in other units than it was written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// How it is written.
    pub label: &'static str,
    /// Twice the power of length, as √δ brings half powers.
    pub m2: i8,
    /// Power of mass.
    pub kg: i8,
    /// Power of time.
    pub s: i8,
}

impl Unit {
    /// A pure number.
    pub const ONE: Unit = Unit { label: "1", m2: 0, kg: 0, s: 0 };
    /// Length.
    pub const M: Unit = Unit { label: "m", m2: 2, kg: 0, s: 0 };
    /// Velocity.
    pub const M_PER_S: Unit = Unit { label: "m/s", m2: 2, kg: 0, s: -1 };
    /// Stress, modulus.
    pub const PA: Unit = Unit { label: "Pa", m2: -2, kg: 1, s: -2 };
    /// Energy per area.
    pub const J_PER_M2: Unit = Unit { label: "J/m²", m2: 0, kg: 1, s: -2 };
    /// Dynamic viscosity.
    pub const PA_S: Unit = Unit { label: "Pa s", m2: -2, kg: 1, s: -1 };
    /// Angle.
    pub const RAD: Unit = Unit { label: "rad", m2: 0, kg: 0, s: 0 };
    /// Force.
    pub const N: Unit = Unit { label: "N", m2: 2, kg: 1, s: -2 };
    /// Stiffness.
    pub const N_PER_M: Unit = Unit { label: "N/m", m2: 0, kg: 1, s: -2 };
    /// Stiffness per area.
    pub const N_PER_M3: Unit = Unit { label: "N/m³", m2: -4, kg: 1, s: -2 };
    /// Stiffness per area of a force that grows as √δ.
    pub const N_PER_M2_5: Unit = Unit { label: "N/m^2.5", m2: -3, kg: 1, s: -2 };
}

/// The values that a property may take; outside, the set-up is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
    /// Whether `lo` itself is outside.
    pub open_lo: bool,
    /// Whether `hi` itself is outside.
    pub open_hi: bool,
}

impl Range {
    /// `[lo, ∞)`.
    pub const fn at_least(lo: f64) -> Range {
        Range { lo, hi: f64::INFINITY, open_lo: false, open_hi: true }
    }
    /// `(lo, ∞)`.
    pub const fn above(lo: f64) -> Range {
        Range { lo, hi: f64::INFINITY, open_lo: true, open_hi: true }
    }
    /// `[lo, hi]`.
    pub const fn within(lo: f64, hi: f64) -> Range {
        Range { lo, hi, open_lo: false, open_hi: false }
    }
    /// `(lo, hi]`.
    pub const fn above_to(lo: f64, hi: f64) -> Range {
        Range { lo, hi, open_lo: true, open_hi: false }
    }
    /// Whether `x` is allowed; NaN and infinities never are.
    pub fn contains(&self, x: f64) -> bool {
        let low = if self.open_lo { x > self.lo } else { x >= self.lo };
        let high = if self.open_hi { x < self.hi } else { x <= self.hi };
        x.is_finite() && low && high
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.lo.is_finite(), self.hi.is_finite()) {
            (true, false) => write!(f, "{} {}", if self.open_lo { "above" } else { "at least" }, self.lo),
            _ => {
                let (l, r) = (if self.open_lo { '(' } else { '[' }, if self.open_hi { ')' } else { ']' });
                write!(f, "within {l}{}, {}{r}", self.lo, self.hi)
            }
        }
    }
}
