//! Rolling resistance and friction on a plane under gravity, and between spheres.
use super::bench::{chain, linear_stiffness, near, sphere};
use granlaw::model::{Body, Kind};
use granlaw::pair::{states, Opened, Partner, Start, State};
use nalgebra::Vector3;

const R: f64 = 0.005;
const RHO: f64 = 2500.0;
const YOUNG: f64 = 5e7;
const NU: f64 = 0.45;
const G: f64 = 9.81;
const MU_R: f64 = 0.1;
const MU: f64 = 0.5;
const DT: f64 = 2e-6;

const NORMAL: (Kind, &str) = (Kind::Normal, "hooke");
const FRICTION: (Kind, &str) = (Kind::Tangential, "history");
const CDT: (Kind, &str) = (Kind::Rolling, "cdt");

/// The overlap at which the spring carries the sphere \[m\].
fn settled(partner: Partner) -> f64 {
    let m = sphere(R, RHO).mass;
    let r = if partner == Partner::Frozen { R / 2.0 } else { R };
    m * G / linear_stiffness(YOUNG / (2.0 * (1.0 - NU * NU)), r, m, 2.0)
}

fn plane() -> Partner {
    Partner::Plane { point: Vector3::zeros(), normal: Vector3::z() }
}

/// A sphere at rest on a plane or on the pole of a frozen sphere, then set in motion; `slope` tilts gravity towards +x.
struct Scene {
    partner: Partner,
    v: Vector3<f64>,
    omega: Vector3<f64>,
    slope: f64,
    mu_r: f64,
}

impl Scene {
    fn on_plane(v: f64, omega: f64) -> Scene {
        Scene { partner: plane(), v: Vector3::x() * v, omega: Vector3::y() * omega, slope: 0.0, mu_r: MU_R }
    }

    fn run(&self, laws: &[(Kind, &str)], chosen: &[(&str, &str)], time: f64) -> Vec<State> {
        let given = [
            ("youngsModulus", [YOUNG; 2]),
            ("poissonsRatio", [NU; 2]),
            ("characteristicVelocity", [2.0; 2]),
            ("coefficientRestitution", [1.0; 2]),
            ("coefficientFriction", [MU; 2]),
            ("coefficientRollingFriction", [self.mu_r; 2]),
        ];
        let (sin, cos) = self.slope.sin_cos();
        let z = R - settled(self.partner) * cos;
        let i = Body { x: Vector3::z() * z, v: self.v, omega: self.omega, ..sphere(R, RHO) };
        let j = Body { tag: 2, x: Vector3::z() * -R, ..sphere(R, RHO) };
        let start = Start {
            bodies: [i, j],
            types: (0, 0),
            partner: self.partner,
            dt: DT,
            steps: (time / DT) as u64,
            first: 0,
            gravity: Vector3::new(G * sin, 0.0, -G * cos),
            opened: Opened::Keeps,
        };
        let all = states(&mut chain(laws, &given, chosen), &start);
        assert!(all.iter().all(|s| s.touching), "lost contact");
        all
    }
}

/// The state at a time, and mean rates between two times.
fn at(all: &[State], time: f64) -> &Body {
    &all[(time / DT).round() as usize].bodies[0]
}

fn slope_of(all: &[State], from: f64, to: f64, of: impl Fn(&Body) -> f64) -> f64 {
    let (to, from) = ((to / DT).round(), (from / DT).round());
    (of(at(all, to * DT)) - of(at(all, from * DT))) / ((to - from) * DT)
}

/// How much shorter than R the lever of friction is.
fn lever() -> f64 {
    settled(plane()) / R
}

/// A sphere that rolls, with μr as the law is told: deceleration 5/7 μr g.
fn rolls_to_rest(told: f64) -> Result<(), String> {
    let v0 = 0.2;
    let scene = Scene { mu_r: told, ..Scene::on_plane(v0, v0 / R) };
    let all = scene.run(&[NORMAL, FRICTION, CDT], &[], 0.45);
    let a = 5.0 / 7.0 * MU_R * G;
    // The lever of friction is shorter by half the overlap; the shear spring that takes up the friction swings about
    // its mean by one part in a thousand of this stretch.
    near("deceleration", -slope_of(&all, 0.05, 0.25, |b| b.v.x), a, 2e-3 + lever(), a)?;
    let stop = 7.0 * v0 / (5.0 * MU_R * G);
    let end = at(&all, stop + 0.02);
    near("distance", end.x.x, v0 * v0 / (2.0 * a), 5e-3, v0 * v0 / (2.0 * a))?;
    // From then on the torque changes sign with the spin: it creeps and chatters, within what the shear spring and a
    // few steps of the torque can do.
    near("speed after the stop", end.v.x, 0.0, 1e-2, v0)
}

