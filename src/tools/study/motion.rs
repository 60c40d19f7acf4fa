//! The symmetric second-order step of two bodies, of any length, from which the better methods are made.
//!
//! Half a kick, the drift, half a kick, as in velocity Verlet; but forces are computed with the velocities of their own instant, found
//! by iteration, and history with the velocities of the middle of the step. So the step is of second order with dashpots and
//! histories too. The laws are used unchanged. They are called once for the force and once for the history, both with the history
//! before the step. The force cannot be asked for after the history was updated, as a slipping contact is then on the border to
//! sticking.
use super::collision::Collision;
use granlaw::chain::Chain;
use granlaw::model::{Body, Call, Contact, Response};
use granlaw::pair::{approach, moving, Partner, Start};

/// The motion of two bodies under a chain of laws.
pub struct Motion<'a> {
    chain: &'a mut Chain,
    start: &'a Start,
    /// For two bonded bodies: their distance at the start \[m\], and 1 if they are pressed, −1 if they are stretched.
    bonded: Option<(f64, f64)>,
    /// Evaluations of the chain so far.
    pub calls: u64,
}

/// Bodies in contact at an instant.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Time since first touch \[s\].
    pub time: f64,
    /// The bodies.
    pub bodies: [Body; 2],
    /// Their history.
    pub history: Vec<f64>,
    /// The forces and torques on them.
    pub response: Response,
    /// Normal relative velocity \[m/s\], negative while approaching.
    pub vn: f64,
}

/// Iterations of the force in each step. The error falls by a factor γ dt/2m* with each; after three it is smaller than that of the
/// step itself.
const ITERATIONS: usize = 3;

impl<'a> Motion<'a> {
    /// The motion of the bodies of a collision; `start` holds the bodies and gravity.
    pub fn new(chain: &'a mut Chain, start: &'a Start, collision: &Collision) -> Motion<'a> {
        let length = || (start.bodies[0].x - start.bodies[1].x).norm();
        let bonded = collision.row().map(|_| (length(), collision.speed.signum()));
        Motion { chain, start, bonded, calls: 0 }
    }

    /// The state of bodies that just touch, or whose bond begins.
    pub fn touch(&mut self, bodies: [Body; 2]) -> Instant {
        let mut history = vec![0.0; self.chain.row()];
        let mut contact = self.contact(&bodies, self.bonded.is_some(), 0.0);
        contact.close.call.step = 1;
        let response = self.evaluate(&contact, &mut history);
        Instant { time: 0.0, bodies, history, response, vn: contact.surface.vn }
    }

    /// The state a time `h` \[s\] later, whether or not the surfaces part before.
    pub fn step(&mut self, from: &Instant, h: f64) -> Instant {
        let mut middle = from.bodies;
        self.kick(&mut middle, &from.response, 0.5 * h);
        let mut to = Instant { time: from.time + h, bodies: self.drift(&middle, h), ..from.clone() };
        self.kick(&mut to.bodies, &from.response, 0.5 * h);
        for (body, half) in to.bodies.iter().zip(&mut middle) {
            half.x = body.x;
        }
        for _ in 0..ITERATIONS {
            let end = self.contact(&to.bodies, true, h);
            let mut between = self.contact(&middle, true, h);
            between.surface.vn = end.surface.vn;
            to.history.clone_from(&from.history);
            to.response = self.evaluate(&end, &mut to.history);
            to.history.clone_from(&from.history);
            self.evaluate(&between, &mut to.history);
            for (body, half) in to.bodies.iter_mut().zip(&middle) {
                (body.v, body.omega) = (half.v, half.omega);
            }
            self.kick(&mut to.bodies, &to.response, 0.5 * h);
        }
        to.vn = self.contact(&to.bodies, false, 0.0).surface.vn;
        to
    }

    /// How fast the bodies still move in the direction in which they began \[m/s\].
    pub fn inward(&self, at: &Instant) -> f64 {
        -at.vn * self.bonded.map_or(1.0, |b| b.1)
    }

    /// Normal relative velocity of bodies \[m/s\].
    pub fn normal_velocity(&self, bodies: &[Body; 2]) -> f64 {
        self.contact(bodies, false, 0.0).surface.vn
    }

    /// The overlap of the surfaces a time `h` later, without evaluating any law \[m\].
    pub fn overlap_after(&self, from: &Instant, h: f64) -> f64 {
        let mut bodies = from.bodies;
        self.kick(&mut bodies, &from.response, 0.5 * h);
        self.overlap(&self.drift(&bodies, h))
    }

    /// The overlap of the surfaces \[m\]; negative when apart. Of bonded bodies, the change of their distance.
    pub fn overlap(&self, bodies: &[Body; 2]) -> f64 {
        if let Some((length, sign)) = self.bonded {
            return sign * (length - (bodies[0].x - bodies[1].x).norm());
        }
        let (gap, overlap) = approach(self.start, bodies, Call::default());
        match self.start.partner {
            Partner::Plane { .. } => overlap,
            _ => gap.i.radius + gap.j.radius - gap.rsq.sqrt(),
        }
    }

    /// The branches that the laws are on.
    pub fn branches(&mut self, at: &Instant) -> Vec<&'static str> {
        let contact = self.contact(&at.bodies, false, 0.0);
        self.chain.observe(self.start.types, &contact, &at.history).iter().map(|t| t.branch).collect()
    }

    fn drift(&self, bodies: &[Body; 2], h: f64) -> [Body; 2] {
        let mut bodies = *bodies;
        moving(self.start, &mut bodies).for_each(|b| b.x += h * b.v);
        bodies
    }

    fn kick(&self, bodies: &mut [Body; 2], response: &Response, time: f64) {
        let forces = [response.force, -response.force];
        let torques = [response.torque_i, response.torque_j];
        for ((b, force), torque) in moving(self.start, bodies).zip(forces).zip(torques) {
            b.v += time * (force / b.mass + self.start.gravity);
            b.omega += time / (0.4 * b.mass * b.radius * b.radius) * torque;
        }
    }

    fn evaluate(&mut self, contact: &Contact, history: &mut [f64]) -> Response {
        let mut response = Response::default();
        self.calls += 1;
        match self.bonded {
            Some(_) => self.chain.surfaces_close(self.start.types, &contact.close, history, &mut response),
            None => self.chain.surfaces_intersect(self.start.types, contact, history, &mut response),
        };
        response
    }

    /// The input of the laws; surfaces that have parted within a step count as just touching.
    fn contact(&self, bodies: &[Body; 2], update: bool, dt: f64) -> Contact {
        let is_wall = matches!(self.start.partner, Partner::Plane { .. });
        let call = Call { dt, step: 2, update, is_wall, ..Call::default() };
        let (gap, overlap) = approach(self.start, bodies, call);
        let mut contact = if is_wall { Contact::wall(gap, overlap) } else { Contact::pair(gap) };
        contact.surface.deltan = contact.surface.deltan.max(0.0);
        contact
    }
}
