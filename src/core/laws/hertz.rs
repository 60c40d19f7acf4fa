//! Hertz contact with a dashpot whose restitution does not depend on the impact speed; Mindlin's tangential stiffness.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | δ, v_n | m, m/s | overlap, normal relative velocity (negative while approaching) |
//! | E*, G*, R*, m* | Pa, Pa, m, kg | effective moduli, radius, mass |
//!
//! - (E1) `Sn = 2 E* √(R*δ)`, `St = 8 G* √(R*δ)`
//! - (E2) `kn = 4/3 E* √(R*δ)`, `kt = St` (secant stiffnesses)
//! - (E3) `β = ln e/√(ln²e + π²)`, `γn = −2 √(5/6) β √(Sn m*)`, `γt = −2 √(5/6) β √(St m*)` or 0
//! - (E4) `Fn = kn δ − γn v_n`; `limitForce on`: `max(Fn, 0)`
//!
//! `centredDamping`, `touchFraction`: see [`super::timing`].
//!
//! Limits: small overlaps of smooth elastic spheres. kt follows the overlap, so a shear history that is loaded at a
//! small overlap and unloaded at a large one returns more work than it took.
use super::formulas::{effective_shear, effective_young, not_below_zero};
use super::prop;
use super::timing::{Onset, Timing};
use crate::lane::Lane;
use crate::law::*;
use std::f64::consts::PI;

/// The law.
pub struct Hertz;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    yeff: f64,
    geff: f64,
    beta: f64,
    tangential_damping: bool,
    limit_force: bool,
    timing: Timing,
    nktv2p: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug)]
pub struct Fit<L = f64> {
    reff: L,
    meff: L,
    yeff: L,
    geff: L,
    beta: L,
    nktv2p: L,
    tangential_damping: bool,
    limit_force: bool,
    timing: Timing,
}

const SQRT_5_6: f64 = 0.912_870_929_175_276_9;

impl Law for Hertz {
    const META: Meta = Meta {
        kind: Kind::Normal,
        keyword: "hertz",
        id: 51,
        stock_id: Some(3),
        summary: "Hertz contact with dashpot, Mindlin tangential stiffness",
        props: &[prop::YOUNG, prop::POISSON, prop::RESTITUTION],
        settings: &[
            prop::TANGENTIAL_DAMPING,
            prop::LIMIT_FORCE,
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
            prop::refused("heating_normal_hertz", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        atoms: &[],
        slots: &[],
        stress_strain_exponent: 1.5,
        reach: Reach::Overlap,
        anchors: false,
        bonds: None,
        coarse_graining: true,
        references: &[
            "H. Hertz, J. reine angew. Math. 92 (1882) 156",
            "Y. Tsuji, T. Tanaka, T. Ishida, Powder Technology 71 (1992) 239",
            "R.D. Mindlin, J. Appl. Mech. 16 (1949) 259",
        ],
        exceptions: &[Exception {
            rule: Rule::CycleDissipates,
            why: "kt follows the overlap, so shear loaded shallow and unloaded deep returns work (with a shear history)",
        }],
    };
    type History = [f64; 0];
    type Coeffs = Coeffs;
    type Fit = Fit;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let log_e = p.get("coefficientRestitution").ln();
        Ok(Coeffs {
            yeff: effective_young(p),
            geff: effective_shear(p),
            beta: log_e / (log_e * log_e + PI * PI).sqrt(),
            tangential_damping: p.on("tangential_damping"),
            limit_force: p.on("limitForce"),
            timing: Timing::new(p),
            nktv2p: p.nktv2p(),
        })
    }

    fn fit(c: &Coeffs, size: &Size) -> Fit {
        Fit {
            reff: size.reff(),
            meff: size.meff,
            yeff: c.yeff,
            geff: c.geff,
            beta: c.beta,
            nktv2p: c.nktv2p,
            tangential_damping: c.tangential_damping,
            limit_force: c.limit_force,
            timing: c.timing,
        }
    }

    fn touch(f: &Fit, x: &Contact, h: &mut [f64; 0], s: &mut Stage) {
        Self::touch_lanes(f, &x.gap.call, &x.surface, h, s);
    }

    fn apart(_: &mut [f64; 0], s: &mut Stage) {
        s.mark = Mark::Set; // As LIGGGHTS, which sets the flag where it would be expected to clear it.
    }

    fn observe(f: &Fit, x: &Contact, _: &[f64; 0]) -> Terms {
        let root = (f.reff * x.surface.deltan).sqrt();
        let secant = 4.0 / 3.0 * f.yeff * root / f.nktv2p;
        let damping = -2.0 * SQRT_5_6 * f.beta * (2.0 * f.yeff * root * f.meff).sqrt();
        Terms {
            branch: "elastic",
            stiffness: 1.5 * secant,
            damping,
            stored: 0.4 * secant * x.surface.deltan * x.surface.deltan,
            dissipated: damping * x.surface.vn * x.surface.vn,
            load: 0.0,
        }
    }
}

impl LaneLaw for Hertz {
    type FitOf<L: Lane> = Fit<L>;
    type HistoryOf<L: Lane> = [L; 0];

    fn fit_at(f: &Fit, _: f64) -> Fit {
        *f
    }

    #[inline(always)]
    fn side_by_side<L: Lane>(f: impl Fn(usize) -> Fit) -> Fit<L> {
        Fit {
            reff: L::from_fn(|k| f(k).reff),
            meff: L::from_fn(|k| f(k).meff),
            yeff: L::from_fn(|k| f(k).yeff),
            geff: L::from_fn(|k| f(k).geff),
            beta: L::from_fn(|k| f(k).beta),
            nktv2p: L::from_fn(|k| f(k).nktv2p),
            tangential_damping: f(0).tangential_damping,
            limit_force: f(0).limit_force,
            timing: f(0).timing,
        }
    }

    #[inline(always)]
    fn touch_lanes<L: Lane>(f: &Fit<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Stage<L>) {
        let root = (f.reff * x.deltan).sqrt();
        let (sn, st) = (L::splat(2.0) * f.yeff * root, L::splat(8.0) * f.geff * root); // (E1)
        let (kn, kt) = (L::splat(4.0 / 3.0) * f.yeff * root / f.nktv2p, st / f.nktv2p); // (E2)
        let damper = L::splat(-2.0 * SQRT_5_6) * f.beta; // (E3)
        let gamman = damper * (sn * f.meff).sqrt();
        let gammat = if f.tangential_damping { damper * (st * f.meff).sqrt() } else { L::splat(0.0) };
        let spring = kn * x.deltan;
        let mut fn_ = -gamman * x.vn + spring; // (E4)
        let mut acts = fn_;
        if f.timing.acts(call) {
            (fn_, acts) = f.timing.normal(call, x, f.meff, spring, gamman, Onset::FourthRoot);
        }
        if f.limit_force {
            (fn_, acts) = not_below_zero(fn_, acts);
        }
        (s.fn_, s.kn, s.kt, s.gamman, s.gammat) = (fn_, kn, kt, gamman, gammat);
        s.force += x.en * acts;
        s.mark = Mark::Set;
    }
}
