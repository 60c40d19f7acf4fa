//! The points in which document, corrected document and upstream header differ; numbers as in the law's sheet.
use super::bench::{Deck, Driven};
use granlaw::model::*;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::PI;

const CONVENTIONS: [&str; 2] = ["documented", "upstream"];

/// Compression in newtons that both conventions give for the same number, up to A.
fn area() -> f64 {
    PI * (0.8 * 5e-4f64).powi(2)
}

fn bond(convention: &'static str) -> Deck {
    let deck = Deck::documented().with("bondConvention", convention).with("dampingBond", "off");
    if convention == "documented" {
        return deck;
    }
    // The header leaves A out of compression.
    ["K", "Ku", "Kc"].iter().fold(deck, |d, k| {
        let name = d.values.keys().find(|n| **n == format!("stiffnessPerUnitArea{k}_fn1")).copied().unwrap();
        let value = d.values[name] * area();
        d.set(name, value)
    })
}

/// (1) A rigid rotation shears nothing; the printed (7) sees the whole speed of the surface.
#[test]
fn point_1_a_rigid_rotation_shears_nothing() {
    let omega = Vector3::z() * (0.1 / 1.02e-3);
    for convention in CONVENTIONS {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        for _ in 0..1000 {
            pair.turn_rigidly(&omega);
        }
        let sheared = 4e9 * area() * 0.1 * 1e-7 * 1000.0;
        assert!(
            pair.response.force.norm() < 1e-4 * sheared,
            "{convention}: {:e} of {sheared:e} N",
            pair.response.force.norm()
        );
        let (n, v) = (pair.close.delta.normalize(), pair.close.i.v - pair.close.j.v);
        let radius = pair.close.i.radius;
        let printed = v - n * v.dot(&n) + (omega * radius - omega * radius).cross(&n);
        approx::assert_relative_eq!(printed.norm(), 0.1, max_relative = 1e-6);
    }
}

/// (2) Both torques together carry the orbital couple; the printed T_j = −T_i loses all of it.
#[test]
fn point_2_torques_keep_the_angular_momentum() {
    for convention in CONVENTIONS {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        (0..50).for_each(|_| pair.step(Vector3::y() * 0.2, Vector3::zeros(), Vector3::zeros()));
        let s = &pair.response;
        let orbital = pair.close.delta.cross(&s.force);
        let lost = (orbital + s.torque_i + s.torque_j).norm();
        assert!(lost < 1e-15 * orbital.norm() + 1e-25, "{convention} loses {lost:e} of {:e}", orbital.norm());
        let printed = (orbital + s.torque_i - s.torque_i).norm();
        approx::assert_relative_eq!(
            printed,
            pair.close.delta.norm() * shear(&pair).norm(),
            max_relative = 1e-12
        );
    }
}

/// The part of the force across the bond \[N\].
fn shear(pair: &Driven) -> Vector3<f64> {
    let n = pair.close.delta.normalize();
    pair.response.force - n * pair.response.force.dot(&n)
}

/// (3) The same number K_fn1 means A times less force in the documented convention; tension is the same.
#[test]
fn point_3_compression_of_the_header_lacks_the_area() {
    let at = |convention: &'static str, delta: f64| {
        let mut pair = Driven::pair(
            &Deck::documented().with("bondConvention", convention).with("dampingBond", "off"),
            Vector3::x() * 1.02e-3,
        );
        pair.place(Vector3::x() * (1.02e-3 - delta));
        pair.response.force.x
    };
    approx::assert_relative_eq!(at("documented", 2e-6), area() * at("upstream", 2e-6), max_relative = 1e-14);
    approx::assert_relative_eq!(
        at("documented", 2e-6),
        4e7 * area() * (2e-6f64).sqrt(),
        max_relative = 1e-12
    );
    approx::assert_relative_eq!(at("documented", -2e-6), at("upstream", -2e-6), max_relative = 1e-14);
}

/// (4) On the virgin line of tension the header evaluates branch 2 with δ for δmin, which is branch 1 but for rounding.
#[test]
fn point_4_branch_2_stands_in_for_branch_1() {
    let mut apart = 0;
    for k in 1..200 {
        let r = 1.02e-3 + k as f64 * 1e-8;
        let at = |convention: &'static str| {
            let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
            pair.place(Vector3::x() * r);
            pair.response.force.x
        };
        let (a, b) = (at("documented"), at("upstream"));
        let root = |r: f64| (r * r).sqrt();
        let (delta, radius) = (root(1.02e-3) - root(r), 0.8f64 * 5e-4);
        let area = PI * radius * radius;
        let normal = r * (1.0 / root(r));
        assert_eq!(b, normal * (2e10 * area * delta + (1e10 - 2e10) * area * delta));
        approx::assert_relative_eq!(a, b, max_relative = 1e-15);
        apart += usize::from(a != b);
    }
    assert!(apart > 0, "both evaluate the same branch");
}

