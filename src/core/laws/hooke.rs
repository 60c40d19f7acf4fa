//! Linear spring and dashpot.
//!
//! The spring is as stiff as makes it as deep as a Hertz contact at the characteristic velocity, so it depends on
//! sizes and masses but not on the overlap.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | δ, v_n | m, m/s | overlap, normal relative velocity (negative while approaching) |
//! | E*, R*, m* | Pa, m, kg | effective modulus, radius, mass |
//!
//! - (E1) `kn = 16/15 √R* E* (15 m* vc²/(16 √R* E*))^(1/5)`, `kt = kn`; `ktToKnUser on`: `kt = 2/7 kn`
//! - (E2) `γn = sqrt(4 m* kn ln²e/(ln²e + π²))`; `γt = γn`, or 0 with `tangential_damping off`
//! - (E3) `Fn = kn δ − γn v_n`; `limitForce on`: `max(Fn, 0)`
//!
//! `centredDamping`, `touchFraction`: see [`super::timing`].
//!
//! Limits: the dashpot makes the force jump to `γn |v_n|` at first touch and attract at the end of the rebound.
//!
//! Departure: with `viscous on` LIGGGHTS divides infinity by infinity at v_n = 0 and gets NaN; here the limit
//! `γn = sqrt(4 m* kn)` holds.
use super::dashpot::{Dashpot, Linear, Restitution};
use super::normal::{Normal, Switches};
use super::prop;
use super::timing::Onset;
use crate::lane::{Lane, Lanes};
use crate::model::*;
use std::f64::consts::PI;
use std::marker::PhantomData;

/// The law; `D` is what its dashpot goes by.
pub struct Hooke<D = Restitution>(PhantomData<D>);

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    linear: Linear,
    kt_over_kn: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L, D> {
    /// kn and kt \[N/m\].
    kn: L,
    kt: L,
    meff: L,
    dashpot: D,
    switches: Switches,
}

/// (E2) for `ln e`; the limit for an infinite one.
#[inline(always)]
fn damping<L: Lane>(meff: L, kn: L, log_e: L) -> L {
    let (four, square) = (L::splat(4.0), log_e * log_e);
    let infinite = square.ge(L::splat(f64::INFINITY));
    let gamma = four * meff * kn * square / (square + L::splat(PI * PI));
    L::select(infinite, four * meff * kn, gamma).sqrt()
}

impl<D: Dashpot> Parameters for Params<f64, D> {
    type Coeffs = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        // The seven-digit 2/7 is LIGGGHTS's.
        let kt_over_kn = if p.on("ktToKnUser") { 0.285714286 } else { 1.0 };
        Ok(Coeffs { linear: Linear::new(p), kt_over_kn })
    }

    fn new(c: &Coeffs, size: &Size) -> Params<f64, D> {
        let Coeffs { linear, kt_over_kn } = c;
        let (spring, dashpot) = linear.between(size, damping); // (E1), (E2)
        let (kn, kt) = (spring / linear.nktv2p, spring * kt_over_kn / linear.nktv2p);
        Params { kn, kt, meff: size.meff, dashpot, switches: linear.switches }
    }
}

impl<D: Dashpot> Law for Hooke<D> {
    type Params = Params<f64, D>;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[
            prop::YOUNG,
            prop::POISSON,
            prop::CHARACTERISTIC_VELOCITY,
            prop::RESTITUTION.needed(Need::Unless("viscous", "on")),
            prop::FLUID_VISCOSITY,
            prop::MAXIMUM_RESTITUTION,
            prop::CRITICAL_STOKES,
        ],
        settings: &[
            prop::VISCOUS,
            prop::VISCOUS_ABS,
            prop::TANGENTIAL_DAMPING,
            prop::LIMIT_FORCE,
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
            Setting::off("ktToKnUser", "tangential stiffness 2/7 of the normal one"),
        ],
        stress_strain_exponent: 1.0,
        references: &["P.A. Cundall, O.D.L. Strack, Géotechnique 29 (1979) 47"],
        exceptions: &[
            Exception {
                rule: Rule::DampingOdd,
                why: "with viscous on, LIGGGHTS's signed Stokes number damps approach and rebound differently",
            },
            Exception {
                rule: Rule::CycleDissipates,
                why: "with viscous and centredDamping on, a prescribed motion is damped more one way than the other, and a share of the spring force goes with the damping",
            },
        ],
        ..Meta::new(Kind::Normal, "hooke", "linear spring and dashpot")
    };
    const LIGGGHTS: Binding = Binding {
        own_settings: &["viscousAbs", "centredDamping", "touchFraction"],
        refused: &[
            prop::refused("heating_normal_hooke", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        // LIGGGHTS sets the flag where it would be expected to clear it.
        contact_flags: [ContactFlag::Set, ContactFlag::Set],
        ..Binding::new(48, Some(0))
    };

    #[inline(always)]
    fn intersect<L: Lane>(
        p: &Params<L, D::Of<L>>,
        call: &Call,
        x: &Surface<L>,
        _: &mut [L; 0],
        s: &mut Response<L>,
    ) {
        let gamman = D::gamma(&p.dashpot, x.vn, damping); // (E2)
        let damping = (gamman, p.switches.tangential(|| gamman));
        let (spring, stiffness) = (p.kn * x.deltan, (p.kn, p.kt));
        let normal = Normal { spring, stiffness, damping, meff: p.meff, onset: Onset::AtOnce };
        p.switches.push(&normal, call, x, s); // (E3)
    }

    fn observe(p: &Params<f64, D>, x: &Contact, _: &[f64; 0]) -> Observation {
        let Surface { deltan, vn, .. } = x.surface;
        let damping = D::gamma(&p.dashpot, vn, damping);
        let (stored, dissipated) = (0.5 * p.kn * deltan * deltan, damping * vn * vn);
        Observation { branch: "spring", stiffness: p.kn, damping, stored, dissipated, load: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_dashpot_for_a_restitution_of_one() {
        assert_eq!(damping(1e-3, 1e4, 1.0f64.ln()), 0.0);
    }

    #[test]
    fn the_dashpot_is_critical_in_the_viscous_limit() {
        let (m, k) = (1e-3, 1e4);
        approx::assert_relative_eq!(damping(m, k, 1e9), damping(m, k, f64::INFINITY), max_relative = 1e-15);
    }
}
