//! Coulomb friction with a tangential spring that remembers the shear since the contact began.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | ξ | m | shear, kept in the tangent plane by projection (history) |
//! | v_t | m/s | tangential relative velocity at the contact |
//! | kt, γt, Fn | N/m, N s/m, N | from the normal law |
//!
//! - (E1) `ξ ← P(ξ + v_t dt)`, P the projection on the tangent plane, only when history may be written
//! - (E2) stick, `kt |ξ| ≤ μ |Fn|`: `Ft = −kt ξ − γt v_t`
//! - (E3) slip: `Ft = −μ |Fn| ξ/|ξ|`, and `ξ ← −Ft/kt`
//!
//! Limits: (E2) adds the dashpot after the Coulomb test, so the force jumps by γt v_t where sticking turns into
//! slipping and may exceed μ|Fn| below it; the projection loses length when the normal turns. Both as LIGGGHTS.
use super::no_history::push;
use super::prop;
use crate::lane::{dot, norm, select3, Lane};
use crate::law::*;
use nalgebra::Vector3;

/// The law.
pub struct History;

/// The coefficient of friction of a type pair.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs<L = f64> {
    mu: L,
}

impl Law for History {
    const META: Meta = Meta {
        kind: Kind::Tangential,
        keyword: "history",
        id: 50,
        stock_id: Some(2),
        summary: "shear spring and dashpot with Coulomb limit",
        props: &[prop::FRICTION],
        settings: &[
            prop::refused("heating_tangential_history", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
        ],
        slots: &[
            Slot { name: "shearx", newton: Newton::Odd, unit: Unit::M },
            Slot { name: "sheary", newton: Newton::Odd, unit: Unit::M },
            Slot { name: "shearz", newton: Newton::Odd, unit: Unit::M },
        ],
        stress_strain_exponent: 0.0,
        reach: Reach::Overlap,
        coarse_graining: true,
        references: &[
            "P.A. Cundall, O.D.L. Strack, Géotechnique 29 (1979) 47",
            "L.E. Silbert et al., Phys. Rev. E 64 (2001) 051302",
        ],
        exceptions: &[Exception {
            rule: Rule::Continuous,
            why:
                "γt v_t is added below the Coulomb limit only, so the force jumps by it at the onset of slip",
        }],
    };
    type History = [f64; 3];
    type Coeffs = Coeffs;
    type Fit = Coeffs;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        Ok(Coeffs { mu: p.get("coefficientFriction") })
    }

    fn fit(c: &Coeffs, _: &Size) -> Coeffs {
        *c
    }

    fn touch(f: &Coeffs, x: &Contact, h: &mut [f64; 3], s: &mut Stage) {
        Self::touch_lanes(f, &x.gap.call, &x.surface, h, s);
    }

    fn apart(_: &Coeffs, _: &Gap, h: &mut [f64; 3], s: &mut Stage) {
        *h = [0.0; 3];
        s.mark = Mark::Clear;
    }

    fn observe(_: &Coeffs, x: &Contact, h: &[f64; 3]) -> Terms {
        let moved = norm(&Vector3::from(*h)) > 0.0 || norm(&x.surface.vtr) > 0.0;
        Terms { branch: if moved { "sheared" } else { "virgin" }, ..Terms::default() }
    }
}

impl LaneLaw for History {
    type FitOf<L: Lane> = Coeffs<L>;
    type HistoryOf<L: Lane> = [L; 3];

    fn fit_at(f: &Coeffs, _: f64) -> Coeffs {
        *f
    }

    fn side_by_side<L: Lane>(f: &[Coeffs]) -> Coeffs<L> {
        Coeffs { mu: L::from_fn(|k| f[k].mu) }
    }

    #[inline]
    fn touch_lanes<L: Lane>(f: &Coeffs<L>, call: &Call, x: &Surface<L>, h: &mut [L; 3], s: &mut Stage<L>) {
        let mut shear = Vector3::from(*h);
        if call.update {
            shear += x.vtr * L::splat(call.dt); // (E1)
            shear -= x.en * dot(&shear, &x.en);
            *h = shear.into();
        }
        let length = norm(&shear);
        let elastic = (shear * s.kt).map(|e| -e);
        let (spring, coulomb) = (s.kt * length, f.mu * s.fn_.abs());
        let slips = spring.gt(coulomb);
        let mut force = elastic - x.vtr * s.gammat; // (E2)
        if L::any(slips) {
            let limited = elastic * (coulomb / spring); // (E3)
            force = select3(slips, limited, force);
            if call.update {
                *h = select3(slips, limited.map(|e| -e / s.kt), shear).into();
            }
        }
        push(x, s, force);
    }
}
