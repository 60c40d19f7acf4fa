//! `cdt_jkr`: its coefficient, both conventions, rolling to rest, inclines, and the limit that ends the chatter.
use super::bench::{chain, linear_stiffness, near, sphere};
use granlaw::model::{Body, Call, ClosePair, Contact, Kind, Response};
use granlaw::pair::{run, Opened, Partner, Start};
use nalgebra::Vector3;
use std::f64::consts::PI;

const R: f64 = 0.005;
const RHO: f64 = 2500.0;
const YOUNG: f64 = 5e7;
const NU: f64 = 0.45;
const WORK: f64 = 0.05;
const ETA: f64 = 10.0;
const G: f64 = 9.81;

const NORMAL: (Kind, &str) = (Kind::Normal, "hooke");
const FRICTION: (Kind, &str) = (Kind::Tangential, "history");
const JKR: (Kind, &str) = (Kind::Rolling, "cdt_jkr");
const CDT: (Kind, &str) = (Kind::Rolling, "cdt");
const DOCUMENTED: (&str, &str) = ("cdtJkrConvention", "documented");
const UPSTREAM: (&str, &str) = ("cdtJkrConvention", "upstream");
const TORSION: (&str, &str) = ("torsionTorque", "on");
const LIMIT: (&str, &str) = ("restTorqueLimit", "on");

fn e_star() -> f64 {
    YOUNG / (2.0 * (1.0 - NU * NU))
}

/// (2) and (3).
fn mu_r(r_star: f64) -> f64 {
    let a0 = (9.0 * PI * WORK * r_star * r_star / (2.0 * e_star())).powf(1.0 / 3.0);
    PI * a0 / (4.0 * r_star) * ETA
}

fn laws(which: &[(Kind, &str)], chosen: &[(&str, &str)], mu_r: f64) -> granlaw::chain::Chain {
    let given = [
        ("youngsModulus", [YOUNG; 2]),
        ("poissonsRatio", [NU; 2]),
        ("characteristicVelocity", [2.0; 2]),
        ("coefficientRestitution", [0.5; 2]),
        ("coefficientFriction", [0.5; 2]),
        ("coefficientRollingFriction", [mu_r; 2]),
        ("workOfAdhesion", [WORK; 2]),
        ("adhesionHysteresis", [ETA; 2]),
    ];
    chain(which, &given, chosen)
}

/// A sphere that lies on a plane, gravity tilted towards +x by `slope`.
struct Plane<'a> {
    laws: &'a [(Kind, &'a str)],
    chosen: &'a [(&'a str, &'a str)],
    slope: f64,
    v: f64,
    omega: f64,
    dt: f64,
    time: f64,
}

impl Plane<'_> {
    /// The sphere at the multiples of `every` \[s\].
    fn run(&self, every: f64) -> Vec<Body> {
        let (sin, cos) = self.slope.sin_cos();
        let m = sphere(R, RHO).mass;
        let z = R - m * G * cos / linear_stiffness(e_star(), R, m, 2.0);
        let i = Body {
            x: Vector3::z() * z,
            v: Vector3::x() * self.v,
            omega: Vector3::y() * self.omega,
            ..sphere(R, RHO)
        };
        let start = Start {
            bodies: [i, Body::default()],
            types: (0, 0),
            partner: Partner::Plane { point: Vector3::zeros(), normal: Vector3::z() },
            dt: self.dt,
            steps: (self.time / self.dt).round() as u64,
            first: 0,
            gravity: Vector3::new(G * sin, 0.0, -G * cos),
            opened: Opened::Keeps,
        };
        let (stride, mut seen) = ((every / self.dt).round() as i64, Vec::new());
        run(&mut laws(self.laws, self.chosen, mu_r(R)), &start, |s| {
            assert!(s.touching, "lost contact");
            if s.step % stride == 0 {
                seen.push(s.bodies[0]);
            }
        });
        seen
    }
}

