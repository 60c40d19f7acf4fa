//! What several laws share. Operations stand in LIGGGHTS's order, so that the same numbers come out to the last bit.
use crate::lane::{dot, each, Lane, Lanes};
use crate::model::{Call, Pair, Response, Size, Surface};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Effective Young's modulus E* \[Pa\]: `1/E* = (1−νi²)/Ei + (1−νj²)/Ej`.
pub fn effective_young(pair: &Pair<'_>) -> f64 {
    let ((ei, ej), (ni, nj)) = (pair.both("youngsModulus"), pair.both("poissonsRatio"));
    1.0 / ((1.0 - ni * ni) / ei + (1.0 - nj * nj) / ej)
}

/// Effective shear modulus G* \[Pa\]: `1/G* = 2(2−νi)(1+νi)/Ei + 2(2−νj)(1+νj)/Ej`.
pub fn effective_shear(pair: &Pair<'_>) -> f64 {
    let ((ei, ej), (ni, nj)) = (pair.both("youngsModulus"), pair.both("poissonsRatio"));
    1.0 / (2.0 * (2.0 - ni) * (1.0 + ni) / ei + 2.0 * (2.0 - nj) * (1.0 + nj) / ej)
}

/// Stiffness of the linear spring \[N/m\] that is as deep as a Hertz contact at the characteristic velocity vc \[m/s\]:
/// `16/15 √R* E* (15 m* vc² / (16 √R* E*))^(1/5)`.
pub fn hooke_stiffness(yeff: f64, reff: f64, meff: f64, vc: f64) -> f64 {
    let root = reff.sqrt();
    16.0 / 15.0 * root * yeff * (15.0 * meff * vc * vc / (16.0 * root * yeff)).powf(0.2)
}

/// Contact radius \[m\] of two adhesive spheres without load, from the work of adhesion W \[J/m²\], R* \[m\] and E* \[Pa\]:
/// `(9π W R*² / (2E*))^(1/3)` (Johnson, Kendall, Roberts 1971).
pub fn jkr_radius(work: f64, reff: f64, yeff: f64) -> f64 {
    (9.0 * PI * work * reff * reff / (2.0 * yeff)).powf(1.0 / 3.0)
}

/// A resistance of constant size `μr kn δ R*` \[N m\] against turning.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct ConstantTorque<L = f64> {
    mu: L,
    reff: L,
}

impl ConstantTorque {
    /// From μr and the sizes.
    pub fn new(mu: f64, size: &Size) -> ConstantTorque {
        ConstantTorque { mu, reff: size.reff() }
    }
}

impl<L: Lane> ConstantTorque<L> {
    /// Its size \[N m\].
    #[inline(always)]
    pub fn size(&self, x: &Surface<L>, kn: L) -> L {
        self.mu * kn * x.deltan * self.reff
    }

    /// The torque along an axis of this length.
    #[inline(always)]
    pub fn along(&self, axis: &Vector3<L>, length: L, call: &Call, x: &Surface<L>, kn: L) -> Vector3<L> {
        // LIGGGHTS multiplies in another order on a wall.
        if call.is_wall {
            let size = self.mu * (x.deltan * kn);
            each(axis, |a| size * a / length * self.reff)
        } else {
            axis * (self.size(x, kn) / length)
        }
    }
}

/// A vector without its part along the unit normal.
#[inline(always)]
pub fn without_normal<L: Lane>(v: Vector3<L>, en: &Vector3<L>) -> Vector3<L> {
    v - en * dot(&v, en)
}

/// Hand a torque against turning to both bodies.
#[inline(always)]
pub fn resist<L: Lane>(s: &mut Response<L>, torque: &Vector3<L>) {
    s.torque_i -= torque;
    s.torque_j += torque;
}
