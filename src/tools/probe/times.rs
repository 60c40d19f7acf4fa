//! How long a run takes, and what for.
use rustix::param::clock_ticks_per_second;
use rustix::time::{clock_gettime, ClockId, Timespec};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Times of a run \[s\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Times {
    /// Wall-clock time from the start of the process to the first step.
    pub start: f64,
    /// Wall-clock time of steps with a new neighbour list, minus that of as many steps without.
    pub lists: f64,
    /// Processor time of all ranks from the first step to the last.
    pub processor: f64,
    /// The part of the processor time that went into following contacts. The other costs of the probe are small and not measured.
    pub probe: f64,
}

impl Times {
    /// Adds those of another rank.
    pub(super) fn merge(&mut self, other: Times) {
        self.start = self.start.max(other.start);
        self.lists = self.lists.max(other.lists);
        self.processor += other.processor;
        self.probe += other.probe;
    }
}

/// Measures the times of a run.
#[derive(Clone, Debug)]
pub(super) struct Stopwatch {
    began: Instant,
    last: Instant,
    start: f64,
    processor: f64,
    /// Number and time of steps without and with a new list \[s\].
    steps: [(u64, f64); 2],
}

impl Stopwatch {
    /// Starts at the first step.
    pub fn new() -> Stopwatch {
        let now = Instant::now();
        Stopwatch { began: now, last: now, start: age(), processor: processor(), steps: [(0, 0.0); 2] }
    }

    /// A step begins, for which the neighbour list was made anew or not.
    pub fn tick(&mut self, listed: bool) {
        let now = Instant::now();
        let (many, time) = &mut self.steps[usize::from(listed)];
        *many += 1;
        *time += (now - self.last).as_secs_f64();
        self.last = now;
    }

    /// Wall-clock time from the first step to the last \[s\], and the other times.
    pub fn read(&self) -> (f64, Times) {
        let [(plain, steps), (listed, lists)] = self.steps;
        let usual = if plain > 0 { steps / plain as f64 } else { 0.0 };
        let times = Times {
            start: self.start,
            lists: (lists - usual * listed as f64).max(0.0),
            processor: processor() - self.processor,
            probe: 0.0,
        };
        ((self.last - self.began).as_secs_f64(), times)
    }
}

fn seconds(t: Timespec) -> f64 {
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// Processor time of this process \[s\].
fn processor() -> f64 {
    seconds(clock_gettime(ClockId::ProcessCPUTime))
}

/// The age of this process \[s\]; 0 if the system does not tell it.
fn age() -> f64 {
    let Ok(stat) = std::fs::read_to_string("/proc/self/stat") else { return 0.0 };
    // The start is the 22nd word. The second is the name of the program, in brackets, which may hold spaces.
    let start = stat.rsplit(')').next().and_then(|rest| rest.split_whitespace().nth(19)?.parse::<f64>().ok());
    let now = seconds(clock_gettime(ClockId::Boottime));
    start.map_or(0.0, |ticks| (now - ticks / clock_ticks_per_second() as f64).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn steps_with_a_new_list_are_told_apart() {
        let mut watch = Stopwatch::new();
        for k in 0..20 {
            let listed = k % 5 == 4;
            std::thread::sleep(Duration::from_millis(if listed { 12 } else { 2 }));
            watch.tick(listed);
        }
        let (seconds, times) = watch.read();
        // Sleeping is never shorter than asked for, and all of it is counted.
        assert!(seconds >= 0.08 && times.lists > 0.02 && times.lists < seconds, "{seconds} {times:?}");
        // It uses next to no processor time, and the process began before the watch.
        assert!(times.processor < seconds && times.start > 0.0, "{times:?}");
    }
}
