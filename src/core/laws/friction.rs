//! What the friction laws share.
use super::timing::Timing;
use crate::lane::{cross, Lane, Lanes};
use crate::model::{LawError, Pair, Parameters, Response, Size, Surface};
use nalgebra::Vector3;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    mu: f64,
    timing: Timing,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L = f64> {
    /// Coefficient of friction.
    pub mu: L,
    /// Effective mass m* \[kg\].
    pub meff: L,
    /// See [`super::timing`].
    pub timing: Timing,
}

impl Parameters for Params {
    type Coeffs = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        Ok(Coeffs { mu: p.get("coefficientFriction"), timing: Timing::new(p) })
    }

    fn new(c: &Coeffs, size: &Size) -> Params {
        Params { mu: c.mu, meff: size.meff, timing: c.timing }
    }
}

/// Hand out a tangential force: torque on either side is lever × force.
#[inline(always)]
pub fn push<L: Lane>(x: &Surface<L>, s: &mut Response<L>, force: Vector3<L>) {
    let turn = cross(&x.en, &force);
    s.force += force;
    s.torque_i += turn * -x.cri;
    s.torque_j += turn * -x.crj;
}
