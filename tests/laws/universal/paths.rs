//! Rules that follow a contact along a path: no jumps, no energy from nothing, and `observe` tells the truth.
use super::recipe::{reseen, Case, Draw, Recipe, Subject};
use super::rules::force_scale;
use granlaw::model::*;
use nalgebra::Vector3;

type Outcome = Result<(), String>;

/// Somewhere between two states of a contact.
fn between(a: &Case, b: &Case, t: f64) -> Case {
    let mix = |a: f64, b: f64| a + (b - a) * t;
    let mix3 = |a: &Vector3<f64>, b: &Vector3<f64>| a + (b - a) * t;
    let mut c = a.clone();
    for (body, to) in
        [(&mut c.contact.close.i, b.contact.close.i), (&mut c.contact.close.j, b.contact.close.j)]
    {
        (body.x, body.v) = (mix3(&body.x, &to.x), mix3(&body.v, &to.v));
        body.omega = mix3(&body.omega, &to.omega);
    }
    c.contact.surface.deltan = mix(a.contact.surface.deltan, b.contact.surface.deltan);
    c.contact = reseen(&c.contact);
    c.history = a.history.iter().zip(&b.history).map(|(a, b)| mix(*a, *b)).collect();
    c
}

/// A state near enough to `a` that all states between them are contacts: the partner comes closer or parts a little,
/// moves otherwise, and remembers otherwise. One time in four all motion reverses, through rest exactly.
fn another(a: &Case, d: &mut Draw<'_>) -> Case {
    let mut b = a.clone();
    let gap = &mut b.contact.close;
    let way = gap.delta * (1.0 / gap.delta.norm());
    let deltan = a.contact.surface.deltan * d.within(0.02, 2.0);
    gap.i.x += way * (a.contact.surface.deltan - deltan);
    let reverse = d.unit() < 0.25;
    for body in [&mut gap.i, &mut gap.j] {
        let (v, omega) = (d.vector(1.0), d.vector(100.0));
        (body.v, body.omega) = if reverse { (-body.v, -body.omega) } else { (v, omega) };
    }
    if gap.call.is_wall {
        (gap.j.v, gap.j.omega) = (Vector3::zeros(), Vector3::zeros());
    }
    b.contact.surface.deltan = deltan;
    b.history.iter_mut().for_each(|h| *h = a.contact.close.i.radius * d.within(-0.02, 0.06));
    b.contact = reseen(&b.contact);
    b
}

/// No jump between two states. The largest change along the way is cut in half again and again: a steep slope
/// vanishes in that, a jump stays.
pub fn continuous(r: &Recipe, a: &Case, d: &mut Draw<'_>) -> Outcome {
    let b = another(a, d);
    let mut subject = r.subject();
    let mut scale = 0.0f64;
    let arm = a.contact.close.i.radius;
    let mut at = |t: f64| {
        let c = between(a, &b, t);
        let s = subject.surfaces_intersect(c.types, &c.contact, &mut c.history.clone());
        scale = scale.max(force_scale(&s, &c.contact, &c.history));
        [s.force, s.torque_i / arm, s.torque_j / arm]
    };
    let change = |p: &[Vector3<f64>; 3], q: &[Vector3<f64>; 3]| -> f64 {
        p.iter().zip(q).map(|(p, q)| (p - q).norm()).fold(0.0, f64::max)
    };
    let n = 64;
    let walk: Vec<_> = (0..=n).map(|k| at(k as f64 / n as f64)).collect();
    let steps = || (0..n).map(|k| (k, change(&walk[k], &walk[k + 1])));
    // Halve every interval with more than its share of change, as a small jump may hide beside a steep slope.
    let share = 4.0 * steps().map(|(_, c)| c).sum::<f64>() / n as f64;
    let mut worst = (0.0, 0.0);
    for (k, _) in steps().filter(|(_, c)| *c >= share) {
        let (mut lo, mut hi) = (k as f64 / n as f64, (k + 1) as f64 / n as f64);
        let (mut p, mut q) = (walk[k], walk[k + 1]);
        for _ in 0..36 {
            let mid = 0.5 * (lo + hi);
            let m = at(mid);
            if change(&p, &m) > change(&m, &q) {
                (hi, q) = (mid, m);
            } else {
                (lo, p) = (mid, m);
            }
        }
        if change(&p, &q) > worst.1 {
            worst = (lo, change(&p, &q));
        }
    }
    // After 36 halvings of 1/64 a slope of a thousand times the scale per unit of the path has become 1e-10.
    if worst.1 <= 1e-7 * scale {
        return Ok(());
    }
    Err(format!("jumps by {:e} of {scale:e} at {} of the way", worst.1, worst.0))
}

