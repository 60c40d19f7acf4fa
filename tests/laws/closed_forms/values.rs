//! Single evaluations against the equations worked out here: what an impact alone would not pin down.
use super::bench::{chain, linear_stiffness, near, sphere, Given};
use granlaw::model::{Body, Call, ClosePair, Contact, Kind, Response};
use nalgebra::Vector3;
use std::f64::consts::PI;

const R: f64 = 0.005;
const YOUNG: f64 = 5e6;
const NU: f64 = 0.3;
const OVERLAP: f64 = 1e-4;
const GIVEN: Given<'_> = &[
    ("youngsModulus", [YOUNG; 2]),
    ("poissonsRatio", [NU; 2]),
    ("characteristicVelocity", [2.0; 2]),
    ("coefficientRestitution", [0.5; 2]),
    ("coefficientFriction", [0.4; 2]),
    ("coefficientMaxElasticStiffness", [5.0; 2]),
    ("coefficientAdhesionStiffness", [0.5; 2]),
    ("coefficientPlasticityDepth", [0.05; 2]),
    ("FluidViscosity", [1e-3; 2]),
    ("MaximumRestitution", [0.9; 2]),
    ("CriticalStokes", [10.0; 2]),
];

/// Two spheres along x; `v` is the velocity of i against j.
fn contact(v: Vector3<f64>) -> Contact {
    let i = Body { v, x: Vector3::x() * (2.0 * R - OVERLAP), ..sphere(R, 2500.0) };
    let j = Body { tag: 2, ..sphere(R, 2500.0) };
    let call = Call { dt: 1e-6, step: 1, update: true, ..Call::default() };
    Contact::pair(ClosePair { call, i, j, delta: i.x, rsq: i.x.norm_squared(), meff: i.mass / 2.0 })
}

fn answer(laws: &[(Kind, &str)], chosen: &[(&str, &str)], v: Vector3<f64>, h: &mut [f64]) -> Response {
    let mut s = Response::default();
    chain(laws, GIVEN, chosen).surfaces_intersect((0, 0), &contact(v), h, &mut s);
    s
}

/// `answer` of a normal law alone with a normal velocity.
fn normal(law: &str, chosen: &[(&str, &str)], vn: f64) -> Response {
    answer(&[(Kind::Normal, law)], chosen, Vector3::x() * vn, &mut [0.0])
}

/// A few operations in another order.
const ROUND_OFF: f64 = 1e-12;

/// γ of a linear spring for ln e, and its kn.
fn dashpot(log_e: f64) -> (f64, f64) {
    let m = sphere(R, 2500.0).mass / 2.0;
    let kn = linear_stiffness(YOUNG / (2.0 * (1.0 - NU * NU)), R / 2.0, m, 2.0);
    ((4.0 * m * kn * log_e * log_e / (log_e * log_e + PI * PI)).sqrt(), kn)
}

#[test]
fn linear_tangential_stiffness_and_damping() {
    let (gamma, kn) = dashpot(0.5f64.ln());
    for (law, chosen, kt, gammat) in [
        ("hooke", &[][..], kn, gamma),
        ("hooke", &[("tangential_damping", "off")], kn, 0.0),
        // LIGGGHTS writes 2/7 with nine digits.
        ("hooke", &[("ktToKnUser", "on")], 0.285714286 * kn, gamma),
        ("hooke/hysteresis", &[], kn, gamma),
        ("hooke/hysteresis", &[("tangential_damping", "off")], kn, 0.0),
    ] {
        let s = normal(law, chosen, -0.1);
        near("kn", s.kn, kn, ROUND_OFF, kn).unwrap();
        near("kt", s.kt, kt, ROUND_OFF, kn).unwrap();
        near("γn", s.gamman, gamma, ROUND_OFF, gamma).unwrap();
        near("γt", s.gammat, gammat, ROUND_OFF, gamma).unwrap();
    }
}

