//! Recording and replay stream: what they hold in memory does not grow with the length of the run.
use super::stop::{begun, wait_for};
use crate::common::{live, program, Scratch};
use rustix::process::{kill_process, Pid, Signal};
use std::io::Write;
use std::process::{Child, Command, Stdio};

const MB: u64 = 1 << 20;

/// The most memory that a process has held so far, in bytes; `None` when it has gone.
fn peak(child: &Child) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kb| kb * 1024)
}

/// The most that a process holds from now to its end.
fn peak_to_the_end(mut child: Child) -> u64 {
    let mut most = 0;
    while child.try_wait().unwrap().is_none() {
        most = peak(&child).unwrap_or(0).max(most);
    }
    assert!(child.wait().unwrap().success());
    most
}

#[test]
fn a_trace_of_any_length_is_recorded_and_replayed_in_little_memory() {
    if !live("a_trace_of_any_length_is_recorded_and_replayed_in_little_memory") {
        return;
    }
    let s = Scratch::new();
    let mut run = begun(&s, &["run", "--record", "t.csv", "--", "-in", "endless.in"]);
    let part = s.path("t.csv.part");
    let after = |megabytes: u64| {
        wait_for("a longer trace", || part.metadata().is_ok_and(|m| m.len() > megabytes * MB));
        peak(&run).expect("it is still running")
    };
    let (short, long) = (after(5), after(120));
    assert!(long < 200 * MB, "{} MB", long / MB);
    assert!(long - short < MB, "grew from {short} to {long} bytes");
    // LIGGGHTS ends its run in order, and the trace is whole.
    kill_process(Pid::from_child(&run), Signal::INT).unwrap();
    assert!(run.wait().unwrap().success());
    assert!(s.path("t.csv").metadata().unwrap().len() > 120 * MB);
    let replay = s.command(program()).args(["replay", "t.csv"]).stdout(Stdio::null()).spawn().unwrap();
    let held = peak_to_the_end(replay);
    assert!((MB..50 * MB).contains(&held), "{held} bytes for 120 MB of trace");
}

#[test]
fn a_shadow_takes_the_same_memory_all_along() {
    if !live("a_shadow_takes_the_same_memory_all_along") {
        return;
    }
    let s = Scratch::new();
    let mut run = begun(&s, &["run", "--shadow", "--", "-in", "endless.in"]);
    let dump = s.path("dump.txt");
    let after = |megabytes: u64| {
        wait_for("more steps", || dump.metadata().is_ok_and(|m| m.len() > megabytes * MB));
        peak(&run).expect("it is still running")
    };
    // Some 400,000 calls lie between: a few bytes kept of each would be seen.
    let (short, long) = (after(1), after(6));
    assert!(long - short < MB, "grew from {short} to {long} bytes");
    kill_process(Pid::from_child(&run), Signal::INT).unwrap();
    assert!(run.wait().unwrap().success());
    assert!(s.read("out.txt").contains("all equal to the last bit"));
}

#[test]
fn a_program_that_keeps_what_it_reads_is_seen_to_grow() {
    // `tail` keeps a line until it ends.
    let mut tail = Command::new("tail").stdin(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    let mut feed = tail.stdin.take().unwrap();
    let mut after = |megabytes: u64| {
        (0..megabytes).for_each(|_| feed.write_all(&[b'x'; MB as usize]).unwrap());
        peak(&tail).unwrap()
    };
    let (short, long) = (after(1), after(30));
    drop(feed);
    assert!(tail.wait().unwrap().success());
    assert!(long - short > 20 * MB, "from {short} to {long} bytes");
}
