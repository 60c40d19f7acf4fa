//! `granlaw bench`: what it measures and compares, and how it ends.
use crate::built::source;
use crate::common::{live, report, Scratch};
use std::fs;
use std::os::unix::fs::PermissionsExt;

/// The decks of `benchmarks/`, each small and short.
fn decks(s: &Scratch) {
    for entry in fs::read_dir(source().join("benchmarks")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !path.is_file() {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let small = |line: &str| match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["variable", name @ ("cells" | "steps"), "index", _] => {
                format!("variable {name} index {}\n", if name == "cells" { 4 } else { 60 })
            }
            _ => format!("{line}\n"),
        };
        s.file(&name, &text.lines().map(small).collect::<String>());
    }
}

#[test]
fn the_decks_give_the_same_dumps_on_every_side() {
    if !live("the_decks_give_the_same_dumps_on_every_side") {
        return;
    }
    let s = Scratch::new();
    decks(&s);
    let said = s.granlaw(&["bench", ".", "--pairs", "1", "--out", "out"]);
    let said = said.ends(0, &["0 did not, 0 could not run", "fcc16: 256 spheres, 60 steps"]);
    let report = report(&s.path("out"));
    let mut scenes = 0;
    for row in report["sections"][0]["items"][2]["table"]["rows"].as_array().unwrap() {
        let (scene, dump) = (row[0].as_str().unwrap(), row[13].as_str().unwrap());
        match row[2].as_str().unwrap() {
            "stock" => scenes += 1,
            "batched" if scene.starts_with("fcc_bond") => {
                assert_eq!(dump, "a law of the chain takes one contact at a time");
                continue;
            }
            _ if scene.starts_with("fcc_") => assert!(dump.starts_with("not compared"), "{row}"),
            _ => assert_eq!(dump, "identical", "{row}"),
        }
        assert!(row[3].as_f64().unwrap() > 0.0, "a Pair time: {row}\n{said}");
    }
    assert!(scenes >= 8, "{scenes} scenes");
    for scene in report["sections"][1]["items"][0]["table"]["rows"].as_array().unwrap() {
        if scene[0].as_str().unwrap().starts_with("fcc_bond") {
            continue;
        }
        // In so few steps the gas does not collide yet.
        assert!(scene[5].as_u64().unwrap() > 0 || scene[0] == "gas", "contacts: {scene}");
        // The limit that the batched path is to keep.
        assert!((1..=300).contains(&scene[8].as_u64().unwrap()), "bytes per neighbour: {scene}");
    }
    assert!(s.read("out/figures/pair.svg").contains("fcc16, batched: "));
    assert!(s.read("out/csv/pair.csv").lines().count() > 16);
}

#[test]
fn every_width_gives_the_same_dumps_on_two_ranks() {
    if !live("every_width_gives_the_same_dumps_on_two_ranks") {
        return;
    }
    let s = Scratch::new();
    decks(&s);
    let args = ["bench", "poly.in", "--pairs", "1", "--np", "1,2", "--lanes", "1,4,8", "--out", "out"];
    let said =
        s.granlaw(&args).ends(0, &["poly: 256 spheres", "poly, 2 ranks: 256 spheres", "batched, 8 wide"]);
    assert_eq!(said.out.matches(" identical").count(), 10, "{said}");
}

#[test]
fn a_dump_that_differs_in_the_last_bit_ends_with_1() {
    if !live("a_dump_that_differs_in_the_last_bit_ends_with_1") {
        return;
    }
    let s = Scratch::new();
    decks(&s);
    let fault =
        "if \"${rust} == 1\" then \"variable diameter index 0.010000000000000002\"\ninclude bed.inc\n";
    s.file("fault.in", fault);
    s.granlaw(&["bench", "fault.in", "--pairs", "2"])
        .ends(1, &["DIFFERS: dump.txt, step 60, particle 1, ", " where stock has ", "2 did not"]);
    s.file("fault.in", &format!("# bench: dumps differ\n{fault}"));
    s.granlaw(&["bench", "fault.in", "--pairs", "1"])
        .ends(0, &["not compared: the deck sets one law against"]);
}

#[test]
fn what_cannot_run_is_told_with_the_reason() {
    if !live("what_cannot_run_is_told_with_the_reason") {
        return;
    }
    let s = Scratch::new();
    decks(&s);
    s.file("typo.in", "variable models index \"hooke/hysteresiss\"\ninclude bed.inc\n");
    s.granlaw(&["bench", "typo.in"]).ends(
        2,
        &["stock", "COULD NOT RUN", "Invalid model specified", "stock did not run", "1 could not run"],
    );
    s.file("silent.in", "units si\natom_style granular\n");
    s.granlaw(&["bench", "silent.in"]).ends(2, &["LIGGGHTS printed no times"]);
    let mixed = "variable models index \"hooke/hysteresis tangential history rolling_friction epsd2\"\ninclude bed.inc\n";
    s.file("mixed.in", mixed);
    s.granlaw(&["bench", "mixed.in", "--pairs", "1"])
        .ends(0, &["a law of the chain is LIGGGHTS's own", "1 sides wrote", "1 were not compared"]);
    s.granlaw(&["bench", "none.in"]).ends(2, &["none.in"]);
    s.granlaw(&["bench", "tiny.in", "--lammps", "no/lmp"]).ends(2, &["no/lmp"]);
}

#[test]
fn lammps_is_measured_beside_the_others_where_a_scene_is_there() {
    if !live("lammps_is_measured_beside_the_others_where_a_scene_is_there") {
        return;
    }
    let s = Scratch::new();
    decks(&s);
    // Its place is taken by a script, as LAMMPS need not be here.
    let fake = |text: &str| {
        let path = s.file("lmp", &format!("#!/bin/sh\ntest -f $2 && echo '{text}'\n"));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    };
    fake("Loop time of 8.5 on 1 procs for 60 steps with 256 atoms\nPair    | 8 | 8.25 | 9 | 0.0 | 97");
    let args = ["bench", "fcc16.in", "tiny.in", "--pairs", "1", "--lammps", "lmp"];
    let said = s.granlaw(&args).ends(0, &["batched / LAMMPS: Pair 0.", "not compared: a law of its own"]);
    assert_eq!(said.out.matches("LAMMPS   ").count(), 1, "tiny.in has no scene for LAMMPS\n{said}");
    fake("ERROR: Unknown pair style");
    s.granlaw(&args).ends(2, &["COULD NOT RUN", "printed no times"]);
}
