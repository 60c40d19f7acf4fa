//! Probes of scenes made for the purpose: impacts and loads of two bodies, each counted by a follower.
use granlaw::model::Body;
use granlaw::pair::{run_while, Opened, Partner, Start};
use granlaw_tools::probe::{Call, Follower, Impact, Partners, Pressed, Probe, FORMAT};
use granlaw_tools::trace::{Handed, Header, LawSpec, Property};
use nalgebra::Vector3;

pub const RADIUS: f64 = 0.005;
pub const MASS: f64 = 1.3e-3;

/// A law with properties, each the same for the one type there is.
pub fn law(kind: &str, keyword: &str, properties: &[(&str, f64)]) -> LawSpec {
    let shape = |name: &str| match name {
        "youngsModulus" | "poissonsRatio" => "peratomtype",
        "characteristicVelocity" => "scalar",
        _ => "peratomtypepair",
    };
    let property = |(name, value): &(&str, f64)| Property {
        name: (*name).into(),
        unit: "1".into(),
        shape: shape(name).into(),
        values: vec![*value],
    };
    LawSpec {
        kind: kind.into(),
        keyword: keyword.into(),
        taken_over: true,
        known: true,
        properties: properties.iter().map(property).collect(),
        ..LawSpec::default()
    }
}

pub fn hooke(e: f64) -> LawSpec {
    let p = [
        ("youngsModulus", 5e6),
        ("poissonsRatio", 0.45),
        ("characteristicVelocity", 1.0),
        ("coefficientRestitution", e),
    ];
    law("normal", "hooke", &p)
}

pub fn hertz(e: f64) -> LawSpec {
    law("normal", "hertz", &[("youngsModulus", 5e6), ("poissonsRatio", 0.45), ("coefficientRestitution", e)])
}

pub fn hysteresis(depth: f64) -> LawSpec {
    let p = [
        ("youngsModulus", 5e6),
        ("poissonsRatio", 0.45),
        ("characteristicVelocity", 1.0),
        ("coefficientRestitution", 0.9),
        ("coefficientMaxElasticStiffness", 5.0),
        ("coefficientAdhesionStiffness", 0.1),
        ("coefficientPlasticityDepth", depth),
    ];
    law("normal", "hooke/hysteresis", &p)
}

pub fn friction(mu: f64) -> LawSpec {
    law("tangential", "history", &[("coefficientFriction", mu)])
}

pub fn rolling(mu: f64) -> LawSpec {
    law("rolling", "cdt", &[("coefficientRollingFriction", mu)])
}

/// A chain of one atom type.
pub fn header(dt: f64, laws: Vec<LawSpec>) -> Header {
    let mut h = Header {
        deck: "made.in".into(),
        who: "pair".into(),
        ranks: 1,
        types: 1,
        nktv2p: 1.0,
        dt,
        ..Header::default()
    };
    for mut l in laws {
        l.offset = h.slots.len();
        let names: &[&str] = match l.keyword.as_str() {
            "hooke/hysteresis" => &["deltaMax"],
            "history" => &["shearx", "sheary", "shearz"],
            _ => &[],
        };
        h.slots.extend(names.iter().map(|s| s.to_string()));
        h.laws.push(l);
    }
    h
}

pub fn partners(wall: bool) -> Partners {
    Partners {
        types: [1, 1],
        wall,
        radius: [RADIUS, if wall { 0.0 } else { RADIUS }],
        mass: [MASS, if wall { 0.0 } else { MASS }],
        meff: if wall { MASS } else { 0.5 * MASS },
    }
}

/// An impact of two equal spheres, or on a wall.
pub fn impact(wall: bool, v: [f64; 3]) -> Impact {
    Impact {
        partners: partners(wall),
        v,
        omega_i: [0.0; 3],
        omega_j: [0.0; 3],
        slip: v[1].hypot(v[2]),
        end: granlaw_tools::probe::End { steps: 1000, overlap: 1e-4, ..Default::default() },
    }
}

pub fn pressed(normal: f64, tangential: f64, kn: f64) -> Pressed {
    Pressed { partners: partners(false), normal, tangential, push: normal, pull: 0.0, time: 1.0, kn }
}

/// What a follower makes of these impacts (normal speed, slip speed, spin of one of the two times its radius, all in m/s) under a chain.
pub fn scene(header: &Header, impacts: &[[f64; 3]]) -> Probe {
    let mut follower = Follower::new(header.clone(), 512);
    for (k, i) in impacts.iter().enumerate() {
        live(&mut follower, header, *i, 10 * k as i64);
    }
    finished(follower)
}

/// As [`scene`], with spheres that lie on their partner for a while.
pub fn bed(header: &Header, impacts: &[[f64; 3]], loads: &[[f64; 2]]) -> Probe {
    let mut follower = Follower::new(header.clone(), 512);
    for (k, i) in impacts.iter().enumerate() {
        live(&mut follower, header, *i, 10 * k as i64);
    }
    for (k, [normal, pull]) in loads.iter().enumerate() {
        let mut s = start(header, [0.0; 3]);
        s.bodies[0].x.x = 2.0 * RADIUS;
        (s.partner, s.steps) = (Partner::Frozen, 20_000);
        s.gravity = Vector3::new(-normal, *pull, 0.0) / MASS;
        hand_all(&mut follower, header, &s, 100_000 * (k as i64 + 1));
    }
    finished(follower)
}

/// A probe of a run that took 100 ns per contact and step.
fn finished(follower: Follower) -> Probe {
    let chains = vec![follower.finish()];
    let seconds = chains[0].calls as f64 * 1e-7;
    Probe { format: FORMAT.into(), ranks: 1, seconds, chains, ..Probe::default() }
}

fn start(header: &Header, [vn, slip, spin]: [f64; 3]) -> Start {
    let body = |x: f64, v: [f64; 3], spin: f64| Body {
        radius: RADIUS,
        mass: MASS,
        x: Vector3::x() * x,
        v: v.into(),
        omega: Vector3::z() * (spin / RADIUS),
        ..Body::default()
    };
    // Contacts begin anywhere within a step.
    let gap = 0.37 * vn * header.dt;
    Start {
        bodies: [
            body(2.0 * RADIUS + gap, [-0.5 * vn, 0.5 * slip, 0.0], spin),
            body(0.0, [0.5 * vn, -0.5 * slip, 0.0], 0.0),
        ],
        types: (0, 0),
        partner: Partner::Free,
        dt: header.dt,
        steps: 20_000,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Keeps,
    }
}

fn live(follower: &mut Follower, header: &Header, impact: [f64; 3], tag: i64) {
    hand_all(follower, header, &start(header, impact), tag);
}

fn hand_all(follower: &mut Follower, header: &Header, start: &Start, tag: i64) {
    let mut chain = header.chain().expect("the laws are ours");
    let mut before = vec![0.0; chain.row()];
    let mut met = false;
    run_while(&mut chain, start, |s| {
        if s.touching && s.step > 0 {
            met = true;
            let mut x = s.contact;
            (x.close.i.tag, x.close.j.tag) = (tag, tag + 1);
            x.close.call.step += 100_000 * tag;
            follower.sees((tag, tag + 1));
            let (force, torque_i, torque_j) = (s.response.force, s.response.torque_i, s.response.torque_j);
            let handed = Handed::from(&s.response);
            let (types, place, share) = ((0, 0), 0, 1.0);
            let before = &before;
            follower.touched(&Call {
                types,
                contact: &x,
                place,
                share,
                before,
                handed,
                force,
                torque_i,
                torque_j,
            });
        }
        before.clone_from(&s.history);
        s.touching || !met
    });
}
