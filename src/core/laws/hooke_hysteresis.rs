//! Luding's piecewise-linear elasto-plastic adhesive law.
//!
//! Loading follows a soft line kn, unloading and reloading a stiffer one k2 that grows with the largest overlap δmax
//! up to a plastic limit; on the way out the contact adheres along −kc δ.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | δ, δmax | m | overlap, largest overlap so far (history) |
//! | v_n | m/s | normal relative velocity, negative while approaching |
//! | kn, k2, k2max, kc | N/m | loading, unloading, stiffest unloading, adhesion |
//! | φF | 1 | plasticity depth |
//!
//! Equation numbers are those of the formula sheet for LIGGGHTS's law (Open DEM Japan, 2025):
//! - (1) `kn = 16/15 √R* E* (15 m* vc²/(16 √R* E*))^(1/5)`
//! - (2) `δlim = k2max/(k2max − kn) · φF · 2R*`, (3) `k2max = kn · coefficientMaxElasticStiffness`
//! - (4) `k2 = kn + (k2max − kn) δmax/δlim` below δlim, else `k2max`; (5) `kc = kn · coefficientAdhesionStiffness`
//! - (6) `Fhys = min(kn δ, max(F2, −kc δ))`
//! - (7) `F2 = k2 (δ − δmax) + kn δmax` below δlim
//! - (8) `γn = sqrt(4 m* kn/(1 + (π/ln e)²))`, `γt = γn` or 0; (9) `Fdamp = −γn v_n`
//! - (10) `Fn = Fhys + Fdamp`; `limitForce on`: `max(Fn, 0)`
//!
//! `centredDamping`, `touchFraction`: see [`super::timing`].
//!
//! Departures from the sheet, all as LIGGGHTS's header has it:
//! - (7′) for δmax ≥ δlim the line refers to δlim, `F2 = k2max (δ − δlim) + kn δlim`, and the cap kn δ no longer holds;
//!   (7) taken literally gives 1/2.29 of the force at k2max/kn = 5, δ = 1.6 δlim.
//! - (6′) on the adhesive line `δmax ← ½ (δ + sqrt(δ² + 4 (kn+kc) δ δlim/(k2max − kn)))`, which the sheet mentions and
//!   does not give: the unloading line through the present point.
//!
//! Departures from LIGGGHTS: `coefficientMaxElasticStiffness = 1` is a linear spring (δlim infinite), where LIGGGHTS
//! divides 0 by 0 in (6′) and, for φF = 0, in (2). `limitForce` works under our own name; LIGGGHTS reads and ignores
//! it, and so does this law where it has taken over the stock name.
use super::dashpot::{Dashpot, Linear, Restitution};
use super::normal::{Normal, Switches};
use super::prop;
use super::timing::Onset;
use crate::lane::{Lane, Lanes};
use crate::model::*;
use std::f64::consts::PI;
use std::marker::PhantomData;

/// The law; `D` is what its dashpot goes by.
pub struct HookeHysteresis<D = Restitution>(PhantomData<D>);

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    linear: Linear,
    k2max_over_kn: f64,
    kc_over_kn: f64,
    phi_f: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L, D> {
    kn: L,
    k2max: L,
    kc: L,
    /// δlim \[m\]; infinite for k2max = kn.
    delta_lim: L,
    meff: L,
    dashpot: D,
    switches: Switches,
}

const EXCEPTIONS: &[Exception] = &[
    Exception {
        rule: Rule::QueryLeavesHistory,
        why: "LIGGGHTS raises δmax in set-up evaluations and queries too; without it the same deck gives other forces",
    },
    Exception {
        rule: Rule::DampingOdd,
        why: "with viscous on, LIGGGHTS's signed Stokes number damps approach and rebound differently",
    },
];

impl<D: Dashpot> Parameters for Params<f64, D> {
    type Coeffs = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        Ok(Coeffs {
            linear: Linear::new(p),
            k2max_over_kn: p.get("coefficientMaxElasticStiffness"),
            kc_over_kn: p.get("coefficientAdhesionStiffness"),
            phi_f: p.get("coefficientPlasticityDepth"),
        })
    }

    fn new(c: &Coeffs, size: &Size) -> Params<f64, D> {
        let (spring, dashpot) = c.linear.between(size, damping); // (1), (8)
        let (kn, reff) = (spring / c.linear.nktv2p, size.reff());
        let k2max = kn * c.k2max_over_kn; // (3)
        let delta_lim = if k2max > kn { k2max / (k2max - kn) * c.phi_f * 2.0 * reff } else { f64::INFINITY }; // (2)
        let kc = kn * c.kc_over_kn; // (5)
        Params { kn, k2max, kc, delta_lim, meff: size.meff, dashpot, switches: c.linear.switches }
    }
}

