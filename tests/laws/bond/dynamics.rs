//! Free pairs under a bond, in LIGGGHTS's time integration: momentum, energy, damping, critical steps.
use super::bench::{Deck, Driven};
use granlaw::model::*;
use granlaw::pair::{run, states, Opened, Partner, Start, State};
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::PI;

const R: [f64; 2] = [5e-4, 4e-4];
const M: [f64; 2] = [1.3e-6, 0.7e-6];
const AREA: f64 = PI * 0.8 * 4e-4 * 0.8 * 4e-4;

/// Two unequal spheres at rest, 0.95 mm apart along x; the bond begins in step 1.
fn start(dt: f64, steps: u64) -> Start {
    let body = |k: usize, x: f64| Body {
        tag: k as i64 + 1,
        radius: R[k],
        mass: M[k],
        x: Vector3::x() * x,
        ..Body::default()
    };
    Start {
        bodies: [body(0, 0.5e-3), body(1, -0.45e-3)],
        types: (0, 0),
        partner: Partner::Free,
        dt,
        steps,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Closes,
    }
}

/// The pair above, turned by `q`, with all modes set going.
pub fn tumbling(q: &Rotation3<f64>, steps: u64) -> Start {
    let mut s = start(1e-8, steps);
    let motion = [
        (Vector3::new(0.1, 0.5, -0.3), Vector3::new(100.0, -300.0, 200.0)),
        (Vector3::new(-0.1, -0.4, 0.2), Vector3::new(-100.0, 50.0, 400.0)),
    ];
    for (b, (v, w)) in s.bodies.iter_mut().zip(motion) {
        (b.x, b.v, b.omega) = (q * b.x, q * v * 10.0, q * w * 10.0);
    }
    s
}

fn inertia(k: usize) -> f64 {
    0.4 * M[k] * R[k] * R[k]
}

fn angular_momentum(s: &State) -> Vector3<f64> {
    let one = |(k, b): (usize, &Body)| b.x.cross(&b.v) * M[k] + b.omega * inertia(k);
    s.bodies.iter().enumerate().map(one).sum()
}

#[test]
fn angular_momentum_of_a_free_pair_stays_for_20_000_steps() {
    for deck in [Deck::documented().with("dampingBond", "off"), damped(0.2)] {
        let (mut first, mut worst, mut held) = (None, 0.0f64, false);
        run(&mut deck.chain(), &tumbling(&Rotation3::identity(), 20_000), |s| {
            let l = angular_momentum(s);
            let l0 = *first.get_or_insert(l);
            worst = worst.max((l - l0).norm() / l0.norm());
            held = s.history[0] != 0.0;
        });
        assert!(held && worst < 1e-12, "{worst:e}");
    }
}

const ETA: [&str; 4] = [
    "dampingNormalForceBondnonlinear",
    "dampingTangentialForceBondnonlinear",
    "dampingNormalTorqueBondnonlinear",
    "dampingTangentialTorqueBondnonlinear",
];

fn damped(eta: f64) -> Deck {
    ETA.into_iter().fold(Deck::documented(), |d, name| d.set(name, eta))
}

/// All lines straight: springs that remember nothing.
fn linear(deck: Deck) -> Deck {
    let pairs = [
        ("stiffnessPerUnitAreaK_fn2", "stiffnessPerUnitAreaKu_fn2"),
        ("stiffnessPerUnitAreaK_tn", "stiffnessPerUnitAreaKu_tn"),
        ("stiffnessPerUnitAreaK_tt", "stiffnessPerUnitAreaKu_tt"),
    ];
    pairs.into_iter().fold(deck, |d, (k, ku)| {
        let value = d.values[k];
        d.set(ku, value)
    })
}

/// Twist that is let go from a deflection: the turning points of a free damped linear mode.
#[test]
fn a_damped_linear_mode_loses_its_share_per_half_cycle() {
    for eta in [0.1, 0.3] {
        let k = 4e9 * 0.5 * AREA * (0.8f64 * 4e-4).powi(2);
        let reduced = 1.0 / (1.0 / inertia(0) + 1.0 / inertia(1));
        let half = PI * (reduced / k).sqrt();
        let mut s = start(half / 2000.0, 1);
        s.bodies[0].omega = Vector3::x() * 1000.0;
        s.bodies[1].omega = -s.bodies[0].omega * (inertia(0) / inertia(1));
        s.steps = 9000;
        let twist = |s: &State| s.history[12];
        let all = states(&mut linear(damped(eta)).chain(), &s);
        let turns: Vec<f64> = all
            .windows(3)
            .map(|w| [twist(&w[0]).abs(), twist(&w[1]).abs(), twist(&w[2]).abs()])
            .filter(|[a, b, c]| b > a && b >= c)
            .map(|[_, b, _]| b)
            .collect();
        assert!(turns.len() >= 3, "{turns:?}");
        let expected = ((1.0 - eta) / (1.0 + eta)).sqrt();
        for w in turns.windows(2) {
            // First order in the step: sgn acts one step late, 1/2000 of a half cycle.
            approx::assert_relative_eq!(w[1] / w[0], expected, max_relative = 2e-3);
        }
    }
}

