//! One contact from first touch to last: two spheres, or a sphere and a wall, collision at each other.
use super::bonded_row::{random, BondedRow, Way};
use granlaw::model::Body;
use granlaw::pair::{Opened, Partner, Start, State};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// How two bodies meet. A pair meets along x, its centre of mass at rest; a wall lies at z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collision {
    /// Radius of i \[m\].
    pub radius: f64,
    /// Radius of j over that of i.
    pub ratio: f64,
    /// Density of i \[kg/m³\].
    pub density: f64,
    /// Density of j over that of i.
    pub heavier: f64,
    /// Atom types, from 0; of a wall, that of its material.
    pub types: (usize, usize),
    /// Whether i meets a wall.
    pub wall: bool,
    /// Normal speed of approach \[m/s\].
    pub speed: f64,
    /// Tangential velocity of i against its partner \[m/s\].
    pub slide: f64,
    /// If set, a sphere that rests on the wall and is then given `speed` and `slide`.
    pub rest: Option<Rest>,
    /// If set, bonded spheres in a row along x, or with `rest` one sphere that hangs on the wall by a bond.
    pub bonded: Option<BondedRow>,
}

/// A sphere that rests on the wall by its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Acceleration of gravity \[m/s²\].
    pub gravity: f64,
    /// Overlap at rest \[m\]; of a sphere that hangs, the extension of its bond.
    pub sunk: f64,
    /// Time for which it is followed \[s\].
    pub time: f64,
    /// Whether it begins by rolling without sliding; if not, it begins without spin.
    pub rolls: bool,
}

/// The outcome of a contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Normal speed of separation over that of approach, along the line of the approach.
    pub restitution: f64,
    /// Largest normal force \[N\].
    pub peak: f64,
    /// Time from first touch to last \[s\].
    pub duration: f64,
    /// Spin of i about the axis about which friction turns it \[rad/s\].
    pub spin: f64,
    /// Kinetic energy, with that of spin, over that at the start, in the frame in which the centre of mass rests.
    pub energy: f64,
    /// Coordinate x of i \[m\].
    pub distance: f64,
    /// The part of the tangential speed that is left; of a sphere that hangs, of the speed with which it first swung through its place of
    /// rest.
    pub left: f64,
    /// Whether the surfaces are apart at the end.
    pub apart: bool,
    /// Whether the surfaces parted.
    pub parted: bool,
    /// Whether all numbers stayed finite.
    pub finite: bool,
    /// Normal force \[N\] over the time since first touch \[s\].
    pub force: Vec<(f64, f64)>,
}

impl Collision {
    /// Two equal spheres that meet head-on.
    pub const fn head_on(radius: f64, density: f64, speed: f64) -> Collision {
        let (ratio, heavier, types) = (1.0, 1.0, (0, 0));
        Collision {
            radius,
            ratio,
            density,
            heavier,
            types,
            wall: false,
            speed,
            slide: 0.0,
            rest: None,
            bonded: None,
        }
    }

    /// The bodies, just touching; of a row, its first two at the moment when bonds begin.
    pub fn bodies(&self) -> [Body; 2] {
        if let Some(bonded) = self.row() {
            let all = beads(self, &bonded);
            return [all[0], all[1]];
        }
        let sphere = |tag: i64, radius: f64| Body {
            tag,
            radius,
            mass: 4.0 / 3.0 * PI * radius.powi(3) * self.density,
            ..Body::default()
        };
        let (mut i, mut j) = (sphere(1, self.radius), sphere(2, self.radius * self.ratio));
        j.mass *= self.heavier;
        if let (Some(bonded), true) = (self.bonded, self.wall) {
            i.x = Vector3::z() * (i.radius + bonded.gap);
            return [i, Body::default()];
        }
        if let Some(rest) = self.rest {
            (i.x, i.v) = (Vector3::z() * (i.radius - rest.sunk), Vector3::new(self.slide, 0.0, -self.speed));
            if rest.rolls {
                i.omega = Vector3::y() * (self.slide / (i.radius - 0.5 * rest.sunk));
            }
            return [i, Body::default()];
        }
        if self.wall {
            (i.x, i.v) = (Vector3::z() * i.radius, Vector3::new(self.slide, 0.0, -self.speed));
            return [i, Body::default()];
        }
        (i.x, j.x) = (Vector3::x() * i.radius, Vector3::x() * -j.radius);
        let (v, total) = (Vector3::new(-self.speed, self.slide, 0.0), i.mass + j.mass);
        (i.v, j.v) = (v * (j.mass / total), v * -(i.mass / total));
        [i, j]
    }