impl<D: Dashpot> Law for HookeHysteresis<D> {
    type Params = Params<f64, D>;
    type History = [f64; 1];
    const META: Meta = Meta {
        props: &[
            prop::YOUNG,
            prop::POISSON,
            prop::CHARACTERISTIC_VELOCITY,
            prop::RESTITUTION.needed(Need::Unless("viscous", "on")),
            prop::FLUID_VISCOSITY,
            prop::MAXIMUM_RESTITUTION,
            prop::CRITICAL_STOKES,
            prop::MAX_STIFFNESS,
            prop::ADHESION_STIFFNESS,
            prop::PLASTICITY_DEPTH,
        ],
        settings: &[
            prop::VISCOUS,
            prop::VISCOUS_ABS,
            prop::TANGENTIAL_DAMPING,
            prop::LIMIT_FORCE,
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
        ],
        slots: &[Slot::even("deltaMax", Unit::M)],
        stress_strain_exponent: 1.0, // (11)
        references: &[
            "S. Luding, Granular Matter 10 (2008) 235, doi:10.1007/s10035-008-0099-x",
            "formula sheet for normal_model_hooke_hysteresis.h, Open DEM Japan (2025)",
        ],
        exceptions: EXCEPTIONS,
        ..Meta::new(
            Kind::Normal,
            "hooke/hysteresis",
            "piecewise-linear elasto-plastic adhesive spring with dashpot",
        )
    };
    const LIGGGHTS: Binding = Binding {
        own_settings: &["viscousAbs", "centredDamping", "touchFraction"],
        ignored: &["limitForce"],
        refused: &[
            prop::refused("ktToKnUser", "LIGGGHTS reads it and ignores it for this law"),
            prop::refused("heating_normal_hooke", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        ..Binding::new(50, Some(2))
    };

    #[inline(always)]
    fn intersect<L: Lane>(
        p: &Params<L, D::Of<L>>,
        call: &Call,
        x: &Surface<L>,
        [delta_max]: &mut [L; 1],
        s: &mut Response<L>,
    ) {
        let spring = hysteresis(p, call, x.deltan, delta_max);
        let gamman = D::gamma(&p.dashpot, x.vn, damping); // (8)
        let (stiffness, damping) = ((p.kn, p.kn), (gamman, p.switches.tangential(|| gamman)));
        let normal = Normal { spring, stiffness, damping, meff: p.meff, onset: Onset::AtOnce };
        p.switches.push(&normal, call, x, s); // (9), (10)
    }

    fn observe(p: &Params<f64, D>, x: &Contact, h: &[f64; 1]) -> Observation {
        let Surface { deltan: delta, vn, .. } = x.surface;
        let delta_max = delta.max(h[0]);
        let (force, branch) = force_and_branch(p, delta, delta_max);
        let k2 = unloading(p, delta_max);
        let (name, stiffness) = match branch {
            Branch::Load if delta_max < p.delta_lim => ("loading", p.kn),
            Branch::Adhesive => ("adhesive", -p.kc),
            _ => ("unloading", k2),
        };
        let damping = D::gamma(&p.dashpot, vn, damping);
        Observation {
            branch: name,
            stiffness,
            damping,
            // What comes back along k2 until the force vanishes.
            stored: if force > 0.0 && k2 > 0.0 { 0.5 * force * force / k2 } else { 0.0 },
            dissipated: damping * vn * vn,
            load: if delta_max > 0.0 { delta_max / p.delta_lim } else { 0.0 },
        }
    }
}

/// (8); 1/∞ = 0 for e = 1.
#[inline(always)]
fn damping<L: Lane>(meff: L, kn: L, log_e: L) -> L {
    let (one, pi) = (L::splat(1.0), L::splat(PI));
    (L::splat(4.0) * meff * kn / (one + (pi / log_e) * (pi / log_e))).sqrt()
}

/// (6): the force of the spring, with δmax moved on.
#[inline(always)]
fn hysteresis<L: Lane, D>(p: &Params<L, D>, call: &Call, delta: L, delta_max: &mut L) -> L {
    *delta_max = L::select(delta.gt(*delta_max), delta, *delta_max);
    let largest = *delta_max;
    let plastic = largest.ge(p.delta_lim);
    let range = p.k2max - p.kn;
    let beyond = p.k2max * (delta - p.delta_lim) + p.kn * p.delta_lim; // (7′)
    let below = (p.kn + range * largest / p.delta_lim) * (delta - largest) + p.kn * largest; // (4), (7)
    let (load, adhesive) = (p.kn * delta, -p.kc * delta);
    let loading = !plastic & below.ge(load);
    let unloading = (plastic & beyond.ge(adhesive)) | (!plastic & below.gt(adhesive));
    let line = L::select(plastic, beyond, below);
    let adheres = !(loading | unloading) & range.gt(L::splat(0.0));
    if call.update && L::any(adheres) {
        let root = (delta * delta + L::splat(4.0) * ((p.kn + p.kc) * delta * p.delta_lim / range)).sqrt();
        *delta_max = L::select(adheres, L::splat(0.5) * (delta + root), largest);
        // (6′)
    }
    L::select(loading, load, L::select(unloading, line, adhesive))
}

/// (4).
fn unloading<D>(p: &Params<f64, D>, delta_max: f64) -> f64 {
    if delta_max >= p.delta_lim {
        p.k2max
    } else {
        p.kn + (p.k2max - p.kn) * delta_max / p.delta_lim
    }
}

enum Branch {
    Load,
    Unload,
    Adhesive,
}

/// The force \[N\] and the branch that holds, for `observe`.
fn force_and_branch<D>(p: &Params<f64, D>, delta: f64, delta_max: f64) -> (f64, Branch) {
    let plastic = delta_max >= p.delta_lim;
    let at = if plastic { p.delta_lim } else { delta_max };
    let line = unloading(p, delta_max) * (delta - at) + p.kn * at;
    match () {
        _ if !plastic && line >= p.kn * delta => (p.kn * delta, Branch::Load),
        _ if line > -p.kc * delta => (line, Branch::Unload),
        _ => (-p.kc * delta, Branch::Adhesive),
    }
}
