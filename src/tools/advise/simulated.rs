//! Repeats the impacts of a probe with two bodies alone.
use crate::probe::{Impact, Partners};
use granlaw::chain::Chain;
use granlaw::model::{Body, Kind, Meta};
use granlaw::pair::{run_while, Opened, Partner, Start, State};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The outcome of an impact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rebound {
    /// Normal speed after over before; 0 where the bodies stick.
    pub restitution: f64,
    /// Time in contact \[s\]; infinite where they stick.
    pub time: f64,
    /// Spins of i and j afterwards \[rad/s\].
    pub spin: [Vector3<f64>; 2],
    /// Highest circular frequency of the normal spring met on the way \[rad/s\].
    pub omega: f64,
}

/// Half the period of an oscillation with this circular frequency \[s\].
pub fn half_period(omega: f64) -> f64 {
    PI / omega
}

/// Repeats an impact with a time step `dt` \[s\]. The bodies touch at `phase` (0 to 1) of the first step; after `longest` \[s\]
/// they count as stuck. `laws`, if given, are asked for stiffnesses.
pub fn impact(
    chain: &mut Chain,
    laws: Option<&mut Chain>,
    what: &Impact,
    (dt, phase, longest): (f64, f64, f64),
) -> Rebound {
    let start = approaching(what, dt, phase, longest);
    let mut seen = Rebound { time: f64::INFINITY, ..Rebound::default() };
    let mut last = 0.0;
    let mut met = false;
    let mut watch = Watch::new(laws, &start);
    run_while(chain, &start, |s| {
        seen.spin = s.bodies.map(|b| b.omega);
        let overlap = overlap(s);
        if s.touching {
            (met, last) = (true, overlap);
            watch.see(s);
            return true;
        }
        if met {
            // The moment between the two steps at which the surfaces parted.
            let part = last / (last - overlap);
            seen.time = ((s.step - 1) as f64 + part - phase) * dt;
            let g = &s.contact.close;
            let away = (s.bodies[0].v - s.bodies[1].v).dot(&g.delta) / g.rsq.sqrt();
            seen.restitution = away / -what.v[0];
        }
        !met
    });
    seen.omega = watch.omega();
    seen
}

/// Asks the laws for the stiffness in every step, with a chain of its own, as the other one is moving the bodies.
struct Watch<'a> {
    laws: Option<&'a mut Chain>,
    springs: Vec<bool>,
    types: (usize, usize),
    most: f64,
}

impl Watch<'_> {
    fn new<'a>(laws: Option<&'a mut Chain>, start: &Start) -> Watch<'a> {
        let spring = |m: &Meta| matches!(m.kind, Kind::Normal | Kind::Cohesion);
        let springs = laws.iter().flat_map(|c| c.laws()).map(spring).collect();
        Watch { laws, springs, types: start.types, most: 0.0 }
    }

    fn see(&mut self, s: &State) {
        let (Some(laws), true) = (&mut self.laws, s.touching) else { return };
        let mut stiffness = 0.0;
        laws.observe_each(self.types, &s.contact, &s.history, |k, terms| {
            stiffness += if self.springs[k] { terms.stiffness } else { 0.0 };
        });
        self.most = self.most.max(stiffness / s.contact.close.meff);
    }

    fn omega(&self) -> f64 {
        self.most.sqrt()
    }
}

fn plane() -> Partner {
    Partner::Plane { point: Vector3::zeros(), normal: Vector3::x() }
}

fn overlap(s: &State) -> f64 {
    let g = &s.contact.close;
    g.i.radius + g.j.radius - g.rsq.sqrt()
}

/// The bodies at the start; they touch at `phase` of the first step.
fn approaching(what: &Impact, dt: f64, phase: f64, longest: f64) -> Start {
    let what = &if what.partners.mass[0] > 0.0 { *what } else { swapped(what) };
    let p = &what.partners;
    let v = Vector3::from(what.v);
    let held = !p.wall && p.mass[1] == 0.0;
    let share = if p.wall || held { 1.0 } else { p.mass[1] / (p.mass[0] + p.mass[1]) };
    let body = |k: usize, x: f64, v: Vector3<f64>, omega: [f64; 3]| Body {
        tag: 1 + k as i64,
        radius: p.radius[k],
        mass: if p.mass[k] > 0.0 { p.mass[k] } else { p.meff },
        x: Vector3::x() * x,
        v,
        omega: omega.into(),
        ..Body::default()
    };
    let apart = p.radius[0] + p.radius[1] - what.v[0] * dt * phase;
    Start {
        bodies: [body(0, apart, v * share, what.omega_i), body(1, 0.0, v * (share - 1.0), what.omega_j)],
        types: (p.types[0] - 1, p.types[1] - 1),
        partner: match (p.wall, held) {
            (true, _) => plane(),
            (_, true) => Partner::Frozen,
            _ => Partner::Free,
        },
        dt,
        steps: (longest / dt).ceil() as u64 + 1,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Keeps,
    }
}

/// The same impact with i and j exchanged, by half a turn about z, so that the body that is held in place is j.
fn swapped(what: &Impact) -> Impact {
    let turn = |[x, y, z]: [f64; 3]| [-x, -y, z];
    let [x, y, z] = what.v;
    let p = &what.partners;
    let swap = |[a, b]: [f64; 2]| [b, a];
    Impact {
        partners: Partners {
            types: [p.types[1], p.types[0]],
            radius: swap(p.radius),
            mass: swap(p.mass),
            ..*p
        },
        v: [x, y, -z],
        omega_i: turn(what.omega_j),
        omega_j: turn(what.omega_i),
        ..*what
    }
}
