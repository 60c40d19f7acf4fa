//! Ctrl-C, kills and failures in mid-run: prompt ends, nothing left running, nothing half-written under a final name.
use crate::common::{deck, live, program, Said, Scratch};
use rustix::process::{kill_process, Pid, Signal};
use std::fs::File;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Two spheres that stick together for longer than anyone waits; `started` appears when the run begins.
fn endless(s: &Scratch) {
    let run = "run             16000";
    let started = format!("shell touch {}", s.path("started").display());
    // Without common motion they stay in their box.
    let still = [("vx 0.6 vy", "vx 0.3 vy"), ("vx 0 vy", "vx -0.3 vy")];
    let endless = [(run, &format!("{started}\nrun 2000000000")[..])];
    s.file("endless.in", &deck("sticking.in", &[&still[..], &endless].concat()));
}

pub fn wait_for(what: &str, mut there: impl FnMut() -> bool) {
    let limit = Instant::now() + Duration::from_secs(60);
    while !there() {
        assert!(Instant::now() < limit, "{what} did not happen");
        sleep(Duration::from_millis(20));
    }
}

/// granlaw on the endless deck, once it has begun.
pub fn begun(s: &Scratch, args: &[&str]) -> Child {
    endless(s);
    let mut command = s.command(program());
    // Into files: a pipe that nobody reads would stop LIGGGHTS when it is full.
    let [out, err] = ["out.txt", "err.txt"].map(|name| File::create(s.path(name)).unwrap());
    let child = command.args(args).stdin(Stdio::null()).stdout(out).stderr(err).spawn().unwrap();
    wait_for("the run", || s.path("started").exists());
    child
}

/// Until LIGGGHTS is in the midst of its steps: a signal that comes during its set-up is lost on it.
pub fn stepping(s: &Scratch) {
    wait_for("some steps", || s.path("dump.txt").metadata().is_ok_and(|m| m.len() > 100_000));
}

/// It ends within moments of the signal; what it said.
fn ends(s: &Scratch, mut child: Child, signal: Signal) -> (ExitStatus, Said) {
    kill_process(Pid::from_child(&child), signal).unwrap();
    let asked = Instant::now();
    while child.try_wait().unwrap().is_none() && asked.elapsed() < Duration::from_secs(30) {
        sleep(Duration::from_millis(20));
    }
    let prompt = child.try_wait().unwrap().is_some();
    if !prompt {
        child.kill().unwrap();
    }
    let status = child.wait().unwrap();
    assert!(prompt, "still running long after {signal:?}");
    (status, Said { code: status.code(), out: s.read("out.txt"), err: s.read("err.txt") })
}

fn nothing_left(s: &Scratch) {
    // What MPI starts beside a rank goes a moment after it.
    wait_for("the end of all that was started", || s.left().iter().all(|l| !l.contains("liggghts")));
}

#[test]
fn ctrl_c_reaches_liggghts_which_ends_its_run_in_order() {
    if !live("ctrl_c_reaches_liggghts_which_ends_its_run_in_order") {
        return;
    }
    let s = Scratch::new();
    let args = ["run", "--laws", "stock", "--record", "t.csv", "--", "-in", "endless.in"];
    let child = begun(&s, &args);
    stepping(&s);
    let (_, said) = ends(&s, child, Signal::INT);
    // LIGGGHTS has a handler of its own: it finishes the step, and its summary.
    said.ends(0, &["Loop time"]);
    nothing_left(&s);
    s.granlaw(&["replay", "t.csv"]).ends(0, &["agreed"]);
}

#[test]
fn ctrl_c_reaches_every_rank() {
    if !live("ctrl_c_reaches_every_rank") {
        return;
    }
    let s = Scratch::new();
    let args = ["run", "--laws", "rust", "--np", "2", "--", "-in", "endless.in"];
    let child = begun(&s, &args);
    stepping(&s);
    let (status, _) = ends(&s, child, Signal::INT);
    assert!(!status.success(), "{status}");
    nothing_left(&s);
}

#[test]
fn a_recording_that_is_killed_has_not_its_final_name() {
    if !live("a_recording_that_is_killed_has_not_its_final_name") {
        return;
    }
    let s = Scratch::new();
    let child = begun(&s, &["run", "--laws", "stock", "--record", "t.csv", "--", "-in", "endless.in"]);
    let part = s.path("t.csv.part");
    wait_for("a megabyte of trace", || part.metadata().is_ok_and(|m| m.len() > 1_000_000));
    let (status, _) = ends(&s, child, Signal::KILL);
    assert_eq!(status.signal(), Some(Signal::KILL.as_raw()));
    assert!(part.exists() && !s.path("t.csv").exists());
    s.granlaw(&["replay", "t.csv.part"]).ends(2, &["the trace was cut short", "record it again"]);
    nothing_left(&s);
}

#[test]
fn a_recording_whose_deck_fails_has_not_its_final_name() {
    if !live("a_recording_whose_deck_fails_has_not_its_final_name") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck("sticking.in", &[("run             16000", "run 1000\nbogus")]));
    s.granlaw(&["run", "--laws", "stock", "--record", "t.csv", "--", "-in", "deck.in"]).ends(1, &["bogus"]);
    assert!(s.path("t.csv.part").exists() && !s.path("t.csv").exists());
}

#[test]
fn an_interrupted_verify_leaves_the_earlier_report_as_it_was() {
    if !live("an_interrupted_verify_leaves_the_earlier_report_as_it_was") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck("head_on_below_limit.in", &[]));
    s.granlaw(&["verify", "deck.in", "--out", "out"]).ends(0, &[]);
    let before = s.read("out/report.json");
    for signal in [Signal::INT, Signal::TERM] {
        let child = begun(&s, &["verify", "endless.in", "--out", "out"]);
        let (_, said) = ends(&s, child, signal);
        said.ends(2, &["interrupted"]);
        nothing_left(&s);
        assert_eq!(s.read("out/report.json"), before);
        std::fs::remove_file(s.path("started")).unwrap();
    }
    let here: Vec<_> = std::fs::read_dir(s.path(".")).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert!(
        here.iter().all(|n| !n.to_string_lossy().starts_with('.')),
        "a temporary folder was left: {here:?}"
    );
}
