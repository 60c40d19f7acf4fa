//! Linear spring and dashpot: restitution, duration, and both without attraction (Schwager & Pöschel 2007).
use super::bench::{chain, impact, linear_stiffness, near, sphere, start, Given, Impact};
use granlaw::model::{Body, Kind};
use nalgebra::Vector3;
use std::f64::consts::PI;

const R: f64 = 0.005;
const RHO: f64 = 2500.0;
const YOUNG: f64 = 5e6;
const NU: f64 = 0.45;
const VC: f64 = 2.0;

/// The undamped angular frequency and m* of two such spheres, or of one on a wall of the same material.
fn oscillator(wall: bool) -> (f64, f64) {
    let mass = sphere(R, RHO).mass;
    let (m, r) = if wall { (mass, R) } else { (mass / 2.0, R / 2.0) };
    let kn = linear_stiffness(YOUNG / (2.0 * (1.0 - NU * NU)), r, m, VC);
    ((kn / m).sqrt(), m)
}

/// An impact with `e` for the dashpot, `n` steps per undamped contact.
fn strike(law: &str, wall: bool, e: f64, chosen: &[(&str, &str)], n: f64) -> Impact {
    let given: Given<'_> = &[
        ("youngsModulus", [YOUNG; 2]),
        ("poissonsRatio", [NU; 2]),
        ("characteristicVelocity", [VC; 2]),
        ("coefficientRestitution", [e; 2]),
        ("coefficientMaxElasticStiffness", [1.0; 2]),
        ("coefficientAdhesionStiffness", [0.0; 2]),
        ("coefficientPlasticityDepth", [0.05; 2]),
    ];
    let (w0, _) = oscillator(wall);
    let body = |v: f64| Body { v: Vector3::x() * v, ..sphere(R, RHO) };
    let dt = PI / w0 / n;
    let start = start([body(-0.3), body(0.2)], wall, dt, (1.6 * n) as u64);
    impact(&mut chain(&[(Kind::Normal, law)], given, chosen), &start)
}

/// b = γ/2m* over ω0 from `γ = sqrt(4 m* k/(1 + (π/ln e)²))`.
fn damping_ratio(e: f64) -> f64 {
    1.0 / (1.0 + (PI / f64::ln(e)).powi(2)).sqrt()
}

/// Restitution, and duration times ω0, of a contact that ends when the force vanishes (Schwager & Pöschel 2007,
/// Granular Matter 9:465).
fn without_attraction(e: f64) -> (f64, f64) {
    let b = damping_ratio(e);
    let w = (1.0 - b * b).sqrt();
    let angle = (2.0 * b * w / (w * w - b * b)).atan();
    let phi = if b < 0.5f64.sqrt() { PI - angle } else { -angle };
    ((-b * phi / w).exp(), phi / w)
}

#[test]
fn the_stiffness_and_the_peak_force_are_those_of_the_formula() {
    let mass = sphere(R, RHO).mass;
    let kn = linear_stiffness(YOUNG / (2.0 * (1.0 - NU * NU)), R / 2.0, mass / 2.0, VC);
    near("kn", kn, KN_OF_PAIR, 1e-11, KN_OF_PAIR).unwrap();
    let peak = strike("hooke", false, 1.0, &[], 4000.0);
    // Peak force √(k m*) V; the peak lies within half a step of a sample: (π/8000)²/2 = 8e-8.
    near("peak", peak.force, (KN_OF_PAIR * mass / 2.0).sqrt() * 0.5, 2e-7, peak.force).unwrap();
}

/// 16/15 √R* E* (15 m* vc²/(16 √R* E*))^0.2 in 30-digit arithmetic: E* = 3134796.23824451, R* = 2.5 mm,
/// m* = 0.654498469497874 g.
const KN_OF_PAIR: f64 = 4593.67389344595;

#[test]
fn an_elastic_impact_is_elastic_and_takes_half_a_period() {
    for law in ["hooke", "hooke/hysteresis"] {
        for wall in [false, true] {
            let (w0, _) = oscillator(wall);
            let got = strike(law, wall, 1.0, &[], 2000.0);
            // The error of e is third order, 1e-6 at 100 steps; that of the duration π²/24/n² = 1e-7.
            near("e", got.e, 1.0, 1e-8, 1.0).unwrap();
            near("duration", got.duration, PI / w0, 1e-6, PI / w0).unwrap();
        }
    }
}

#[test]
fn the_dashpot_gives_the_restitution_that_it_was_made_for() {
    for e in [0.9, 0.5, 0.2] {
        for (law, wall) in [("hooke", false), ("hooke", true), ("hooke/hysteresis", false)] {
            let (w0, _) = oscillator(wall);
            let got = strike(law, wall, e, &[], 4e5);
            // First order: 0.36/n at e = 0.5, about 1/n at 0.2.
            near("e", got.e, e, 5e-6, 1.0).unwrap();
            let duration = PI / w0 / (1.0 - damping_ratio(e).powi(2)).sqrt();
            near("duration", got.duration, duration, 1e-5, duration).unwrap();
        }
    }
}

#[test]
fn without_attraction_a_contact_ends_sooner_and_gives_back_more() {
    // Schwager & Pöschel's formula at these e gives these numbers; LIGGGHTS with limitForce on .902023, .550266, .324835
    // at its coarser step.
    for (e, published) in [(0.9, 0.9020261), (0.5, 0.5502832), (0.2, 0.3248628)] {
        let (expected, duration) = without_attraction(e);
        near("formula", expected, published, 1e-7, 1.0).unwrap();
        for (law, wall) in [("hooke", false), ("hooke", true), ("hooke/hysteresis", false)] {
            let (w0, _) = oscillator(wall);
            let got = strike(law, wall, e, &[("limitForce", "on")], 4e5);
            near("e", got.e, expected, 5e-6, 1.0).unwrap();
            near("duration", got.pushed, duration / w0, 1e-5, duration / w0).unwrap();
        }
    }
}

#[test]
fn a_spring_off_by_a_thousandth_is_seen() {
    let (w0, _) = oscillator(false);
    let got = strike("hooke", false, 1.0, &[], 2000.0);
    assert!(near("duration", got.duration, PI / (w0 * 1.001f64.sqrt()), 1e-6, PI / w0).is_err());
    let got = strike("hooke", false, 0.5, &[], 4e5);
    assert!(near("e", got.e, without_attraction(0.5).0, 5e-6, 1.0).is_err());
}
