//! Work of a step, exactly as LIGGGHTS's time integration does it.
//!
//! A force changes the velocity from one half step to the next, so its work is the force times the mean of the two velocities. Of the
//! change a contact knows only its own part. For two bodies alone there is no other, and the work is the change of their kinetic
//! energy to the last digits.
use super::call::Call;
use super::tally::Directions;
use granlaw::model::{Body, ClosePair, Surface};
use nalgebra::Vector3;

/// Mean relative velocity and spins of the step: half of the change by the force of the whole chain is added.
#[derive(Clone, Copy)]
pub(super) struct Motion {
    v: Vector3<f64>,
    omega: [Vector3<f64>; 2],
}

impl Motion {
    pub fn of(call: &Call<'_>) -> Motion {
        let (g, half) = (&call.contact.close, 0.5 * call.contact.close.call.dt);
        let v = g.i.v - g.j.v + call.force * (half / g.meff);
        let turned = |b: &Body, torque: Vector3<f64>, held: bool| match held {
            true => b.omega,
            false => b.omega + torque * (half / (0.4 * b.mass * b.radius * b.radius)),
        };
        let [i, j] = held(g);
        Motion { v, omega: [turned(&g.i, call.torque_i, i), turned(&g.j, call.torque_j, j)] }
    }

    /// Normal relative velocity over the one that the laws see; 1 if that is zero.
    pub fn faster(&self, s: &Surface) -> f64 {
        if s.vn == 0.0 {
            1.0
        } else {
            self.v.dot(&s.en) / s.vn
        }
    }

    /// Work of the whole chain in this step \[J\]; `normal` is its force along the normal \[N\].
    pub fn directions(&self, call: &Call<'_>, normal: f64) -> Directions {
        let (s, dt) = (&call.contact.surface, call.contact.close.call.dt);
        let [wi, wj] = &self.omega;
        let torque_j = call.on_j();
        let ft = call.force - s.en * normal;
        // The torque by the lever of the tangential force belongs to this force.
        let slip = ft.dot(&self.v) - s.en.cross(&ft).dot(&(wi * s.cri + wj * s.crj));
        let spin = |t: &Vector3<f64>, w: &Vector3<f64>| t.dot(&s.en) * w.dot(&s.en);
        let torsion = spin(&call.torque_i, wi) + spin(&torque_j, wj);
        let push = normal * s.en.dot(&self.v);
        let rolling = self.power(&call.force, &call.torque_i, &torque_j) - push - slip - torsion;
        Directions { normal: push * dt, tangential: slip * dt, rolling: rolling * dt, torsion: torsion * dt }
    }

    /// Power of a force on i and of the torques on i and j \[W\].
    pub fn power(&self, force: &Vector3<f64>, torque_i: &Vector3<f64>, torque_j: &Vector3<f64>) -> f64 {
        force.dot(&self.v) + torque_i.dot(&self.omega[0]) + torque_j.dot(&self.omega[1])
    }
}

/// Whether i and j are held in place: a wall is, and a body of infinite mass.
fn held(g: &ClosePair) -> [bool; 2] {
    [g.i.frozen, g.call.is_wall || g.j.frozen]
}
