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
use super::formulas::{effective_shear, effective_young};
use super::normal::{Normal, Switches};
use super::prop;
use super::timing::Onset;
use crate::lane::{Lane, Lanes};
use crate::model::*;
use std::f64::consts::PI;

/// The law.
pub struct Hertz;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    yeff: f64,
    geff: f64,
    beta: f64,
    switches: Switches,
    nktv2p: f64,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L = f64> {
    reff: L,
    meff: L,
    yeff: L,
    geff: L,
    beta: L,
    nktv2p: L,
    switches: Switches,
}

const SQRT_5_6: f64 = 0.912_870_929_175_276_9;

impl Parameters for Params {
    type Coeffs = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let log_e = p.get("coefficientRestitution").ln();
        let beta = log_e / (log_e * log_e + PI * PI).sqrt();
        let (yeff, geff) = (effective_young(p), effective_shear(p));
        Ok(Coeffs { yeff, geff, beta, switches: Switches::new(p), nktv2p: p.nktv2p() })
    }

    fn new(c: &Coeffs, size: &Size) -> Params {
        let Coeffs { yeff, geff, beta, switches, nktv2p } = *c;
        Params { reff: size.reff(), meff: size.meff, yeff, geff, beta, nktv2p, switches }
    }
}

impl Law for Hertz {
    type Params = Params;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[prop::YOUNG, prop::POISSON, prop::RESTITUTION],
        settings: &[
            prop::TANGENTIAL_DAMPING,
            prop::LIMIT_FORCE,
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
        ],
        stress_strain_exponent: 1.5,
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
        ..Meta::new(Kind::Normal, "hertz", "Hertz contact with dashpot, Mindlin tangential stiffness")
    };
    const LIGGGHTS: Binding = Binding {
        own_settings: &["centredDamping", "touchFraction"],
        refused: &[
            prop::refused("heating_normal_hertz", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
            prop::DISABLE_WHEN_BONDED,
        ],
        // LIGGGHTS sets the flag where it would be expected to clear it.
        contact_flags: [ContactFlag::Set, ContactFlag::Set],
        ..Binding::new(51, Some(3))
    };

    #[inline(always)]
    fn intersect<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        let root = (p.reff * x.deltan).sqrt();
        let (sn, st) = (L::splat(2.0) * p.yeff * root, L::splat(8.0) * p.geff * root); // (E1)
        let (kn, kt) = (L::splat(4.0 / 3.0) * p.yeff * root / p.nktv2p, st / p.nktv2p); // (E2)
        let damper = L::splat(-2.0 * SQRT_5_6) * p.beta; // (E3)
        let gamman = damper * (sn * p.meff).sqrt();
        let gammat = p.switches.tangential(
            #[inline(always)]
            || damper * (st * p.meff).sqrt(),
        );
        let (spring, stiffness, damping) = (kn * x.deltan, (kn, kt), (gamman, gammat));
        let normal = Normal { spring, stiffness, damping, meff: p.meff, onset: Onset::FourthRoot };
        p.switches.push(&normal, call, x, s); // (E4)
    }

    fn observe(p: &Params, x: &Contact, _: &[f64; 0]) -> Observation {
        let Surface { deltan, vn, .. } = x.surface;
        let root = (p.reff * deltan).sqrt();
        let secant = 4.0 / 3.0 * p.yeff * root / p.nktv2p;
        let damping = -2.0 * SQRT_5_6 * p.beta * (2.0 * p.yeff * root * p.meff).sqrt();
        Observation {
            branch: "elastic",
            stiffness: 1.5 * secant,
            damping,
            stored: 0.4 * secant * deltan * deltan,
            dissipated: damping * vn * vn,
            load: 0.0,
        }
    }
}
