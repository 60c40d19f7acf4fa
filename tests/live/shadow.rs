//! Shadows of runs inside LIGGGHTS.
use crate::built::{alone, must};
use crate::common::{deck, live, plugin, program, text, Said, Scratch};
use granlaw_tools::trace::Reader;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The number of calls that one of the last lines tells, by what stands before and behind it.
fn calls(said: &Said, begins: &str) -> u64 {
    let line =
        said.out.lines().rev().find(|l| l.trim().starts_with(begins)).unwrap_or_else(|| panic!("{said}"));
    let number = line.split(|c: char| !c.is_ascii_digit()).find(|w| !w.is_empty());
    number.unwrap().parse().unwrap()
}

/// LIGGGHTS on so many ranks, with whatever is preloaded.
fn on(s: &Scratch, ranks: usize) -> Command {
    if ranks == 1 {
        return alone(Path::new("liggghts"), &s.path(""));
    }
    let mut command = s.command(Path::new("mpirun"));
    command.args(["--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]);
    command.args(["-np", &ranks.to_string(), "liggghts"]);
    command
}

/// The dump of a deck by LIGGGHTS alone.
fn plain(s: &Scratch, name: &str, ranks: usize) -> String {
    must(on(s, ranks).args(["-in", name]));
    s.read("dump.txt")
}

#[test]
fn a_shadow_sees_every_call_and_leaves_the_run_as_it_was() {
    if !live("a_shadow_sees_every_call_and_leaves_the_run_as_it_was") {
        return;
    }
    type Case = (&'static str, usize, &'static [(&'static str, &'static str)]);
    let cases: [Case; 5] = [
        ("oblique_slip_wall.in", 1, &[]),
        ("mesh_wall.in", 1, &[]),
        ("two_types.in", 1, &[]),
        ("several_runs.in", 1, &[]),
        ("gas_two_ranks.in", 2, &[("run             4000", "run             700")]),
    ];
    for (name, ranks, changes) in cases {
        let s = Scratch::new();
        fs::copy(crate::built::source().join("liggghts_inputs/plane.stl"), s.path("plane.stl")).unwrap();
        s.file("deck.in", &deck(name, changes));
        let stock = plain(&s, "deck.in", ranks);
        let args =
            ["run", "--shadow", "--record", "t.csv", "--np", &ranks.to_string(), "--", "-in", "deck.in"];
        let said = s.granlaw(&args).ends(0, &["all equal to the last bit", "worst difference 0, allowed 0"]);
        assert!(stock.len() > 1000 && stock == s.read("dump.txt"), "{name}: the dumps differ");
        // Traces hold a pair that two ranks see once, the shadow compares it on both.
        let traces = fs::read_dir(s.path("")).unwrap().map(|e| e.unwrap().path());
        let traces = traces.filter(|p| p.extension().is_some_and(|e| e == "csv"));
        let rows: u64 =
            traces.map(|p| Reader::open(&p).unwrap().map(|r| r.map(|_| 1).unwrap()).sum::<u64>()).sum();
        let seen = calls(&said, "agreed: ");
        let share = seen as f64 / rows as f64;
        let expected = if ranks == 1 { 1.0..=1.0 } else { 1.0..=1.5 };
        assert!(rows > 100 && expected.contains(&share), "{name}: {seen} calls, {rows} rows");
    }
}

/// Pairs go through the batched pass, as they do in a run on the Rust laws; `--path contact` and walls take the other way.
#[test]
fn either_path_and_every_width_is_held_against_liggghts() {
    if !live("either_path_and_every_width_is_held_against_liggghts") {
        return;
    }
    let s = Scratch::new();
    for name in ["unequal_oblique.in", "frozen_partner.in"] {
        s.file("deck.in", &deck(name, &[]));
        let run = |path: &str, lanes: &str| {
            let args = ["run", "--shadow", "--path", path, "--", "-in", "deck.in"];
            let said = Said::of(s.command(program()).args(args).env("GRANLAW_LANES", lanes));
            said.ends(0, &["all equal to the last bit", "worst difference 0"])
        };
        let single = run("contact", "").says(&["calls compared, one contact at a time: "]);
        let n = calls(&single, "agreed: ");
        assert!(n > 100, "{single}");
        for (lanes, way) in
            [("1", "one contact at a time"), ("4", "4 contacts at a time, "), ("8", "8 contacts at a time, ")]
        {
            let said = run("batched", lanes).says(&[&format!("{n} calls compared, batched, {way}")]);
            assert_eq!(calls(&said, "agreed: "), n);
        }
    }
    let args = ["run", "--shadow", "--", "-in", "deck.in"];
    Said::of(s.command(program()).args(args).env("GRANLAW_LANES", "3"))
        .ends(1, &["GRANLAW_LANES=3 must be 1, 4, 8 or widest"]);
}

/// A library that spoils LIGGGHTS's answer on its way to the shadow, as a wrong Rust law would differ from it.
fn fault(s: &Scratch, what: &str) -> String {
    let source = FAULT.replace("WHAT", what);
    let (source, out) = (s.file("fault.c", &source), s.path("fault.so"));
    must(Command::new("cc").args(["-shared", "-fPIC", "-o"]).arg(&out).arg(&source).arg("-ldl"));
    out.display().to_string()
}

const FAULT: &str = r#"
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
typedef struct { double force[3], torque[3]; } forces;
typedef struct {
  const void *pass, *contact;
  bool touch;
  double mi, mj;
  const double *before, *after;
  const forces *i, *j;
} call;
int32_t granlaw_shadow_call(void *s, size_t chain, const call *c) {
  int32_t (*real)(void *, size_t, const call *) = dlsym(RTLD_NEXT, "granlaw_shadow_call");
  call other = *c;
  forces i = *c->i;
  double after[4];
  memcpy(after, c->after, sizeof after);
  other.i = &i;
  other.after = after;
  WHAT;
  return real(s, chain, &other);
}
"#;

#[test]
fn a_wrong_law_ends_with_status_3_and_is_told() {
    if !live("a_wrong_law_ends_with_status_3_and_is_told") {
        return;
    }
    let s = Scratch::new();
    s.file("wall.in", &deck("oblique_slip_wall.in", &[]));
    s.file("two.in", &deck("two_ranks.in", &[]));
    let shadow = |fault: &str, tolerance: &str, name: &str| {
        let preload = format!("{fault}:{}", plugin().unwrap().path.display());
        let mut command = on(&s, if name == "two.in" { 2 } else { 1 });
        command.args(["-in", name]).env("LD_PRELOAD", preload);
        command.env("GRANLAW_SHADOW", "on").env("GRANLAW_TOLERANCE", tolerance);
        Said::of(&mut command)
    };
    let stock = plain(&s, "wall.in", 1);
    for (what, told) in [
        ("i.force[2] *= 1.001", "force: "),
        ("i.torque[1] *= 1.001", "torque: "),
        ("after[1] *= 1.001", "history: 9.99e-4 of its scale"),
    ] {
        let fault = fault(&s, what);
        let words = ["DIFFERS: ", told, "inputs at step "];
        let said = shadow(&fault, "0", "wall.in").ends(3, &words).says(&["particle 1 and the wall"]);
        assert_eq!(said.out.matches(" differ\n").count(), 1, "the wall's, not the pair's: {said}");
        assert!(stock == s.read("dump.txt"), "the run is LIGGGHTS's own");
        shadow(&fault, "0.01", "wall.in").ends(0, &["agreed: ", told, "allowed 1e-2"]);
        let said = shadow(&fault, "0", "two.in").ends(3, &words).says(&["2 ranks"]);
        assert_eq!(said.out.matches("granlaw shadow").count(), 1, "told once for all ranks: {said}");
    }
    // LIGGGHTS's own failure keeps its status, and what was seen by then is told.
    s.file("fails.in", &(deck("oblique_slip_wall.in", &[]) + "bogus\n"));
    shadow(&fault(&s, "i.force[2] *= 1.001"), "0", "fails.in")
        .ends(1, &["Unknown command: bogus", "DIFFERS: "]);
}

/// With k2max = kn and no plasticity depth LIGGGHTS's law divides 0 by 0; ours is a linear spring (DESIGN, "Departures").
#[test]
fn a_law_of_liggghts_that_gives_no_number_is_found() {
    if !live("a_law_of_liggghts_that_gives_no_number_is_found") {
        return;
    }
    let s = Scratch::new();
    let ratio = "coefficientMaxElasticStiffness peratomtypepair 1";
    s.file("deck.in", &deck("plasticity_depth_zero.in", &[(&format!("{ratio} 5"), &format!("{ratio} 1"))]));
    let said = s.granlaw(&["run", "--shadow", "--tolerance", "1", "--", "-in", "deck.in"]);
    said.ends(3, &["inf of its scale", "where LIGGGHTS has NaN", "worst difference inf, allowed 1e0"]);
}

#[test]
fn what_cannot_be_compared_is_said_and_is_no_success() {
    if !live("what_cannot_be_compared_is_said_and_is_no_success") {
        return;
    }
    let s = Scratch::new();
    let shadow = |name: &str| s.granlaw(&["run", "--shadow", "--", "-in", name]);
    for (from, why) in [
        ("stock_rolling_epsd2.in", "calls NOT COMPARED: granlaw has no rolling epsd2"),
        ("cdt_jkr_twist.in", "calls NOT COMPARED: LIGGGHTS has no rolling cdt_jkr"),
    ] {
        s.file(from, &deck(from, &[]));
        shadow(from).ends(2, &[why, "NOTHING COMPARED; "]);
    }
    // A wall with a twin and a pair without: one is compared, the other is named.
    let pair = (
        "pair_style      gran model hooke/hysteresis tangential history",
        "pair_style      gran model hooke/hysteresis/rs tangential history",
    );
    s.file("half.in", &deck("settling_box.in", &[pair, ("run             8000", "run             400")]));
    let said = shadow("half.in").ends(
        0,
        &[
            "calls NOT COMPARED: the deck itself runs granlaw's normal hooke/hysteresis/rs",
            " calls not compared",
        ],
    );
    assert!(calls(&said, "agreed: ") > 1000, "{said}");
    // Without contact, and without any law.
    s.file("apart.in", &deck("head_on_beyond_limit.in", &[("vx 2 vy", "vx -2 vy")]));
    shadow("apart.in").ends(2, &["no contact", "NOTHING COMPARED: "]);
    s.file("no_laws.in", "units si\n");
    shadow("no_laws.in").ends(2, &["nothing was compared, as no pair_style gran"]);
}

#[test]
fn options_that_make_no_sense_are_refused() {
    if !live("options_that_make_no_sense_are_refused") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", "units si\n");
    let run = |args: &[&str]| s.granlaw(&[&["run"], args, &["--", "-in", "deck.in"]].concat());
    run(&["--shadow", "--laws", "rust"]).ends(2, &["--shadow runs LIGGGHTS's own laws"]);
    run(&["--tolerance", "1"]).ends(2, &["--shadow"]);
    run(&["--shadow", "--tolerance=-1"]).ends(2, &["must be a number, 0 or above"]);
    for (name, value, words) in [
        ("GRANLAW_SHADOW", "yes", "GRANLAW_SHADOW=yes must be on or off"),
        ("GRANLAW_TOLERANCE", "none", "GRANLAW_TOLERANCE=none must be a number, 0 or above"),
        ("GRANLAW_LAWS", "rust", "leave GRANLAW_LAWS=rust out"),
    ] {
        let mut command = s.command(Path::new("liggghts"));
        command
            .args(["-in", "deck.in"])
            .env("LD_PRELOAD", plugin().unwrap().path)
            .env("GRANLAW_SHADOW", "on");
        Said::of(command.env(name, value)).ends(2, &[words]);
    }
    let parts = ["run", "--shadow", "--np", "2", "--", "-partition", "2x1", "-in", "wall.in"];
    s.file("wall.in", &deck("oblique_slip_wall.in", &[]));
    let said = s.granlaw(&parts).ends(1, &[]);
    // LIGGGHTS may end an error with bytes from freed memory.
    let screens = ["screen.0", "screen.1"].map(|name| text(&fs::read(s.path(name)).unwrap_or_default()));
    assert!(screens.concat().contains("granlaw cannot shadow a run in partitions"), "{screens:?}\n{said}");
}
