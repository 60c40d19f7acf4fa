//! A process with a time limit. Whatever it started goes with it.
use rustix::process::{kill_process, kill_process_group, Pid, Signal};
use std::fs;
use std::io;
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, ExitStatus};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// How a process ended.
#[derive(Clone, Copy, Debug)]
pub(super) enum End {
    /// By itself.
    Exited(ExitStatus),
    /// It was stopped at the time limit.
    TimedOut,
    /// It was stopped because we are.
    Interrupted,
}

/// Stop every run, now and from here on; for a handler of Ctrl-C.
pub fn interrupt() {
    INTERRUPTED.store(true, Ordering::SeqCst);
}

/// Run to the end or to the limit.
pub(super) fn run(command: &mut Command, limit: Duration) -> io::Result<End> {
    let begun = Instant::now();
    let mut child = command.process_group(0).spawn()?;
    let mut pause = Duration::from_millis(1);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(End::Exited(status));
        }
        let interrupted = INTERRUPTED.load(Ordering::SeqCst);
        if interrupted || begun.elapsed() > limit {
            stop(&mut child)?;
            return Ok(if interrupted { End::Interrupted } else { End::TimedOut });
        }
        sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(10));
    }
}

/// Ask first, so that mpirun can clear up; then insist. The ranks of mpirun have process groups of their own, so the
/// family is looked up before its head is gone.
fn stop(child: &mut Child) -> io::Result<()> {
    let group = Pid::from_child(child);
    let family = family(child.id());
    // A group or process that is gone already is what we want.
    let _ = kill_process_group(group, Signal::TERM);
    let asked = Instant::now();
    while child.try_wait()?.is_none() && asked.elapsed() < Duration::from_secs(3) {
        sleep(Duration::from_millis(10));
    }
    let _ = kill_process_group(group, Signal::KILL);
    let alive = |(id, started): &(u32, u64)| stat(*id).is_some_and(|s| s.started == *started && !s.dead);
    for (id, _) in family.iter().filter(|f| alive(f)) {
        let _ = Pid::from_raw(*id as i32).map(|p| kill_process(p, Signal::KILL));
    }
    // The system takes a moment to do it.
    let killed = Instant::now();
    while family.iter().any(alive) && killed.elapsed() < Duration::from_secs(3) {
        sleep(Duration::from_millis(10));
    }
    child.wait().map(drop)
}

struct Stat {
    /// Whether it has ended and only waits for its parent to notice.
    dead: bool,
    parent: u32,
    started: u64,
}

/// What the system says of a process; the start time tells a process from a later one with the same number.
fn stat(id: u32) -> Option<Stat> {
    let text = fs::read_to_string(format!("/proc/{id}/stat")).ok()?;
    // The name in brackets may hold anything; the fields behind it are fixed.
    let fields: Vec<_> = text.rsplit_once(')')?.1.split_whitespace().collect();
    let dead = ["Z", "X"].contains(fields.first()?);
    Some(Stat { dead, parent: fields.get(1)?.parse().ok()?, started: fields.get(19)?.parse().ok()? })
}

/// All descendants of a process, with their start times.
fn family(head: u32) -> Vec<(u32, u64)> {
    let ids = fs::read_dir("/proc").into_iter().flatten().flatten();
    let ids = ids.filter_map(|e| e.file_name().to_str()?.parse::<u32>().ok());
    let all: Vec<_> = ids.filter_map(|id| Some((id, stat(id)?))).collect();
    let mut found = vec![(head, 0)];
    let mut next = 0;
    while next < found.len() {
        let parent = found[next].0;
        found.extend(all.iter().filter(|(_, s)| s.parent == parent).map(|(id, s)| (*id, s.started)));
        next += 1;
    }
    found.split_off(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_ends_a_process_and_what_it_started() {
        let dir = tempfile::tempdir().unwrap();
        let note = dir.path().join("pid");
        // The grandchild leaves the process group, as the ranks of mpirun do, and ignores a polite request.
        let script = "setsid sh -c 'trap \"\" TERM; echo $$ > pid; while :; do sleep 1; done' & wait";
        let mut command = Command::new("sh");
        command.args(["-c", script]).current_dir(dir.path());
        let begun = Instant::now();
        let end = run(&mut command, Duration::from_millis(800)).unwrap();
        assert!(matches!(end, End::TimedOut), "{end:?}");
        assert!(begun.elapsed() < Duration::from_secs(10));
        let id: u32 = fs::read_to_string(note).unwrap().trim().parse().unwrap();
        assert!(stat(id).is_none_or(|s| s.dead), "process {id} is still there");
    }

    #[test]
    fn a_process_that_ends_by_itself_is_not_late() {
        let end = run(Command::new("sh").args(["-c", "exit 3"]), Duration::from_secs(20)).unwrap();
        assert!(matches!(end, End::Exited(s) if s.code() == Some(3)), "{end:?}");
    }
}
