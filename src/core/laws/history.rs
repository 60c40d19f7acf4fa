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
//! `centredDamping`, `touchFraction`: see [`super::timing`]. With the latter the shear begins with the surfaces, and the
//! dashpot acts for the part of a step in which the contact sticks: with `g = (kt|ξ| − μ|Fn|)/(rate dt)` steps since
//! slip began, or −g until it will,
//! - (E4) slip: dashpot × `max(0, a − g)`; stick: dashpot × `w − max(0, b + g)`, w from (T3); a and b are 1/2, near
//!   first touch what (T3) leaves over
//! - (E5) where Fn changes its sign within a step the Coulomb limit was zero, so ξ counts from there
//!
//! Limits: (E2) adds the dashpot after the Coulomb test, so the force jumps by γt v_t where sticking turns into
//! slipping and may exceed μ|Fn| below it; the projection loses length when the normal turns. Both as LIGGGHTS.
//! When slip turns into stick shows in second derivatives only, so there (E4) has no counterpart.
use super::friction::{push, Params};
use super::prop;
use super::timing::{at_once, growing, turning, Ends};
use crate::lane::{dot, each, norm, select3, zero, Lane};
use crate::model::*;
use nalgebra::Vector3;

/// The law.
pub struct History;

impl Law for History {
    type Params = Params;
    type History = [f64; 3];
    const META: Meta = Meta {
        props: &[prop::FRICTION],
        settings: &[prop::CENTRED_DAMPING, prop::TOUCH_FRACTION],
        slots: &[Slot::odd("shearx", Unit::M), Slot::odd("sheary", Unit::M), Slot::odd("shearz", Unit::M)],
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
        ..Meta::new(Kind::Tangential, "history", "shear spring and dashpot with Coulomb limit")
    };
    const LIGGGHTS: Binding = Binding {
        own_settings: &["centredDamping", "touchFraction"],
        refused: &[
            prop::refused("heating_tangential_history", "contacts do not produce heat"),
            prop::HEATING_TRACKING,
            prop::ELASTIC_POTENTIAL,
            prop::DISSIPATED_ENERGY,
        ],
        ..Binding::new(50, Some(2))
    };

    #[inline(always)]
    fn intersect<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, h: &mut [L; 3], s: &mut Response<L>) {
        if p.timing.acts(call) {
            return timed(p, call, x, h, s);
        }
        let mut shear = Vector3::from(*h);
        if call.update {
            shear += x.vtr * L::splat(call.dt); // (E1)
            shear -= x.en * dot(&shear, &x.en);
            *h = shear.into();
        }
        let length = norm(&shear);
        let elastic = each(&shear, |x| -(x * s.kt));
        let (spring, coulomb) = (s.kt * length, p.mu * s.fn_.abs());
        let slips = spring.gt(coulomb);
        let mut force = elastic - x.vtr * s.gammat; // (E2)
        if L::any(slips) {
            let limited = elastic * (coulomb / spring); // (E3)
            force = select3(slips, limited, force);
            if call.update {
                *h = select3(slips, each(&limited, |e| -e / s.kt), shear).into();
            }
        }
        push(x, s, force);
    }

    fn observe(_: &Params, x: &Contact, h: &[f64; 3]) -> Observation {
        let moved = norm(&Vector3::from(*h)) > 0.0 || norm(&x.surface.vtr) > 0.0;
        Observation { branch: if moved { "sheared" } else { "virgin" }, ..Observation::default() }
    }
}

/// (E1) to (E3) with what [`super::timing`] does to them.
#[inline(always)]
fn timed<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, h: &mut [L; 3], s: &mut Response<L>) {
    let (none, one, dt) = (L::splat(0.0), L::splat(1.0), L::splat(call.dt));
    let ends = p.timing.ends(call, x, s.fn_, p.meff);
    let rise = (-s.kn * x.vn - s.gamman * s.fn_ / p.meff) * dt;
    let (turned, begun) = begun(p, s.fn_ / rise, ends.since);
    let mut shear = select3(turned, zero(), Vector3::from(*h)) + x.vtr * (dt * begun); // (E1), (E5)
    shear -= x.en * dot(&shear, &x.en);
    let length = norm(&shear);
    let way = select3(length.gt(none), each(&shear, |e| e / length), zero());
    let (spring, coulomb) = (s.kt * length, p.mu * s.fn_.abs());
    let slips = spring.gt(coulomb);
    *h = select3(slips, way * (coulomb / s.kt), shear).into();
    let (mut stuck, mut slid) = (one, none);
    if p.timing.fraction() {
        let limit = p.mu * L::select(none.gt(s.fn_), -rise, rise);
        let faster = s.kt * dot(&x.vtr, &way) * dt;
        (stuck, slid) = shares(ends.since, spring, coulomb, faster, limit);
        slid = L::select(turned, none, slid);
    }
    let factor = p.timing.centring(call, s.gammat, turning(call, x, p.meff));
    let (elastic, dashpot) = (way * -(spring * factor), x.vtr * -(s.gammat * factor));
    let end = at_once(ends.left);
    let stick = (elastic * growing(ends.since) + dashpot * stuck) * end; // (E2), (E4)
    let slip = way * -pressed(p, call, x, s, &ends) + dashpot * (slid * end); // (E3), (E4)
    push(x, s, select3(slips, slip, stick));
}

/// (E5): whether the normal force, zero so many steps ago, changed its sign in this one, and the part of the step that
/// shears.
#[inline(always)]
fn begun<L: Lane>(p: &Params<L>, zero_since: L, since: L) -> (L::Mask, L) {
    let (none, one) = (L::splat(0.0), L::splat(1.0));
    if !p.timing.fraction() {
        return (none.gt(one), one);
    }
    let turned = zero_since.gt(none) & one.gt(zero_since) & since.gt(one);
    (turned, L::select(turned, zero_since, L::select(one.gt(since), since, one)))
}

/// The Coulomb force as it acts over the step \[N\], weighted as the parts of the normal force are.
#[inline(always)]
fn pressed<L: Lane>(p: &Params<L>, call: &Call, x: &Surface<L>, s: &Response<L>, ends: &Ends<L>) -> L {
    let dashpot = -s.gamman * x.vn * p.timing.centring(call, s.gamman, p.meff);
    let acts = (s.fn_ - dashpot) * ends.growing() + dashpot * ends.at_once();
    // A normal force that was cut off has no friction.
    p.mu * L::select(s.fn_.abs().gt(L::splat(0.0)), acts.abs(), L::splat(0.0))
}

/// (E4): what part of the dashpot acts where the contact sticks, and where it slips. `faster` and `limit` are what
/// spring and Coulomb force grow by in the step \[N\].
#[inline(always)]
fn shares<L: Lane>(since: L, spring: L, coulomb: L, faster: L, limit: L) -> (L, L) {
    let (none, half, one, two) = (L::splat(0.0), L::splat(0.5), L::splat(1.0), L::splat(2.0));
    let least = |a: L, b: L| L::select(b.gt(a), a, b);
    let not_negative = |a: L| L::select(a.gt(none), a, none);
    let rate = faster - limit;
    let g = (spring - coulomb) / rate;
    let a = L::select(one.gt(since), since, L::select(two.gt(since), L::splat(1.5) - half * since, half));
    let b = half * least(since, one);
    // A limit that falls to zero comes back as soon as the normal force has changed its sign.
    let brief = L::select(none.gt(limit), -two * spring / limit, L::splat(f64::INFINITY));
    let will = rate.gt(none);
    let gone = L::select(will, least(not_negative(b + g), brief), none);
    (at_once(since) - gone, L::select(will, not_negative(a - g), none))
}