/// Kinetic energy \[J\].
fn kinetic(s: &State) -> f64 {
    let one =
        |(k, b): (usize, &Body)| 0.5 * M[k] * b.v.norm_squared() + 0.5 * inertia(k) * b.omega.norm_squared();
    s.bodies.iter().enumerate().map(one).sum()
}

/// A step just below the critical one of a linear mode is stable, just above it grows; formulas as in the law's sheet.
#[test]
fn critical_steps_of_the_linear_modes_are_those_of_the_sheet() {
    // Two equal spheres, so that shear and bending do not couple. Tension has one side only: what swings there comes
    // loose at its upper end, and branch switches pump energy long before the critical step of the line.
    let (m, r, turn) = (M[0] / 2.0, R[0], 0.5 * 0.4 * M[0] * R[0] * R[0]);
    let radius = 0.8 * r;
    let area = PI * radius * radius;
    let polar = 0.5 * area * radius * radius;
    let kappa = 0.95e-3 / (2.0 * r);
    let modes = [
        ("shear", (m / ((1.0 + 2.5 * kappa * kappa) * 4e9 * area)).sqrt()),
        ("twist", (turn / (4e9 * polar)).sqrt()),
        ("bend", (turn / (1e10 * 0.5 * polar)).sqrt()),
    ];
    for (mode, time) in modes {
        let grows = |part: f64| {
            let all = states(&mut only(mode).chain(), &plucked(mode, 2.0 * time * part));
            all.iter().map(kinetic).fold(0.0, f64::max) > 100.0 * kinetic(&all[1])
        };
        let (below, above) = (grows(0.995), grows(1.005));
        assert!(!below && above, "{mode}: {below} below, {above} above");
    }
}

/// A straight bond with one mode.
fn only(mode: &str) -> Deck {
    let settings = [("shear", "shearStress"), ("twist", "normalTorqueStress"), ("bend", "shearTorqueStress")];
    let deck = linear(Deck::documented().with("dampingBond", "off").with("compressionStress", "off"));
    let deck = deck.with("tensionStress", "off");
    let deck = settings.iter().filter(|(m, _)| *m != mode).fold(deck, |d, (_, s)| d.with(s, "off"));
    deck.set("maxDistanceBondnonlinear", 1.0)
}

/// Two equal spheres with a little of one mode.
fn plucked(mode: &str, dt: f64) -> Start {
    let mut s = start(dt, 2000);
    (s.bodies[1].radius, s.bodies[1].mass) = (R[0], M[0]);
    let (i, j) = s.bodies.split_at_mut(1);
    let (i, j) = (&mut i[0], &mut j[0]);
    match mode {
        "shear" => (i.v.y, j.v.y) = (1e-9, -1e-9),
        "twist" => (i.omega.x, j.omega.x) = (1e-3, -1e-3),
        _ => (i.omega.z, j.omega.z) = (1e-3, -1e-3),
    }
    s
}

/// The step beyond which a bond between these bodies grows, by what the law says of its modes \[s\].
fn told(deck: &Deck, s: &Start) -> f64 {
    let [i, j] = s.bodies;
    let is_wall = matches!(s.partner, Partner::Plane { .. });
    let (massj, radj) = if is_wall { (0.0, 0.0) } else { (j.mass, j.radius) };
    let meff = if is_wall { i.mass } else { i.mass * massj / (i.mass + massj) };
    let size = Size { radi: i.radius, radj, massi: i.mass, massj, frozen: [false; 2], meff, is_wall };
    let modes = deck.chain().modes((0, 0), &size, 1e-3);
    modes.into_iter().map(|m| m.mode.step()).fold(f64::INFINITY, f64::min)
}

/// Shear and bending swing together where the bodies differ and at a wall; twist does not.
#[test]
fn the_law_tells_the_critical_steps_of_unlike_bodies_and_of_a_wall() {
    for wall in [false, true] {
        for mode in ["shear", "twist", "bend", "shear and bend"] {
            let deck = match mode {
                "shear and bend" => linear(only("shear").with("shearTorqueStress", "on")),
                _ => only(mode),
            };
            // As far apart as one can begin.
            let deck =
                deck.set("createDistanceBondnonlinear", if wall { 1.0000001e-3 } else { 0.9500001e-3 });
            let grows = |part: f64| {
                let mut s = plucked(if mode.starts_with("shear") { "shear" } else { mode }, 0.0);
                s.dt = part * {
                    (s.bodies[1].radius, s.bodies[1].mass) = (R[1], M[1]);
                    if wall {
                        s.partner = Partner::Plane { point: Vector3::zeros(), normal: Vector3::x() };
                    }
                    told(&deck, &s)
                };
                s.steps = 4000;
                let all = states(&mut deck.chain(), &s);
                all.iter().map(kinetic).fold(0.0, f64::max) > 100.0 * kinetic(&all[1])
            };
            let at = [0.995, 1.005].map(grows);
            assert_eq!(at, [false, true], "{mode}, wall {wall}");
            // Planted: a step that is too long or too short by a twentieth.
            assert!(grows(1.05 * 0.995) && !grows(0.95 * 1.005), "{mode}, wall {wall}");
        }
    }
}

