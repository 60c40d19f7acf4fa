//! How long the probed run took, and how long another run will take.
use crate::probe::Probe;

/// The time that the probed run took.
#[derive(Clone, Copy, Debug)]
pub struct RunTime {
    /// Processor time per contact call of everything that is done in every step \[ns\].
    per_call: f64,
    /// Time that does not grow with the number of steps, over that which does. It is that of the start, and of neighbour lists,
    /// which are made anew after a distance travelled.
    fixed: f64,
}

impl RunTime {
    /// The run_time of a probed run. The time for following contacts is taken out; the other costs of the probe stay in.
    pub(super) fn of(probe: &Probe) -> RunTime {
        let calls: u64 = probe.chains.iter().map(|c| c.calls).sum();
        let (t, ranks) = (&probe.times, probe.ranks.max(1) as f64);
        // Processor time is not lengthened by other programs on the machine.
        let whole = if t.processor > 0.0 { t.processor / ranks } else { probe.seconds };
        let lists = if probe.seconds > 0.0 { t.lists * whole / probe.seconds } else { 0.0 };
        let steps = (whole - lists - t.probe / ranks).max(0.0);
        let fixed = if steps > 0.0 { (t.start + lists) / steps } else { 0.0 };
        RunTime { per_call: 1e9 * steps * ranks / calls.max(1) as f64, fixed }
    }

    /// Time of another run relative to the probed one: its laws cost `is` instead of `was` \[ns per contact\], and it takes `steps`
    /// times as many steps.
    pub(super) fn relative(&self, (was, is): (f64, f64), steps: f64) -> f64 {
        let each = 1.0 + (is - was) / self.per_call.max(was);
        (self.fixed + each * steps) / (self.fixed + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::{self, Times};

    #[test]
    fn what_does_not_grow_with_the_steps_is_not_saved() {
        let chains = vec![probe::Contacts { calls: 4_000_000, ..probe::Contacts::default() }];
        let times = Times { start: 0.5, lists: 0.5, processor: 3.0, probe: 0.5 };
        let mut probe = Probe { ranks: 1, seconds: 6.0, times, chains, ..Probe::default() };
        // The machine was busy: of 6 s only half were ours, half a second of that the probe's. So 2.25 s of steps, 0.25 s of
        // lists and half a second to start.
        let run_time = RunTime::of(&probe);
        assert!(
            (run_time.per_call - 562.5).abs() < 1e-9 && (run_time.fixed - 0.75 / 2.25).abs() < 1e-12,
            "{run_time:?}"
        );
        assert!((run_time.relative((50.0, 50.0), 0.1) - (0.75 + 0.225) / 3.0).abs() < 1e-12);
        assert_eq!(run_time.relative((50.0, 50.0), 1.0), 1.0);
        // Laws that cost 56 ns more make each step a tenth longer.
        assert!((run_time.relative((50.0, 106.25), 1.0) - (0.75 + 2.475) / 3.0).abs() < 1e-12);
        // A probe without times: all time is taken to grow with the steps.
        probe.times = Times::default();
        assert!((RunTime::of(&probe).relative((50.0, 50.0), 0.1) - 0.1).abs() < 1e-12);
    }
}
