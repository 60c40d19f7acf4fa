//! Integrates spheres in a row, each bonded to the next: two of them, or a chain.
//!
//! The scheme is that of [`granlaw::pair`], LIGGGHTS's velocity Verlet with its operations in its order. Bonds begin in the first
//! step, in which nothing acts yet.
use super::bonded_row::BondedRow;
use super::collision::{beads, Collision, Outcome};
use granlaw::chain::Chain;
use granlaw::model::{Body, Call, Contact, Response};
use granlaw::pair::{approach, Start};
use nalgebra::Vector3;

/// The spheres of a row one step of `dt` \[s\] before its bonds begin.
pub fn ahead(collision: &Collision, bonded: &BondedRow, dt: f64) -> Vec<Body> {
    let mut all = beads(collision, bonded);
    all.iter_mut().for_each(|b| b.x -= b.v * dt);
    all
}

/// A row in motion.
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
            let mut s = Response::default();
            let sum = gap.i.radius + gap.j.radius;
            if gap.rsq < sum * sum {
                self.chain.surfaces_intersect((0, 0), &Contact::pair(gap), history, &mut s);
            } else {
                self.chain.surfaces_close((0, 0), &gap, history, &mut s);
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

/// What is observed on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// The largest kinetic energy.
    Energy,
    /// One swing out and back: its largest force and its duration. The row is followed no further.
    Once {
        /// Whether forces are kept.
        with_force: bool,
    },
    /// Nothing but the end.
    End,
}

/// A row is followed for this many times the duration of its swing, until all its bonds are slack.
const LONGER: f64 = 1.2;

/// This number of steps, rounded up so that [`every`] divides it.
pub fn whole(steps: f64) -> u64 {
    let n = steps.ceil() as u64;
    if n < 128 {
        n
    } else {
        n.next_multiple_of(128)
    }
}

/// The energy is observed once in this many steps, so that LIGGGHTS can report it at the same ones.
pub fn every(steps: u64) -> u64 {
    (steps / 128).max(1)
}

/// Integrates a row over a number of steps of `dt` \[s\].
pub fn run(
    chain: &mut Chain,
    collision: &Collision,
    bonded: &BondedRow,
    (dt, steps): (f64, u64),
    look: Look,
) -> Outcome {
    let bodies = ahead(collision, bonded, dt);
    let n = bodies.len();
    let (histories, forces) = (vec![vec![0.0; chain.row()]; n - 1], vec![[Vector3::zeros(); 2]; n]);
    let mut row =
        Row { chain, start: collision.start(dt, 0.0, steps), bodies, histories, forces, first: 0.0 };
    let mut swing = Swing {
        whole: length(&beads(collision, bonded)),
        sign: collision.speed.signum(),
        ..Swing::default()
    };
    let mut most = 1.0f64;
    row.evaluate(0, false);
    for step in 1..=steps {
        row.kick(0.5 * dt);
        row.bodies.iter_mut().for_each(|b| b.x += dt * b.v);
        row.evaluate(step as i64, true);
        row.kick(0.5 * dt);
        match look {
            Look::Energy if step % every(steps) == 0 => most = most.max(collision.judge(&row.bodies).energy),
            Look::Once { with_force } if swing.over(&row, dt * (step - 1) as f64, dt, with_force) => break,
            _ => {}
        }
        if !row.bodies[0].x.x.is_finite() {
            break;
        }
    }
    let end = collision.judge(&row.bodies);
    let energy = if look == Look::Energy { most } else { end.energy };
    let Outcome { peak, duration, parted, force, .. } = swing.seen;
    Outcome { peak, duration, parted, force, energy, ..end }
}

/// Distance of the first and the last \[m\].
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
    /// Takes a state. Returns whether the swing is over.
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
