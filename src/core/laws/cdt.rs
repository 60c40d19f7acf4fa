//! Constant directional torque: rolling resistance of constant size against the relative spin.
//!
//! - (E1) `M = −μr kn δ R* ω/|ω|` on i, `+M` on j, zero where nothing rolls; ω = ω_i − ω_j \[rad/s\] (wall: ω_i)
//! - (E2) `torsionTorque off` (default): without the part of M along the normal
//!
//! Fn of the literature is the elastic product kn δ \[N\] here, not the force of the normal law. kn comes from the
//! normal law; for `hooke/hysteresis` it is the loading stiffness.
//!
//! Limits: a sign torque never settles; near rest it overshoots by up to `|M| dt/I` each step and chatters.
use super::formulas::{without_normal, ConstantTorque};
use super::prop;
use crate::lane::{norm, select3, zero, Lane};
use crate::law::*;

/// The law.
pub struct Cdt;

/// What sizes and types decide.
#[derive(Clone, Copy, Debug)]
pub struct Fit<L = f64> {
    torque: ConstantTorque<L>,
    torsion: bool,
}

impl Law for Cdt {
    const META: Meta = Meta {
        kind: Kind::Rolling,
        keyword: "cdt",
        id: 49,
        stock_id: Some(1),
        summary: "constant directional torque",
        props: &[prop::ROLLING_FRICTION],
        settings: &[Setting::off("torsionTorque", Support::Full, "also resist spin about the normal")],
        atoms: &[],
        slots: &[],
        stress_strain_exponent: 0.0,
        reach: Reach::Overlap,
        anchors: false,
        bonds: None,
        coarse_graining: false,
        references: &["J. Ai, J.-F. Chen, J.M. Rotter, J.Y. Ooi, Powder Technology 206 (2011) 269, model A"],
        exceptions: &[Exception {
            rule: Rule::Continuous,
            why: "the torque keeps its size and changes sign with the spin",
        }],
    };
    type History = [f64; 0];
    type Coeffs = (f64, bool);
    type Fit = Fit;

    fn coeffs(p: &Pair<'_>) -> Result<(f64, bool), LawError> {
        Ok((p.get("coefficientRollingFriction"), p.on("torsionTorque")))
    }

    fn fit(c: &(f64, bool), size: &Size) -> Fit {
        Fit { torque: ConstantTorque::new(c.0, size), torsion: c.1 }
    }

    fn touch(f: &Fit, x: &Contact, h: &mut [f64; 0], s: &mut Stage) {
        Self::touch_lanes(f, &x.gap.call, &x.surface, h, s);
    }

    fn apart(_: &mut [f64; 0], s: &mut Stage) {
        s.mark = Mark::Leave; // LIGGGHTS's law does not touch the flag, neither here nor in contact.
    }

    fn observe(_: &Fit, x: &Contact, _: &[f64; 0]) -> Terms {
        Terms { branch: if norm(&x.surface.roll) > 0.0 { "rolling" } else { "at rest" }, ..Terms::default() }
    }
}

impl LaneLaw for Cdt {
    type FitOf<L: Lane> = Fit<L>;
    type HistoryOf<L: Lane> = [L; 0];

    fn fit_at(f: &Fit, _: f64) -> Fit {
        *f
    }

    #[inline(always)]
    fn side_by_side<L: Lane>(f: impl Fn(usize) -> Fit) -> Fit<L> {
        Fit { torque: ConstantTorque::side_by_side(|k| f(k).torque), torsion: f(0).torsion }
    }

    #[inline(always)]
    fn touch_lanes<L: Lane>(f: &Fit<L>, call: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Stage<L>) {
        let spin = norm(&x.roll);
        let torque = f.torque.along(&x.roll, spin, call, x, s.kn);
        let mut torque = select3(spin.gt(L::splat(0.0)), torque, zero()); // (E1)
        if !f.torsion {
            torque = without_normal(torque, &x.en); // (E2)
        }
        s.torque_i -= torque;
        s.torque_j += torque;
        s.mark = Mark::Leave;
    }
}
