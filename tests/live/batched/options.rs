//! `--path` and `GRANLAW_LANES`.
use super::{dump, stock};
use crate::built::alone;
use crate::common::{deck, live, plugin, program, Said, Scratch};
use std::path::Path;

const DECK: &str = "two_types.in";

#[test]
fn every_path_and_width_gives_the_dump_of_liggghts() {
    if !live("every_path_and_width_gives_the_dump_of_liggghts") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck(DECK, &[]));
    let reference = stock(&s);
    let run = |path: &str, lanes: &str| {
        let args = ["run", "--laws", "rust", "--path", path, "--", "-in", "deck.in"];
        Said::of(s.command(program()).args(args).env("GRANLAW_LANES", lanes)).ends(0, &[])
    };
    for (lanes, words) in [
        ("", "granlaw: batched path, "),
        ("1", "granlaw: batched path, one contact at a time"),
        ("4", "granlaw: batched path, 4 contacts at a time, "),
        ("8", "granlaw: batched path, 8 contacts at a time, "),
    ] {
        let said = run("batched", lanes).says(&[words]);
        assert_eq!(said.out.matches("granlaw: batched path, ").count(), 1, "said once: {said}");
        assert!(dump(&s) == reference, "GRANLAW_LANES={lanes}: not the dump of LIGGGHTS");
    }
    let said = run("contact", "");
    assert!(!said.out.contains("granlaw: ") && dump(&s) == reference, "{said}");
    // A stiffer sphere does not give it: the dumps do compare something.
    s.file(
        "deck.in",
        &deck(DECK, &[("youngsModulus peratomtype 5e6", "youngsModulus peratomtype 5.000001e6")]),
    );
    run("batched", "");
    assert!(dump(&s) != reference);
}

#[test]
fn values_that_are_none_are_refused_in_words() {
    if !live("values_that_are_none_are_refused_in_words") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck(DECK, &[]));
    s.granlaw(&["run", "--path", "quick", "--", "-in", "deck.in"]).ends(2, &["quick", "batched", "contact"]);
    for (name, value, code, words) in [
        ("GRANLAW_PATH", "quick", 2, "GRANLAW_PATH=quick must be batched or contact"),
        ("GRANLAW_LANES", "3", 1, "GRANLAW_LANES=3 must be 1, 4, 8 or widest"),
        ("GRANLAW_LANES", "many", 1, "GRANLAW_LANES=many must be 1, 4, 8 or widest"),
    ] {
        let mut command = alone(Path::new("liggghts"), &s.path(""));
        command.args(["-in", "deck.in"]).env("LD_PRELOAD", plugin().unwrap().path);
        Said::of(command.env("GRANLAW_LAWS", "rust").env(name, value)).ends(code, &[words]);
    }
    s.granlaw(&["run", "--laws", "rust", "--path", "batched", "--", "-in", "deck.in"]).ends(0, &[]);
}
