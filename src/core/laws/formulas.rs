//! What several laws share. Operations stand in LIGGGHTS's order, so that the same numbers come out to the last bit.
use crate::lane::{dot, each, Lane};
use crate::law::{Call, Pair, Size, Surface};
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
#[derive(Clone, Copy, Debug)]
pub struct ConstantTorque<L = f64> {
    mu: L,
    reff: L,
}

impl ConstantTorque {
    /// From μr and the sizes.
    pub fn new(mu: f64, size: &Size) -> ConstantTorque {
        ConstantTorque { mu, reff: size.reff() }
    }

    /// One per lane.
    #[inline(always)]
    pub fn side_by_side<L: Lane>(of: impl Fn(usize) -> ConstantTorque) -> ConstantTorque<L> {
        ConstantTorque { mu: L::from_fn(|k| of(k).mu), reff: L::from_fn(|k| of(k).reff) }
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

/// `limitForce`: a normal force \[N\] as it is now and as it acts over the step, neither attracting.
#[inline(always)]
pub fn not_below_zero<L: Lane>(now: L, acts: L) -> (L, L) {
    let zero = L::splat(0.0);
    let attracts = zero.gt(now);
    (L::select(attracts, zero, now), L::select(attracts | zero.gt(acts), zero, acts))
}

/// What `viscous on` needs to turn a normal velocity into ln e.
#[derive(Clone, Copy, Debug)]
pub struct Viscous {
    mu: f64,
    log_e_max: f64,
    stokes_critical: f64,
    abs: bool,
}

impl Viscous {
    /// The coefficients of a type pair, if the setting is on.
    pub fn new(pair: &Pair<'_>) -> Option<Viscous> {
        pair.on("viscous").then(|| Viscous {
            mu: pair.get("FluidViscosity"),
            log_e_max: pair.get("MaximumRestitution").ln(),
            stokes_critical: pair.get("CriticalStokes"),
            abs: pair.on("viscousAbs"),
        })
    }

    /// `ln e = ln e_max + St_c/St` with `St = m* v_n/(6π μ_f R*²)` (Legendre et al. 2006, Schmeeckle et al. 2001).
    /// Infinite at v_n = 0. Signed as LIGGGHTS has it, unless `viscousAbs on`.
    pub fn log_restitution(&self, size: &Size, vn: f64) -> f64 {
        let reff = size.reff();
        let stokes = size.meff * vn / (6.0 * PI * self.mu * reff * reff);
        let stokes = if self.abs { stokes.abs() } else { stokes };
        self.log_e_max + self.stokes_critical / stokes
    }
}

/// The dashpot of a linear spring: fixed by the coefficient of restitution, or by the velocity with `viscous on`.
#[derive(Clone, Copy, Debug)]
pub struct Damper {
    gamman: f64,
    tangential: bool,
    moving: Option<(Viscous, Size, f64)>,
    law: DampingLaw,
}

/// Damping coefficient \[N s/m\] from m* \[kg\], kn \[N/m\] and ln e.
pub type DampingLaw = fn(f64, f64, f64) -> f64;

impl Damper {
    /// For a spring `kn` between two sizes. `log_e` is not read with `viscous on`.
    pub fn new(
        law: DampingLaw,
        size: &Size,
        kn: f64,
        log_e: f64,
        viscous: Option<Viscous>,
        tangential: bool,
    ) -> Damper {
        let gamman = if viscous.is_some() { 0.0 } else { law(size.meff, kn, log_e) };
        Damper { gamman, tangential, moving: viscous.map(|v| (v, *size, kn)), law }
    }

    /// Whether the velocity decides.
    pub fn follows_speed(&self) -> bool {
        self.moving.is_some()
    }

    /// γn and γt \[N s/m\] at a normal velocity \[m/s\].
    #[inline]
    pub fn at(&self, vn: f64) -> (f64, f64) {
        let gamman = match &self.moving {
            None => self.gamman,
            Some((v, size, kn)) => (self.law)(size.meff, *kn, v.log_restitution(size, vn)),
        };
        (gamman, if self.tangential { gamman } else { 0.0 })
    }
}
