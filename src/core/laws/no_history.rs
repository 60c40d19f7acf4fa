//! Coulomb friction regularised by a dashpot, without memory.
//!
//! - (E1) `Ft = −γ v_t`, `γ = min(γt, μ|Fn|/|v_t|)`
//!
//! `v_t` \[m/s\] is the tangential relative velocity at the contact, γt \[N s/m\] and Fn \[N\] come from the normal law.
//! `centredDamping`, `touchFraction`: see [`super::timing`].
//! Limits: no static friction; a contact at rest creeps.
use super::prop;
use super::timing::{turning, Timing};
use crate::lane::{cross, norm, Lane};
use crate::law::*;

/// The law.
pub struct NoHistory;

/// What a pair of types decides.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    mu: f64,
    timing: Timing,
}

/// What two sizes decide.
#[derive(Clone, Copy, Debug)]
pub struct Fit<L = f64> {
    mu: L,
    meff: L,
    timing: Timing,
}

impl Law for NoHistory {
    const META: Meta = Meta {
        kind: Kind::Tangential,
        keyword: "no_history",
        id: 49,
        stock_id: Some(1),
        summary: "viscous friction with Coulomb limit, no memory",
        props: &[prop::FRICTION],
        settings: &[
            prop::CENTRED_DAMPING,
            prop::TOUCH_FRACTION,
            prop::refused("disableTangentialWhenBonded", "the friction law does not look at bonds"),
            prop::DISSIPATED_ENERGY,
        ],
        atoms: &[],
        slots: &[],
        stress_strain_exponent: 0.0,
        reach: Reach::Overlap,
        anchors: false,
        bonds: None,
        coarse_graining: true,
        references: &["P.K. Haff, B.T. Werner, Powder Technology 48 (1986) 239"],
        exceptions: &[],
    };
    type History = [f64; 0];
    type Coeffs = Coeffs;
    type Fit = Fit;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        Ok(Coeffs { mu: p.get("coefficientFriction"), timing: Timing::new(p) })
    }

    fn fit(c: &Coeffs, size: &Size) -> Fit {
        Fit { mu: c.mu, meff: size.meff, timing: c.timing }
    }

    fn touch(f: &Fit, x: &Contact, h: &mut [f64; 0], s: &mut Stage) {
        Self::touch_lanes(f, &x.gap.call, &x.surface, h, s);
    }

    fn observe(f: &Fit, x: &Contact, _: &[f64; 0]) -> Terms {
        // Before the normal law has run, only the speed is known.
        let _ = f;
        Terms { branch: if norm(&x.surface.vtr) > 0.0 { "sliding" } else { "at rest" }, ..Terms::default() }
    }
}

impl LaneLaw for NoHistory {
    type FitOf<L: Lane> = Fit<L>;
    type HistoryOf<L: Lane> = [L; 0];

    fn fit_at(f: &Fit, _: f64) -> Fit {
        *f
    }

    #[inline(always)]
    fn side_by_side<L: Lane>(f: impl Fn(usize) -> Fit) -> Fit<L> {
        Fit { mu: L::from_fn(|k| f(k).mu), meff: L::from_fn(|k| f(k).meff), timing: f(0).timing }
    }

    #[inline(always)]
    fn touch_lanes<L: Lane>(f: &Fit<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Stage<L>) {
        let speed = norm(&x.vtr);
        let coulomb = f.mu * s.fn_.abs();
        let acts = f.timing.acts(call);
        let mut gammat = s.gammat;
        if acts {
            gammat = gammat * f.timing.centring(call, gammat, turning(call, x, f.meff));
        }
        let mut gamma = L::select((gammat * speed).gt(coulomb), coulomb / speed, gammat); // (E1)
        if acts {
            gamma *= f.timing.ends(call, x, s.fn_, f.meff).at_once();
        }
        let force = x.vtr * -gamma;
        push(x, s, force);
    }
}

/// Hand out a tangential force: torque on either side is lever × force.
#[inline(always)]
pub(super) fn push<L: Lane>(x: &Surface<L>, s: &mut Stage<L>, force: nalgebra::Vector3<L>) {
    let turn = cross(&x.en, &force);
    s.force += force;
    s.torque_i += turn * -x.cri;
    s.torque_j += turn * -x.crj;
    s.mark = Mark::Set;
}