/// (5) Damage outlives a change of sense in the documented convention; the header forgets it.
#[test]
fn point_5_crossing_zero_forgets_nothing() {
    let again = |convention: &'static str| {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        for delta in [4e-6, -1e-6, 3e-6] {
            pair.place(Vector3::x() * (1.02e-3 - delta));
        }
        pair.response.force.x / area()
    };
    let (virgin, reloading) = (4e7 * (3e-6f64).sqrt(), 8e7 * (3e-6f64).sqrt() - 4e7 * (4e-6f64).sqrt());
    approx::assert_relative_eq!(again("documented"), reloading, max_relative = 1e-10);
    approx::assert_relative_eq!(again("upstream"), virgin, max_relative = 1e-10);
}

/// (6) No deadband around δ = 0.
#[test]
fn point_6_there_is_no_deadband() {
    let small = |convention: &'static str| {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        pair.place(Vector3::x() * (1.02e-3 - 9e-16));
        pair.response.force.x
    };
    assert_eq!(small("upstream"), 0.0);
    // δ is what is left of 1.02 mm, rounded to 2e-19 m.
    approx::assert_relative_eq!(small("documented"), 4e7 * area() * (9e-16f64).sqrt(), max_relative = 1e-3);
}

/// (7) Twist is linear and the same in both senses.
#[test]
fn point_7_twist_has_no_handedness() {
    for convention in CONVENTIONS {
        let torque = |way: f64| {
            let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
            let spin = Vector3::x() * (600.0 * way);
            (0..80).for_each(|_| pair.step(Vector3::zeros(), spin, -spin));
            (0..30).for_each(|_| pair.step(Vector3::zeros(), -spin, spin));
            pair.response.torque_i.x
        };
        assert_eq!(torque(1.0), -torque(-1.0), "{convention}");
        assert!(torque(1.0) < 0.0);
    }
}

/// (8) After a rigid quarter turn a bent bond is still bent; the header's has become twisted, as it keeps angles per
/// axis of the box.
#[test]
fn point_8_bending_turns_with_the_bond() {
    let turned = |convention: &'static str| {
        // Turning in finite steps shears a little, see below; that is left out here.
        let mut pair = Driven::pair(&bond(convention).with("shearStress", "off"), Vector3::x() * 1.02e-3);
        let spin = Vector3::z() * 600.0;
        (0..50).for_each(|_| pair.step(Vector3::zeros(), spin, -spin));
        let before = pair.response.torque_i;
        let steps = 2000;
        let omega = Vector3::y() * (0.5 * PI / (steps as f64 * pair.dt));
        (0..steps).for_each(|_| pair.turn_rigidly(&omega));
        let n = pair.close.delta.normalize();
        (before.norm(), pair.response.torque_i.dot(&n).abs(), pair.response.torque_i)
    };
    let (size, along, torque) = turned("documented");
    assert!(along < 1e-12 * size, "twist {along:e} of {size:e}");
    let carried = Rotation3::from_axis_angle(&Vector3::y_axis(), 0.5 * PI) * (Vector3::z() * -size);
    // About an axis normal to the bond the carrying is exact; 2000 steps round.
    assert!((torque - carried).norm() < 1e-12 * size, "{torque} instead of {carried}");
    let (size, along, _) = turned("upstream");
    approx::assert_relative_eq!(along, size, max_relative = 1e-3);
}

