//! The documented convention: kinematics, shear (7), (8), and what acts on the two bodies (13).
//!
//! With D now and D_o in the step before, and n̄ along the mean of both, D̄. What is added up is v Δt = D − D_o, which serves
//! every integrator and whose rounding does not add up; at a wall, where the anchor is kept instead of D_o, and for
//! damping, v is LIGGGHTS's:
//! - (C1) vectors of the tangent plane are carried by the rotation that takes n_o to n, and then about n by the mean
//!   spin: `b = a − (n_o+n)(a·n)/(1+n_o·n)`, `C(a) = b cos ψ + n×b sin ψ`, `ψ = ½(ω_i+ω_j)·n̄ Δt`
//! - (7) `v_tr = P[v − (v·n̄) n̄ − (|D̄|/r) (r_ci ω_i + r_cj ω_j) × n̄]`, P the projection on the plane of n
//! - (8) `F_t ← C(F_t) − kt A Δt v_tr`; twist `θn += Δt (ω_i−ω_j)·n̄`; bending `θt ← C(θt) + Δt P(ω_i−ω_j)`
//!
//! In an evaluation that may not write, nothing is carried or added: the stored state gives the answer.
use super::bend::Disc;
use super::coeffs::Modes;
use super::loads::Loads;
use super::{apart, creation, damping, failure, normal, seen_from, twist, Params};
use crate::model::{BondEvent, ClosePair, ContactFlag, Effects, Observation, Response};
use bytemuck::{Pod, Zeroable};
use nalgebra::Vector3;

/// The history of a bond; vectors as seen by the lower tag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct History {
    /// Distance when it began \[m\]; 0 where there is no bond.
    pub r0: f64,
    /// Largest overlap, not negative, and smallest, not positive \[m\].
    pub extremes: [f64; 2],
    /// Shear force \[N\], undamped.
    pub shear: [f64; 3],
    /// D of the step before; at a wall the anchor \[m\].
    pub from: [f64; 3],
    /// Bending angle \[rad\].
    pub bend: [f64; 3],
    /// Twist angle \[rad\].
    pub twist: f64,
    /// Its extremes \[rad\].
    pub twists: [f64; 2],
    /// Centre and radius of the disc that bending has visited \[rad\].
    pub centre: [f64; 3],
    /// See `centre`.
    pub rho: f64,
}

/// How the two bodies move.
struct Motion {
    /// Distance \[m\] and unit normal.
    r: f64,
    n: Vector3<f64>,
    /// Normals before and at half the way.
    before: Vector3<f64>,
    half: Vector3<f64>,
    /// How far the bond is sheared in this step \[m\], v_tr Δt of (7).
    way: Vector3<f64>,
    /// Relative velocity, and its part that shears the bond \[m/s\].
    v: Vector3<f64>,
    shear: Vector3<f64>,
    /// Relative spin, and the mean spin about n̄ \[rad/s\].
    turn: Vector3<f64>,
    mean: f64,
}

/// One evaluation.
pub fn interact(p: &Params, x: &ClosePair, h: &mut History, s: &mut Response, e: &mut Effects) {
    if h.r0 == 0.0 {
        return begin(p, x, h, s, e);
    }
    if x.call.update {
        return hold(p, x, h, s, e);
    }
    hold(p, x, &mut h.clone(), s, e);
}

/// A bond that is there; `h` moves on where history may be written.
fn hold(p: &Params, x: &ClosePair, h: &mut History, s: &mut Response, e: &mut Effects) {
    let (m, side) = (Motion::new(p, x, h), seen_from(x));
    if x.call.update {
        if failure::torn(p, apart(x, m.r)) || m.out_of_hand() {
            return end(h, e);
        }
        m.advance(p, x.call.dt, h, side);
    }
    let delta = h.r0 - m.r; // (1)
    let loads = loads(p, delta, h, side);
    if x.call.update && failure::fails(p, delta, &loads) {
        return end(h, e);
    }
    react(p, x, &m, &loads, s, e);
    (e.contact_flag, e.bond_event) = (ContactFlag::Set, BondEvent::Lasts);
}

