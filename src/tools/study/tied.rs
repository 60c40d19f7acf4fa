//! Spheres in a row, each bonded to the next: two of them, or a chain.
//!
//! The scheme is that of [`granlaw::pair`], LIGGGHTS's velocity Verlet with its operations in its order. Bonds begin in the first
//! step, in which nothing acts yet.
use super::shot::{Outcome, Shot};
use granlaw::chain::Chain;
use granlaw::law::{Body, Call, Contact, Stage};
use granlaw::pair::{approach, Start};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// How many spheres a row has, and what sets them going.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tied {
    /// At least two; of unlike sizes in turn.
    pub beads: usize,
    /// Gap between the surfaces when the bonds begin \[m\]: they act across it.
    pub gap: f64,
    /// What moves.
    pub way: Way,
}

/// What sets a row going. Without a number in it, `speed` or `slide` of the shot is the velocity of one end against the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// The slowest mode along the row, together for `speed` above 0, apart below.
    Along,
    /// Across the row.
    Shear,
    /// The ends turn against each other about an axis across the row; surfaces move with `slide`.
    Bend,
    /// About the row.
    Twist,
    /// Every sphere along the row at random, from a seed, up to `speed`.
    AlongAtRandom(u64),
    /// Every sphere about the row at random, up to `slide`.
    TwistAtRandom(u64),
}

/// A number within [−1, 1] for every sphere of a seed (the finaliser of SplitMix64).
fn random(seed: u64, k: usize) -> f64 {
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (k as u64 + 1).rotate_left(32);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// The spheres of a row where its bonds begin, the first at the upper end of x.
pub fn beads(shot: &Shot, tied: &Tied) -> Vec<Body> {
    let n = tied.beads;
    let mut all: Vec<Body> = Vec::with_capacity(n);
    for k in 0..n {
        let radius = if k % 2 == 1 { shot.radius * shot.ratio } else { shot.radius };
        let mass = 4.0 / 3.0 * PI * radius.powi(3) * shot.density;
        let x = all.last().map_or(0.0, |b: &Body| b.x.x - (b.radius + tied.gap + radius));
        all.push(Body { tag: k as i64 + 1, radius, mass, x: Vector3::x() * x, ..Body::default() });
    }
    let total: f64 = all.iter().map(|b| b.mass).sum();
    for k in 0..n {
        // Of two, momentum is zero whatever their masses; of more, they are alike.
        let shape = match n {
            2 => [total - all[0].mass, all[1].mass - total][k] / total,
            _ => (PI * (k as f64 + 0.5) / n as f64).cos() / (2.0 * (PI / (2 * n) as f64).cos()),
        };
        let b = &mut all[k];
        match tied.way {
            Way::Along => b.v.x = -shot.speed * shape,
            Way::Shear => b.v.y = shot.slide * shape,
            Way::Bend => b.omega.z = shot.slide * shape / b.radius,
            Way::Twist => b.omega.x = shot.slide * shape / b.radius,
            Way::AlongAtRandom(seed) => b.v.x = shot.speed * random(seed, k),
            Way::TwistAtRandom(seed) => b.omega.x = shot.slide * random(seed, k) / b.radius,
        }
    }
    all
}

/// The same one step of `dt` \[s\] before.
pub fn ahead(shot: &Shot, tied: &Tied, dt: f64) -> Vec<Body> {
    let mut all = beads(shot, tied);
    all.iter_mut().for_each(|b| b.x -= b.v * dt);
    all
}

/// A row on its way.
struct Row<'a> {
    chain: &'a mut Chain,
    start: Start,
    bodies: Vec<Body>,
    histories: Vec<Vec<f64>>,
    forces: Vec<[Vector3<f64>; 2]>,
    /// Force of the first bond \[N\], positive when it pushes apart.
    first: f64,
}

impl Row<'_> {
    fn kick(&mut self, half: f64) {
        for (b, [force, torque]) in self.bodies.iter_mut().zip(&self.forces) {
            b.v += half / b.mass * force;
            b.omega += half / 0.4 / (b.radius * b.radius * b.mass) * torque;
        }
    }

    fn evaluate(&mut self, step: i64, update: bool) {
        let call = Call { dt: self.start.dt, step, update, counts: update, is_wall: false };
        self.forces.iter_mut().for_each(|f| *f = [Vector3::zeros(); 2]);
        for (k, history) in self.histories.iter_mut().enumerate() {
            let (gap, _) = approach(&self.start, &[self.bodies[k], self.bodies[k + 1]], call);
            let mut s = Stage::default();
            let sum = gap.i.radius + gap.j.radius;
            if gap.rsq < sum * sum {
                self.chain.touch((0, 0), &Contact::pair(gap), history, &mut s);
            } else {
                self.chain.apart((0, 0), &gap, history, &mut s);
            }
            let [i, j] = [[s.force, s.torque_i], [-s.force, s.torque_j]];
            for (at, add) in [(k, i), (k + 1, j)] {
                (0..2).for_each(|d| self.forces[at][d] += add[d]);
            }
            if k == 0 {
                self.first = s.force.dot(&gap.delta) / gap.rsq.sqrt();
            }
        }
    }
}

