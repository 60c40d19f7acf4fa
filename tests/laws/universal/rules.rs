//! The rules that every law obeys, one function each. A rule is broken by an `Err` that says where.
use super::recipe::{for_all, reseen, Case, Draw, Fault, Laws, Recipe, Switches};
use granlaw::model::*;
use nalgebra::{Rotation3, Vector3};
use std::cell::RefCell;
use std::panic::{catch_unwind, AssertUnwindSafe};

pub type Outcome = Result<(), String>;

/// Two numbers agree within `tolerance` of `scale`.
pub fn close(what: &str, a: f64, b: f64, tolerance: f64, scale: f64) -> Outcome {
    if (a - b).abs() <= tolerance * scale {
        return Ok(());
    }
    Err(format!("{what}: {a:e} against {b:e}, scale {scale:e}"))
}

pub fn close3(what: &str, a: &Vector3<f64>, b: &Vector3<f64>, tolerance: f64, scale: f64) -> Outcome {
    close(what, (a - b).norm(), 0.0, tolerance, scale)
}

/// The largest force that any term of the answer can have: cancelling terms round off relative to it.
pub fn force_scale(s: &Response, x: &Contact, h: &[f64]) -> f64 {
    let speed = x.surface.vn.abs() + x.surface.vtr.norm();
    let shear = h.iter().fold(0.0, |m: f64, h| m.max(h.abs())) + speed * x.close.call.dt;
    s.fn_.abs() + s.kn * x.surface.deltan + (s.gamman + s.gammat) * speed + s.kt * shear
}

/// Runs of three slots named …x, …y, …z are vectors.
pub fn vectors(slots: &[Slot]) -> Vec<usize> {
    let named = |k: usize, axis: &str| slots.get(k).and_then(|s| s.name.strip_suffix(axis));
    let is_vector = |k: &usize| {
        let stem = named(*k, "x");
        stem.is_some() && stem == named(k + 1, "y") && stem == named(k + 2, "z")
    };
    (0..slots.len()).filter(is_vector).collect()
}

/// i and j change places: the force turns round, torques change hands, history follows its flags. To the last bit,
/// as every operation is odd or symmetric.
pub fn swap(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    if c.contact.close.call.is_wall {
        return Ok(());
    }
    let mut subject = r.subject();
    let turn = |slots: &[Slot], h: &[f64]| -> Vec<f64> {
        h.iter().zip(slots).map(|(h, s)| if s.newton == Newton::Odd { -h } else { *h }).collect()
    };
    let (mut h, mut mirrored) = (c.history.clone(), turn(&subject.slots, &c.history));
    let mut y = c.contact;
    std::mem::swap(&mut y.close.i, &mut y.close.j);
    let a = subject.surfaces_intersect(c.types, &c.contact, &mut h);
    let b = subject.surfaces_intersect((c.types.1, c.types.0), &reseen(&y), &mut mirrored);
    close3("force", &a.force, &-b.force, 0.0, 1.0)?;
    close3("torque on i", &a.torque_i, &b.torque_j, 0.0, 1.0)?;
    close3("torque on j", &a.torque_j, &b.torque_i, 0.0, 1.0)?;
    let back = turn(&subject.slots, &mirrored);
    if h != back {
        return Err(format!("history: {h:?} against {back:?}"));
    }
    Ok(())
}

/// The whole picture is turned, and the answers turn with it.
pub fn rotation(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    let mut subject = r.subject();
    let q = Rotation3::new(d.direction() * 2.0);
    let turn = |slots: &[Slot], h: &[f64]| {
        let mut h = h.to_vec();
        for k in vectors(slots) {
            let v = q * Vector3::from_column_slice(&h[k..k + 3]);
            h[k..k + 3].copy_from_slice(v.as_slice());
        }
        h
    };
    let (mut h, mut turned) = (c.history.clone(), turn(&subject.slots, &c.history));
    let mut y = c.contact;
    for b in [&mut y.close.i, &mut y.close.j] {
        (b.x, b.v, b.omega) = (q * b.x, q * b.v, q * b.omega);
    }
    let a = subject.surfaces_intersect(c.types, &c.contact, &mut h);
    let b = subject.surfaces_intersect(c.types, &reseen(&y), &mut turned);
    same_motion(c, &subject.slots, (&a, &turn(&subject.slots, &h)), (&b, &turned), &|v| q * v)
}

/// Both bodies get the same velocity and are shifted alike; nothing changes.
pub fn galilean(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    let mut subject = r.subject();
    let (shift, velocity) = (d.vector(0.05), d.vector(2.0));
    let (mut h, mut moved) = (c.history.clone(), c.history.clone());
    let mut y = c.contact;
    for b in [&mut y.close.i, &mut y.close.j] {
        b.x += shift;
        b.v += velocity;
    }
    let a = subject.surfaces_intersect(c.types, &c.contact, &mut h);
    let b = subject.surfaces_intersect(c.types, &reseen(&y), &mut moved);
    same_motion(c, &subject.slots, (&a, &h), (&b, &moved), &|v| v)
}

