//! Constant directional torque: rolling resistance of constant size against the relative spin.
//!
//! - (E1) `M = −μr kn δ R* ω/|ω|` on i, `+M` on j, zero where nothing rolls; ω = ω_i − ω_j \[rad/s\] (wall: ω_i)
//! - (E2) `torsionTorque off` (default): without the part of M along the normal
//!
//! Fn of the literature is the elastic product kn δ \[N\] here, not the force of the normal law. kn comes from the
//! normal law; for `hooke/hysteresis` it is the loading stiffness.
//!
//! Limits: a sign torque never settles; near rest it overshoots by up to `|M| dt/I` each step and chatters.
use super::formulas::{resist, without_normal, ConstantTorque};
use super::prop;
use crate::lane::{norm, select3, zero, Lane, Lanes};
use crate::model::*;

/// The law.
pub struct Cdt;

/// What sizes and types decide.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Params<L = f64> {
    torque: ConstantTorque<L>,
    torsion: bool,
}

impl Parameters for Params {
    type Coeffs = (f64, bool);

    fn coeffs(p: &Pair<'_>) -> Result<(f64, bool), LawError> {
        Ok((p.get("coefficientRollingFriction"), p.on("torsionTorque")))
    }

    fn new(c: &(f64, bool), size: &Size) -> Params {
        Params { torque: ConstantTorque::new(c.0, size), torsion: c.1 }
    }
}

impl Law for Cdt {
    type Params = Params;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[prop::ROLLING_FRICTION],
        settings: &[prop::TORSION_TORQUE],
        references: &["J. Ai, J.-F. Chen, J.M. Rotter, J.Y. Ooi, Powder Technology 206 (2011) 269, model A"],
        exceptions: &[Exception {
            rule: Rule::Continuous,
            why: "the torque keeps its size and changes sign with the spin",
        }],
        ..Meta::new(Kind::Rolling, "cdt", "constant directional torque")
    };
    // LIGGGHTS's law does not touch the flag.
    const LIGGGHTS: Binding = Binding { contact_flags: [ContactFlag::Leave; 2], ..Binding::new(49, Some(1)) };

    #[inline(always)]
    fn intersect<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        let spin = norm(&x.roll);
        let torque = p.torque.along(&x.roll, spin, call, x, s.kn);
        let mut torque = select3(spin.gt(L::splat(0.0)), torque, zero()); // (E1)
        if !p.torsion {
            torque = without_normal(torque, &x.en); // (E2)
        }
        resist(s, &torque);
    }

    fn observe(_: &Params, x: &Contact, _: &[f64; 0]) -> Observation {
        Observation {
            branch: if norm(&x.surface.roll) > 0.0 { "rolling" } else { "at rest" },
            ..Observation::default()
        }
    }
}
