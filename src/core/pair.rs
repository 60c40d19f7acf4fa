//! Two bodies under a chain of laws, in the time integration of LIGGGHTS.
//!
//! The scheme is velocity Verlet as `fix nve/sphere` does it, with its operations in its order: a set-up evaluation with
//! full-step velocities that may not write history; then per step half a kick, the drift, an evaluation that sees
//! half-step velocities, and the other half of the kick. A pair then moves bit for bit as in LIGGGHTS.
use crate::chain::Chain;
use crate::model::{Body, Call, ClosePair, Contact, Response};
use nalgebra::Vector3;

/// What stands against body i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Partner {
    /// The other particle, free to move.
    Free,
    /// The other particle, held in place; the effective mass is that of i.
    Frozen,
    /// A plane at rest through `point` with unit normal `normal`, on whose side i is.
    Plane {
        /// A point of the plane \[m\].
        point: Vector3<f64>,
        /// Its unit normal.
        normal: Vector3<f64>,
    },
}

/// What becomes of the history when surfaces part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opened {
    /// It stays, as in LIGGGHTS while the contact distance factor is 1 and no neighbour list is built.
    Keeps,
    /// The laws are told by `apart`, as in LIGGGHTS with a larger contact distance factor.
    Closes,
}

/// Two bodies before the first step.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Bodies i and j; j is not read against a plane.
    pub bodies: [Body; 2],
    /// Their atom types, from 0; of a plane, the type of its material.
    pub types: (usize, usize),
    /// What j is.
    pub partner: Partner,
    /// Time step \[s\].
    pub dt: f64,
    /// Steps to make.
    pub steps: u64,
    /// Number of the step before the first.
    pub first: i64,
    /// Acceleration that acts on free bodies \[m/s²\].
    pub gravity: Vector3<f64>,
    /// What happens when surfaces part.
    pub opened: Opened,
}

/// The state after a step; `contact` is what the laws saw in it, with half-step velocities.
#[derive(Clone, Debug)]
pub struct State {
    /// Number of the step.
    pub step: i64,
    /// Bodies with full-step velocities.
    pub bodies: [Body; 2],
    /// Whether the surfaces overlap.
    pub touching: bool,
    /// What the laws saw; the surface is zero unless they touch.
    pub contact: Contact,
    /// What they answered.
    pub response: Response,
    /// The history after it.
    pub history: Vec<f64>,
}

/// Follow two bodies; `each` sees the set-up evaluation and every step.
pub fn run(chain: &mut Chain, start: &Start, mut each: impl FnMut(&State)) {
    run_while(chain, start, |s| {
        each(s);
        true
    });
}

/// Follow two bodies as long as `each` says so.
pub fn run_while(chain: &mut Chain, start: &Start, mut each: impl FnMut(&State) -> bool) {
    let mut s = State {
        step: start.first,
        bodies: start.bodies,
        touching: false,
        contact: Contact::default(),
        response: Response::default(),
        history: vec![0.0; chain.row()],
    };
    evaluate(chain, start, &mut s, false);
    let mut go_on = each(&s);
    while go_on && s.step < start.first + start.steps as i64 {
        s.step += 1;
        kick(start, &mut s);
        for body in moving(start, &mut s.bodies) {
            body.x += start.dt * body.v;
        }
        evaluate(chain, start, &mut s, true);
        kick(start, &mut s);
        go_on = each(&s);
    }
}

/// Follow two bodies and keep every state.
pub fn states(chain: &mut Chain, start: &Start) -> Vec<State> {
    let mut all = Vec::with_capacity(start.steps as usize + 1);
    run(chain, start, |s| all.push(s.clone()));
    all
}

/// The bodies that are free to move.
pub fn moving<'a>(start: &Start, bodies: &'a mut [Body; 2]) -> impl Iterator<Item = &'a mut Body> {
    let n = if start.partner == Partner::Free { 2 } else { 1 };
    bodies.iter_mut().take(n)
}

