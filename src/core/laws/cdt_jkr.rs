//! Rolling resistance of adhesive spheres: the constant directional torque of `cdt`, with a coefficient that follows
//! from the work of adhesion and its hysteresis instead of being given.
//!
//! Source: "CDT–JKR 転がり抵抗モデルの数式解説", Open DEM Japan, 29 June 2025; the numbers are its own.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | W, η | J/m², 1 | `workOfAdhesion`, `adhesionHysteresis` |
//! | R*, E* | m, Pa | effective radius (wall: R_i) and Young's modulus |
//! | kn, δ | N/m, m | from the normal law; for `hooke/hysteresis` kn is the loading stiffness |
//! | ω_ij | rad/s | ω_i − ω_j (wall: ω_i) |
//!
//! - (2) `a0 = (9π W R*² / (2E*))^(1/3)`, the contact radius without load \[m\]
//! - (3) `μr = π a0/(4R*) η`
//! - (5) `ω_t = ω_ij − (ω_ij·n) n`, the rolling part of (4)
//! - (7) `Fn = kn δ`, the elastic product and not the force of the normal law; (8) `Mmax = μr Fn R*`
//! - (9) `M = −Mmax ω_t/|ω_t|` on i, `−M` on j, zero where nothing rolls
//! - (10) with `torsionTorque off` (default) no part along n; with `on`, `M = −Mmax ω_ij/|ω_ij|`
//! - (L) `restTorqueLimit on`: ω_ij is replaced by `q = I (ω_ij/dt + T_i/I_i − T_j/I_j)`, the torque \[N m\] that would bring
//!   the pair to rest within the step against the torques T of the laws before this one, `1/I = 1/I_i + 1/I_j`;
//!   and |M| is at most |q|
//!
//! Departures and choices. `cdtJkrConvention upstream` is the header of LIGGGHTS_Flexible_Fibers instead: (3) without π,
//! and (9) over the length of the whole ω_ij, so that |M| shrinks as soon as there is spin along n. (9) and (10)
//! contradict each other for `torsionTorque on`, as (9) leaves no part along n; both conventions then resist the whole
//! spin. The displacement (6) is not stored, since nothing reads it. (L) is ours.
//!
//! Limits: without (L) a sign torque never settles; near rest it overshoots by up to `Mmax dt/I` each step, and what lies
//! on a slope creeps. (L) takes spheres for solid and free, unless frozen.
use super::formulas::{effective_young, jkr_radius, resist, without_normal, ConstantTorque};
use super::prop;
use crate::lane::{dot, norm, select3, zero, Lane, Lanes};
use crate::model::*;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The law.
pub struct CdtJkr;

/// What types decide.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    work: f64,
    hysteresis: f64,
    yeff: f64,
    documented: bool,
    switches: Switches,
}

/// What the deck chose.
#[derive(Clone, Copy, Debug)]
struct Switches {
    /// Resist spin along the normal too.
    torsion: bool,
    /// Normalise by the rolling part only (9).
    rolling_part: bool,
    /// (L).
    rest_limit: bool,
}

/// What sizes, masses and types decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L = f64> {
    torque: ConstantTorque<L>,
    /// 1/I_i and 1/I_j, and I of (L).
    mobility: [L; 2],
    inertia: L,
    switches: Switches,
}

const fn adhesion(name: &'static str, symbol: &'static str, unit: Unit, doc: &'static str) -> Prop {
    Prop::new(name, symbol, Shape::PerPair, unit, Range::at_least(0.0), doc)
}

/// Share of the spin below which a rolling part is the round-off of a spin along the normal, squared.
const ROUND_OFF: f64 = 1e-28;

impl Parameters for Params {
    type Coeffs = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        let (torsion, rest_limit) = (p.on("torsionTorque"), p.on("restTorqueLimit"));
        if rest_limit && p.nktv2p() != 1.0 {
            // There a torque over an inertia is no angular acceleration.
            let why = "it needs consistent units; units real, metal and electron are not";
            return Err(p.refuse_option("restTorqueLimit", "on", why));
        }
        let documented = p.option("cdtJkrConvention") == "documented";
        Ok(Coeffs {
            work: p.get("workOfAdhesion"),
            hysteresis: p.get("adhesionHysteresis"),
            yeff: effective_young(p) / p.nktv2p(),
            documented,
            switches: Switches { torsion, rolling_part: documented && !torsion, rest_limit },
        })
    }

    fn new(c: &Coeffs, size: &Size) -> Params {
        let reff = size.reff();
        let a0 = jkr_radius(c.work, reff, c.yeff); // (2)
        let pi = if c.documented { PI } else { 1.0 };
        let mu = pi * a0 / (4.0 * reff) * c.hysteresis; // (3)
        let (i, j) = size.mobilities();
        // Two that are held do not turn.
        let inertia = if i + j > 0.0 { 1.0 / (i + j) } else { 0.0 };
        Params { torque: ConstantTorque::new(mu, size), mobility: [i, j], inertia, switches: c.switches }
    }
}

