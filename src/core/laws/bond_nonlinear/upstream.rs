//! The upstream convention: the numbers of LIGGGHTS-INL's header, its faults included.
//!
//! What differs from [`super::documented`]: compression forces lack the area; crossing δ = 0 forgets the damage of the
//! other side; |δ| ≤ 1e-15 m gives no force; angles, their extremes and the sgn of damping are kept per axis of the
//! box; F_t is projected, not carried, and the evaluation in which a bond begins already adds to it; extremes are
//! written in every evaluation, queries included, and survive the bond; a wall takes half of ω for the shear velocity
//! and compares 2r when bonds begin, r when they break; the strength itself does not break.
//!
//! Operations stand in the header's order, so that runs which magnify rounding agree too.
//!
//! Extremes keep their sign when i and j change places while the angles turn: right in serial runs only, as there.
use super::coeffs::{Breaks, Line};
use super::{apart, creation, seen_from, Params};
use crate::lane::{dot, norm};
use crate::model::{BondEvent, ClosePair, ContactFlag, Effects, Response};
use bytemuck::{Pod, Zeroable};
use nalgebra::Vector3;

/// Below this overlap the normal force is switched off \[m\].
const DEADBAND: f64 = 1e-15;

/// The history of a bond. F_t and the angles as seen by the lower tag, the rest as it comes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct History {
    r0: f64,
    /// Largest and smallest overlap \[m\].
    extremes: [f64; 2],
    shear: [f64; 3],
    /// The contact point on a wall; elsewhere the position of j when the bond began.
    from: [f64; 3],
    bend: [f64; 3],
    twist: [f64; 3],
    twist_max: [f64; 3],
    twist_min: [f64; 3],
    bend_max: [f64; 3],
    bend_min: [f64; 3],
}

/// How the two bodies move, as the header sees it.
struct Motion {
    r: f64,
    n: Vector3<f64>,
    /// Parts of the relative velocity along n, and at the bond's surface \[m/s\].
    along: Vector3<f64>,
    shear: Vector3<f64>,
    /// Parts of the relative spin along n and across it \[rad/s\].
    twist: Vector3<f64>,
    bend: Vector3<f64>,
}

/// One evaluation.
pub fn interact(p: &Params, x: &ClosePair, h: &mut History, s: &mut Response, e: &mut Effects) {
    let r = x.rsq.sqrt();
    e.bond_event = BondEvent::Lasts;
    if h.r0 == 0.0 {
        e.bond_event = BondEvent::None;
        if !creation::wanted(p, x, apart(x, r)) {
            return;
        }
        let kept = *h;
        *h = History { r0: r, from: (x.i.x - x.delta).into(), ..kept };
        (h.shear, h.twist, h.bend) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        e.bond_event = BondEvent::Begins;
    } else if x.call.is_wall && x.call.update {
        h.from = (Vector3::from(h.from) + x.j.v * x.call.dt).into();
    }
    let m = Motion::new(x, h);
    if x.call.update && matches!(p.c.breaks, Breaks::Distance(max) if m.r > max) {
        return end(h, e);
    }
    e.contact_flag = ContactFlag::Set;
    evaluate(p, x, &m, h, s, e);
}

fn end(h: &mut History, e: &mut Effects) {
    h.r0 = 0.0;
    (e.contact_flag, e.bond_event) = (ContactFlag::Clear, BondEvent::Ends);
}

impl Motion {
    fn new(x: &ClosePair, h: &History) -> Motion {
        let d = if x.call.is_wall { x.i.x - Vector3::from(h.from) } else { x.delta };
        let r = norm(&d);
        let n = d * (1.0 / r);
        let v = x.i.v - x.j.v;
        let along = projected(&v, &n);
        let spin = if x.call.is_wall {
            x.i.omega * 0.5
        } else {
            let sum = 1.0 / (x.i.radius + x.j.radius);
            x.i.omega * (x.i.radius * sum) + x.j.omega * (x.j.radius * sum)
        };
        let turn = x.i.omega - x.j.omega;
        let twist = projected(&turn, &n);
        Motion { r, n, along, shear: (v - along) + d.cross(&spin), twist, bend: turn - twist }
    }
}

/// The part of a vector along n, whose length is made 1 once more.
fn projected(a: &Vector3<f64>, n: &Vector3<f64>) -> Vector3<f64> {
    let unit = n * (1.0 / norm(n));
    unit * dot(a, &unit)
}

