//! Two bodies in our own integration, and their calls handed to a follower.
use granlaw::chain::Chain;
use granlaw::model::Body;
use granlaw::pair::{states, Opened, Partner, Start, State};
use granlaw_tools::probe::{Call, Contacts, Follower};
use granlaw_tools::trace::{Handed, Header, LawSpec, Property};
use nalgebra::Vector3;

pub const MU: f64 = 0.2;
pub const RADIUS: f64 = 0.005;
pub const MASS: f64 = 1.3e-3;

/// The whole chain of hysteresis, friction and rolling resistance.
pub fn header() -> Header {
    let property = |name: &str, shape: &str, value: f64| Property {
        name: name.into(),
        unit: "1".into(),
        shape: shape.into(),
        values: vec![value],
    };
    let law = |kind: &str, keyword: &str, offset, properties| LawSpec {
        kind: kind.into(),
        keyword: keyword.into(),
        taken_over: true,
        known: true,
        offset,
        properties,
        ..LawSpec::default()
    };
    let normal = vec![
        property("youngsModulus", "peratomtype", 5e6),
        property("poissonsRatio", "peratomtype", 0.45),
        property("characteristicVelocity", "scalar", 2.0),
        property("coefficientRestitution", "peratomtypepair", 0.8),
        property("coefficientMaxElasticStiffness", "peratomtypepair", 5.0),
        property("coefficientAdhesionStiffness", "peratomtypepair", 0.2),
        property("coefficientPlasticityDepth", "peratomtypepair", 0.05),
    ];
    let friction = vec![property("coefficientFriction", "peratomtypepair", MU)];
    let rolling = vec![property("coefficientRollingFriction", "peratomtypepair", 0.05)];
    Header {
        who: "pair".into(),
        ranks: 1,
        types: 1,
        nktv2p: 1.0,
        dt: 1e-6,
        slots: ["deltaMax", "shearx", "sheary", "shearz"].map(String::from).to_vec(),
        laws: vec![
            law("normal", "hooke/hysteresis", 0, normal),
            law("tangential", "history", 1, friction),
            law("rolling", "cdt", 4, rolling),
        ],
        ..Header::default()
    }
}

pub fn chain() -> Chain {
    header().chain().expect("the laws are ours")
}

/// Two spheres shortly before an oblique impact with spin.
pub fn start() -> Start {
    let body = |x: f64, v: [f64; 3], omega: [f64; 3]| Body {
        tag: if x < 0.0 { 1 } else { 2 },
        radius: RADIUS,
        mass: MASS,
        x: Vector3::new(x, 0.0, 0.0),
        v: v.into(),
        omega: omega.into(),
        ..Body::default()
    };
    Start {
        bodies: [
            body(-0.005003, [0.6, 0.3, 0.0], [5.0, 20.0, -40.0]),
            body(0.005003, [-0.4, 0.0, 0.1], [0.0, -30.0, 10.0]),
        ],
        types: (0, 0),
        partner: Partner::Free,
        dt: 1e-6,
        steps: 3000,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Keeps,
    }
}

/// A sphere above a plane in the same state.
pub fn on_a_plane() -> Start {
    let mut s = start();
    s.partner = Partner::Plane { point: Vector3::zeros(), normal: -Vector3::x() };
    s
}

/// All states of a start under the chain.
pub fn followed(start: &Start) -> Vec<State> {
    states(&mut chain(), start)
}

/// What a follower makes of the states; `change` may alter a call before it is seen.
pub fn probed(all: &[State], change: impl Fn(&mut Call<'_>)) -> Contacts {
    let mut follower = Follower::new(header(), 512);
    feed(&mut follower, all, [1, 2], 0, change);
    follower.finish()
}

/// Hands the touching states to a follower, as the contact of two particles that begins `later`.
pub fn feed(
    follower: &mut Follower,
    all: &[State],
    tags: [i64; 2],
    later: i64,
    change: impl Fn(&mut Call<'_>),
) {
    all.windows(2).for_each(|w| hand(follower, &w[0].history, &w[1], tags, later, &change));
}

/// Hands one state to a follower, if it is one of contact.
pub fn hand(
    follower: &mut Follower,
    before: &[f64],
    state: &State,
    tags: [i64; 2],
    later: i64,
    change: impl Fn(&mut Call<'_>),
) {
    if !state.touching {
        return;
    }
    let mut x = state.contact;
    (x.close.i.tag, x.close.j.tag) = (tags[0], if x.close.call.is_wall { -1 } else { tags[1] });
    x.close.call.step += later;
    if follower.sees((x.close.i.tag, x.close.j.tag)) {
        let s = &state.response;
        let (force, torque_i, torque_j) = (s.force, s.torque_i, s.torque_j);
        let handed = Handed::from(s);
        let (types, place, share) = ((0, 0), 0, 1.0);
        let mut call = Call { types, contact: &x, place, share, before, handed, force, torque_i, torque_j };
        change(&mut call);
        follower.touched(&call);
    }
}