/// Distance from the centre to the contact, at rest on a level plane \[m\].
fn lever() -> f64 {
    let m = sphere(R, RHO).mass;
    R - 0.5 * m * G / linear_stiffness(e_star(), R, m, 2.0)
}

const ROLLING: Plane<'static> = Plane {
    laws: &[NORMAL, FRICTION, JKR],
    chosen: &[DOCUMENTED],
    slope: 0.0,
    v: 0.2,
    omega: 0.2 / R,
    dt: 1e-6,
    time: 0.24,
};

/// Deceleration \[m/s²\] and stopping distance \[m\].
fn stopping(dt: f64, chosen: &[(&str, &str)]) -> [f64; 2] {
    let seen = Plane { dt, chosen, ..ROLLING }.run(0.008);
    [(seen[2].v.x - seen[22].v.x) / 0.16, seen.last().unwrap().x.x]
}

fn off(got: [f64; 2], expected: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|k| (got[k] / expected[k] - 1.0).abs())
}

#[test]
fn a_rolling_sphere_decelerates_and_stops_as_mu_r_says() {
    let closed = |mu_r: f64| {
        let a = 5.0 / 7.0 * mu_r * G;
        [a, ROLLING.v * ROLLING.v / (2.0 * a)]
    };
    let got = stopping(1e-6, &[DOCUMENTED]);
    let [a, way] = off(got, closed(mu_r(R)));
    assert!(a < 1e-3 && way < 1e-3, "deceleration off by {a:e}, distance by {way:e}");
    assert!(
        off(got, closed(1.002 * mu_r(R))).iter().all(|e| *e > 1e-3),
        "a wrong rolling friction is not seen"
    );
    // What is left is the lever of friction, shorter by half the overlap.
    let l = lever();
    let a = mu_r(R) * G * R * l / (0.4 * R * R + l * l);
    near("deceleration with this lever", got[0], a, 1e-8, a).unwrap();
}

#[test]
fn the_stopping_distance_converges_with_the_time_step() {
    // With the limit, as the chatter after the stop goes on to move the sphere.
    let way = |dt: f64| stopping(dt, &[DOCUMENTED, LIMIT])[1];
    let last = way(1.25e-7);
    let errors = [32e-6, 8e-6, 2e-6, 5e-7].map(|dt| (way(dt) / last - 1.0).abs());
    assert!(errors[0] < 1e-8, "{errors:?}");
    assert!(errors.windows(2).all(|e| e[1] < e[0] / 3.0), "{errors:?}");
}

/// On an incline on which μr is `part` of tan α.
fn incline<'a>(
    part: f64,
    laws: &'a [(Kind, &'a str)],
    chosen: &'a [(&'a str, &'a str)],
    dt: f64,
) -> Plane<'a> {
    Plane { laws, chosen, slope: (mu_r(R) / part).atan(), v: 0.0, omega: 0.0, dt, time: 0.2 }
}

const LIMITED: &[(&str, &str)] = &[DOCUMENTED, LIMIT];
const JKR_CHAIN: &[(Kind, &str)] = &[NORMAL, FRICTION, JKR];

#[test]
fn on_an_incline_just_gentler_than_mu_r_a_limited_torque_holds() {
    let held = incline(1.01, JKR_CHAIN, LIMITED, 1e-5).run(0.01);
    let (before, end) = (&held[15], held.last().unwrap());
    assert!(end.v.norm() < 1e-12 && end.omega.norm() * R < 1e-12, "{end:?}");
    assert!(end.x.x < 1e-6 && (end.x - before.x).norm() < 1e-15, "{end:?}");
}

#[test]
fn on_an_incline_just_steeper_it_rolls_by_what_is_left() {
    let slope = (mu_r(R) / 0.99).atan();
    let a = 5.0 / 7.0 * G * (slope.sin() - mu_r(R) * slope.cos());
    let rolled = incline(0.99, JKR_CHAIN, LIMITED, 1e-5).run(0.01);
    // A hundredth of either term: the lever counts a hundredfold, 0.3 %; the shear spring swings by some 5 %.
    near("acceleration", (rolled[20].v.x - rolled[5].v.x) / 0.15, a, 5e-2, a).unwrap();
}