fn evaluate(p: &Params, x: &ClosePair, m: &Motion, h: &mut History, s: &mut Response, e: &mut Effects) {
    let (c, dt, side) = (&p.c, x.call.dt, seen_from(x));
    let zero = Vector3::zeros();
    let delta = h.r0 - m.r;
    let normal = m.n * normal_force(p, delta, &mut h.extremes);
    let old = Vector3::from(h.shear) * side;
    let (mut shear, mut twist, mut bend) = (old, Vector3::from(h.twist) * side, Vector3::from(h.bend) * side);
    let (mut twisting, mut bending) = (zero, zero);
    if c.on.shear {
        shear = (old - projected(&old, &m.n)) - m.shear * (c.shear * p.area * dt);
    }
    if c.on.twist {
        twist += m.twist * dt;
        twisting = torques(&c.twist, p.polar, &twist, &mut h.twist_max, &mut h.twist_min);
    }
    if c.on.bend {
        bend += m.bend * dt;
        bending = torques(&c.bend, p.bending, &bend, &mut h.bend_max, &mut h.bend_min);
    }
    let broken = fails(p, delta, [&normal, &shear, &twisting, &bending]);
    if broken && x.call.update {
        return end(h, e);
    }
    if x.call.update {
        (h.shear, h.twist, h.bend) = ((shear * side).into(), (twist * side).into(), (bend * side).into());
    }
    let rmin = if x.call.is_wall { x.i.radius } else { x.i.radius.min(x.j.radius) };
    let smooth = c.smooth.then_some((1e-5 * rmin / dt, 0.01, dt));
    let fn_ = damped(&normal, c.eta.normal, &m.along, smooth);
    let ft = if c.on.shear { damped(&shear, c.eta.shear, &m.shear, smooth) } else { zero };
    let tn = damped(&twisting, c.eta.twist, &m.twist, None);
    let tt = damped(&bending, c.eta.bend, &m.bend, None);
    let arm = ft.cross(&m.n);
    if x.call.is_wall {
        return e.replace(s, fn_ + ft, arm * m.r + tn + tt, zero);
    }
    let sum = 1.0 / (x.i.radius + x.j.radius);
    let (cri, crj) = (m.r * x.i.radius * sum, m.r * x.j.radius * sum);
    e.replace(s, fn_ + ft, arm * cri + tn + tt, arm * crj - tn - tt);
}

/// F_n \[N\]. Branch 1 of (6) gives way to branch 2, as the extreme is moved first; and the extreme of the side that
/// δ is not on is forgotten.
fn normal_force(p: &Params, delta: f64, [max, min]: &mut [f64; 2]) -> f64 {
    let (press, pull) = (&p.c.compression, &p.c.tension);
    let (largest, smallest) = (max.max(delta), min.min(delta));
    *max = if delta < 0.0 { 0.0 } else { largest };
    *min = if delta > 0.0 { 0.0 } else { smallest };
    if !(p.c.on_tension && delta < -DEADBAND || p.c.on.normal && delta > DEADBAND) {
        return 0.0;
    }
    match () {
        _ if delta < pull.left * smallest => {
            pull.ku * p.area * delta + (pull.k - pull.ku) * p.area * smallest
        }
        _ if delta < 0.0 => -pull.kc * p.area * delta,
        _ if delta < press.left * press.left * largest => -press.kc * delta.sqrt(),
        _ if delta < largest => press.ku * delta.sqrt() + (press.k - press.ku) * largest.sqrt(),
        _ => press.k * delta.sqrt(),
    }
}

/// Torque of each axis by itself \[N m\], with its extremes moved on afterwards; `area` is J or I.
fn torques(
    line: &Line,
    area: f64,
    theta: &Vector3<f64>,
    max: &mut [f64; 3],
    min: &mut [f64; 3],
) -> Vector3<f64> {
    let Line { k, ku, kc, left } = *line;
    Vector3::from_fn(|axis, _| {
        let (t, max, min) = (theta[axis], &mut max[axis], &mut min[axis]);
        if t > 0.0 {
            *min = 0.0;
        } else if t < 0.0 {
            *max = 0.0;
        }
        let torque = match () {
            _ if t >= *max || t <= *min => -k * area * t,
            _ if t > left * *max => -ku * area * t + (ku - k) * area * *max,
            _ if t >= left * *min => kc * area * t,
            _ => -ku * area * t + (ku - k) * area * *min,
        };
        (*max, *min) = (t.max(*max), t.min(*min));
        torque
    })
}

/// Each axis damped by the sign of its own velocity; `smooth` holds the least velocity and two factors that make one of
/// the load, with its sign.
fn damped(load: &Vector3<f64>, eta: f64, v: &Vector3<f64>, smooth: Option<(f64, f64, f64)>) -> Vector3<f64> {
    let sign = |x: f64| if x == 0.0 { 0.0 } else { x.signum() };
    load.zip_map(v, |load, v| {
        let way = match smooth {
            Some((least, scale, dt)) => (v / least.max(scale * load * dt)).clamp(-1.0, 1.0),
            None => sign(v),
        };
        load - eta * load.abs() * way
    })
}

fn fails(p: &Params, delta: f64, [normal, shear, twist, bend]: [&Vector3<f64>; 4]) -> bool {
    let Breaks::Stress { sigma, tau, ratio } = p.c.breaks else { return false };
    let limit = if delta < -DEADBAND { ratio * sigma } else { sigma };
    limit < norm(normal) / p.area + norm(bend) * p.radius / p.bending
        || tau < norm(shear) / p.area + norm(twist) * p.radius / p.polar
}
