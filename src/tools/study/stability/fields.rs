//! The fields: for each law, the parameters with which its stability changes.
use super::bonds;
use super::plan::{values, Build, Field, Plan};
use super::row::{Row, Scene};
use crate::study::collision::{Collision, Rest};
use crate::study::matter::Matter;
use crate::study::modes::stiffness;
use crate::study::Options;
use granlaw::model::Kind;
use std::f64::consts::PI;

const SHOT: Collision = Collision::head_on(0.005, 2500.0, 1.0);
const GRAVITY: f64 = 9.81;

fn matter(normal: &'static str, tangential: Option<&'static str>, e: f64) -> Matter {
    let laws = [(Kind::Normal, normal)].into_iter().chain(tangential.map(|t| (Kind::Tangential, t)));
    let values = vec![
        ("youngsModulus", 5e6),
        ("poissonsRatio", 0.45),
        ("characteristicVelocity", 2.0),
        ("coefficientRestitution", e),
        ("coefficientFriction", 0.5),
        ("coefficientMaxElasticStiffness", 5.0),
        ("coefficientAdhesionStiffness", 0.5),
        ("coefficientPlasticityDepth", 0.05),
    ];
    Matter { laws: laws.collect(), values, settings: Vec::new() }
}

/// The collision at a few speeds about its own.
fn about(collision: Collision) -> Vec<Collision> {
    [0.9, 1.0, 1.1]
        .map(|s| Collision { speed: s * collision.speed, slide: s * collision.slide, ..collision })
        .to_vec()
}

/// A sphere at rest on the wall that is given a small velocity.
fn at_rest(matter: &Matter, speed: f64, slide: f64) -> Collision {
    let collision = Collision { wall: true, speed: 0.0, ..SHOT };
    let sunk = collision.meff() * GRAVITY / stiffness(matter, &collision);
    // It is so slow that it never leaves the wall.
    let slow = 0.1 * (GRAVITY * sunk).sqrt();
    let rest = Some(Rest { gravity: GRAVITY, sunk, time: 0.0, rolls: false });
    Collision { speed: speed * slow, slide: slide * slow, rest, ..collision }
}

/// A sphere that rolls to rest.
fn rolling(matter: &Matter, mu_r: f64) -> Collision {
    let collision = at_rest(matter, 0.0, 0.0);
    let slide = 0.05;
    let time = 1.3 * 7.0 * slide / (5.0 * mu_r * GRAVITY);
    Collision { slide, rest: collision.rest.map(|r| Rest { time, rolls: true, ..r }), ..collision }
}

fn impact(param: f64, matter: Matter, collision: Collision) -> Row {
    Row::new(param, matter, about(collision), Scene::Impact)
}

/// The fields that are asked for.
pub fn fields(options: &Options) -> Vec<Field> {
    plans(options.full).filter(|p| options.wants(p.name)).map(Plan::build).collect()
}

/// The names of all fields.
pub fn names() -> Vec<&'static str> {
    plans(false).map(|p| p.name).collect()
}

/// The field of a name.
pub fn field(name: &str) -> Option<Field> {
    plans(false).find(|p| p.name == name).map(Plan::build)
}

fn plans(full: bool) -> impl Iterator<Item = Plan> {
    let n = if full { 40 } else { 24 };
    hysteresis(n)
        .into_iter()
        .chain(dashpots(n))
        .chain(friction(n))
        .chain(rolling_laws(n))
        .chain(bonds::plans(n))
}

fn hysteresis(n: usize) -> Vec<Plan> {
    let law = "hooke/hysteresis";
    let base = || matter(law, None, 0.9);
    let range = (0.02, 2.0);
    let fast = Collision { speed: 4.0, ..SHOT };
    vec![
        Plan {
            name: "k2max",
            title: "hooke/hysteresis: stiffest unloading, impact at 4 m/s beyond the plastic limit, kc = 0.5 kn, e = 0.9",
            law,
            label: "k2max/kn [1]",
            log: true,
            range,
            values: values(1.5, 1000.0, n, true),
            build: Box::new(move |v| impact(v, base().with("coefficientMaxElasticStiffness", v), fast)),
        },
        Plan {
            name: "kc",
            title: "hooke/hysteresis: adhesion, impact at 4 m/s, k2max = 5 kn, no dashpot",
            law,
            label: "kc/kn [1]",
            log: true,
            range,
            values: values(0.01, 10.0, n, true),
            build: Box::new(move |v| {
                impact(v, matter(law, None, 1.0).with("coefficientAdhesionStiffness", v), fast)
            }),
        },
        Plan {
            name: "phiF",
            title: "hooke/hysteresis: plasticity depth, impact at 1 m/s, k2max = 5 kn, kc = 0.5 kn, e = 0.9",
            law,
            label: "φF [1]",
            log: true,
            range,
            values: values(0.001, 0.5, n, true),
            build: Box::new(move |v| impact(v, base().with("coefficientPlasticityDepth", v), SHOT)),
        },
    ]
}

