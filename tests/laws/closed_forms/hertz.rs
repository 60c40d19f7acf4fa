//! Hertz contact: peaks, durations and restitution, with the materials of Chung & Ooi (2011), tests 1 to 3.
use super::bench::{chain, impact, near, sphere, start, Impact};
use granlaw::model::{Body, Kind};
use nalgebra::Vector3;

/// E \[Pa\], ν, ρ \[kg/m³\].
pub type Material = (f64, f64, f64);

/// Young's modulus of a wall that may count as rigid.
pub const RIGID: f64 = 1e30;

/// 2√π Γ(7/5)/Γ(9/10).
const DURATION: f64 = 2.94327518;

/// Peak overlap \[m\], peak force \[N\] and duration \[s\] of an elastic impact at relative speed v.
fn peaks(e_star: f64, r_star: f64, m_star: f64, v: f64) -> [f64; 3] {
    let k = 4.0 / 3.0 * e_star * r_star.sqrt();
    let overlap = (5.0 * m_star * v * v / (4.0 * k)).powf(0.4);
    [overlap, k * overlap.powf(1.5), DURATION * overlap / v]
}

/// E*, R*, m* of two spheres or of one on a rigid wall.
fn stars((young, nu, rho): Material, r: f64, wall: bool) -> [f64; 3] {
    let (e, m) = (young / (1.0 - nu * nu), sphere(r, rho).mass);
    if wall {
        [e, r, m]
    } else {
        [e / 2.0, r / 2.0, m / 2.0]
    }
}

/// An impact at relative speed `v` with `n` steps in an elastic contact.
fn strike((young, nu, rho): Material, r: f64, wall: bool, v: f64, e: f64, n: f64) -> Impact {
    let [e_star, r_star, m_star] = stars((young, nu, rho), r, wall);
    let given =
        [("youngsModulus", [young, RIGID]), ("poissonsRatio", [nu, nu]), ("coefficientRestitution", [e; 2])];
    let dt = peaks(e_star, r_star, m_star, v)[2] / n;
    let body = |v: f64| Body { v: Vector3::x() * v, ..sphere(r, rho) };
    let speeds = if wall { [-v, 0.0] } else { [-v / 2.0, v / 2.0] };
    let start = start(speeds.map(body), wall, dt, (2.5 * n) as u64);
    impact(&mut chain(&[(Kind::Normal, "hertz")], &given, &[]), &start)
}

const GLASS: Material = (4.8e10, 0.20, 2800.0);
const LIMESTONE: Material = (2.0e10, 0.25, 2500.0);
const ALUMINIUM: Material = (7.0e10, 0.30, 2699.0);
const MAGNESIUM: Material = (4.0e10, 0.35, 1800.0);
pub const ALUMINA: Material = (3.8e11, 0.23, 4000.0);
const CAST_IRON: Material = (1.0e11, 0.25, 7000.0);

/// Material, R \[m\], on a wall, relative speed \[m/s\]; peak overlap \[µm\], peak force \[kN\], duration \[µs\] of Hertz's
/// theory for Chung & Ooi's tests 1 and 2.
const ELASTIC: [(Material, f64, bool, f64, [f64; 3]); 4] = [
    (GLASS, 0.01, false, 20.0, [274.1127, 10.696889, 40.33946]),
    (LIMESTONE, 0.01, false, 20.0, [368.3040, 7.108241, 54.20101]),
    (ALUMINIUM, 0.1, true, 0.2, [49.71718, 11.369858, 731.6566]),
    (MAGNESIUM, 0.1, true, 0.2, [52.12329, 7.232681, 767.0659]),
];

fn elastic(stiffer: f64) -> Result<(), String> {
    for ((young, nu, rho), r, wall, v, expected) in ELASTIC {
        let got = strike((young * stiffer, nu, rho), r, wall, v, 1.0, 4000.0);
        // Third order in the step: 3e-5 at 50 steps.
        near("e", got.e, 1.0, 1e-6, 1.0)?;
        let got = [got.overlap * 1e6, got.force * 1e-3, got.duration * 1e6];
        // Seven digits are quoted; the peak is missed by at most half a step, 2e-7 of it; duration is second order.
        for ((what, got), expected) in ["overlap", "force", "duration"].iter().zip(got).zip(expected) {
            near(what, got, expected, 1e-6, expected)?;
        }
    }
    Ok(())
}

#[test]
fn chung_and_ooi_1_and_2_peaks_and_durations() {
    for (m, r, wall, v, expected) in ELASTIC {
        let [e, rs, ms] = stars(m, r, wall);
        let [overlap, force, duration] = peaks(e, rs, ms, v);
        near("overlap", overlap * 1e6, expected[0], 1e-6, expected[0]).unwrap();
        near("force", force * 1e-3, expected[1], 1e-6, expected[1]).unwrap();
        near("duration", duration * 1e6, expected[2], 1e-6, expected[2]).unwrap();
    }
    elastic(1.0).unwrap();
}

#[test]
fn a_modulus_off_by_a_thousandth_is_seen() {
    assert!(elastic(1.001).unwrap_err().contains("instead of"));
}

#[test]
fn chung_and_ooi_1_and_2_the_published_curves() {
    // Ends of the force-displacement curves as the Kratos project digitised them from the paper. The glass curve ends
    // 3 and 5 per cent below Hertz's theory, which the law agrees with to 1e-6; the other within 0.6 per cent.
    let glass = strike(GLASS, 0.01, false, 20.0, 1.0, 1000.0);
    near("overlap", 265.2e-6, glass.overlap, 0.05, glass.overlap).unwrap();
    near("force", 10.18e3, glass.force, 0.05, glass.force).unwrap();
    let aluminium = strike(ALUMINIUM, 0.1, true, 0.2, 1.0, 1000.0);
    near("overlap", 49.99e-6, aluminium.overlap, 0.02, aluminium.overlap).unwrap();
    near("force", 11.33e3, aluminium.force, 0.02, aluminium.force).unwrap();
}

#[test]
fn chung_and_ooi_3_restitution_comes_out_as_it_went_in() {
    for material in [ALUMINA, CAST_IRON] {
        for e in [0.2, 0.4, 0.6, 0.8, 1.0] {
            let got = strike(material, 0.0025, true, 3.9, e, 20_000.0);
            assert!(got.apart);
            near("e", got.e, e, 1e-5, 1.0).unwrap();
        }
    }
}

#[test]
fn restitution_does_not_depend_on_the_impact_speed() {
    for e in [0.9, 0.5, 0.2] {
        for v in [1e-3, 0.1, 10.0] {
            let got = strike(GLASS, 0.01, false, v, e, 20_000.0);
            near("e", got.e, e, 1e-5, 1.0).unwrap();
        }
    }
}