impl Law for CdtJkr {
    type Params = Params;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[
            prop::YOUNG,
            prop::POISSON,
            adhesion("workOfAdhesion", "W", Unit::J_PER_M2, "energy per area that parts two surfaces")
                .usually(1e-3, 5.0),
            adhesion(
                "adhesionHysteresis",
                "η",
                Unit::ONE,
                "hysteresis of adhesion, a factor of the rolling friction",
            )
            .usually(0.0, 50.0),
        ],
        settings: &[
            prop::TORSION_TORQUE,
            Setting::off(
                "restTorqueLimit",
                "never let the torque turn the spin round within a step, so that what rolls comes to rest",
            ),
            Setting {
                name: "cdtJkrConvention",
                options: &["documented", "upstream"],
                default: None,
                doc: "documented is the published law, with pi in the rolling friction and the size of the torque set by the \
                      rolling part of the spin; upstream is the code of LIGGGHTS_Flexible_Fibers, without pi and with the \
                      whole spin. The torques differ by a factor of pi and more, so there is no default",
            },
        ],
        references: &[
            "Open DEM Japan, CDT-JKR rolling resistance model (rolling_model_cdt_jkr.h), 29 June 2025",
            "K.L. Johnson, K. Kendall, A.D. Roberts, Proc. R. Soc. A 324 (1971) 301",
        ],
        exceptions: &[Exception {
            rule: Rule::Continuous,
            why: "the torque keeps its size and changes sign with the spin, unless restTorqueLimit is on",
        }],
        ..Meta::new(Kind::Rolling, "cdt_jkr", "constant directional torque of adhesive spheres")
    };
    // As `cdt`.
    const LIGGGHTS: Binding = Binding { contact_flags: [ContactFlag::Leave; 2], ..Binding::new(58, None) };

    #[inline(always)]
    fn intersect<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        let Switches { torsion, rest_limit, .. } = p.switches;
        let spin = if rest_limit { p.resting(call, x, s) } else { x.roll };
        let (axis, length, rolls) = p.axis(spin, &x.en);
        let mut torque = p.torque.along(&axis, length, call, x, s.kn); // (8)
        if rest_limit {
            torque = select3(p.torque.size(x, s.kn).gt(length), axis, torque);
        }
        torque = select3(rolls, torque, zero()); // (9)
        if !torsion {
            torque = without_normal(torque, &x.en); // (10)
        }
        resist(s, &torque);
    }

    fn observe(p: &Params, x: &Contact, _: &[f64; 0]) -> Observation {
        let (_, _, rolls) = p.axis(x.surface.roll, &x.surface.en);
        Observation { branch: if rolls { "rolling" } else { "at rest" }, ..Observation::default() }
    }
}

impl<L: Lane> Params<L> {
    /// (L) The torque that brings the pair to rest within the step \[N m\].
    #[inline(always)]
    fn resting(&self, call: &Call, x: &Surface<L>, s: &Response<L>) -> Vector3<L> {
        // Of a wall, the surface model gives ω_i times (R − δ/2)/(R − δ).
        let shown = if call.is_wall { x.cri / (x.cri - L::splat(0.5) * x.deltan) } else { L::splat(1.0) };
        let turned = s.torque_i * self.mobility[0] - s.torque_j * self.mobility[1];
        (x.roll / (shown * L::splat(call.dt)) + turned) * self.inertia
    }

    /// What the torque is against: the whole of a spin, or its rolling part (5); its length, and whether there is any.
    #[inline(always)]
    fn axis(&self, spin: Vector3<L>, en: &Vector3<L>) -> (Vector3<L>, L, L::Mask) {
        if !self.switches.rolling_part {
            let length = norm(&spin);
            return (spin, length, length.gt(L::splat(0.0)));
        }
        let rolling = without_normal(spin, en);
        let square = dot(&rolling, &rolling);
        (rolling, square.sqrt(), square.gt(dot(&spin, &spin) * L::splat(ROUND_OFF)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static LAW: Entry = Entry::law::<CdtJkr>();

    fn setup(convention: &str, limit: &str, nktv2p: f64) -> Setup {
        let mut settings = Settings::new(&LAW, false);
        settings.set("cdtJkrConvention", convention).unwrap();
        settings.set("restTorqueLimit", limit).unwrap();
        // E, ν, W and η.
        let of = [5e6, 0.45, 5.0, 1.0].map(|v| vec![v]).to_vec();
        Setup { law: &LAW, settings, values: Values { types: 1, of }, nktv2p }
    }

    /// Mmax over kn δ R*, for two spheres of 5 mm.
    fn mu(setup: &Setup) -> f64 {
        let size = Size {
            radi: 5e-3,
            radj: 5e-3,
            massi: 1.0,
            massj: 1.0,
            frozen: [false; 2],
            meff: 0.5,
            is_wall: false,
        };
        let params = Params::new(&Params::coeffs(&setup.pair(0, 0)).unwrap(), &size);
        params.torque.size(&Surface { deltan: 1.0, ..Surface::default() }, 1.0) / size.reff()
    }

    #[test]
    fn the_coefficient_is_that_of_either_source() {
        // By hand with thirty digits.
        let expected = [("documented", 0.163_487_380_910_043_6), ("upstream", 0.052_039_649_609_962_02)];
        for (convention, value) in expected {
            approx::assert_relative_eq!(mu(&setup(convention, "off", 1.0)), value, max_relative = 1e-15);
        }
    }

    #[test]
    fn pressures_in_units_of_their_own_are_converted() {
        let mut other = setup("documented", "off", 1e5);
        other.values.of[0][0] *= 1e5;
        approx::assert_relative_eq!(mu(&other), mu(&setup("documented", "off", 1.0)), max_relative = 1e-15);
    }

    #[test]
    fn the_limit_is_refused_where_a_torque_over_an_inertia_is_no_acceleration() {
        let other = setup("documented", "on", 1e5);
        let why = Params::coeffs(&other.pair(0, 0)).unwrap_err().to_string();
        assert!(
            why.starts_with("cdt_jkr/rs: setting restTorqueLimit on is not supported (it needs"),
            "{why}"
        );
    }
}