/// Both answers agree, the first seen through `turn`.
fn same_motion(
    c: &Case,
    slots: &[Slot],
    (a, ha): (&Response, &[f64]),
    (b, hb): (&Response, &[f64]),
    turn: &dyn Fn(Vector3<f64>) -> Vector3<f64>,
) -> Outcome {
    // Positions of 0.1 m round off by 1e-17 m, the least overlap is 1e-6 m: 1e-11; ten times that for what follows.
    let tolerance = 1e-10;
    let scale = force_scale(a, &c.contact, &c.history);
    let arm = c.contact.close.i.radius;
    close3("force", &turn(a.force), &b.force, tolerance, scale)?;
    close3("torque on i", &turn(a.torque_i), &b.torque_i, tolerance, scale * arm)?;
    close3("torque on j", &turn(a.torque_j), &b.torque_j, tolerance, scale * arm)?;
    for ((s, a), b) in slots.iter().zip(ha).zip(hb) {
        close(s.name, *a, *b, tolerance, arm)?;
    }
    Ok(())
}

/// Another metre, kilogram and second: the numbers change by the powers that the units say.
pub fn units(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    // Powers of two scale without rounding; only the fifth root in the stiffness rounds anew, by an ulp or two.
    let (m, kg, s) = (2f64.powi(6), 2f64.powi(-4), 2f64.powi(8));
    let tolerance = 1e-14;
    let scale = |pm: i32, pkg: i32, ps: i32| m.powi(pm) * kg.powi(pkg) * s.powi(ps);
    let of = |u: &Unit| m.sqrt().powi(u.m2.into()) * scale(0, u.kg.into(), u.s.into());
    let mut other = r.clone();
    for setup in &mut other.setups {
        for (p, values) in setup.law.meta.props.iter().zip(&mut setup.values.of) {
            values.iter_mut().for_each(|v| *v *= of(&p.unit));
        }
    }
    let mut y = c.contact;
    y.close.call.dt *= s;
    for b in [&mut y.close.i, &mut y.close.j] {
        (b.radius, b.mass, b.x) = (b.radius * m, b.mass * kg, b.x * m);
        (b.v, b.omega) = (b.v * (m / s), b.omega / s);
    }
    y.surface.deltan *= m;
    y.close.meff *= kg;
    let (mut subject, mut scaled) = (r.subject(), other.subject());
    let mut h = c.history.clone();
    let mut k: Vec<_> = h.iter().zip(&subject.slots).map(|(h, s)| h * of(&s.unit)).collect();
    let a = subject.surfaces_intersect(c.types, &c.contact, &mut h);
    let b = scaled.surfaces_intersect(c.types, &reseen(&y), &mut k);
    let force = scale(1, 1, -2);
    let size = force_scale(&a, &c.contact, &c.history);
    close3("force", &(a.force * force), &b.force, tolerance, size * force)?;
    let arm = c.contact.close.i.radius + c.contact.close.j.radius;
    close3("torque", &(a.torque_i * force * m), &b.torque_i, tolerance, size * arm * force * m)?;
    close("kn", a.kn * scale(0, 1, -2), b.kn, tolerance, b.kn)?;
    close("kt", a.kt * scale(0, 1, -2), b.kt, tolerance, b.kt)?;
    close("γn", a.gamman * scale(0, 1, -1), b.gamman, tolerance, b.gamman)?;
    for ((slot, a), b) in subject.slots.iter().zip(&h).zip(&k) {
        close(slot.name, a * of(&slot.unit), *b, tolerance, arm * of(&slot.unit))?;
    }
    Ok(())
}

/// The pair's angular momentum stays: lever arm × force and both torques cancel.
pub fn angular_momentum(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    if c.contact.close.call.is_wall {
        return Ok(());
    }
    let s = r.subject().surfaces_intersect(c.types, &c.contact, &mut c.history.clone());
    let total = c.contact.close.delta.cross(&s.force) + s.torque_i + s.torque_j;
    let scale = force_scale(&s, &c.contact, &c.history) * c.contact.close.delta.norm();
    // Round-off of a handful of operations.
    close3("total torque", &total, &Vector3::zeros(), 1e-14, scale)
}

/// A query writes no history.
pub fn query(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    let (mut x, mut h) = (c.contact, c.history.clone());
    x.close.call.update = false;
    r.subject().surfaces_intersect(c.types, &x, &mut h);
    if h != c.history {
        return Err(format!("a query made {h:?} of {:?}", c.history));
    }
    Ok(())
}

/// Separation clears the history, and gives no force within reach of overlap only.
pub fn clears(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    let mut h = c.history.clone();
    let mut gap = c.contact.close;
    gap.call.update = true;
    let s = r.subject().surfaces_close(c.types, &gap, &mut h);
    if let Some(k) = h.iter().position(|h| *h != 0.0) {
        return Err(format!("slot {k} keeps {} after separation", h[k]));
    }
    if s.force != Vector3::zeros() && r.setups.iter().all(|s| s.law.meta.reach == Reach::Overlap) {
        return Err(format!("force {} after separation", s.force));
    }
    Ok(())
}