#[test]
fn mindlin_stiffness_and_damping() {
    // G* of two like spheres: E/(4 (2−ν)(1+ν)).
    let (g, e) = (YOUNG / (4.0 * (2.0 - NU) * (1.0 + NU)), YOUNG / (2.0 * (1.0 - NU * NU)));
    let (root, m) = ((R / 2.0 * OVERLAP).sqrt(), sphere(R, 2500.0).mass / 2.0);
    let beta = 0.5f64.ln() / (0.5f64.ln().powi(2) + PI * PI).sqrt();
    let gamma = |stiffness: f64| -2.0 * (5.0f64 / 6.0).sqrt() * beta * (stiffness * m).sqrt();
    let s = normal("hertz", &[], -0.1);
    // The overlap is a difference of lengths of 0.01 m: 1e-18/1e-4.
    for (what, got, expected) in [
        ("kn", s.kn, 4.0 / 3.0 * e * root),
        ("kt", s.kt, 8.0 * g * root),
        ("γn", s.gamman, gamma(2.0 * e * root)),
        ("γt", s.gammat, gamma(8.0 * g * root)),
    ] {
        near(what, got, expected, ROUND_OFF, expected).unwrap();
    }
    assert_eq!(normal("hertz", &[("tangential_damping", "off")], -0.1).gammat, 0.0);
}

#[test]
fn viscous_restitution_follows_the_stokes_number_with_its_sign_or_without() {
    let m = sphere(R, 2500.0).mass / 2.0;
    for law in ["hooke", "hooke/hysteresis"] {
        for vn in [-0.4, -0.02, 0.02, 0.4] {
            let stokes = m * vn / (6.0 * PI * 1e-3 * (R / 2.0).powi(2));
            for (chosen, stokes) in [
                (&[("viscous", "on")][..], stokes),
                (&[("viscous", "on"), ("viscousAbs", "on")], stokes.abs()),
            ] {
                let (gamma, _) = dashpot(0.9f64.ln() + 10.0 / stokes);
                near("γn", normal(law, chosen, vn).gamman, gamma, ROUND_OFF, gamma).unwrap();
            }
        }
        // At rest the Stokes number is 0 and the dashpot critical.
        let (critical, _) = dashpot(1e9);
        near("γn", normal(law, &[("viscous", "on")], 0.0).gamman, critical, ROUND_OFF, critical).unwrap();
    }
}

#[test]
fn shear_is_turned_into_the_tangent_plane_and_cut_at_the_coulomb_limit() {
    let laws = [(Kind::Normal, "hooke"), (Kind::Tangential, "history")];
    let (v, off) = (Vector3::new(0.0, 1.0, 0.0), [("tangential_damping", "off")]);
    let mut h = [5e-6, 2e-6, 0.0];
    let s = answer(&laws, &off, v, &mut h);
    // 2e-6 m and 1 m/s for 1e-6 s: sticks, with what lay along the normal gone.
    for (got, expected) in h.iter().zip([0.0, 3e-6, 0.0]) {
        near("shear", *got, expected, ROUND_OFF, 3e-6).unwrap();
    }
    near("force", s.force.y, -s.kt * 3e-6, ROUND_OFF, s.force.y).unwrap();
    let mut h = [0.0, 9e-5, 0.0];
    let s = answer(&laws, &off, v, &mut h);
    near("force", s.force.y, -0.4 * s.fn_, ROUND_OFF, s.fn_).unwrap();
    near("shear", h[1], 0.4 * s.fn_ / s.kt, ROUND_OFF, h[1]).unwrap();
    // Below the limit the dashpot is added.
    let mut h = [0.0, 2e-6, 0.0];
    let s = answer(&laws, &[], v, &mut h);
    near("force", s.force.y, -s.kt * 3e-6 - s.gammat, ROUND_OFF, s.force.y).unwrap();
}

#[test]
fn viscous_friction_is_cut_at_the_coulomb_limit() {
    let laws = [(Kind::Normal, "hooke"), (Kind::Tangential, "no_history")];
    let slow = answer(&laws, &[], Vector3::y() * 1e-3, &mut []);
    near("force", slow.force.y, -slow.gammat * 1e-3, ROUND_OFF, slow.force.y).unwrap();
    let fast = answer(&laws, &[], Vector3::y() * 1e3, &mut []);
    near("force", fast.force.y, -0.4 * fast.fn_, ROUND_OFF, fast.fn_).unwrap();
    let lever = R - OVERLAP / 2.0;
    for torque in [fast.torque_i, fast.torque_j] {
        near("torque", torque.z, -lever * fast.force.y, ROUND_OFF, torque.z).unwrap();
    }
}