/// (8) Carried with the bond through 1.25 turns at 1e-3 rad per step, a preload of 6 µm is off by 1.1e-4 in the documented
/// convention: chords are shorter than arcs, which shears the bond by r Δ²/12 per radian.
#[test]
fn point_8_shear_is_carried_to_second_order() {
    let off = |steps_per_turn: usize| {
        let mut pair = Driven::pair(&bond("documented"), Vector3::x() * 1.02e-3);
        (0..300).for_each(|_| pair.step(Vector3::y() * 0.2, Vector3::zeros(), Vector3::zeros()));
        let (before, normal) = (shear(&pair), pair.close.delta.normalize());
        // About an axis that is not normal to the bond, so that its spin counts too.
        let axis = nalgebra::Unit::new_normalize(Vector3::new(1.0, 2.0, 2.0));
        let (steps, angle) = (steps_per_turn * 5 / 4, 2.0 * PI / steps_per_turn as f64);
        (0..steps).for_each(|_| pair.turn_rigidly(&(axis.into_inner() * (angle / pair.dt))));
        let q = Rotation3::from_axis_angle(&axis, angle * steps as f64);
        assert!((q * normal - pair.close.delta.normalize()).norm() < 1e-9);
        (q * before - shear(&pair)).norm() / before.norm()
    };
    let (coarse, fine) = (off(1571), off(6284));
    assert!((0.9e-4..1.3e-4).contains(&fine), "{fine:e} at 1e-3 rad per step");
    let order = (coarse / fine).log(4.0);
    assert!((1.8..2.2).contains(&order), "order {order}");
}

/// (9) Damping along the velocity, not by the signs of its components: a turned frame changes the header's answer.
#[test]
fn point_9_damping_knows_no_axes() {
    let answer = |convention: &'static str, angle: f64| {
        let q = Rotation3::new(Vector3::new(1.0, 0.3, -0.2) * angle);
        let deck = Deck::documented().with("bondConvention", convention);
        let deck = [
            "dampingNormalForceBondnonlinear",
            "dampingTangentialForceBondnonlinear",
            "dampingNormalTorqueBondnonlinear",
            "dampingTangentialTorqueBondnonlinear",
        ]
        .into_iter()
        .fold(deck, |d, name| d.set(name, 0.3));
        let mut pair = Driven::pair(&deck, q * Vector3::x() * 1.02e-3);
        let (v, w) =
            (Vector3::new(1.0, 1.5, 0.0), [Vector3::new(100.0, 50.0, 0.0), Vector3::new(-60.0, 0.0, 80.0)]);
        for k in 1..=40 {
            let place = Vector3::x() * 1.02e-3 + v * (k as f64 * pair.dt);
            pair.go(q * place, q * v, q * w[0], q * w[1]);
        }
        // Loaded one way, moved another.
        let (place, v) = (Vector3::x() * 1.02e-3 + v * (40.0 * pair.dt), Vector3::new(0.9, -0.7, 0.8));
        pair.go(q * (place + v * pair.dt), q * v, q * Vector3::new(-80.0, 50.0, 90.0), Vector3::zeros());
        (q.inverse() * pair.response.force, pair.response.force.norm())
    };
    for (convention, changes) in [("documented", false), ("upstream", true)] {
        let straight = answer(convention, 0.0);
        let change = |angle: f64| (straight.0 - answer(convention, angle).0).norm() / straight.1;
        let most = [0.5, 1.0, 2.0, 3.0].map(change).into_iter().fold(0.0, f64::max);
        assert!(if changes { most > 0.05 } else { most < 1e-12 }, "{convention}: {most:e}");
    }
    // Smoothed, the header's damped normal force leaves the normal.
    let off_normal = |convention: &'static str| {
        let deck =
            Deck::documented().set("dampingNormalForceBondnonlinear", 0.3).with("dampingBondSmooth", "on");
        let along = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let deck = deck.with("bondConvention", convention).with("shearStress", "off");
        let mut pair = Driven::pair(&deck, along * 1.02e-3);
        (0..20).for_each(|_| pair.step(along * 0.02, Vector3::zeros(), Vector3::zeros()));
        shear(&pair).norm() / pair.response.force.norm()
    };
    assert!(off_normal("documented") < 1e-14, "{:e}", off_normal("documented"));
    assert!(off_normal("upstream") > 0.01, "{:e}", off_normal("upstream"));
}

/// (10) i and j change places in mid-run, as after a migration between ranks: the header's extremes keep the old sign.
#[test]
fn point_10_partners_may_change_places() {
    let torque = |convention: &'static str, swaps: bool| {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        let spin = Vector3::x() * 600.0;
        (0..80).for_each(|_| pair.step(Vector3::zeros(), spin, -spin));
        (0..20).for_each(|_| pair.step(Vector3::zeros(), -spin, spin));
        let spin = if swaps { -spin } else { spin };
        if swaps {
            pair.swap();
        }
        pair.step(Vector3::zeros(), -spin, spin);
        pair.response.torque_i.x * if swaps { -1.0 } else { 1.0 }
    };
    assert_eq!(torque("documented", false), torque("documented", true));
    let (there, back) = (torque("upstream", false), torque("upstream", true));
    assert!((there / back - 1.0).abs() > 0.3, "{there:e} and {back:e}");
}