/// A new bond is at rest, and carries nothing in the evaluation in which it begins.
fn begin(p: &Params, x: &ClosePair, h: &mut History, s: &mut Response, e: &mut Effects) {
    let r = x.rsq.sqrt();
    if !creation::wanted(p, x, apart(x, r)) {
        return;
    }
    let from = if x.call.is_wall { x.i.x - x.delta } else { x.delta * seen_from(x) };
    *h = History { r0: r, from: from.into(), ..History::default() };
    e.replace(s, Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
    (e.contact_flag, e.bond_event) = (ContactFlag::Set, BondEvent::Begins);
}

/// A bond that breaks leaves nothing behind, and no force in the evaluation in which it breaks.
fn end(h: &mut History, e: &mut Effects) {
    *h = History::default();
    (e.contact_flag, e.bond_event) = (ContactFlag::Clear, BondEvent::Ends);
}

impl Motion {
    /// The motion, with the anchor or D moved on in `now` where history may be written.
    fn new(p: &Params, x: &ClosePair, now: &mut History) -> Motion {
        let (v, dt) = (x.i.v - x.j.v, if x.call.update { x.call.dt } else { 0.0 });
        let (d, moved) = if x.call.is_wall {
            let anchor = Vector3::from(now.from) + x.j.v * dt;
            now.from = anchor.into();
            (x.i.x - anchor, v * dt)
        } else if x.call.update {
            let side = seen_from(x);
            let moved = x.delta - Vector3::from(now.from) * side;
            now.from = (x.delta * side).into();
            (x.delta, moved)
        } else {
            (x.delta, Vector3::zeros())
        };
        let r = d.norm();
        let (n, middle) = (d / r, d - moved * 0.5);
        let half = middle.normalize();
        let roll = (x.i.omega * p.arms[0] + x.j.omega * p.arms[1]).cross(&middle);
        // (7); |D̄| n̄ is D̄.
        let sheared = |v: &Vector3<f64>, roll: &Vector3<f64>| flat(&(v - half * v.dot(&half) - roll), &n);
        Motion {
            r,
            n,
            before: (d - moved).normalize(),
            half,
            way: sheared(&moved, &(roll * dt)),
            v,
            shear: sheared(&v, &roll),
            turn: x.i.omega - x.j.omega,
            mean: 0.5 * (x.i.omega + x.j.omega).dot(&half),
        }
    }

    /// Whether the bond turned by a right angle or more in one step, so that how it turned cannot be told; no run with a
    /// sensible time step comes near. A length of 0 counts too.
    fn out_of_hand(&self) -> bool {
        let cosine = self.before.dot(&self.n);
        cosine <= 0.0 || cosine.is_nan()
    }

    /// Carry the stored vectors with the bond and add what this step brings.
    fn advance(&self, p: &Params, dt: f64, now: &mut History, side: f64) {
        let (sin, cos) = (self.mean * dt).sin_cos();
        let (sum, scale) = (self.before + self.n, 1.0 / (1.0 + self.before.dot(&self.n)));
        let carry = |stored: [f64; 3]| {
            let a = Vector3::from(stored) * side;
            let b = a - sum * (a.dot(&self.n) * scale);
            b * cos + self.n.cross(&b) * sin // (C1)
        };
        let shear = carry(now.shear) - self.way * (p.c.shear * p.area); // (8)
        let bend = carry(now.bend) + flat(&self.turn, &self.n) * dt;
        let centre = carry(now.centre);
        let mut disc = Disc { centre, rho: now.rho };
        disc.visit(&bend);
        now.twist += dt * self.turn.dot(&self.half);
        now.twists = widened(now.twists, now.twist);
        (now.shear, now.bend) = ((shear * side).into(), (bend * side).into());
        (now.centre, now.rho) = ((disc.centre * side).into(), disc.rho);
    }
}

/// The part of a vector in the plane of n.
fn flat(a: &Vector3<f64>, n: &Vector3<f64>) -> Vector3<f64> {
    a - n * a.dot(n)
}

/// Largest and smallest value with one more (4).
fn widened([max, min]: [f64; 2], x: f64) -> [f64; 2] {
    [x.max(max), x.min(min)]
}

fn loads(p: &Params, delta: f64, now: &mut History, side: f64) -> Loads {
    let c = &p.c;
    now.extremes = widened(now.extremes, delta);
    let [max, min] = now.extremes;
    let mut l = Loads {
        normal: normal::stress(c, delta, max, min) * p.area,
        shear: Vector3::zeros(),
        twist: 0.0,
        bend: Vector3::zeros(),
    };
    if c.on.shear {
        l.shear = Vector3::from(now.shear) * side;
    }
    if c.on.twist {
        let [max, min] = now.twists;
        l.twist = -p.polar * twist::stress(&c.twist, now.twist, max, min); // (9)
    }
    if c.on.bend {
        let disc = Disc { centre: Vector3::from(now.centre) * side, rho: now.rho };
        l.bend = disc.stress(&c.bend, &(Vector3::from(now.bend) * side)) * -p.bending;
        // (10)
    }
    l
}

/// The damped loads on both bodies.
fn react(p: &Params, x: &ClosePair, m: &Motion, l: &Loads, s: &mut Response, e: &mut Effects) {
    let (eta, mass) = (&p.c.eta, inertia(p, x, m));
    let across = flat(&m.turn, &m.n);
    let fn_ = damping::along(l.normal, eta.normal, m.v.dot(&m.n), mass.normal); // (11)
    let ft = damping::in_plane(l.shear, eta.shear, &m.shear, mass.shear);
    let tn = damping::along(l.twist, eta.twist, m.turn.dot(&m.n), mass.twist); // (12)
    let tt = damping::in_plane(l.bend, eta.bend, &across, mass.bend);
    let (couple, own) = (ft.cross(&m.n) * m.r, m.n * tn + tt);
    let on_j = if x.call.is_wall { Vector3::zeros() } else { couple * p.arms[1] - own };
    e.replace(s, m.n * fn_ + ft, couple * p.arms[0] + own, on_j); // (13)
}

/// The inertia of each mode over 10 Δt; infinite where damping changes sign at once.
fn inertia(p: &Params, x: &ClosePair, m: &Motion) -> Modes<f64> {
    let modes = |normal: f64, shear: f64, turn: f64| Modes { normal, shear, twist: turn, bend: turn };
    if !p.c.smooth {
        return modes(f64::INFINITY, f64::INFINITY, f64::INFINITY);
    }
    let part = |mass: f64, radius: f64| 1.0 / (0.4 * mass * radius * radius);
    let other = if x.call.is_wall { 0.0 } else { part(x.j.felt_mass(), x.j.radius) };
    let kappa = m.r / if x.call.is_wall { x.i.radius } else { x.i.radius + x.j.radius };
    let scale = 1.0 / (10.0 * x.call.dt);
    modes(
        x.meff * scale,
        x.meff * scale / (1.0 + 2.5 * kappa * kappa),
        scale / (part(x.i.felt_mass(), x.i.radius) + other),
    )
}

/// What a study wants to know: the normal mode, and the strength that all modes use.
pub fn observe(p: &Params, x: &ClosePair, h: &History) -> Observation {
    let r = if x.call.is_wall { (x.i.x - Vector3::from(h.from)).norm() } else { x.rsq.sqrt() };
    let delta = h.r0 - r;
    let [max, min] = widened(h.extremes, delta);
    let carried = loads(p, delta, &mut h.clone(), seen_from(x));
    Observation {
        branch: normal::branch_name(&p.c, delta, max, min),
        stiffness: normal::tangent(&p.c, delta, max, min) * p.area,
        load: failure::used(p, [apart(x, h.r0), apart(x, r)], &carried),
        ..Observation::default()
    }
}
