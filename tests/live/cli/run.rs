//! `granlaw run`: LIGGGHTS with the plugin in it, and recording.
use crate::common::{deck, live, Scratch};
use granlaw_tools::trace::{Reader, Row};
use std::path::Path;

const HEAD_ON: &str = "head_on_below_limit.in";

fn rows(trace: &Path) -> Vec<Row> {
    Reader::open(trace).and_then(Iterator::collect).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn the_rust_laws_take_over_and_give_the_same_dump() {
    if !live("the_rust_laws_take_over_and_give_the_same_dump") {
        return;
    }
    let s = Scratch::new();
    // Nothing but a law that has taken over refuses this property in these words.
    let ratio = "coefficientMaxElasticStiffness peratomtypepair 1";
    s.file("spoilt.in", &deck(HEAD_ON, &[(&format!("{ratio} 5"), &format!("{ratio} 0.5"))]));
    s.granlaw(&["run", "--laws", "rust", "--", "-in", "spoilt.in"])
        .ends(1, &["hooke/hysteresis: coefficientMaxElasticStiffness = 0.5 (types 1-1) must be at least 1"]);
    s.granlaw(&["run", "--laws", "stock", "--", "-in", "spoilt.in"]).ends(0, &[]);

    s.file("deck.in", &deck(HEAD_ON, &[]));
    let mut dumps = Vec::new();
    for laws in ["stock", "rust"] {
        s.granlaw(&["run", "--laws", laws, "--", "-in", "deck.in"])
            .ends(0, &["granlaw: plugin ", "libgranlaw_liggghts.so", "Loop time"]);
        dumps.push(s.read("dump.txt"));
    }
    // Under their own names the same laws give the same numbers.
    let own = [("model hooke/hysteresis tangential", "model hooke/hysteresis/rs tangential")];
    s.file("own.in", &deck(HEAD_ON, &own));
    s.granlaw(&["run", "--", "-in", "own.in"]).ends(0, &[]);
    dumps.push(s.read("dump.txt"));
    assert!(dumps[0].len() > 10_000 && dumps[0] == dumps[1] && dumps[0] == dumps[2]);
}

#[test]
fn the_exit_status_and_the_arguments_are_those_of_liggghts() {
    if !live("the_exit_status_and_the_arguments_are_those_of_liggghts") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", "units ${u}\nshell touch reached\nbogus\n");
    let run = |args: &[&str]| s.granlaw(&[&["run", "--", "-in", "deck.in"], args].concat());
    run(&["-var", "u", "si", "-log", "other.log"]).ends(1, &["ERROR: Unknown command: bogus"]);
    assert!(s.path("reached").exists() && s.path("other.log").exists());
    run(&["-var", "u", "miles"]).ends(1, &["ERROR: Illegal units command"]);
    s.granlaw(&["run", "--", "-in", "nowhere.in"]).ends(2, &["cannot read the deck nowhere.in"]);
    s.file("fine.in", "units si\n");
    s.granlaw(&["run", "--", "-in", "fine.in"]).ends(0, &[]);
}

#[test]
fn calls_are_recorded_all_or_every_nth_step() {
    if !live("calls_are_recorded_all_or_every_nth_step") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck(HEAD_ON, &[]));
    let record = |name: &str, more: &[&str]| {
        let args =
            [&["run", "--laws", "stock", "--record", name][..], more, &["--", "-in", "deck.in"]].concat();
        s.granlaw(&args).ends(0, &[]);
        assert!(!s.path(&format!("{name}.part")).exists());
        rows(&s.path(name))
    };
    let (all, some) = (record("all.csv", &[]), record("some.csv", &["--every", "7"]));
    let kept: Vec<_> = all.iter().filter(|r| r.close.call.step % 7 == 0).cloned().collect();
    assert!(
        all.len() > 1000 && kept == some,
        "{} rows, {} of them kept, {}",
        all.len(),
        kept.len(),
        some.len()
    );
    let header = Reader::open(&s.path("all.csv")).unwrap().header().clone();
    assert_eq!((header.deck.as_str(), header.every, header.ranks), ("deck.in", 1, 1));
    s.granlaw(&["replay", "all.csv", "some.csv"]).ends(0, &["equal to the last bit: force"]);
    // A folder that is not there is told before LIGGGHTS starts.
    s.granlaw(&["run", "--record", "no/all.csv", "--", "-in", "deck.in"])
        .ends(2, &["no folder no; make it first"]);
}

#[test]
fn a_wall_and_each_rank_have_traces_of_their_own() {
    if !live("a_wall_and_each_rank_have_traces_of_their_own") {
        return;
    }
    let s = Scratch::new();
    s.file("wall.in", &deck("primitive_wall.in", &[]));
    s.granlaw(&["run", "--laws", "rust", "--record", "wall.csv", "--", "-in", "wall.in"]).ends(0, &[]);
    assert!(rows(&s.path("wall.wall-floor.csv")).iter().all(|r| r.close.call.is_wall));
    s.file("two.in", &deck("two_ranks.in", &[]));
    s.granlaw(&["run", "--laws", "stock", "--record", "two.csv", "--np", "2", "--", "-in", "two.in"])
        .ends(0, &[]);
    let ranks = ["two.rank0.csv", "two.rank1.csv"].map(|name| rows(&s.path(name)));
    assert!(ranks.iter().all(|r| r.len() > 100), "the pair crosses from one rank to the other");
    s.granlaw(&["replay", "two.rank0.csv", "two.rank1.csv"]).ends(0, &[]);
    let alone = s.granlaw(&["run", "--laws", "stock", "--record", "one.csv", "--", "-in", "two.in"]);
    // `processors 2 1 1` does not fit one rank: LIGGGHTS's own refusal, and no trace.
    alone.ends(1, &["ERROR"]);
    assert!(!s.path("one.csv").exists());
}