/// The corners of a cycle: overlap, sideways shift and turn of i; it begins and ends out of contact.
type Corners = Vec<(f64, f64, f64)>;

/// What the contact gives over a cycle, and what goes back and forth in it \[J\]. Positions are prescribed, j rests.
fn work(subject: &mut Subject, c: &Case, corners: &Corners) -> (f64, f64) {
    let (steps, dt) = (1500, 1e-6);
    let (i, j) = (c.contact.close.i, c.contact.close.j);
    let call = Call { dt, update: true, ..c.contact.close.call };
    let reach = i.radius + if call.is_wall { 0.0 } else { j.radius };
    let place = |(overlap, shift, _): (f64, f64, f64)| match call.is_wall {
        true => Vector3::new(reach - overlap, shift, 0.0),
        false => {
            let angle = shift / reach;
            Vector3::new(angle.cos(), angle.sin(), 0.0) * (reach - overlap)
        }
    };
    let mut h = vec![0.0; c.history.len()];
    let (mut x, mut last) = (place(corners[0]), Response::default());
    let (mut given, mut moved) = (0.0, 0.0);
    for leg in corners.windows(2) {
        for k in 1..=steps {
            let t = k as f64 / steps as f64;
            let mix = |a: f64, b: f64| a + (b - a) * t;
            let now = (mix(leg[0].0, leg[1].0), mix(leg[0].1, leg[1].1), mix(leg[0].2, leg[1].2));
            let (to, turn) = (place(now), (leg[1].2 - leg[0].2) / steps as f64);
            let (way, angle) = (to - x, Vector3::new(0.0, 0.3 * turn, turn));
            let i = Body { x: to, v: way / dt, omega: angle / dt, ..i };
            let foot = if call.is_wall { Vector3::new(0.0, to.y, 0.0) } else { Vector3::zeros() };
            let j = Body { x: foot, v: Vector3::zeros(), omega: Vector3::zeros(), ..j };
            let mut s = Response::default();
            if now.0 > 0.0 {
                let gap = ClosePair { call, i, j, meff: c.contact.close.meff, ..ClosePair::default() };
                let surface = Surface { deltan: now.0, ..Surface::default() };
                s = subject.surfaces_intersect(c.types, &reseen(&Contact { close: gap, surface }), &mut h);
            }
            // The trapezoid is exact for springs and second order in the step for the rest.
            let w = 0.5 * (last.force + s.force).dot(&way) + 0.5 * (last.torque_i + s.torque_i).dot(&angle);
            (given, moved) = (given + w, moved + w.abs());
            (x, last) = (to, s);
        }
    }
    (given, moved)
}

