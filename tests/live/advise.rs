//! `granlaw advise` on a deck: the advised deck runs, its bulk observables are compared, fresh contacts are tried, and
//! what is wrong is seen.
use crate::common::{deck, live, Scratch};
use std::fs;

/// A gas of 216 spheres that cools: the smallest scene with thousands of impacts.
fn gas() -> String {
    let property = |k: usize, text: &str| format!("fix p{k} all property/global {text}\n");
    let properties: String = [
        "youngsModulus peratomtype 5e6",
        "poissonsRatio peratomtype 0.3",
        "coefficientRestitution peratomtypepair 1 0.9",
        "coefficientFriction peratomtypepair 1 0.0",
    ]
    .iter()
    .enumerate()
    .map(|(k, p)| property(k, p))
    .collect();
    format!(
        "variable seed index 15485867\nunits si\natom_style granular\natom_modify map array sort 0 0\nboundary p p p\n\
         newton off\ncommunicate single vel yes\nregion box block 0 0.06 0 0.06 0 0.06 units box\ncreate_box 1 box\n\
         neighbor 0.002 bin\nneigh_modify delay 0\n{properties}pair_style gran model hertz tangential history\n\
         pair_coeff * *\nlattice sc 0.01\ncreate_atoms 1 box\nset group all diameter 0.007 density 2500\n\
         variable vx atom random(-1,1,${{seed}})\nvariable vy atom random(-1,1,${{seed}})\n\
         variable vz atom random(-1,1,${{seed}})\nvelocity all set v_vx v_vy v_vz\ntimestep 5e-6\n\
         fix move all nve/sphere\nthermo 10000\nrun 20000\n"
    )
}

#[test]
fn an_advised_deck_is_checked_and_a_wrong_one_is_found_out() {
    if !live("an_advised_deck_is_checked_and_a_wrong_one_is_found_out") {
        return;
    }
    let s = Scratch::new();
    s.file("gas.in", &gas());
    // So few spheres scatter: what is held to the bound here is the machinery.
    let bound = ["--check", "--bound", "0.3"];
    let all = [&["advise", "gas.in", "--out", "report", "--write-deck", "advised.in"], &bound[..]].concat();
    s.granlaw(&all).ends(0, &["timestep ", "kinetic energy", "predicted"]);
    let advised = s.read("advised.in");
    assert!(advised.contains("round(20000*") && !advised.contains("timestep 5e-6"), "{advised}");
    let report = s.read("report/index.html");
    for told in [
        "The ladder of models",
        "How often: normal speed at first touch",
        "coordination number",
        "The advised deck",
    ] {
        assert!(report.contains(told), "the report lacks {told}");
    }
    assert!(fs::read_dir(s.path("report/figures")).unwrap().count() >= 4);

    // Stiffer spheres touch for less than half the time: fewer contacts at a time.
    s.file("stiff.in", &advised.replace("5e6", "5e7"));
    s.granlaw(&[&["advise", "gas.in", "--advised", "stiff.in"], &bound[..]].concat())
        .ends(1, &["x coordination number"]);
    // A deck that runs another time cannot be compared.
    s.file("short.in", &advised.replace("round(20000*", "round(10000*"));
    s.granlaw(&[&["advise", "gas.in", "--advised", "short.in"], &bound[..]].concat())
        .ends(2, &["it ran for"]);
    let fresh =
        s.granlaw(&["advise", "gas.in", "--held-out"]).says(&["Fresh contacts of a run with seed=32452867"]);
    // Few contacts of few spheres: whether the last class is within the accuracy, chance decides. What is not is told.
    assert_eq!(
        fresh.code,
        Some(i32::from(fresh.out.contains("\nx contact time") || fresh.out.contains("\nx restitution")))
    );
    // A variable that the deck does not read gives no fresh contacts.
    s.granlaw(&["advise", "gas.in", "--held-out", "--fresh", "sead=1"])
        .ends(2, &["sead=1 had the very contacts"]);
}

/// Half of a scene that is shipped: what is advised there holds in the whole scene and on fresh contacts, and what is not does not.
#[test]
fn a_shipped_scene_bears_its_advice_and_no_wrong_coefficient() {
    if !live("a_shipped_scene_bears_its_advice_and_no_wrong_coefficient") {
        return;
    }
    let s = Scratch::new();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/elastic_gas.in");
    let deck = fs::read_to_string(scene).unwrap().replace("run             40000", "run 20000");
    assert!(deck.contains("run 20000"));
    s.file("gas.in", &deck);
    let check = ["advise", "gas.in", "--check", "--seeds", "2"];
    s.granlaw(&[&check[..], &["--held-out", "--write-deck", "advised.in"]].concat())
        .ends(0, &["no tangential law: predicted", "means of 2 runs each", "0 of 0 of lasting contacts"]);
    let advised = s.read("advised.in");
    assert!(advised.contains("pair_style gran model hertz\n") && !advised.contains("5e-6"), "{advised}");

    // A gas that is not quite elastic cools.
    let wrong = advised.replace("peratomtypepair 1 1.0", "peratomtypepair 1 0.95");
    assert_ne!(wrong, advised);
    s.file("wrong.in", &wrong);
    s.granlaw(&[&check[..], &["--advised", "wrong.in"]].concat()).ends(1, &["x kinetic energy"]);
}

#[test]
fn laws_without_a_twin_are_named_as_the_reason() {
    if !live("laws_without_a_twin_are_named_as_the_reason") {
        return;
    }
    let s = Scratch::new();
    let own = ["kn", "kt", "gamman", "gammat"]
        .map(|name| format!("fix {name} all property/global {name} peratomtypepair 1 10\n"))
        .concat();
    let stiff = gas().replace(
        "pair_style gran model hertz tangential history",
        &format!("{own}pair_style gran model hooke/stiffness"),
    );
    s.file("stiff.in", &stiff.replace("run 20000", "run 10"));
    s.granlaw(&["advise", "stiff.in"]).ends(2, &["no contact could be counted", "granlaw laws"]);
    let probe = s.granlaw(&["run", "--probe", "stiff.json", "--", "-in", "stiff.in"]);
    probe.ends(2, &["no probe was written", "granlaw laws"]);
    assert!(!s.path("stiff.json").exists());
    // Only the wall: it is named, and there is no advice on a scene of which a part was not seen.
    let rich =
        "fix             floor all wall/gran model hooke/hysteresis tangential history rolling_friction cdt";
    let simple = format!("{own}fix floor all wall/gran model hooke/stiffness");
    s.file("floor.in", &deck("primitive_wall.in", &[(rich, &simple)]));
    s.granlaw(&["run", "--probe", "floor.json", "--", "-in", "floor.in"])
        .ends(0, &["fix floor are not in the probe"]);
    assert!(s.read("floor.json").contains("wall floor"));
    s.granlaw(&["advise", "floor.json"]).ends(2, &["contacts of wall floor were not seen"]);
}

#[test]
fn what_needs_a_deck_says_so() {
    let s = Scratch::new();
    s.file("probe.json", "{\"format\": \"granlaw probe 2\"}");
    s.granlaw(&["advise", "probe.json", "--check"]).ends(2, &["is a probe", "need the deck"]);
    s.granlaw(&["advise", "probe.json", "--fresh", "seed"]).ends(2, &["must be NAME=VALUE"]);
    s.granlaw(&["advise", "probe.json", "--advised", "a.in"]).ends(2, &["--check"]);
}
