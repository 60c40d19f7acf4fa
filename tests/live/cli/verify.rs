//! `granlaw verify`: its options. What it finds in decks is tested in `tests/decks.rs`.
use crate::common::{case, deck, live, report, Scratch};
use std::collections::BTreeSet;

/// A deck that is quick to run.
const QUICK: &str = "stiffness_ratio_1000.in";

#[test]
fn the_shards_of_a_folder_are_all_its_decks_and_share_none() {
    if !live("the_shards_of_a_folder_are_all_its_decks_and_share_none") {
        return;
    }
    let s = Scratch::new();
    let decks = BTreeSet::from(["a", "b", "c", "d", "e"].map(String::from));
    decks.iter().for_each(|name| drop(s.file(&format!("in/{name}.in"), &deck(QUICK, &[]))));
    let mut all = Vec::new();
    for k in 1..=3 {
        let (shard, out) = (format!("{k}/3"), format!("out{k}"));
        s.granlaw(&["verify", "in", "--shard", &shard, "--out", &out]).ends(0, &["0 skipped"]);
        let cases = report(&s.path(&out));
        all.extend(
            cases["cases"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap().to_string()),
        );
    }
    assert_eq!(all.len(), decks.len(), "{all:?}");
    assert_eq!(BTreeSet::from_iter(all), decks);
    s.granlaw(&["verify", "in/a.in", "--shard", "2/2"]).ends(2, &["--shard 2/2 leaves none of the 1 decks"]);
}

#[test]
fn cases_come_in_the_order_of_the_decks_however_many_run_at_once() {
    if !live("cases_come_in_the_order_of_the_decks_however_many_run_at_once") {
        return;
    }
    let s = Scratch::new();
    for (name, source) in [("a", "sticking.in"), ("b", QUICK), ("c", QUICK)] {
        s.file(&format!("in/{name}.in"), &deck(source, &[]));
    }
    for jobs in ["1", "3"] {
        let said = s.granlaw(&["verify", "in", "--jobs", jobs, "--out", "out"]).ends(0, &["3 cases"]);
        let report = report(&s.path("out"));
        let names: Vec<_> = report["cases"].as_array().unwrap().iter().map(|c| &c["name"]).collect();
        assert_eq!(names, ["a", "b", "c"], "{said}");
        // A bar is for terminals; here are none of its control codes.
        assert!(!said.err.contains('\u{1b}') && !said.out.contains('\u{1b}'), "{said}");
        let lines = said.out.lines().filter(|l| l.starts_with("agreed ")).count();
        assert_eq!(lines, 3, "a line per case: {said}");
    }
    s.granlaw(&["verify", "in", "--jobs", "many"]).ends(2, &["--jobs"]);
}

#[test]
fn the_command_and_the_programs_are_in_the_report() {
    if !live("the_command_and_the_programs_are_in_the_report") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck(QUICK, &[]));
    s.granlaw(&["verify", "deck.in", "--out", "sub/out"])
        .ends(0, &["granlaw: plugin ", "report: sub/out/index.html"]);
    let report = report(&s.path("sub/out"));
    let about = &report["about"];
    assert!(about["command"].as_str().unwrap().ends_with("granlaw verify deck.in --out sub/out"));
    assert!(about["liggghts"].as_str().unwrap().starts_with("LIGGGHTS-PUBLIC 3.8.0"));
    assert!(about["plugin"].as_str().unwrap().contains("libgranlaw_liggghts.so for LIGGGHTS 3.8.0"));
    let case = case(&report, "deck");
    assert_eq!(
        (&case["deck"], &case["title"]),
        (&"deck.in".into(), &"k2max/kn = 1000, beyond the plastic limit".into())
    );
}

#[test]
fn a_place_that_the_report_cannot_have_is_told_before_anything_runs() {
    let s = Scratch::new();
    s.file("deck.in", &deck(QUICK, &[]));
    s.file("thesis/chapter1.tex", "");
    for (out, says) in [
        ("thesis", "holds chapter1.tex, which no report of ours does"),
        ("deck.in", "is not a folder"),
        (".", "is the folder you are in"),
    ] {
        let said = s.granlaw(&["verify", "deck.in", "--out", out]).ends(2, &[out, says, "name a new folder"]);
        assert!(said.out.is_empty(), "{said}");
    }
    assert!(s.path("thesis/chapter1.tex").exists());
}