fn kick(start: &Start, s: &mut State) {
    let half = 0.5 * start.dt;
    let forces = [s.response.force, -s.response.force];
    let torques = [s.response.torque_i, s.response.torque_j];
    for ((body, force), torque) in moving(start, &mut s.bodies).zip(forces).zip(torques) {
        // LIGGGHTS adds gravity to the contact force before it divides by the mass.
        let force = force + body.mass * start.gravity;
        body.v += half / body.mass * force;
        let turn = half / 0.4 / (body.radius * body.radius * body.mass);
        body.omega += turn * torque;
    }
}

fn evaluate(chain: &mut Chain, start: &Start, s: &mut State, update: bool) {
    let is_wall = matches!(start.partner, Partner::Plane { .. });
    let call = Call { dt: start.dt, step: s.step, update, counts: update, is_wall };
    let (gap, overlap) = approach(start, &s.bodies, call);
    s.response = Response::default();
    s.touching = if is_wall { overlap >= 0.0 } else { gap.rsq < square(gap.i.radius + gap.j.radius) };
    s.contact = Contact { close: gap, ..Contact::default() };
    if s.touching {
        s.contact = if is_wall { Contact::wall(gap, overlap) } else { Contact::pair(gap) };
        chain.surfaces_intersect(start.types, &s.contact, &mut s.history, &mut s.response);
    } else if start.opened == Opened::Closes {
        chain.surfaces_close(start.types, &gap, &mut s.history, &mut s.response);
    }
}

/// How the bodies lie to each other, and the overlap with a plane \[m\].
pub fn approach(start: &Start, bodies: &[Body; 2], call: Call) -> (ClosePair, f64) {
    let [i, mut j] = *bodies;
    if let Partner::Plane { point, normal } = start.partner {
        let distance = normal.dot(&(i.x - point));
        let delta = normal * distance;
        let j = Body { tag: -1, x: i.x - delta, ..Body::default() };
        let gap = ClosePair { call, i, j, delta, rsq: square(distance), meff: 0.0 };
        return (gap.weighed(), i.radius - distance);
    }
    let delta = i.x - j.x;
    if start.partner == Partner::Frozen {
        j.frozen = true;
    }
    let gap = ClosePair { call, i, j, delta, rsq: crate::lane::dot(&delta, &delta), meff: 0.0 };
    (gap.weighed(), 0.0)
}

