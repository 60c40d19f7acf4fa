//! The cases: impacts of spheres of 1 cm, E = 5 MPa, ν = 0.45, 2500 kg/m³, characteristic velocity 2 m/s.
use super::case::{Case, Measure};
use crate::study::collision::{Collision, Rest};
use crate::study::matter::Matter;
use crate::study::modes::stiffness;
use granlaw::model::Kind;

fn matter(normal: &'static str, e: f64) -> Matter {
    let values = vec![
        ("youngsModulus", 5e6),
        ("poissonsRatio", 0.45),
        ("characteristicVelocity", 2.0),
        ("coefficientRestitution", e),
        ("coefficientFriction", 0.0),
        ("coefficientMaxElasticStiffness", 5.0),
        ("coefficientAdhesionStiffness", 0.0),
        ("coefficientPlasticityDepth", 0.05),
    ];
    Matter { laws: vec![(Kind::Normal, normal), (Kind::Tangential, "history")], values, settings: Vec::new() }
}

fn head_on(name: &'static str, title: &'static str, matter: Matter, speed: f64) -> Case {
    let collision = Collision::head_on(0.005, 2500.0, speed);
    Case { name, title, matter, collision, measure: Measure::Restitution }
}

fn oblique(name: &'static str, title: &'static str, e: f64, mu: f64, slide: f64) -> Case {
    let case = head_on(name, title, matter("hooke", e).with("coefficientFriction", mu), 0.2);
    let collision = Collision { slide: slide * case.collision.speed, ..case.collision };
    Case { collision, measure: Measure::Spin, ..case }
}

/// A sphere that rolls to rest under cdt with μr = 0.1. It is followed for 1.5 times the time that it rolls by the closed form,
/// 7v/(5 μr g).
fn rolling() -> Case {
    let mut matter =
        matter("hooke", 0.5).with("coefficientFriction", 0.5).with("coefficientRollingFriction", 0.1);
    matter.laws.push((Kind::Rolling, "cdt"));
    let (gravity, v) = (9.81, 0.05);
    let collision = Collision { wall: true, slide: v, ..Collision::head_on(0.005, 2500.0, 0.0) };
    let sunk = collision.meff() * gravity / stiffness(&matter, &collision);
    let rest = Some(Rest { gravity, sunk, time: 1.5 * 7.0 * v / (5.0 * 0.1 * gravity), rolls: true });
    let title = "hooke + history + cdt, rolls to rest";
    Case {
        name: "rolling",
        title,
        matter,
        collision: Collision { rest, ..collision },
        measure: Measure::Distance,
    }
}

/// All cases.
pub fn cases() -> Vec<Case> {
    let mut all = impacts();
    all.extend(super::bonds::cases());
    all
}

fn impacts() -> Vec<Case> {
    let plastic = |kc: f64| matter("hooke/hysteresis", 1.0).with("coefficientAdhesionStiffness", kc);
    let on_wall = |case: Case, name, title| Case {
        name,
        title,
        collision: Collision { wall: true, ..case.collision },
        ..case
    };
    let undamped = |case: Case| Case { matter: case.matter.set("tangential_damping", "off"), ..case };
    let damped = |e| matter("hooke", e);
    vec![
        head_on("undamped", "hooke, head-on, e = 1", damped(1.0), 1.0),
        head_on("damped-0.9", "hooke, head-on, e = 0.9", damped(0.9), 1.0),
        head_on("damped-0.5", "hooke, head-on, e = 0.5", damped(0.5), 1.0),
        on_wall(head_on("", "", damped(0.5), 1.0), "damped-0.5-wall", "hooke, head-on on a wall, e = 0.5"),
        head_on("hertz-0.5", "hertz, head-on, e = 0.5", matter("hertz", 0.5), 1.0),
        head_on("plastic-below", "hooke/hysteresis, below the plastic limit", plastic(0.0), 1.0),
        head_on("plastic-beyond", "hooke/hysteresis, beyond the plastic limit", plastic(0.0), 4.0),
        head_on("adhesive", "hooke/hysteresis, adhesive, kc = 0.5 kn", plastic(0.5), 1.0),
        oblique("stick", "hooke + history, sticks, e = 0.9, μ = 5", 0.9, 5.0, 0.5),
        oblique("slip", "hooke + history, slips throughout, e = 0.9, μ = 0.2", 0.9, 0.2, 3.0),
        oblique("stick-slip", "hooke + history, sticks and slips, e = 0.9, μ = 0.4", 0.9, 0.4, 0.8),
        undamped(oblique(
            "stick-slip-td-off",
            "hooke + history, sticks and slips, e = 0.9, μ = 0.4, tangential_damping off",
            0.9,
            0.4,
            0.8,
        )),
        rolling(),
    ]
}