/// The dashpot takes approach and rebound alike.
pub fn odd_damping(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    let mut subject = r.subject();
    let (deltan, vn) = (c.contact.surface.deltan, c.contact.surface.vn);
    let mut at = |v| subject.surfaces_intersect(c.types, &c.at(deltan, v), &mut c.history.clone());
    let (there, back) = (at(vn), at(-vn));
    close("γn", there.gamman, back.gamman, 1e-14, there.gamman.max(back.gamman))?;
    if r.setups.iter().any(|s| s.settings.chosen().any(|(n, o)| n == "limitForce" && o == "on")) {
        return Ok(()); // What limitForce cuts off is not the dashpot's.
    }
    let rest = at(0.0).fn_;
    close("damping force", there.fn_ - rest, rest - back.fn_, 1e-12, force_scale(&there, &c.contact, &[]))
}

/// Whatever comes in, the law answers; and the answer to a number that is none is not a force that looks sound.
pub fn survives(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, f64::MAX];
    let bad = bad[(d.unit() * bad.len() as f64) as usize];
    let (mut gap, mut h, mut overlap) = (c.contact.close, c.history.clone(), c.contact.surface.deltan);
    let fields: [&mut f64; 12] = [
        &mut gap.i.x.x,
        &mut gap.i.v.y,
        &mut gap.i.omega.z,
        &mut gap.i.radius,
        &mut gap.j.x.y,
        &mut gap.j.v.x,
        &mut gap.j.omega.x,
        &mut gap.j.radius,
        &mut gap.meff,
        &mut gap.i.mass,
        &mut gap.call.dt,
        &mut overlap,
    ];
    let k = (d.unit() * (fields.len() + h.len()) as f64) as usize;
    let n = fields.len();
    match fields.into_iter().nth(k) {
        Some(field) => *field = bad,
        None => h[k - n] = bad,
    }
    let x = Contact { close: gap, surface: Surface { deltan: overlap, ..c.contact.surface } };
    let answer = || {
        let mut subject = r.subject();
        let s = subject.surfaces_intersect(c.types, &reseen(&x), &mut h);
        subject.surfaces_close(c.types, &gap, &mut h);
        s
    };
    let s = catch_unwind(AssertUnwindSafe(answer)).map_err(|_| format!("panics on {bad} in place {k}"))?;
    // Velocities enter every force with a dashpot or friction; a NaN velocity of i must not vanish in the answer.
    if bad.is_nan() && k == 1 && s.gamman > 0.0 && s.force.iter().all(|f| f.is_finite()) {
        return Err("a velocity that is no number gives a force that looks sound".into());
    }
    Ok(())
}

/// A wall is a partner without end: what the surface model saw of it, told as a sphere 1e9 times as large and heavy.
pub fn wall_limit(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    if !c.contact.close.call.is_wall {
        return Ok(());
    }
    let mut subject = r.subject();
    let i = c.contact.close.i;
    let large = 1e9;
    let mut y = c.contact;
    y.close.call.is_wall = false;
    // Of a wall LIGGGHTS shows a rolling law a longer spin than of a sphere.
    y.surface.roll = i.omega;
    y.close.j = Body { tag: 2, radius: i.radius * large, mass: i.mass * large, ..y.close.j };
    y.close.meff = i.mass * (large / (1.0 + large));
    y.surface.crj = y.close.j.radius - 0.5 * y.surface.deltan;
    let (mut h, mut k) = (c.history.clone(), c.history.clone());
    let a = subject.surfaces_intersect(c.types, &c.contact, &mut h);
    let b = subject.surfaces_intersect(c.types, &y, &mut k);
    // R* and m* differ from the wall's by 1e-9, and no law has a power above 1 of either.
    let (tolerance, scale) = (1e-8, force_scale(&a, &c.contact, &c.history));
    close3("force", &a.force, &b.force, tolerance, scale)?;
    close3("torque on i", &a.torque_i, &b.torque_i, tolerance, scale * i.radius)?;
    for ((slot, a), b) in subject.slots.iter().zip(&h).zip(&k) {
        close(slot.name, *a, *b, tolerance, i.radius)?;
    }
    Ok(())
}

/// Every slot, empty before, holds something after some contact.
pub fn written(laws: &Laws, fault: Option<Fault>) -> Outcome {
    let seen = RefCell::new(vec![false; laws.iter().map(|e| e.meta.slots.len()).sum()]);
    for_all(laws, Switches::Any, 20, fault, |r, c, _| {
        let (mut x, mut h) = (c.contact, vec![0.0; c.history.len()]);
        x.close.call.update = true;
        r.subject().surfaces_intersect(c.types, &x, &mut h);
        seen.borrow_mut().iter_mut().zip(&h).for_each(|(seen, h)| *seen |= *h != 0.0);
        Ok(())
    })?;
    let empty = seen.into_inner().iter().position(|s| !s);
    match empty {
        None => Ok(()),
        Some(k) => Err(format!("slot {k} is never written")),
    }
}
