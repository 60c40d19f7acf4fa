//! The fields of bonds: spheres of 1 mm in a row, or one on a wall, with a gap that the bonds act across.
use super::plan::{values, Plan};
use super::row::{Row, Scene};
use crate::study::bond::{Bond, MODES};
use crate::study::bonded_row::{BondedRow, Way};
use crate::study::collision::{beads, Collision, Rest};
use crate::study::matter::Matter;
use granlaw::model::Mode;
use granlaw::model::{ClosePair, NamedMode, Size};

const SHOT: Collision = Collision::head_on(5e-4, 2500.0, 0.1);
/// Gap between surfaces when bonds begin \[m\]; no swing of these fields closes it.
const GAP: f64 = 1e-4;
/// Number of steps for which bonds with damage are followed.
const LONG: u64 = 3072;
/// The same for bonds without damage, whose energy soon overflows beyond the critical step.
const SHORT: u64 = 256;
/// Stiffness of unloading and of the line through zero, over that of first loading, unless a field has its own.
const UNLOADING: f64 = 2.0;
const HEALING: f64 = 0.5;

/// A bond with these modes only, which is `ku` times as stiff in unloading as in loading, with a damping ratio of `eta`.
fn bond(ku: f64, eta: f64, modes: &[&'static str]) -> Matter {
    let k = [4e7, 1e10, 4e9, 4e9, 1e10];
    Bond { radius: SHOT.radius, gap: GAP, k, over: [ku, HEALING], eta, modes }.matter()
}

const BOTH: [&str; 2] = ["compressionStress", "tensionStress"];

fn row(beads: usize, way: Way) -> Collision {
    Collision { slide: 1e-4, bonded: Some(BondedRow { beads, gap: GAP, way }), ..SHOT }
}

/// Largest ω² of a row along itself, or in its only mode, over that of two bodies: `2 cos²(π/2N)` for a chain of equal linear springs with
/// free ends.
fn chained(beads: usize) -> f64 {
    2.0 * (std::f64::consts::PI / (2 * beads) as f64).cos().powi(2)
}

/// The modes of two spheres of a row that meet at `speed` \[m/s\].
fn modes(matter: &Matter, collision: &Collision, speed: f64) -> Vec<NamedMode> {
    let all = beads(collision, &collision.bonded.expect("a row"));
    let (i, j) = (&all[0], &all[1]);
    let meff = i.mass * j.mass / (i.mass + j.mass);
    let size = ClosePair { i: *i, j: *j, meff, ..ClosePair::default() }.size();
    matter.chain().expect("a sound bond").modes((0, 0), &size, speed)
}

/// A row of a field. Steps are in units of the mode called `by`; theory uses the fastest mode and the length of the chain.
fn bonded(param: f64, matter: Matter, collisions: Vec<Collision>, by: &str, steps: u64) -> Row {
    let speed = collisions.iter().map(|s| s.speed).fold(f64::INFINITY, f64::min);
    let bonded = collisions[0].bonded.expect("a row");
    let all = modes(&matter, &collisions[0], speed);
    let unit = all.iter().find(|s| s.name == by).expect("a mode");
    let mode = |m: &NamedMode, n: f64| Mode { stiffness: n * m.mode.stiffness, ..m.mode };
    let steps_of = |m: &NamedMode| m.mode.step();
    let fastest = all.iter().min_by(|a, b| steps_of(a).total_cmp(&steps_of(b))).expect("a mode");
    let modes = [mode(unit, 1.0), mode(fastest, chained(bonded.beads))];
    Row::bonded(param, matter, collisions, Scene::Bonded(steps), modes)
}

/// Shots at `n` speeds about `speed`, so that δ = 0 is passed at many moments within a step.
fn blows(n: usize, speed: f64, beads: usize, way: impl Fn(usize) -> Way) -> Vec<Collision> {
    let one = |k: usize| Collision { speed: speed * (0.5 + k as f64 / n as f64), ..row(beads, way(k)) };
    (0..n).map(one).collect()
}

/// A sphere that hangs on a wall by a bond without damage and comes to rest.
fn hanging(eta: f64, smooth: bool) -> Row {
    let straight =
        bond(1.0, eta, &["tensionStress"]).set("dampingBondSmooth", if smooth { "on" } else { "off" });
    // Bonds of a wall are as long as those of a pair of the same size.
    let collision = Collision { wall: true, speed: 0.0, ..row(2, Way::Along) };
    // LIGGGHTS finds no contacts further from a wall than the skin of its neighbour lists.
    let straight = straight.with("maxDistanceBondnonlinear", 2.0 * SHOT.radius + 1.5 * GAP);
    let collision =
        Collision { bonded: Some(BondedRow { gap: 0.5 * GAP, beads: 2, way: Way::Along }), ..collision };
    let (m, gravity) = (collision.meff(), 1e3);
    let frozen = [false; 2];
    let size =
        Size { radi: collision.radius, radj: 0.0, massi: m, massj: 0.0, frozen, meff: m, is_wall: true };
    let swing = straight.chain().expect("a sound bond").modes((0, 0), &size, 1.0)[0];
    let mode = swing.mode;
    let sunk = m * gravity * (1.0 + eta) / swing.mode.stiffness;
    // It is pulled away from the wall.
    let rest = Some(Rest { gravity: -gravity, sunk, time: 0.0, rolls: false });
    Row::bonded(eta, straight, vec![Collision { rest, ..collision }], Scene::Hang(200), [mode, mode])
}

const LAW: &str = "bond/nonlinear";

pub(super) fn plans(n: usize) -> Vec<Plan> {
    let half = n / 2;
    let plan = |name, title, label, log, values, build| Plan {
        name,
        title,
        law: LAW,
        label,
        log,
        range: (0.02, 2.0),
        values,
        build,
    };
    let zero = plan(
        "bond-zero",
        "bond: √δ at zero; pressed and stretched at ever lower speeds, ku = 2 k, undamped",
        "speed [m/s]",
        true,
        values(1e-5, 1.0, half, true),
        Box::new(|v| bonded(v, bond(UNLOADING, 0.0, &BOTH), blows(8, v, 2, |_| Way::Along), "tension", LONG)),
    );
    vec![
        Plan { range: (0.004, 2.0), ..zero },
        plan(
            "bond-ku",
            "bond: stiffness of unloading, pressed and stretched, undamped",
            "ku/k [1]",
            true,
            values(1.0, 20.0, half, true),
            Box::new(|ku| {
                bonded(ku, bond(ku, 0.0, &BOTH), blows(8, 0.3, 2, |_| Way::Along), "tension", LONG)
            }),
        ),
        plan(
            "bond-eta",
            "bond: damping by the sign of the velocity, pressed and stretched, ku = 2 k",
            "damping ratio η [1]",
            true,
            values(0.01, 0.9, half, true),
            Box::new(|eta| {
                bonded(eta, bond(UNLOADING, eta, &BOTH), blows(8, 0.3, 2, |_| Way::Along), "tension", LONG)
            }),
        ),
        plan(
            "bond-twist",
            "bond: twist alone, stiffness of unloading, undamped",
            "ku/k [1]",
            true,
            values(1.0, 20.0, n, true),
            Box::new(|ku| bonded(ku, bond(ku, 0.0, &MODES[3..4]), vec![row(2, Way::Twist)], "twist", LONG)),
        ),
        plan(
            "bond-size",
            "bond: shear and bending together, straight and undamped, spheres of unlike sizes",
            "radius of j over radius of i [1]",
            true,
            values(1.0, 10.0, half, true),
            Box::new(|ratio| {
                let m = bond(1.0, 0.0, &["shearStress", "shearTorqueStress"]);
                let far = SHOT.radius * (1.0 + ratio) + GAP;
                let m = m.with("createDistanceBondnonlinear", 1.0001 * far);
                let m = m.with("maxDistanceBondnonlinear", far + 3.0 * GAP);
                let collisions = [Way::Shear, Way::Bend].map(|way| Collision { ratio, ..row(2, way) });
                bonded(ratio, m, collisions.to_vec(), "shear", SHORT)
            }),
        ),
        plan(
            "bond-chain",
            "bond: a chain of straight bonds that twists at random, three seeds, undamped",
            "bonds in the chain [1]",
            true,
            [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0].to_vec(),
            Box::new(|n| {
                let collisions = (0..3).map(|seed| row(n as usize + 1, Way::TwistAtRandom(seed)));
                bonded(n, bond(1.0, 0.0, &MODES[3..4]), collisions.collect(), "twist", SHORT)
            }),
        ),
        plan(
            "bond-chain-damage",
            "bond: a chain that is shaken along at random, four seeds, ku = 2 k, undamped",
            "bonds in the chain [1]",
            true,
            [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0].to_vec(),
            Box::new(|n| {
                let collisions = blows(4, 0.3, n as usize + 1, |k| Way::AlongAtRandom(k as u64));
                bonded(n, bond(UNLOADING, 0.0, &BOTH), collisions, "tension", LONG / 2)
            }),
        ),
        plan(
            "bond-rest",
            "bond: a sphere that hangs on a wall comes to rest under damping by the sign of its velocity",
            "damping ratio η [1]",
            true,
            values(0.02, 0.8, half, true),
            Box::new(|eta| hanging(eta, false)),
        ),
        plan(
            "bond-rest-smooth",
            "the same with dampingBondSmooth on",
            "damping ratio η [1]",
            true,
            values(0.02, 0.8, half, true),
            Box::new(|eta| hanging(eta, true)),
        ),
    ]
}
