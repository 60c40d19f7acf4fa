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
use super::formulas::{effective_young, hooke_stiffness, not_below_zero, Damper, Viscous};
use super::prop;
use super::timing::{Onset, Timing};
use crate::lane::Lane;
use crate::law::*;
use std::f64::consts::PI;

/// The law.
pub struct HookeHysteresis;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    yeff: f64,
    vc: f64,
    log_e: f64,
    viscous: Option<Viscous>,
    k2max_over_kn: f64,
    kc_over_kn: f64,
    phi_f: f64,
    tangential_damping: bool,
    limit_force: bool,
    timing: Timing,
    nktv2p: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug)]
pub struct Fit<L = f64> {
    kn: L,
    k2max: L,
    kc: L,
    /// δlim \[m\]; infinite for k2max = kn.
    delta_lim: L,
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

impl Law for HookeHysteresis {
    const META: Meta = Meta {
        kind: Kind::Normal,
        keyword: "hooke/hysteresis",
        id: 50,
        stock_id: Some(2),
        summary: "piecewise-linear elasto-plastic adhesive spring with dashpot",
        props: &[
            prop::YOUNG,
            prop::POISSON,
            prop::CHARACTERISTIC_VELOCITY,
            Prop { need: Need::Unless("viscous", "on"), ..prop::RESTITUTION },
            prop::FLUID_VISCOSITY,
            prop::MAXIMUM_RESTITUTION,
            prop::CRITICAL_STOKES,
            Prop {
                name: "coefficientMaxElasticStiffness",
                symbol: "k2max/kn",
                shape: Shape::PerPair,
                unit: Unit::ONE,
                range: Range::at_least(1.0),
                usual: (1.5, 20.0),
                need: Need::Always,
                doc: "stiffest unloading over loading stiffness; 1 is a linear spring",
            },
            Prop {
                name: "coefficientAdhesionStiffness",
                symbol: "kc/kn",
                shape: Shape::PerPair,
                unit: Unit::ONE,
                range: Range::at_least(0.0),
                usual: (0.0, 2.0),
                need: Need::Always,
                doc: "adhesion over loading stiffness",
            },
            Prop {
                name: "coefficientPlasticityDepth",
                symbol: "φF",
                shape: Shape::PerPair,
                unit: Unit::ONE,
                range: Range::at_least(0.0),
                usual: (0.01, 0.5),
                need: Need::Always,
                doc: "plastic depth over the diameter 2R*; 0 unloads along k2max from the start",
            },
        ],
        settings: &[
            prop::VISCOUS,
            prop::VISCOUS_ABS,
            prop::TANGENTIAL_DAMPING,
            Setting { support: Support::StockIgnores, ..prop::LIMIT_FORCE },
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
            prop::refused("ktToKnUser", "LIGGGHTS reads it and ignores it for this law"),
            prop::refused("heating_normal_hooke", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        atoms: &[],
        slots: &[Slot::even("deltaMax", Unit::M)],
        stress_strain_exponent: 1.0, // (11)
        reach: Reach::Overlap,
        anchors: false,
        bonds: None,
        coarse_graining: false,
        references: &[
            "S. Luding, Granular Matter 10 (2008) 235, doi:10.1007/s10035-008-0099-x",
            "formula sheet for normal_model_hooke_hysteresis.h, Open DEM Japan (2025)",
        ],
        exceptions: EXCEPTIONS,
    };
    type History = [f64; 1];
    type Coeffs = Coeffs;
    type Fit = Fitted;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let viscous = Viscous::new(p);
        Ok(Coeffs {
            yeff: effective_young(p),
            vc: p.get("characteristicVelocity"),
            log_e: if viscous.is_some() { 0.0 } else { p.get("coefficientRestitution").ln() },
            viscous,
            k2max_over_kn: p.get("coefficientMaxElasticStiffness"),
            kc_over_kn: p.get("coefficientAdhesionStiffness"),
            phi_f: p.get("coefficientPlasticityDepth"),
            tangential_damping: p.on("tangential_damping"),
            limit_force: p.on("limitForce"),
            timing: Timing::new(p),
            nktv2p: p.nktv2p(),
        })
    }

    fn fit(c: &Coeffs, size: &Size) -> Fitted {
        let reff = size.reff();
        let spring = hooke_stiffness(c.yeff, reff, size.meff, c.vc); // (1)
        let damper = Damper::new(damping, size, spring, c.log_e, c.viscous, c.tangential_damping);
        let kn = spring / c.nktv2p;
        let k2max = kn * c.k2max_over_kn; // (3)
        let delta_lim = if k2max > kn { k2max / (k2max - kn) * c.phi_f * 2.0 * reff } else { f64::INFINITY }; // (2)
        let kc = kn * c.kc_over_kn; // (5)
        let Coeffs { limit_force, timing, .. } = *c;
        let (gamman, gammat, meff) = (0.0, 0.0, size.meff);
        let fit = Fit { kn, k2max, kc, delta_lim, gamman, gammat, meff, limit_force, timing };
        Fitted { fit, damper }
    }

    fn touch(f: &Fitted, x: &Contact, h: &mut [f64; 1], s: &mut Stage) {
        Self::touch_lanes(&Self::fit_at(f, x.surface.vn), &x.gap.call, &x.surface, h, s);
    }

    fn observe(f: &Self::Fit, x: &Contact, h: &[f64; 1]) -> Terms {
        let (fit, delta) = (Self::fit_at(f, x.surface.vn), x.surface.deltan);
        let delta_max = delta.max(h[0]);
        let (force, branch) = spring(&fit, delta, delta_max);
        let k2 = unloading(&fit, delta_max);
        let (name, stiffness) = match branch {
            Branch::Load if delta_max < fit.delta_lim => ("loading", fit.kn),
            Branch::Adhesive => ("adhesive", -fit.kc),
            _ => ("unloading", k2),
        };
        // What comes back along k2 until the force vanishes.
        let stored = if force > 0.0 && k2 > 0.0 { 0.5 * force * force / k2 } else { 0.0 };
        let dissipated = fit.gamman * x.surface.vn * x.surface.vn;
        Terms {
            branch: name,
            stiffness,
            damping: fit.gamman,
            stored,
            dissipated,
            load: if delta_max > 0.0 { delta_max / fit.delta_lim } else { 0.0 },
        }
    }
}

/// (8); 1/∞ = 0 for e = 1.
fn damping(meff: f64, kn: f64, log_e: f64) -> f64 {
    (4.0 * meff * kn / (1.0 + (PI / log_e) * (PI / log_e))).sqrt()
}

/// (4).
fn unloading(f: &Fit, delta_max: f64) -> f64 {
    if delta_max >= f.delta_lim {
        f.k2max
    } else {
        f.kn + (f.k2max - f.kn) * delta_max / f.delta_lim
    }
}

enum Branch {
    Load,
    Unload,
    Adhesive,
}

/// The branch that holds and its force \[N\], for `observe`.
fn spring(f: &Fit, delta: f64, delta_max: f64) -> (f64, Branch) {
    let plastic = delta_max >= f.delta_lim;
    let at = if plastic { f.delta_lim } else { delta_max };
    let line = unloading(f, delta_max) * (delta - at) + f.kn * at;
    match () {
        _ if !plastic && line >= f.kn * delta => (f.kn * delta, Branch::Load),
        _ if line > -f.kc * delta => (line, Branch::Unload),
        _ => (-f.kc * delta, Branch::Adhesive),
    }
}

impl LaneLaw for HookeHysteresis {
    type FitOf<L: Lane> = Fit<L>;
    type HistoryOf<L: Lane> = [L; 1];

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
            k2max: L::from_fn(|k| f(k).k2max),
            kc: L::from_fn(|k| f(k).kc),
            delta_lim: L::from_fn(|k| f(k).delta_lim),
            gamman: L::from_fn(|k| f(k).gamman),
            gammat: L::from_fn(|k| f(k).gammat),
            meff: L::from_fn(|k| f(k).meff),
            limit_force: f(0).limit_force,
            timing: f(0).timing,
        }
    }

