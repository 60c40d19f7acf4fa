//! The cases of bonds: spheres of 1 cm with a gap of 1 mm that their bonds act across.
//!
//! A swing is one way out and back; the bonds have no stiffness on the other side, so the spheres then move freely. It is the swing of two
//! spheres, or of a chain in its slowest mode: all its bonds are then stretched in proportion, and turn and change branch at the same
//! time, so that it comes back as two spheres do.
use super::case::{Case, Measure};
use crate::study::bond::{Bond, LAMBDA, MODES};
use crate::study::bonded::whole;
use crate::study::bonded_row::{BondedRow, Way};
use crate::study::collision::Collision;
use granlaw::model::ClosePair;
use std::f64::consts::PI;

const SHOT: Collision = Collision::head_on(0.005, 2500.0, 0.2);
const GAP: f64 = 1e-3;
/// Stiffness of first loading in compression \[N/m^2.5\] and tension, and of bending \[N/m³\].
const K: [f64; 5] = [1e6, 1e8, 0.0, 0.0, 1e8];
/// Stiffness of unloading and of the line through zero, over that of first loading.
const OVER: [f64; 2] = [2.0, 0.5];
const STRAIGHT: [f64; 2] = [1.0, 0.5];
/// Damping ratio of the cases with damping.
const ETA: f64 = 0.1;
/// Number of periods for which the vibration is followed. It is not a whole number, so that an error of the phase shows.
const SWINGS: f64 = 10.125;

/// Number of bonds, times the number of periods for which they are followed.
pub(super) fn calls(case: &Case) -> f64 {
    case.collision.row().map_or(1.0, |t| (t.beads - 1) as f64 * swings(case))
}

/// Number of its own periods for which a row is followed.
pub(super) fn swings(case: &Case) -> f64 {
    if case.measure == Measure::Spin {
        SWINGS
    } else {
        1.0
    }
}

fn case(
    name: &'static str,
    title: &'static str,
    over: [f64; 2],
    eta: f64,
    mode: usize,
    collision: Collision,
) -> Case {
    let matter = Bond { radius: SHOT.radius, gap: GAP, k: K, over, eta, modes: &MODES[mode..=mode] }.matter();
    Case { name, title, matter, collision, measure: Measure::Restitution }
}

fn row(beads: usize, way: Way, speed: f64) -> Collision {
    Collision { speed, bonded: Some(BondedRow { beads, gap: GAP, way }), ..SHOT }
}

/// All cases of bonds.
pub(super) fn cases() -> Vec<Case> {
    let stretched = |beads| row(beads, Way::Along, -SHOT.speed);
    let turning = Collision { slide: SHOT.speed, ..row(2, Way::Bend, 0.0) };
    let vibrating = case("bond-vibration", "bond, bends to and fro ten times", STRAIGHT, 0.0, 4, turning);
    vec![
        Case { measure: Measure::Spin, ..vibrating },
        case("bond", "bond, stretched and back, ku = 2 k, kc = 0.5 k", OVER, 0.0, 1, stretched(2)),
        case("bond-damped", "bond, stretched and back, straight, η = 0.1", STRAIGHT, ETA, 1, stretched(2)),
        case(
            "bond-pressed",
            "bond, pressed and back (√δ), ku = 2 k, kc = 0.5 k",
            OVER,
            0.0,
            0,
            row(2, Way::Along, SHOT.speed),
        ),
        case(
            "bond-chain",
            "chain of 8, stretched and back, ku = 2 k, kc = 0.5 k",
            OVER,
            0.0,
            1,
            stretched(8),
        ),
        case(
            "bond-chain-damped",
            "chain of 8, stretched and back, straight, η = 0.1",
            STRAIGHT,
            ETA,
            1,
            stretched(8),
        ),
    ]
}

/// Step \[s\] and number of steps of a row, with about `n` steps per `period` \[s\]. A vibration ends exactly after its time.
pub(super) fn steps(case: &Case, period: f64, n: f64) -> (f64, u64) {
    if case.measure == Measure::Spin {
        let steps = whole(SWINGS * n + 1.0);
        return (SWINGS * period / (steps - 1) as f64, steps);
    }
    (period / n, whole(1.5 * n))
}

/// The closed form of what is measured of a row, and the approximate duration of one period or swing \[s\].
pub(super) fn closed_form(case: &Case) -> Option<(f64, f64)> {
    let bonded = case.collision.row()?;
    let [i, j] = case.collision.bodies();
    let area = PI * (LAMBDA * i.radius).powi(2);
    let meff = case.collision.meff();
    if case.measure == Measure::Spin {
        let size = ClosePair { i, j, meff, ..ClosePair::default() }.size();
        let (ti, tj) = size.mobilities();
        // I = ¼ A r_b².
        let stiffness = 0.25 * area * (LAMBDA * i.radius).powi(2) * K[4];
        let omega = (stiffness * (ti + tj)).sqrt();
        return Some(((2.0 * PI * SWINGS).cos() * i.omega.z, 2.0 * PI / omega));
    }
    // ω of the slowest mode of a free chain over √(k/m).
    let slow = 2.0 * (0.5 * PI / bonded.beads as f64).sin();
    let duration = PI / slow * (i.mass / (area * K[1])).sqrt();
    let (straight, eta) = (case.matter.value("stiffnessPerUnitAreaKu_fn2")? == K[1], damping(case));
    let [ku, kc] = if straight { STRAIGHT } else { OVER };
    // The fraction of the way out at which the line through zero is met, and the fraction of the work that comes back.
    let a = if straight { 0.0 } else { (ku - 1.0) / (ku + kc) };
    let back = if case.collision.speed < 0.0 {
        ku * (1.0 - a * a) - 2.0 * (ku - 1.0) * (1.0 - a) - kc * a * a
    } else {
        ku * (1.0 - a.powi(3)) - 1.5 * (ku - 1.0) * (1.0 - a * a) - kc * a.powi(3)
    };
    // Damping takes energy on the way out and back. Only bonds without damage are damped here.
    let back = back * (1.0 - eta) / (1.0 + eta);
    Some((back.sqrt(), duration))
}

fn damping(case: &Case) -> f64 {
    case.matter.value("dampingNormalForceBondnonlinear").unwrap_or(0.0)
}
