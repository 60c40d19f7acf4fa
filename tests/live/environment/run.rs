//! `granlaw run` is the user's own run: what he tells the plugin counts, and options win.
use super::disturbing;
use crate::common::{deck, live, program, Said, Scratch};
use granlaw_tools::probe::Probe;
use rayon::prelude::*;

fn granlaw(s: &Scratch, options: &[&str], variables: &[(&str, &str)]) -> Said {
    let args = [&["run"], options, &["--", "-in", "deck.in", "-log", "none"]].concat();
    Said::of(s.command(program()).args(args).envs(variables.iter().copied()))
}

fn written(name: &str) -> Scratch {
    let s = Scratch::new();
    s.file("deck.in", &deck(name, &[]));
    s
}

/// All that the plugin refuses it refuses here too, in its own words.
#[test]
fn every_variable_of_the_user_reaches_the_plugin() {
    if !live("every_variable_of_the_user_reaches_the_plugin") {
        return;
    }
    let s = written("head_on_at_limit.in");
    disturbing().into_par_iter().for_each(|(name, value)| {
        let said = match name {
            "GRANLAW_LAWS" => granlaw(&s, &[], &[(name, value)]),
            // Batched is possible here, and the name of a deck is no mistake.
            "GRANLAW_PATH" => granlaw(&s, &["--laws", "rust"], &[(name, "quick")]),
            "GRANLAW_DECK" => return,
            _ => granlaw(&s, &["--laws", "rust"], &[(name, value)]),
        };
        assert!(said.code != Some(0), "{name}: {said}");
        // Of files that cannot be written the words are LIGGGHTS's own, which MPI may keep to itself.
        if !value.starts_with("no/") {
            said.says(&[name]);
        }
    });
}

#[test]
fn a_probe_is_steered_by_what_the_user_says() {
    if !live("a_probe_is_steered_by_what_the_user_says") {
        return;
    }
    let s = written("settling_box.in");
    let probe = |variables: &[(&str, &str)]| {
        granlaw(&s, &["--probe", "scene.json"], variables).ends(0, &[]);
        Probe::read(&s.path("scene.json")).unwrap()
    };
    let (some, all) =
        (probe(&[("GRANLAW_STEPS", "300")]), &[("GRANLAW_STEPS", "300"), ("GRANLAW_FOLLOW", "all")]);
    let all = probe(all);
    let sums = |p: &Probe| p.chains.iter().fold((0, 0), |n, c| (n.0 + c.calls, n.1 + c.followed));
    let ((calls, followed), (every, each)) = (sums(&some), sums(&all));
    assert!(calls == every && calls > 0, "{calls} and {every} calls in 300 steps");
    assert!(followed < calls && each == every, "{followed} of {calls}, {each} of {every}");
}

#[test]
fn options_win_over_the_environment() {
    if !live("options_win_over_the_environment") {
        return;
    }
    let s = written("two_ranks.in");
    // In a run on two ranks mpirun stands between.
    for (options, variables, code, words) in [
        (&["--np", "2"][..], &[("GRANLAW_LAWS", "rusty")][..], 2, "GRANLAW_LAWS=rusty must be"),
        (&["--np", "2", "--laws", "rust"], &[("GRANLAW_LAWS", "rusty")], 0, "batched path"),
        (&["--np", "2"], &[("GRANLAW_LAWS", "rust")], 0, "batched path"),
        (
            &["--np", "2", "--path", "batched"],
            &[("GRANLAW_LAWS", "rust"), ("GRANLAW_PATH", "quick")],
            0,
            "batched path",
        ),
    ] {
        granlaw(&s, options, variables).ends(code, &[words]);
    }
    let recorded = ["--np", "2", "--record", "mine.csv", "--every", "5"];
    granlaw(&s, &recorded, &[("GRANLAW_RECORD", "no/where.csv"), ("GRANLAW_EVERY", "0")]).ends(0, &[]);
    assert!(s.path("mine.rank0.csv").exists());
}
