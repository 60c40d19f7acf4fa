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
use super::formulas::{effective_young, hooke_stiffness, not_below_zero, Damper, Viscous};
use super::prop;
use super::timing::{Onset, Timing};
use crate::lane::Lane;
use crate::law::*;
use std::f64::consts::PI;

/// The law.
pub struct Hooke;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    yeff: f64,
    vc: f64,
    log_e: f64,
    viscous: Option<Viscous>,
    kt_over_kn: f64,
    tangential_damping: bool,
    limit_force: bool,
    timing: Timing,
    nktv2p: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug)]
pub struct Fit<L = f64> {
    /// kn and kt \[N/m\].
    kn: L,
    kt: L,
    /// γn and γt \[N s/m\].
    gamman: L,
    gammat: L,
    meff: L,
    limit_force: bool,
    timing: Timing,
}

/// A fit whose dashpot still waits for the velocity.
#[derive(Clone, Copy, Debug)]
pub struct Fitted {
    fit: Fit,
    damper: Damper,
}

/// (E2) for `ln e`; the limit for an infinite one.
fn damping(meff: f64, kn: f64, log_e: f64) -> f64 {
    if log_e.is_infinite() {
        return (4.0 * meff * kn).sqrt();
    }
    let square = log_e * log_e;
    (4.0 * meff * kn * square / (square + PI * PI)).sqrt()
}

impl Law for Hooke {
    const META: Meta = Meta {
        kind: Kind::Normal,
        keyword: "hooke",
        id: 48,
        stock_id: Some(0),
        summary: "linear spring and dashpot",
        props: &[
            prop::YOUNG,
            prop::POISSON,
            prop::CHARACTERISTIC_VELOCITY,
            Prop { need: Need::Unless("viscous", "on"), ..prop::RESTITUTION },
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
            Setting::off("ktToKnUser", Support::Full, "tangential stiffness 2/7 of the normal one"),
            prop::refused("heating_normal_hooke", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        atoms: &[],
        slots: &[],
        stress_strain_exponent: 1.0,
        reach: Reach::Overlap,
        anchors: false,
        bonds: None,
        coarse_graining: false,
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
    };
    type History = [f64; 0];
    type Coeffs = Coeffs;
    type Fit = Fitted;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let viscous = Viscous::new(p);
        Ok(Coeffs {
            yeff: effective_young(p),
            vc: p.get("characteristicVelocity"),
            log_e: if viscous.is_some() { 0.0 } else { p.get("coefficientRestitution").ln() },
            viscous,
            // The seven-digit 2/7 is LIGGGHTS's.
            kt_over_kn: if p.on("ktToKnUser") { 0.285714286 } else { 1.0 },
            tangential_damping: p.on("tangential_damping"),
            limit_force: p.on("limitForce"),
            timing: Timing::new(p),
            nktv2p: p.nktv2p(),
        })
    }

    fn fit(c: &Coeffs, size: &Size) -> Fitted {
        let kn = hooke_stiffness(c.yeff, size.reff(), size.meff, c.vc); // (E1)
        let damper = Damper::new(damping, size, kn, c.log_e, c.viscous, c.tangential_damping);
        let (k, kt) = (kn / c.nktv2p, kn * c.kt_over_kn / c.nktv2p);
        let Coeffs { limit_force, timing, .. } = *c;
        let fit = Fit { kn: k, kt, gamman: 0.0, gammat: 0.0, meff: size.meff, limit_force, timing };
        Fitted { fit, damper }
    }

    fn touch(f: &Fitted, x: &Contact, h: &mut [f64; 0], s: &mut Stage) {
        Self::touch_lanes(&Self::fit_at(f, x.surface.vn), &x.gap.call, &x.surface, h, s);
    }

    fn apart(_: &mut [f64; 0], s: &mut Stage) {
        s.mark = Mark::Set; // As LIGGGHTS, which sets the flag where it would be expected to clear it.
    }

    fn observe(f: &Self::Fit, x: &Contact, _: &[f64; 0]) -> Terms {
        let fit = Self::fit_at(f, x.surface.vn);
        Terms {
            branch: "spring",
            stiffness: fit.kn,
            damping: fit.gamman,
            stored: 0.5 * fit.kn * x.surface.deltan * x.surface.deltan,
            dissipated: fit.gamman * x.surface.vn * x.surface.vn,
            load: 0.0,
        }
    }
}

impl LaneLaw for Hooke {
    type FitOf<L: Lane> = Fit<L>;
    type HistoryOf<L: Lane> = [L; 0];

    fn follows_speed(f: &Fitted) -> bool {
        f.damper.follows_speed()
    }

    fn fit_at(f: &Fitted, vn: f64) -> Fit {
        let (gamman, gammat) = f.damper.at(vn);
        Fit { gamman, gammat, ..f.fit }
    }

    #[inline(always)]
    fn side_by_side<L: Lane>(f: impl Fn(usize) -> Fit) -> Fit<L> {
        Fit {
            kn: L::from_fn(|k| f(k).kn),
            kt: L::from_fn(|k| f(k).kt),
            gamman: L::from_fn(|k| f(k).gamman),
            gammat: L::from_fn(|k| f(k).gammat),
            meff: L::from_fn(|k| f(k).meff),
            limit_force: f(0).limit_force,
            timing: f(0).timing,
        }
    }

    #[inline(always)]
    fn touch_lanes<L: Lane>(f: &Fit<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Stage<L>) {
        let spring = f.kn * x.deltan;
        let mut fn_ = -f.gamman * x.vn + spring; // (E3)
        let mut acts = fn_;
        if f.timing.acts(call) {
            (fn_, acts) = f.timing.normal(call, x, f.meff, spring, f.gamman, Onset::AtOnce);
        }
        if f.limit_force {
            (fn_, acts) = not_below_zero(fn_, acts);
        }
        (s.fn_, s.kn, s.kt, s.gamman, s.gammat) = (fn_, f.kn, f.kt, f.gamman, f.gammat);
        s.force += x.en * acts;
        s.mark = Mark::Set;
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