#[test]
fn a_rolling_sphere_decelerates_by_five_sevenths_of_mu_r_g_and_stops() {
    rolls_to_rest(MU_R).unwrap();
}

#[test]
fn a_rolling_friction_off_by_a_hundredth_is_seen() {
    assert!(rolls_to_rest(MU_R * 1.01).unwrap_err().contains("deceleration"));
}

#[test]
fn on_a_slope_it_accelerates_by_what_the_resistance_leaves() {
    for slope in [0.2, 0.3] {
        let scene = Scene { slope, ..Scene::on_plane(0.1, 0.1 / R) };
        let all = scene.run(&[NORMAL, FRICTION, CDT], &[], 0.3);
        let (sin, cos) = slope.sin_cos();
        let a = 5.0 / 7.0 * G * (sin - MU_R * cos);
        near("acceleration", slope_of(&all, 0.05, 0.25, |b| b.v.x), a, 5e-3, a).unwrap();
    }
}

#[test]
fn on_a_slope_gentler_than_mu_r_it_stays() {
    let scene = Scene { slope: 0.05, ..Scene::on_plane(0.0, 0.0) };
    let all = scene.run(&[NORMAL, FRICTION, CDT], &[], 0.3);
    // Rolling freely it would come 0.16 m far.
    near("way", at(&all, 0.29).x.x, 0.0, 1e-3, 0.16).unwrap();
}

#[test]
fn a_spin_without_friction_decays_at_a_constant_rate() {
    let omega = 100.0;
    let all = Scene::on_plane(0.0, omega).run(&[NORMAL, CDT], &[], 0.15);
    // M = μr m g R on I = 2/5 m R².
    let rate = 5.0 * MU_R * G / (2.0 * R);
    near("rate", -slope_of(&all, 0.01, 0.14, |b| b.omega.y), rate, 1e-9, rate).unwrap();
    assert_eq!(at(&all, 0.14).v.x, 0.0);
}

#[test]
fn spin_about_the_normal_is_resisted_only_with_torsion_torque() {
    let scene = Scene { omega: Vector3::z() * 100.0, ..Scene::on_plane(0.0, 0.0) };
    let free = scene.run(&[NORMAL, CDT], &[], 0.1);
    assert_eq!(at(&free, 0.09).omega.z, 100.0);
    let held = scene.run(&[NORMAL, CDT], &[("torsionTorque", "on")], 0.1);
    let rate = 5.0 * MU_R * G / (2.0 * R);
    near("rate", -slope_of(&held, 0.01, 0.09, |b| b.omega.z), rate, 1e-9, rate).unwrap();
}

#[test]
fn between_two_spheres_the_effective_radius_halves_the_torque() {
    let omega = 100.0;
    let scene = Scene { partner: Partner::Frozen, omega: Vector3::y() * omega, ..Scene::on_plane(0.0, 0.0) };
    let all = scene.run(&[NORMAL, CDT], &[], 0.2);
    let rate = 5.0 * MU_R * G / (4.0 * R);
    near("rate", -slope_of(&all, 0.01, 0.19, |b| b.omega.y), rate, 1e-9, rate).unwrap();
}

#[test]
fn a_spin_that_is_used_up_chatters_by_one_step_of_the_torque() {
    let all = Scene::on_plane(0.0, 1.0).run(&[NORMAL, CDT], &[], 0.05);
    let rate = 5.0 * MU_R * G / (2.0 * R);
    for s in &all[(0.02 / DT) as usize..] {
        near("spin", s.bodies[0].omega.y, 0.0, 1.0 + 1e-9, rate * DT).unwrap();
    }
}

#[test]
fn a_sliding_sphere_comes_to_roll_with_five_sevenths_of_its_speed() {
    for law in ["history", "no_history"] {
        let u = 0.5;
        let all =
            Scene { mu_r: 0.0, ..Scene::on_plane(u, 0.0) }.run(&[NORMAL, (Kind::Tangential, law)], &[], 0.1);
        if law == "no_history" {
            // Without a dashpot (e = 1) viscous friction is none.
            assert_eq!(at(&all, 0.09).v.x, u);
            continue;
        }
        let ends = 2.0 * u / (7.0 * MU * G);
        near("deceleration", -slope_of(&all, 0.1 * ends, 0.9 * ends, |b| b.v.x), MU * G, 1e-9, MU * G)
            .unwrap();
        let (b, lever) = (at(&all, 0.09), 1.0 - 0.5 * lever());
        near(
            "spin up",
            slope_of(&all, 0.1 * ends, 0.9 * ends, |b| b.omega.y),
            2.5 * MU * G * lever / R,
            1e-9,
            MU * G / R,
        )
        .unwrap();
        // The shear spring goes on swinging, as nothing damps it; its share of the speed.
        near("final speed", b.v.x, 5.0 / 7.0 * u, 2e-2, u).unwrap();
    }
}
