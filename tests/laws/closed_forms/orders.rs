//! How fast velocity Verlet, as LIGGGHTS has it, converges in the time step: second order, first with a dashpot.
use super::bench::{chain, impact, linear_stiffness, sphere, start};
use granlaw::model::{Body, Kind};
use nalgebra::Vector3;
use std::f64::consts::PI;

const R: f64 = 0.005;
const RHO: f64 = 2500.0;
const YOUNG: f64 = 5e6;
const NU: f64 = 0.45;
const PHASES: u32 = 256;

/// Mean over the phases of first touch within a step of |error of e|, with `n` steps per contact, `spread`: and up to
/// one more. Hysteresis has k2max/kn = 5, kc = 0 and no dashpot.
fn error_of_e(law: &str, e: f64, n: f64, spread: bool) -> f64 {
    let mass = sphere(R, RHO).mass;
    let v = 0.5;
    let e_star = YOUNG / (2.0 * (1.0 - NU * NU));
    let kn = linear_stiffness(e_star, R / 2.0, mass / 2.0, 2.0);
    let duration = match law {
        "hertz" => 2.868265 * ((mass / 2.0).powi(2) / (R / 2.0 * e_star * e_star * v)).powf(0.2),
        "hooke" => PI * (mass / 2.0 / kn).sqrt() * (1.0 + (e.ln() / PI).powi(2)).sqrt(),
        _ => PI * (mass / 2.0 / kn).sqrt(),
    };
    let expected = if law == "hooke/hysteresis" {
        // Below the plastic limit e² = kn/k2.
        let limit = 5.0 / 4.0 * 0.05 * R;
        let k2 = 1.0 + 4.0 * v * (mass / 2.0 / kn).sqrt() / limit;
        (1.0 / k2).sqrt()
    } else {
        e
    };
    let given = [
        ("youngsModulus", [YOUNG; 2]),
        ("poissonsRatio", [NU; 2]),
        ("characteristicVelocity", [2.0; 2]),
        ("coefficientRestitution", [e; 2]),
        ("coefficientMaxElasticStiffness", [5.0; 2]),
        ("coefficientAdhesionStiffness", [0.0; 2]),
        ("coefficientPlasticityDepth", [0.05; 2]),
    ];
    let mut laws = chain(&[(Kind::Normal, law)], &given, &[]);
    let body = |v: f64| Body { v: Vector3::x() * v, ..sphere(R, RHO) };
    let mut sum = 0.0;
    for k in 0..PHASES {
        // By golden fractions, so that where the contact ends within a step is spread as evenly as where it begins.
        let more = if spread { (f64::from(k) * 0.618_033_988_749_895).fract() } else { 0.0 };
        let dt = duration / (n + more);
        let mut start = start([body(-0.5 * v), body(0.5 * v)], false, dt, (4.0 * n) as u64);
        start.bodies[0].x.x += v * dt * (f64::from(k) + 0.5) / f64::from(PHASES);
        let got = impact(&mut laws, &start);
        assert!(got.apart);
        sum += (got.e - expected).abs();
    }
    sum / f64::from(PHASES)
}

/// The power of the step by which the error falls from `n` to `8 n` steps.
fn order(law: &str, e: f64, n: f64) -> f64 {
    (error_of_e(law, e, n, true) / error_of_e(law, e, 8.0 * n, true)).log2() / 3.0
}

#[test]
fn the_restitution_converges_with_order_two_or_better_undamped_and_one_damped() {
    // Over 256 phases smooth laws fit within 0.01; hysteresis meets its kinks by chance and scatters by 0.3.
    for (law, e, lo, hi) in [
        ("hooke", 1.0, 1.9, 2.1),
        ("hertz", 1.0, 2.3, 2.7),
        ("hooke/hysteresis", 1.0, 1.7, 2.6),
        ("hooke", 0.9, 0.95, 1.05),
        ("hooke", 0.5, 0.95, 1.05),
    ] {
        let order = order(law, e, 100.0);
        assert!((lo..hi).contains(&order), "{law} with e = {e}: order {order}");
    }
}

/// Steps per contact and mean error of e, from an independent integration of the same scheme.
const PUBLISHED: [(&str, f64, f64, f64); 14] = [
    ("hooke", 1.0, 20.0, 1.3e-4),
    ("hooke", 1.0, 50.0, 8.2e-6),
    ("hooke", 1.0, 100.0, 1.0e-6),
    ("hooke", 1.0, 200.0, 1.3e-7),
    ("hooke", 0.9, 20.0, 1.6e-3),
    ("hooke", 0.9, 50.0, 4.8e-4),
    ("hooke", 0.9, 100.0, 2.3e-4),
    ("hooke", 0.9, 200.0, 1.2e-4),
    ("hooke", 0.5, 50.0, 7.1e-3),
    ("hooke", 0.5, 100.0, 3.5e-3),
    ("hooke", 0.5, 200.0, 1.8e-3),
    ("hertz", 1.0, 50.0, 2.7e-5),
    ("hertz", 1.0, 100.0, 4.7e-6),
    ("hertz", 1.0, 200.0, 8.2e-7),
];

#[test]
fn the_errors_are_those_that_the_scheme_is_known_for() {
    for (law, e, n, expected) in PUBLISHED {
        let got = error_of_e(law, e, n, false);
        // Two digits are quoted, over other phases than ours; with whole steps per contact a linear spring is third order.
        assert!(
            (got / expected - 1.0).abs() < 0.15,
            "{law} e = {e}, {n} steps: {got:e} instead of {expected:e}"
        );
    }
}

/// Error of the position after a contact, at a fixed time: the phase error of the scheme.
fn error_of_position(e: f64, n: f64) -> f64 {
    let mass = sphere(R, RHO).mass;
    let kn = linear_stiffness(YOUNG / (2.0 * (1.0 - NU * NU)), R / 2.0, mass / 2.0, 2.0);
    let given = [
        ("youngsModulus", [YOUNG; 2]),
        ("poissonsRatio", [NU; 2]),
        ("characteristicVelocity", [2.0; 2]),
        ("coefficientRestitution", [e; 2]),
    ];
    let w0 = (kn / (mass / 2.0)).sqrt();
    let b = w0 / (1.0 + (PI / e.ln()).powi(2)).sqrt();
    let w = (w0 * w0 - b * b).sqrt();
    let time = 0.6 * PI / w;
    let dt = time / n;
    let body = |v: f64| Body { v: Vector3::x() * v, ..sphere(R, RHO) };
    let start = start([body(-0.5), body(0.5)], false, dt, n as u64);
    let overlap = R - impact(&mut chain(&[(Kind::Normal, "hooke")], &given, &[]), &start).last.x.x;
    let exact = 0.5 / w * (-b * time).exp() * (w * time).sin();
    ((overlap - exact) / exact).abs()
}

#[test]
fn the_path_converges_with_order_two_undamped_and_one_damped() {
    for (e, lo, hi) in [(1.0, 1.95, 2.05), (0.5, 0.9, 1.1)] {
        let order = (error_of_position(e, 100.0) / error_of_position(e, 800.0)).log2() / 3.0;
        assert!((lo..hi).contains(&order), "e = {e}: order {order}");
    }
}