    #[inline(always)]
    fn touch_lanes<L: Lane>(f: &Fit<L>, call: &Call, x: &Surface<L>, h: &mut [L; 1], s: &mut Stage<L>) {
        let [delta_max] = h;
        let delta = x.deltan;
        *delta_max = L::select(delta.gt(*delta_max), delta, *delta_max);
        let largest = *delta_max;
        let plastic = largest.ge(f.delta_lim);
        let range = f.k2max - f.kn;
        let beyond = f.k2max * (delta - f.delta_lim) + f.kn * f.delta_lim; // (7′)
        let below = (f.kn + range * largest / f.delta_lim) * (delta - largest) + f.kn * largest; // (4), (7)
        let (load, adhesive) = (f.kn * delta, -f.kc * delta);
        let loading = !plastic & below.ge(load);
        let unloading = (plastic & beyond.ge(adhesive)) | (!plastic & below.gt(adhesive));
        let line = L::select(plastic, beyond, below);
        let elastic = L::select(loading, load, L::select(unloading, line, adhesive)); // (6)
        let adheres = !(loading | unloading) & range.gt(L::splat(0.0));
        if call.update && L::any(adheres) {
            let root = (delta * delta + L::splat(4.0) * ((f.kn + f.kc) * delta * f.delta_lim / range)).sqrt();
            *delta_max = L::select(adheres, L::splat(0.5) * (delta + root), largest);
            // (6′)
        }
        let mut fn_ = elastic + -f.gamman * x.vn; // (9), (10)
        let mut acts = fn_;
        if f.timing.acts(call) {
            (fn_, acts) = f.timing.normal(call, x, f.meff, elastic, f.gamman, Onset::AtOnce);
        }
        if f.limit_force {
            (fn_, acts) = not_below_zero(fn_, acts);
        }
        (s.fn_, s.kn, s.kt, s.gamman, s.gammat) = (fn_, f.kn, f.kn, f.gamman, f.gammat);
        s.force += x.en * acts;
        s.mark = Mark::Set;
    }
}
