//! The times that a code prints at the end of a run.

/// What LIGGGHTS or LAMMPS says of one `run` command.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Times {
    /// Time for pair contacts \[s\].
    pub pair: f64,
    /// Time for all of it \[s\].
    pub whole: f64,
    /// Time steps.
    pub steps: u64,
    /// Particles.
    pub particles: u64,
    /// How often neighbour lists were built.
    pub builds: u64,
}

impl Times {
    /// Every run of a log.
    pub fn read(log: &str) -> Vec<Times> {
        let mut runs: Vec<Times> = Vec::new();
        for line in log.lines() {
            if let Some(rest) = line.strip_prefix("Loop time of ") {
                let word = |k: usize| rest.split_whitespace().nth(k);
                let number = |k: usize| word(k).and_then(|w| w.parse().ok()).unwrap_or_default();
                let whole = word(0).and_then(|w| w.parse().ok()).unwrap_or_default();
                runs.push(Times { whole, steps: number(5), particles: number(8), ..Times::default() });
            } else if let Some(run) = runs.last_mut() {
                run.pair = pair(line).unwrap_or(run.pair);
                run.builds = after(line, "Neighbor list builds = ").unwrap_or(run.builds);
            }
        }
        runs
    }

    /// The longest of some runs.
    pub fn longest(runs: &[Times]) -> Option<Times> {
        runs.iter().copied().max_by(|a, b| a.whole.total_cmp(&b.whole))
    }
}

/// `Pair  time (%) = 1.2 (97)` of LIGGGHTS, `Pair    | min | avg | max | ...` of LAMMPS.
fn pair(line: &str) -> Option<f64> {
    after(line, "Pair  time (%) = ").or_else(|| {
        let mut columns = line.strip_prefix("Pair ")?.split('|');
        columns.nth(2)?.trim().parse().ok()
    })
}

/// The number behind some words.
fn after<T: std::str::FromStr>(line: &str, words: &str) -> Option<T> {
    line.strip_prefix(words)?.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_run_of_liggghts_counts() {
        let log = "Loop time of 33.5 on 1 procs for 500 steps with 16384 atoms, finish time Thu\n\n\
            Pair  time (%) = 32.25 (97.5)\nNeigh time (%) = 0.01 (0.03)\nNeighbor list builds = 3\n\
            Loop time of 7.11e-07 on 1 procs for 0 steps with 16384 atoms, finish time Thu\n\
            Pair  time (%) = 0 (0)\nNeighbor list builds = 0\n";
        let times = Times { pair: 32.25, whole: 33.5, steps: 500, particles: 16384, builds: 3 };
        assert_eq!(Times::read(log).len(), 2);
        assert_eq!(Times::longest(&Times::read(log)), Some(times));
        assert_eq!(Times::read("ERROR: Unknown command"), []);
    }

    #[test]
    fn lammps_has_a_table() {
        let log = "Loop time of 4.5 on 1 procs for 500 steps with 16384 atoms\n\nSection |  min time  |  avg time  |  max time  |%varavg| %total\n\
            Pair    | 4.125      | 4.25       | 4.375      |   0.0 | 94.00\nNeigh   | 0 | 0 | 0 | 0.0 | 0\n\
            Neighbor list builds = 1\n";
        let times = Times { pair: 4.25, whole: 4.5, steps: 500, particles: 16384, builds: 1 };
        assert_eq!(Times::read(log), [times]);
    }
}