/// A closed cycle gives no more energy than it took.
pub fn cycle(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    let size = 0.02 * c.contact.close.i.radius;
    let mut some = |scale: f64| scale * size * d.within(-1.0, 1.0);
    let (s1, s2, s3) = (some(1.0), some(1.0), some(3.0));
    let (t1, t2) = (some(30.0), some(30.0));
    let deep = size * d.within(0.2, 2.0);
    let shallow = deep * d.within(0.05, 0.9);
    // In, sheared shallow, deeper, sheared back, up, turned, down again, out. Shear taken up shallow and given back
    // deep is what a stiffness that follows the overlap cannot bear.
    let corners = vec![
        (0.0, 0.0, 0.0),
        (shallow, 0.0, 0.0),
        (shallow, s1, 0.0),
        (deep, s1, 0.0),
        (deep, 0.1 * s1, 0.0),
        (0.3 * shallow, s2, t1),
        (deep, s3, t2),
        (shallow, 0.0, 0.0),
        (0.0, 0.0, 0.0),
    ];
    let mut subject = r.subject();
    let worst = [&corners[..], &[&corners[..5], &corners[8..]].concat()[..]]
        .map(|corners| work(&mut subject, c, &corners.to_vec()))
        .into_iter()
        .fold((0.0, 1.0), |worst: (f64, f64), w| if w.0 / w.1 > worst.0 / worst.1 { w } else { worst });
    // 1500 steps a leg: the one step at each corner in which velocity and force do not belong together is 1e-3.
    if worst.0 <= 1e-3 * worst.1 {
        return Ok(());
    }
    Err(format!("gives {:e} J of {:e} J moved", worst.0, worst.1))
}

/// `observe` of a normal law against the difference quotients of its force, and its stored energy against what comes
/// back on the way to zero force.
pub fn observed(r: &Recipe, c: &Case, _: &mut Draw<'_>) -> Outcome {
    let mut subject = r.subject();
    let (deltan, vn) = (c.contact.surface.deltan, c.contact.surface.vn);
    let now = subject.observe(c.types, &c.at(deltan, 0.0), &c.history);
    let fast = subject.observe(c.types, &c.at(deltan, vn), &c.history);
    let force = |subject: &mut Subject, deltan: f64, vn: f64| {
        subject.surfaces_intersect(c.types, &c.at(deltan, vn), &mut c.history.clone())
    };
    let step = 1e-5 * deltan;
    let near =
        [deltan - step, deltan + step].map(|x| subject.observe(c.types, &c.at(x, 0.0), &c.history).branch);
    let [low, high] = [deltan - step, deltan + step].map(|x| force(&mut subject, x, 0.0));
    if near == [now.branch; 2] {
        let slope = (high.fn_ - low.fn_) / (2.0 * step);
        // Round-off 1e-16/1e-5 and the curvature of Hertz 1e-10; relative to the stiffest spring there is.
        agree("stiffness", now.stiffness, slope, 1e-8 * high.kn.max(now.stiffness.abs()))?;
    }
    let s = force(&mut subject, deltan, vn);
    agree("damping", fast.damping, s.gamman, 1e-14 * s.gamman)?;
    agree("dissipated power", fast.dissipated, s.gamman * vn * vn, 1e-13 * s.gamman * vn * vn)?;
    agree("stored energy", now.stored, returned(&mut subject, c), 1e-5 * high.kn * deltan * deltan)
}

/// What a normal law gives back from here until its force vanishes, slowly \[J\].
fn returned(subject: &mut Subject, c: &Case) -> f64 {
    let (n, mut h) = (20_000, c.history.clone());
    let mut at = |overlap: f64| subject.surfaces_intersect(c.types, &c.at(overlap, 0.0), &mut h).fn_;
    let deltan = c.contact.surface.deltan;
    let (mut sum, mut last) = (0.0, at(deltan));
    for k in (0..n).rev() {
        let f = at(deltan * k as f64 / n as f64);
        if last <= 0.0 {
            break;
        }
        // Of a force that turns negative within the step, the triangle that is left.
        let part = if f < 0.0 { last / (last - f) } else { 1.0 };
        sum += 0.5 * (last + f.max(0.0)) * part * deltan / n as f64;
        last = f;
    }
    sum
}

fn agree(what: &str, told: f64, true_: f64, tolerance: f64) -> Outcome {
    if (told - true_).abs() <= tolerance {
        return Ok(());
    }
    Err(format!("{what}: observe tells {told:e}, it is {true_:e}"))
}