fn square(x: f64) -> f64 {
    x * x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::find;
    use crate::model::{Kind, Settings, Setup, Values};

    fn chain(laws: &[(Kind, &str)]) -> Chain {
        let given = |name: &str| match name {
            "youngsModulus" => 5e6,
            "poissonsRatio" => 0.45,
            "characteristicVelocity" => 2.0,
            "coefficientMaxElasticStiffness" => 5.0,
            "coefficientAdhesionStiffness" => 0.0,
            "coefficientPlasticityDepth" => 0.05,
            _ => 1.0,
        };
        let setup = |(kind, name): &(Kind, &str)| {
            let law = find(*kind, name).unwrap();
            let of = law.meta.props.iter().map(|p| vec![given(p.name)]).collect();
            Setup { law, settings: Settings::new(law, false), values: Values { types: 1, of }, nktv2p: 1.0 }
        };
        Chain::packed(&laws.iter().map(setup).collect::<Vec<_>>()).unwrap()
    }

    /// Two spheres 0.02 mm apart that come towards each other.
    fn start() -> Start {
        let body = |x: f64, v: f64| Body {
            radius: 0.005,
            mass: 1e-3,
            x: Vector3::new(x, 0.0, 0.0),
            v: Vector3::new(v, 0.0, 0.0),
            ..Body::default()
        };
        Start {
            bodies: [body(-0.00501, 0.5), body(0.00501, -0.2)],
            types: (0, 0),
            partner: Partner::Free,
            dt: 1e-6,
            steps: 3000,
            first: 0,
            gravity: Vector3::zeros(),
            opened: Opened::Keeps,
        }
    }

    #[test]
    fn an_elastic_pair_swaps_velocities_and_keeps_its_momentum() {
        let all = states(&mut chain(&[(Kind::Normal, "hooke")]), &start());
        let end = all.last().unwrap();
        assert!(all.iter().any(|s| s.touching) && !end.touching);
        // Third order in the step, 600 steps per contact.
        approx::assert_relative_eq!(end.bodies[0].v.x, -0.2, max_relative = 1e-6);
        approx::assert_relative_eq!(end.bodies[0].v.x + end.bodies[1].v.x, 0.3, max_relative = 1e-13);
    }

    #[test]
    fn an_opened_contact_keeps_its_history_unless_it_is_told() {
        let after = |opened| {
            let mut laws = chain(&[(Kind::Normal, "hooke/hysteresis")]);
            let all = states(&mut laws, &Start { opened, ..start() });
            assert!(all.iter().any(|s| s.touching) && !all.last().unwrap().touching);
            all.last().unwrap().history[0]
        };
        assert!(after(Opened::Keeps) > 0.0);
        assert_eq!(after(Opened::Closes), 0.0);
    }

    #[test]
    fn a_frozen_partner_stays_and_counts_as_infinitely_heavy() {
        let mut s = Start { partner: Partner::Frozen, ..start() };
        s.bodies[1].v = Vector3::zeros();
        let all = states(&mut chain(&[(Kind::Normal, "hooke")]), &s);
        let end = all.last().unwrap();
        assert_eq!(end.bodies[1], s.bodies[1]);
        assert_eq!(end.contact.close.meff, 1e-3);
        approx::assert_relative_eq!(end.bodies[0].v.x, -0.5, max_relative = 1e-6);
    }

    #[test]
    fn a_plane_turns_a_sphere_round_from_its_other_side_too() {
        for side in [1.0, -1.0] {
            let plane = Partner::Plane { point: Vector3::x() * 0.1, normal: Vector3::x() * side };
            let mut s = Start { partner: plane, ..start() };
            s.bodies[0].x.x = 0.1 + side * 0.00501;
            s.bodies[0].v.x = -side * 0.5;
            let all = states(&mut chain(&[(Kind::Normal, "hooke")]), &s);
            assert!(all.iter().any(|s| s.touching));
            approx::assert_relative_eq!(all.last().unwrap().bodies[0].v.x, side * 0.5, max_relative = 1e-6);
        }
    }

    #[test]
    fn gravity_accelerates_what_is_free() {
        let mut s = Start { gravity: Vector3::z() * -9.81, steps: 1000, ..start() };
        s.bodies[0].x.x = -1.0;
        let end = states(&mut chain(&[(Kind::Normal, "hooke")]), &s).pop().unwrap();
        for body in end.bodies {
            // A thousand additions of the same number.
            approx::assert_relative_eq!(body.v.z, -9.81e-3, max_relative = 1e-12);
            approx::assert_relative_eq!(body.x.z, -0.5 * 9.81e-6, max_relative = 1e-12);
        }
    }

    #[test]
    fn the_set_up_evaluation_gives_forces_and_writes_no_shear() {
        let mut s = Start { first: 40, steps: 1, ..start() };
        (s.bodies[0].x.x, s.bodies[0].v.y) = (-0.00498, 1.0);
        let all = states(&mut chain(&[(Kind::Normal, "hooke"), (Kind::Tangential, "history")]), &s);
        assert_eq!((all[0].step, all[1].step), (40, 41));
        assert!(all[0].touching && all[0].response.fn_ > 0.0);
        assert_eq!(all[0].history, [0.0; 3]);
        // One step at half-step velocity, which the first half kick along x does not turn.
        approx::assert_relative_eq!(all[1].history[1], 1e-6, max_relative = 1e-3);
    }
}
