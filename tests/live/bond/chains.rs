//! A bond in a chain with every other law that LIGGGHTS or granlaw has, on pairs, a primitive wall and a mesh wall at once.
use super::bench::{frames, run, scratch};
use crate::common::{live, Scratch};
use std::collections::BTreeMap;
use std::fs;

const NORMAL: [&str; 12] = [
    "hooke",
    "hooke/rs",
    "hertz",
    "hertz/rs",
    "hooke/hysteresis",
    "hooke/hysteresis/rs",
    "hooke/stiffness",
    "hertz/stiffness",
    "edinburgh",
    "edinburgh/stiffness",
    "luding",
    "thornton_ning",
];
const TANGENTIAL: [&str; 6] = ["off", "no_history", "no_history/rs", "history", "history/rs", "tan_luding"];
const ROLLING: [&str; 8] = ["off", "cdt", "cdt/rs", "cdt_jkr", "epsd", "epsd2", "epsd3", "luding"];

/// The laws of a chain: normal, tangential, rolling, cohesion.
type Laws = [&'static str; 4];

/// Six spheres between a plane and a mesh, pressed together, bonded, spinning, some of them torn off within 300 steps.
fn scene(laws: &Laws, dump: &str) -> String {
    let [normal, tangential, rolling, cohesion] = laws;
    let of = |kind: &str, law: &str| if law == "off" { String::new() } else { format!(" {kind} {law}") };
    let (tangential, rolls) = (of("tangential", tangential), of("rolling_friction", rolling));
    let models = format!("model {normal}{tangential} cohesion {cohesion}{rolls}");
    let jkr = if *rolling == "cdt_jkr" { " cdtJkrConvention documented" } else { "" };
    let settings = format!("bondConvention documented stressBreak on{jkr}");
    include_str!("scene.in").replace("MODELS", &models).replace("SETTINGS", &settings).replace("DUMP", dump)
}

/// Every combination; the bond answers to either of its names.
fn all() -> Vec<Laws> {
    let mut all = Vec::new();
    for normal in NORMAL {
        for tangential in TANGENTIAL {
            for rolling in ROLLING {
                let cohesion = ["bond/nonlinear", "bond/nonlinear/rs"][all.len() % 2];
                all.push([normal, tangential, rolling, cohesion]);
            }
        }
    }
    all
}

/// Run scenes in one LIGGGHTS, one after the other; their dumps.
fn dumps(scenes: &[String]) -> Vec<String> {
    let s: Scratch = scratch(&scenes.join("\nclear\n"));
    run(&s, 1, "").ends(0, &[]);
    (0..scenes.len()).map(|k| fs::read_to_string(s.path(&format!("dump{k}.txt"))).unwrap()).collect()
}

/// A law of ours and LIGGGHTS's of the same name give the same bytes wherever they stand in a chain with bonds.
#[test]
fn bonds_go_with_every_law() {
    if !live("bonds_go_with_every_law") {
        return;
    }
    let all = all();
    let scenes: Vec<_> = all.iter().enumerate().map(|(k, l)| scene(l, &format!("dump{k}.txt"))).collect();
    let mut groups: BTreeMap<[String; 3], (&Laws, String)> = BTreeMap::new();
    let mut compared = 0;
    for (laws, dump) in all.iter().zip(dumps(&scenes)) {
        sound(&dump).unwrap_or_else(|e| panic!("{laws:?}: {e}"));
        let group = [laws[0], laws[1], laws[2]].map(|l| l.replace("/rs", ""));
        let (other, first) = groups.entry(group).or_insert((laws, dump.clone()));
        assert!(*first == dump, "{laws:?} and {other:?} differ");
        compared += usize::from(*other != laws);
    }
    assert_eq!((all.len(), groups.len(), compared), (576, 252, 324));
    // The laws beside the bond have their say.
    let of = |n: &str, t: &str, r: &str| &groups[&[n, t, r].map(String::from)].1;
    for (n, t, r) in [("hooke", "off", "off"), ("hertz", "history", "off"), ("hertz", "history", "cdt_jkr")] {
        assert!(of(n, t, r) != of("hertz", "history", "cdt"), "{n} {t} {r}");
    }
}

/// Bonds of all three kinds of contact were there and some broke, and all numbers are numbers.
fn sound(dump: &str) -> Result<(), String> {
    let frames = frames(dump);
    let (first, last) = (&frames[&100][0], &frames[&300][0]);
    let [pairs, walls, ended] = [16, 17, 18].map(|column| last[column]);
    if first[16] + first[17] < 6.0 || pairs < 1.0 || walls < 1.0 || ended < 1.0 {
        return Err(format!("{pairs} and {walls} bonds, {ended} broken"));
    }
    let finite = frames.values().flatten().flatten().all(|x| x.is_finite());
    finite.then_some(()).ok_or("not finite".into())
}

#[test]
fn one_law_off_by_a_millionth_is_seen() {
    if !live("one_law_off_by_a_millionth_is_seen") {
        return;
    }
    let laws = ["hertz/rs", "history", "cdt/rs", "bond/nonlinear"];
    let changes = [
        ("youngsModulus peratomtype 1e7", "youngsModulus peratomtype 10000010"),
        ("coefficientFriction peratomtypepair 1 0.5", "coefficientFriction peratomtypepair 1 0.5000005"),
        ("RollingFriction peratomtypepair 1 0.1", "RollingFriction peratomtypepair 1 0.1000001"),
        ("AreaK_ft peratomtypepair 1 4e9", "AreaK_ft peratomtypepair 1 4.000004e9"),
    ];
    let mut scenes = vec![scene(&laws, "dump0.txt")];
    for (k, (from, to)) in changes.iter().enumerate() {
        let good = scene(&laws, &format!("dump{}.txt", k + 1));
        assert!(good.contains(from), "the scene has no {from:?}");
        scenes.push(good.replace(from, to));
    }
    let dumps = dumps(&scenes);
    for ((_, to), dump) in changes.iter().zip(&dumps[1..]) {
        assert!(*dump != dumps[0], "{to} was not seen");
    }
}