fn dashpots(n: usize) -> Vec<Plan> {
    let restitutions = || values(0.1, 1.0, n, false);
    let label = "coefficient of restitution e [1]";
    let range = (0.02, 2.0);
    let plan = |name, title, law, build: Build| Plan {
        name,
        title,
        law,
        label,
        log: false,
        range,
        values: restitutions(),
        build,
    };
    vec![
        plan(
            "hooke",
            "hooke: head-on impact",
            "hooke",
            Box::new(|v| impact(v, matter("hooke", None, v), SHOT)),
        ),
        plan(
            "hooke-timed",
            "hooke with centredDamping and touchFraction: head-on impact",
            "hooke",
            Box::new(|v| impact(v, matter("hooke", None, v).timed(), SHOT)),
        ),
        plan(
            "hertz",
            "hertz: head-on impact",
            "hertz",
            Box::new(|v| impact(v, matter("hertz", None, v), SHOT)),
        ),
        plan(
            "rest-normal",
            "hooke: a sphere at rest on a wall, pushed along the normal",
            "hooke",
            Box::new(|v| {
                let m = matter("hooke", None, v);
                let collision = at_rest(&m, 1.0, 0.0);
                Row::new(v, m, vec![collision], Scene::RestNormal)
            }),
        ),
        Plan {
            name: "viscous",
            title: "hooke, viscous on (μf = 1 mPa s, e_max = 0.9, St_c = 10): head-on impact, ever slower",
            law: "hooke",
            label: "speed of impact [m/s]",
            log: true,
            range,
            values: values(1e-4, 1.0, n, true),
            build: Box::new(|v| {
                let m = matter("hooke", None, 0.9)
                    .with("FluidViscosity", 1e-3)
                    .with("MaximumRestitution", 0.9)
                    .with("CriticalStokes", 10.0)
                    .set("viscous", "on")
                    .set("viscousAbs", "on");
                impact(v, m, Collision { speed: v, ..SHOT })
            }),
        },
    ]
}

fn friction(n: usize) -> Vec<Plan> {
    let rough = |e, mu| matter("hooke", Some("history"), e).with("coefficientFriction", mu);
    vec![
        Plan {
            name: "size-ratio",
            title: "hooke + history: oblique impact that sticks and slips, spheres of unlike sizes, e = 0.9, μ = 0.4",
            law: "history",
            label: "radius of j over radius of i [1]",
            log: true,
            range: (0.02, 2.0),
            values: values(1.0, 100.0, n, true),
            build: Box::new(move |v| {
                let collision = Collision { ratio: v, slide: 0.8, ..SHOT };
                Row::new(v, rough(0.9, 0.4), about(collision), Scene::Oblique)
            }),
        },
        Plan {
            name: "rest-tangential",
            title: "hooke + history: a sphere at rest on a wall, pushed along the wall",
            law: "history",
            label: "coefficient of restitution e [1]",
            log: false,
            range: (0.05, 2.0),
            values: values(0.1, 1.0, n, false),
            build: Box::new(move |v| {
                let m = rough(v, 100.0);
                let collision = at_rest(&m, 0.0, 1.0);
                Row::new(v, m, vec![collision], Scene::RestTangential)
            }),
        },
        Plan {
            name: "kt",
            title: "hertz + history: tangential stiffness; a sphere at rest on a wall, pushed along the wall, e = 0.9",
            law: "history",
            label: "kt/kn, by Poisson's ratio [1]",
            log: false,
            range: (0.05, 2.0),
            values: values(0.68, 0.99, n / 2, false),
            build: Box::new(move |v| {
                let nu = 2.0 * (1.0 - v) / (2.0 - v);
                let m = matter("hertz", Some("history"), 0.9).with("coefficientFriction", 100.0);
                let m = m.with("poissonsRatio", nu);
                let collision = at_rest(&m, 0.0, 1.0);
                // F = 4/3 E* √R δ^1.5.
                let press = 4.0 / 3.0 * 5e6 / (2.0 * (1.0 - nu * nu)) * collision.radius.sqrt();
                let sunk = (collision.meff() * GRAVITY / press).powf(2.0 / 3.0);
                let rest = collision.rest.map(|r| Rest { sunk, ..r });
                let slide = 0.1 * (GRAVITY * sunk).sqrt();
                Row::new(v, m, vec![Collision { rest, slide, ..collision }], Scene::RestTangential)
            }),
        },
    ]
}

fn rolling_laws(n: usize) -> Vec<Plan> {
    let base = |law: &'static str| {
        let mut m = matter("hooke", Some("history"), 0.5);
        m.laws.push((Kind::Rolling, law));
        m
    };
    let adhesive = move |eta: f64, limit: &'static str| {
        let m = base("cdt_jkr").with("workOfAdhesion", 0.05).with("adhesionHysteresis", eta);
        m.set("cdtJkrConvention", "documented").set("restTorqueLimit", limit)
    };
    // μr by the law's own equations, as it decides how long the sphere rolls.
    let mu_r = |eta: f64| {
        let e_star = 5e6 / (2.0 * (1.0 - 0.45 * 0.45));
        let a0 = (9.0 * PI * 0.05 * SHOT.radius.powi(2) / (2.0 * e_star)).cbrt();
        PI * a0 / (4.0 * SHOT.radius) * eta
    };
    let jkr = move |name, title, limit| Plan {
        name,
        title,
        law: "cdt_jkr",
        label: "adhesionHysteresis η [1]",
        log: true,
        range: (0.02, 1.0),
        values: values(0.2, 20.0, n.min(12), true),
        build: Box::new(move |eta| {
            let m = adhesive(eta, limit);
            let collision = rolling(&m, mu_r(eta));
            Row::new(eta, m, vec![collision], Scene::Roll)
        }),
    };
    vec![
        Plan {
            name: "cdt",
            title: "hooke + history + cdt: a sphere rolls to rest; what is left of its speed afterwards",
            law: "cdt",
            label: "coefficient of rolling friction [1]",
            log: true,
            range: (0.02, 1.0),
            values: values(0.005, 0.5, n.min(12), true),
            build: Box::new(move |v| {
                let m = base("cdt").with("coefficientRollingFriction", v);
                let collision = rolling(&m, v);
                Row::new(v, m, vec![collision], Scene::Roll)
            }),
        },
        jkr("cdt-jkr", "hooke + history + cdt_jkr: a sphere rolls to rest; what is left of its speed", "off"),
        jkr("cdt-jkr-limit", "the same with restTorqueLimit on", "on"),
    ]
}