    /// Effective mass \[kg\].
    pub fn meff(&self) -> f64 {
        let [i, j] = self.bodies();
        if self.wall {
            i.mass
        } else {
            i.mass * j.mass / (i.mass + j.mass)
        }
    }

    /// The start of an integration, `before` steps ahead of first touch.
    pub fn start(&self, dt: f64, before: f64, steps: u64) -> Start {
        let mut bodies = self.bodies();
        for body in bodies.iter_mut().filter(|_| self.rest.is_none()) {
            body.x -= body.v * (dt * before);
        }
        let partner = match self.wall {
            true => Partner::Plane { point: Vector3::zeros(), normal: Vector3::z() },
            false => Partner::Free,
        };
        let gravity = Vector3::z() * self.rest.map_or(0.0, |r| -r.gravity);
        let opened = if self.bonded.is_some() { Opened::Closes } else { Opened::Keeps };
        let types = self.types;
        Start { bodies, types, partner, dt, steps, first: 0, gravity, opened }
    }

    fn normal(&self) -> Vector3<f64> {
        if self.wall {
            Vector3::z()
        } else {
            Vector3::x()
        }
    }

    /// How spheres are bonded in a row, if they are.
    pub fn row(&self) -> Option<BondedRow> {
        self.bonded.filter(|_| !self.wall)
    }

    /// All bodies that move, at the start.
    fn begun(&self) -> Vec<Body> {
        match self.row() {
            Some(bonded) => beads(self, &bonded),
            _ => self.bodies()[..if self.wall { 1 } else { 2 }].to_vec(),
        }
    }

    /// The outcome as far as it follows from the motion of the bodies, of a row from its first and last; forces and times are left to
    /// the caller.
    pub fn judge(&self, bodies: &[Body]) -> Outcome {
        let (i, j) = (&bodies[0], &bodies[bodies.len() - 1]);
        let apart = if self.wall { i.v } else { i.v - j.v }.dot(&self.normal());
        let left = match (self.rest, self.bonded) {
            (Some(r), Some(_)) => i.v.z / (r.gravity * r.sunk).abs().sqrt(),
            _ => i.v.x / self.slide,
        };
        let outcome = Outcome {
            restitution: apart / self.speed,
            spin: if self.wall { i.omega.y } else { i.omega.z },
            energy: self.energy(if self.wall { &bodies[..1] } else { bodies }),
            distance: i.x.x,
            left,
            apart: self.overlap(bodies) < 0.0,
            ..Outcome::default()
        };
        let finite = [outcome.distance, outcome.spin, outcome.energy].iter().all(|x| x.is_finite());
        Outcome { finite, ..outcome }
    }

    /// Kinetic energy over that at the start. Of a sphere that rests, the energy of its spring is added to both; of one that hangs, the
    /// reference is the energy gained by falling to its place of rest.
    fn energy(&self, bodies: &[Body]) -> f64 {
        let one = |b: &Body| {
            0.5 * b.mass * (b.v.norm_squared() + 0.4 * b.radius * b.radius * b.omega.norm_squared())
        };
        let kinetic = |all: &[Body]| all.iter().map(one).sum::<f64>();
        let Some(r) = self.rest else { return kinetic(bodies) / kinetic(&self.begun()) };
        if self.bonded.is_some() {
            return kinetic(bodies) / (0.5 * bodies[0].mass * (r.gravity * r.sunk).abs());
        }
        let all = |b: &[Body]| {
            // The spring of a sphere at rest, relative to its place of rest.
            let off = b[0].x.z - (b[0].radius - r.sunk);
            kinetic(b) + 0.5 * b[0].mass * r.gravity / r.sunk * off * off
        };
        all(bodies) / all(&self.begun())
    }

    /// The overlap of the surfaces \[m\]; negative when apart. Of a row, the change of its length, positive in the direction in which it
    /// was set going.
    pub fn overlap(&self, bodies: &[Body]) -> f64 {
        let (i, j) = (&bodies[0], &bodies[bodies.len() - 1]);
        if self.wall {
            return i.radius - i.x.z;
        }
        let length = (i.x - j.x).norm();
        if self.row().is_some() {
            let begun = self.begun();
            return self.speed.signum() * ((begun[0].x - begun[begun.len() - 1].x).norm() - length);
        }
        i.radius + j.radius - length
    }
}