/// Mean speed down an incline that is gentle enough to hold \[m/s\].
fn creep(laws: &[(Kind, &str)], chosen: &[(&str, &str)], dt: f64) -> f64 {
    let seen = incline(1.01, laws, chosen, dt).run(0.008);
    (seen[25].x.x - seen[12].x.x) / 0.104
}

#[test]
fn without_the_limit_it_creeps_in_proportion_to_the_time_step_as_cdt_does() {
    for dt in [8e-6, 4e-6, 2e-6, 1e-6] {
        let (jkr, cdt) = (creep(JKR_CHAIN, &[DOCUMENTED], dt), creep(&[NORMAL, FRICTION, CDT], &[], dt));
        assert_eq!(jkr, cdt);
        // The torque m g R sin α of friction turns the sphere by this much a step.
        let turn = 2.5 * G * mu_r(R) / 1.01 * dt;
        assert!((0.3..1.0).contains(&(jkr / turn)), "{dt:e}: {jkr:e} m/s, {} of a step", jkr / turn);
        assert!(creep(JKR_CHAIN, LIMITED, dt).abs() < 1e-15);
    }
}

#[test]
fn a_limit_that_does_not_know_the_torque_of_friction_creeps() {
    // The rolling law before friction: it brings the spin to rest, and friction turns the sphere by a step's worth.
    for dt in [8e-6, 1e-6] {
        let slope = (mu_r(R) / 1.01).atan();
        near("creep", creep(&[NORMAL, JKR, FRICTION], LIMITED, dt), 2.5 * G * slope.sin() * dt, 1e-3, G * dt)
            .unwrap();
    }
}

/// Two spheres of unequal size and density that overlap along (1 2 2)/3, under the torques of a friction law.
fn touching(spin: [Vector3<f64>; 2]) -> (Contact, Response) {
    let (mut i, mut j) = (sphere(R, RHO), sphere(0.6 * R, 2.0 * RHO));
    let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    (i.omega, j.omega, j.tag) = (spin[0], spin[1], 2);
    i.x = n * (1.6 * R - 1e-5);
    let call = Call { dt: 1e-6, step: 1, update: true, ..Call::default() };
    let gap = ClosePair { call, i, j, delta: i.x, rsq: i.x.norm_squared(), meff: 0.0 }.weighed();
    let torque = Vector3::new(2.0, -1.0, 0.0) * 1e-6;
    (Contact::pair(gap), Response { torque_i: torque, torque_j: 0.6 * torque, ..Response::default() })
}

/// The torque of the law alone, and Mmax of (8) with its coefficient.
fn resist(x: &Contact, response: &Response, chosen: &[(&str, &str)]) -> (Vector3<f64>, f64) {
    let mut s = *response;
    laws(&[NORMAL, JKR], chosen, 0.0).surfaces_intersect((0, 0), x, &mut [], &mut s);
    let r = x.close.i.radius * x.close.j.radius / (x.close.i.radius + x.close.j.radius);
    (s.torque_i - response.torque_i, mu_r(r) * s.kn * x.surface.deltan * r)
}