/// (11) A query between two steps changes nothing; in the header it does.
#[test]
fn point_11_queries_leave_no_trace() {
    let force = |convention: &'static str, asked: bool| {
        let mut pair = Driven::pair(&bond(convention), Vector3::x() * 1.02e-3);
        pair.place(Vector3::x() * (1.02e-3 - 2e-6));
        if asked {
            // As a set-up evaluation would after the particles were displaced by a command.
            pair.query(Vector3::x() * (1.02e-3 - 4e-6));
        }
        pair.place(Vector3::x() * (1.02e-3 - 3e-6));
        pair.response.force.x
    };
    assert_eq!(force("documented", false), force("documented", true));
    assert!(force("upstream", true) < 0.95 * force("upstream", false));
}

/// (12) A bond that begins where one broke is virgin; the header's inherits the extremes.
#[test]
fn point_12_a_new_bond_is_virgin() {
    let again = |convention: &'static str| {
        let deck = bond(convention).with("createBondAlways", "on").set("maxDistanceBondnonlinear", 1.13e-3);
        let mut pair = Driven::pair(&deck, Vector3::x() * 1.02e-3);
        let spin = Vector3::x() * 600.0;
        (0..80).for_each(|_| pair.step(Vector3::zeros(), spin, -spin));
        pair.place(Vector3::x() * 1.2e-3);
        assert_eq!(
            (pair.bond_event, pair.response.force),
            (BondEvent::Ends, Vector3::zeros()),
            "{convention}"
        );
        pair.place(Vector3::x() * 1.02e-3);
        assert_eq!(pair.bond_event, BondEvent::Begins, "{convention}");
        (0..20).for_each(|_| pair.step(Vector3::zeros(), spin, -spin));
        pair.response.torque_i.x
    };
    // From the second of its steps on, as nothing is added in the step in which a bond begins.
    let polar = 0.5 * area() * (0.8f64 * 5e-4).powi(2);
    approx::assert_relative_eq!(
        again("documented"),
        -4e9 * polar * 20.0 * 1200.0 * 1e-7,
        max_relative = 1e-12
    );
    assert!((again("upstream") / again("documented") - 1.0).abs() > 0.05);
}

/// (13) At a wall the whole spin shears the bond; the header takes half of it for the velocity and all of it for the arm.
#[test]
fn point_13_a_wall_feels_the_whole_spin() {
    let rolled = |convention: &'static str| {
        let mut ball = Driven::wall(&bond(convention), Vector3::z() * 5.1e-4);
        (0..20).for_each(|_| ball.step(Vector3::zeros(), Vector3::y() * 100.0, Vector3::zeros()));
        ball.response.force.x
    };
    // v_tr = −ω × r n.
    let expected = 4e9 * area() * 5.1e-4 * 100.0 * 1e-7 * 20.0;
    approx::assert_relative_eq!(rolled("documented"), expected, max_relative = 1e-12);
    // The header adds a share in the step in which the bond begins, when nothing moved yet here.
    approx::assert_relative_eq!(rolled("upstream"), 0.5 * expected, max_relative = 1e-12);
}

/// (14) At exactly the strength a bond breaks; the header's holds.
#[test]
fn point_14_the_strength_itself_breaks() {
    let ends = |convention: &'static str, part: f64| {
        let delta = 1.02e-3 - 1.025e-3;
        let (radius, k2) = (0.8f64 * 5e-4, 1e10);
        let area = PI * radius * radius;
        let load: f64 = match convention {
            "documented" => k2 * delta * area,
            _ => 2e10 * area * delta + (k2 - 2e10) * area * delta,
        };
        let strength = load.abs() / area;
        let deck = bond(convention).with("stressBreak", "on").set("maxSigmaBondnonlinear", strength * part);
        let mut pair = Driven::pair(&deck.set("maxTauBondnonlinear", 1e9), Vector3::x() * 1.02e-3);
        pair.place(Vector3::x() * 1.025e-3);
        pair.bond_event == BondEvent::Ends
    };
    assert_eq!(CONVENTIONS.map(|c| ends(c, 1.0)), [true, false]);
    assert_eq!(CONVENTIONS.map(|c| ends(c, 1.0 + 1e-9)), [false, false]);
    assert_eq!(CONVENTIONS.map(|c| ends(c, 1.0 - 1e-9)), [true, true]);
}