/// The spheres of a row at the moment when its bonds begin; the first has the largest x.
pub fn beads(collision: &Collision, bonded: &BondedRow) -> Vec<Body> {
    let n = bonded.beads;
    let mut all: Vec<Body> = Vec::with_capacity(n);
    for k in 0..n {
        let radius = if k % 2 == 1 { collision.radius * collision.ratio } else { collision.radius };
        let mass = 4.0 / 3.0 * PI * radius.powi(3) * collision.density;
        let x = all.last().map_or(0.0, |b: &Body| b.x.x - (b.radius + bonded.gap + radius));
        all.push(Body { tag: k as i64 + 1, radius, mass, x: Vector3::x() * x, ..Body::default() });
    }
    let total: f64 = all.iter().map(|b| b.mass).sum();
    for k in 0..n {
        // Two spheres of any masses have no momentum together; in longer rows all have the same mass.
        let shape = match n {
            2 => [total - all[0].mass, all[1].mass - total][k] / total,
            _ => (PI * (k as f64 + 0.5) / n as f64).cos() / (2.0 * (PI / (2 * n) as f64).cos()),
        };
        let b = &mut all[k];
        match bonded.way {
            Way::Along => b.v.x = -collision.speed * shape,
            Way::Shear => b.v.y = collision.slide * shape,
            Way::Bend => b.omega.z = collision.slide * shape / b.radius,
            Way::Twist => b.omega.x = collision.slide * shape / b.radius,
            Way::AlongAtRandom(seed) => b.v.x = collision.speed * random(seed, k),
            Way::TwistAtRandom(seed) => b.omega.x = collision.slide * random(seed, k) / b.radius,
        }
    }
    all
}

/// Follows an integration step by step and finds when the contact is over.
#[derive(Debug)]
pub struct Follow<'a> {
    collision: &'a Collision,
    start: &'a Start,
    before: f64,
    with_force: bool,
    overlap: f64,
    seen: Outcome,
}

impl<'a> Follow<'a> {
    /// Follows an integration that begins `before` steps ahead of first touch; forces are kept if asked for.
    pub fn new(collision: &'a Collision, start: &'a Start, before: f64, with_force: bool) -> Follow<'a> {
        Follow { collision, start, before, with_force, overlap: 0.0, seen: Outcome::default() }
    }

    /// Takes a state. Returns whether to go on.
    pub fn step(&mut self, s: &State) -> bool {
        if self.collision.rest.is_some() {
            return s.bodies[0].x.x.is_finite();
        }
        let overlap = self.collision.overlap(&s.bodies);
        let dt = self.start.dt;
        let time = dt * ((s.step - self.start.first) as f64 - self.before);
        let was = std::mem::replace(&mut self.overlap, overlap);
        if s.touching {
            self.seen.peak = self.seen.peak.max(s.response.fn_);
            if self.with_force {
                self.seen.force.push((time, s.response.fn_));
            }
        } else if time > dt {
            // Surfaces part between two steps, where the velocity is nearly constant.
            self.seen.duration = time + dt * overlap / (was - overlap);
            self.seen.parted = true;
        }
        !self.seen.parted && overlap.is_finite()
    }

    /// The outcome.
    pub fn end(self, bodies: &[Body]) -> Outcome {
        let Outcome { peak, duration, parted, force, .. } = self.seen;
        Outcome { peak, duration, parted, force, ..self.collision.judge(bodies) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_begin_without_momentum_and_as_wide_apart_as_they_are_told() {
        let bonded = |beads, way| BondedRow { beads, gap: 1e-5, way };
        let collision = Collision { ratio: 0.5, slide: 0.3, ..Collision::head_on(1e-3, 1000.0, 0.2) };
        let two = beads(&collision, &bonded(2, Way::Along));
        let momentum: f64 = two.iter().map(|b| b.mass * b.v.x).sum();
        assert!(momentum.abs() < 1e-18 && (two[1].v.x - two[0].v.x - 0.2).abs() < 1e-15);
        assert!((two[0].x.x - two[1].x.x - 1.51e-3).abs() < 1e-18);
        let many = beads(&Collision { ratio: 1.0, ..collision }, &bonded(7, Way::Along));
        assert!((many[6].v.x - many[0].v.x - 0.2).abs() < 1e-15 && many[3].v.x.abs() < 1e-15);
        let at_random = beads(&collision, &bonded(100, Way::AlongAtRandom(3)));
        assert!(at_random.iter().all(|b| b.v.x.abs() <= 0.2) && at_random.iter().any(|b| b.v.x > 0.1));
        assert_ne!(at_random[0].v, beads(&collision, &bonded(100, Way::AlongAtRandom(4)))[0].v);
    }
}