#[test]
fn documented_brakes_the_rolling_part_with_all_of_mmax_and_upstream_with_a_share() {
    let n = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let across = Vector3::new(2.0, 1.0, -2.0) / 3.0;
    for twist in [0.0, 1.0, 30.0, 1e6] {
        let spin = across * 4.0 + n * twist;
        let (x, s) = touching([spin, Vector3::zeros()]);
        let (m, most) = resist(&x, &s, &[DOCUMENTED]);
        // Round-off of the rolling part, relative to the spin.
        let tolerance = 1e-14 * (1.0 + twist);
        near("documented", (m + across * most).norm(), 0.0, tolerance, most).unwrap();
        let (m, _) = resist(&x, &s, &[UPSTREAM]);
        near("upstream", (m + across * (most / PI * 4.0 / spin.norm())).norm(), 0.0, 1e-14, most).unwrap();
        for convention in [DOCUMENTED, UPSTREAM] {
            let most = if convention == UPSTREAM { most / PI } else { most };
            let (m, _) = resist(&x, &s, &[convention, TORSION]);
            near("torsion", (m + spin.normalize() * most).norm(), 0.0, 1e-14, most).unwrap();
        }
    }
    // Nothing rolls: equal spins, and a spin along n that leaves only round-off.
    for spins in [[across; 2], [n * 7.0, n * -3.0]] {
        let (x, s) = touching(spins);
        assert_eq!(resist(&x, &s, &[DOCUMENTED]).0, Vector3::zeros());
    }
}

#[test]
fn the_limit_ends_the_relative_spin_within_the_step_and_never_turns_it_round() {
    let slow = [Vector3::new(2.0, -1.0, 1.0) * 1e-4, Vector3::new(0.0, 1.0, -1.0) * 1e-4];
    let (x, s) = touching(slow);
    for (held, chosen) in [(0, &[DOCUMENTED, LIMIT][..]), (0, &[UPSTREAM, LIMIT]), (1, LIMITED), (2, LIMITED)]
    {
        let mut x = x;
        match held {
            1 => x.close.i.mass = f64::INFINITY,
            2 => x.close.j.mass = f64::INFINITY,
            _ => {}
        }
        let (m, most) = resist(&x, &s, chosen);
        assert!(m.norm() > 0.0 && m.norm() < most, "not limited: {} of {most}", m.norm());
        let turned = |b: &Body, torque: Vector3<f64>| {
            b.omega + torque * (x.close.call.dt / (0.4 * b.mass * b.radius.powi(2)))
        };
        let left = turned(&x.close.i, s.torque_i + m) - turned(&x.close.j, s.torque_j - m);
        let rolling = left - x.surface.en * left.dot(&x.surface.en);
        near("what is left of the spin", rolling.norm(), 0.0, 1e-14, 1e-4).unwrap();
    }
    // A fast spin is braked as without the limit, but for what friction turns meanwhile.
    let (x, s) = touching(slow.map(|w| w * 1e6));
    let (limited, plain) = (resist(&x, &s, LIMITED).0, resist(&x, &s, &[DOCUMENTED]).0);
    near("fast", (limited - plain).norm(), 0.0, 1e-3, plain.norm()).unwrap();
}

#[test]
fn with_its_coefficient_cdt_answers_bit_for_bit() {
    let across = Vector3::new(0.0, 3.0, -3.0);
    let r = 0.6 / 1.6 * R;
    let (radi, radj) = (R, 0.6 * R);
    let told = mu_r(radi * radj / (radi + radj));
    near("R*", radi * radj / (radi + radj), r, 1e-15, r).unwrap();
    let cdt = |x: &Contact, torsion: &[(&str, &str)], mu: f64| {
        let mut s = Response::default();
        laws(&[NORMAL, CDT], torsion, mu).surfaces_intersect((0, 0), x, &mut [], &mut s);
        s.torque_i
    };
    let (x, _) = touching([across, Vector3::zeros()]);
    let none = Response::default();
    assert_eq!(resist(&x, &none, &[DOCUMENTED]).0, cdt(&x, &[], told));
    assert_ne!(resist(&x, &none, &[DOCUMENTED]).0, cdt(&x, &[], told.next_up().next_up()));
    let (x, _) = touching([Vector3::new(1.0, 5.0, -2.0), across]);
    assert_eq!(resist(&x, &none, &[DOCUMENTED, TORSION]).0, cdt(&x, &[TORSION], told));
    assert_ne!(resist(&x, &none, &[DOCUMENTED]).0, cdt(&x, &[], told));
}
