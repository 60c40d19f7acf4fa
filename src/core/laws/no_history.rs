//! Coulomb friction regularised by a dashpot, without memory.
//!
//! - (E1) `Ft = −γ v_t`, `γ = min(γt, μ|Fn|/|v_t|)`
//!
//! `v_t` \[m/s\] is the tangential relative velocity at the contact, γt \[N s/m\] and Fn \[N\] come from the normal law.
//! `centredDamping`, `touchFraction`: see [`super::timing`].
//! Limits: no static friction; a contact at rest creeps.
use super::friction::{push, Params};
use super::prop;
use super::timing::turning;
use crate::lane::{norm, Lane};
use crate::model::*;

/// The law.
pub struct NoHistory;

impl Law for NoHistory {
    type Params = Params;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[prop::FRICTION],
        settings: &[prop::CENTRED_DAMPING, prop::TOUCH_FRACTION],
        coarse_graining: true,
        references: &["P.K. Haff, B.T. Werner, Powder Technology 48 (1986) 239"],
        ..Meta::new(Kind::Tangential, "no_history", "viscous friction with Coulomb limit, no memory")
    };
    const LIGGGHTS: Binding = Binding {
        own_settings: &["centredDamping", "touchFraction"],
        refused: &[
            prop::refused("disableTangentialWhenBonded", "the friction law does not look at bonds"),
            prop::DISSIPATED_ENERGY,
        ],
        ..Binding::new(49, Some(1))
    };

    #[inline(always)]
    fn intersect<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        let speed = norm(&x.vtr);
        let coulomb = p.mu * s.fn_.abs();
        let acts = p.timing.acts(call);
        let mut gammat = s.gammat;
        if acts {
            gammat = gammat * p.timing.centring(call, gammat, turning(call, x, p.meff));
        }
        let mut gamma = L::select((gammat * speed).gt(coulomb), coulomb / speed, gammat); // (E1)
        if acts {
            gamma *= p.timing.ends(call, x, s.fn_, p.meff).at_once();
        }
        push(x, s, x.vtr * -gamma);
    }

    /// Before the normal law has run, only the speed is known.
    fn observe(_: &Params, x: &Contact, _: &[f64; 0]) -> Observation {
        Observation {
            branch: if norm(&x.surface.vtr) > 0.0 { "sliding" } else { "at rest" },
            ..Observation::default()
        }
    }
}