/// What is looked at on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// The largest kinetic energy.
    Energy,
    /// One swing out and back: its largest force and how long it lasts, and then no more.
    Once {
        /// Whether forces are kept.
        with_force: bool,
    },
    /// Nothing: only the end counts.
    End,
}

/// A row whose swing is over is followed so much longer, until all its bonds are slack.
const LONGER: f64 = 1.2;

/// So many steps, or a few more, that [`every`] divides.
pub fn whole(steps: f64) -> u64 {
    let n = steps.ceil() as u64;
    if n < 128 {
        n
    } else {
        n.next_multiple_of(128)
    }
}

/// Every so many steps the energy is looked at, so that LIGGGHTS can be asked in the same ones.
pub fn every(steps: u64) -> u64 {
    (steps / 128).max(1)
}

/// What becomes of a row in so many steps of `dt` \[s\].
pub fn run(chain: &mut Chain, shot: &Shot, tied: &Tied, (dt, steps): (f64, u64), look: Look) -> Outcome {
    let bodies = ahead(shot, tied, dt);
    let n = bodies.len();
    let (histories, forces) = (vec![vec![0.0; chain.row()]; n - 1], vec![[Vector3::zeros(); 2]; n]);
    let mut row = Row { chain, start: shot.start(dt, 0.0, steps), bodies, histories, forces, first: 0.0 };
    let mut swing =
        Swing { whole: length(&beads(shot, tied)), sign: shot.speed.signum(), ..Swing::default() };
    let mut most = 1.0f64;
    row.evaluate(0, false);
    for step in 1..=steps {
        row.kick(0.5 * dt);
        row.bodies.iter_mut().for_each(|b| b.x += dt * b.v);
        row.evaluate(step as i64, true);
        row.kick(0.5 * dt);
        match look {
            Look::Energy if step % every(steps) == 0 => most = most.max(shot.judge(&row.bodies).energy),
            Look::Once { with_force } if swing.over(&row, dt * (step - 1) as f64, dt, with_force) => break,
            _ => {}
        }
        if !row.bodies[0].x.x.is_finite() {
            break;
        }
    }
    let end = shot.judge(&row.bodies);
    let energy = if look == Look::Energy { most } else { end.energy };
    let Outcome { peak, duration, parted, force, .. } = swing.seen;
    Outcome { peak, duration, parted, force, energy, ..end }
}

/// From the first to the last \[m\].
fn length(bodies: &[Body]) -> f64 {
    (bodies[0].x - bodies[bodies.len() - 1].x).norm()
}

/// One swing out and back.
#[derive(Default)]
struct Swing {
    whole: f64,
    sign: f64,
    way: f64,
    seen: Outcome,
}

impl Swing {
    /// Sees a state; whether it is over.
    fn over(&mut self, row: &Row<'_>, time: f64, dt: f64, with_force: bool) -> bool {
        let now = self.sign * (self.whole - length(&row.bodies));
        let was = std::mem::replace(&mut self.way, now);
        if self.seen.parted {
            return time > LONGER * self.seen.duration;
        }
        if time > 1.5 * dt && now < 0.0 {
            (self.seen.duration, self.seen.parted) = (time + dt * now / (was - now), true);
            return false;
        }
        self.seen.peak = self.seen.peak.max(row.first.abs());
        if with_force {
            self.seen.force.push((time, row.first.abs()));
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_begin_without_momentum_and_as_wide_apart_as_they_are_told() {
        let tied = |beads, way| Tied { beads, gap: 1e-5, way };
        let shot = Shot { ratio: 0.5, slide: 0.3, ..Shot::head_on(1e-3, 1000.0, 0.2) };
        let two = beads(&shot, &tied(2, Way::Along));
        let momentum: f64 = two.iter().map(|b| b.mass * b.v.x).sum();
        assert!(momentum.abs() < 1e-18 && (two[1].v.x - two[0].v.x - 0.2).abs() < 1e-15);
        assert!((two[0].x.x - two[1].x.x - 1.51e-3).abs() < 1e-18);
        let many = beads(&Shot { ratio: 1.0, ..shot }, &tied(7, Way::Along));
        assert!((many[6].v.x - many[0].v.x - 0.2).abs() < 1e-15 && many[3].v.x.abs() < 1e-15);
        let at_random = beads(&shot, &tied(100, Way::AlongAtRandom(3)));
        assert!(at_random.iter().all(|b| b.v.x.abs() <= 0.2) && at_random.iter().any(|b| b.v.x > 0.1));
        assert_ne!(at_random[0].v, beads(&shot, &tied(100, Way::AlongAtRandom(4)))[0].v);
    }
}