/// As in the law's sheet: damping that sets on the wrong way adds its share to the stiffness; compression is as stiff as
/// where a blow ends.
#[test]
fn damping_and_the_speed_of_a_blow_count() {
    let stiffness = |deck: &Deck, name: &str, speed: f64| {
        let body = Body { radius: R[0], mass: M[0], ..Body::default() };
        let size = ClosePair { i: body, j: body, ..ClosePair::default() }.weighed().size();
        let all = deck.chain().modes((0, 0), &size, speed);
        all.into_iter().find(|s| s.name == name).expect("a mode").mode.stiffness
    };
    let (plain, eta) = (Deck::documented().with("dampingBond", "off"), damped(0.2));
    for name in ["compression", "tension", "shear", "twist", "bending"] {
        approx::assert_relative_eq!(
            stiffness(&eta, name, 0.1),
            1.2 * stiffness(&plain, name, 0.1),
            max_relative = 1e-12
        );
    }
    // δ grows with the 4/3 of the speed, the tangent falls with its root.
    let ratio = stiffness(&plain, "compression", 0.8) / stiffness(&plain, "compression", 0.1);
    approx::assert_relative_eq!(ratio, 0.25, max_relative = 1e-12);
    // ½ m* v² = ⅔ A k1 δ^1.5.
    let area = PI * (0.8f64 * R[0]).powi(2);
    let deepest = (0.75 * 0.5 * M[0] * 0.01 / (area * 4e7)).powf(2.0 / 3.0);
    let expected = 0.5 * area * 8e7 / deepest.sqrt();
    approx::assert_relative_eq!(stiffness(&plain, "compression", 0.1), expected, max_relative = 1e-12);
}

/// Without damping and with straight lines a free pair keeps its energy, as kinetic energy at each return through rest.
#[test]
fn a_linear_bond_keeps_energy() {
    let mut s = start(1e-8, 40_000);
    s.bodies[0].omega = Vector3::new(300.0, 0.0, 0.0);
    let all = states(&mut linear(Deck::documented().with("dampingBond", "off")).chain(), &s);
    let most = all.iter().map(kinetic).fold(0.0, f64::max);
    approx::assert_relative_eq!(most, kinetic(&all[0]), max_relative = 1e-6);
}

/// At rest under a load, damping that changes sign chatters; the smoothed one stands still.
#[test]
fn smoothed_damping_comes_to_rest() {
    let residual = |smooth: &'static str| {
        let deck = linear(damped(0.5)).with("dampingBondSmooth", smooth).with("shearTorqueStress", "off");
        let mut s = start(1e-7, 60_000);
        s.partner = Partner::Frozen;
        s.bodies[1].mass = f64::INFINITY;
        s.gravity = Vector3::x() * 1000.0;
        let all = states(&mut deck.chain(), &s);
        let tail = &all[50_000..];
        tail.iter().map(|s| s.bodies[0].v.norm()).fold(0.0, f64::max)
    };
    let (hard, smooth) = (residual("off"), residual("on"));
    // ½ η g Δt = 2.5e-5 m/s.
    assert!(hard < 1e-4 && hard > 1e-6, "{hard:e}");
    assert!(smooth < 1e-3 * hard, "{smooth:e} against {hard:e}");
}

/// How such a bond turned cannot be told, as when a deck sets its ends elsewhere. What is left is no bond, not NaN.
#[test]
fn a_bond_that_swings_round_in_one_step_breaks() {
    let after = |to: Vector3<f64>| {
        let mut pair = Driven::pair(&Deck::documented(), Vector3::x() * 1.02e-3);
        (0..5).for_each(|_| pair.step(Vector3::y() * 0.2, Vector3::z() * 100.0, Vector3::zeros()));
        pair.place(to.normalize() * 1.02e-3);
        (pair.bond_event, pair.response.force.norm(), pair.history.iter().all(|&h| h == 0.0))
    };
    let back = -Vector3::new(1.02e-3, 5.0 * 0.2e-7, 0.0);
    for to in [back, -Vector3::x(), -Vector3::y(), Vector3::new(-0.01, 1.0, 1.0)] {
        assert_eq!(after(to), (BondEvent::Ends, 0.0, true), "{to}");
    }
    let (life, force, _) = after(Vector3::new(0.1, 1.0, 1.0));
    assert!(life == BondEvent::Lasts && force.is_finite() && force > 0.0);
}
