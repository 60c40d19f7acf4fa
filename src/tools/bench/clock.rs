//! The times that a run prints at its end, and what our plugin adds to them.

/// What LIGGGHTS or LAMMPS says of one `run` command.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Clock {
    /// Time for pair contacts \[s\].
    pub pair: f64,
    /// Time of the whole run \[s\].
    pub whole: f64,
    pub steps: u64,
    pub spheres: u64,
    /// How often neighbour lists were built.
    pub builds: u64,
}

impl Clock {
    /// The longest run of a log.
    pub(super) fn read(log: &str) -> Option<Clock> {
        let mut runs: Vec<Clock> = Vec::new();
        for line in log.lines() {
            if let Some(rest) = line.strip_prefix("Loop time of ") {
                let word = |k: usize| rest.split_whitespace().nth(k);
                let number = |k: usize| word(k).and_then(|w| w.parse().ok()).unwrap_or_default();
                let whole = word(0).and_then(|w| w.parse().ok()).unwrap_or_default();
                runs.push(Clock { whole, steps: number(5), spheres: number(8), ..Clock::default() });
            } else if let Some(run) = runs.last_mut() {
                run.pair = pair(line).unwrap_or(run.pair);
                run.builds = after(line, "Neighbor list builds = ").unwrap_or(run.builds);
            }
        }
        runs.into_iter().max_by(|a, b| a.whole.total_cmp(&b.whole))
    }
}

/// `Pair  time (%) = 1.2 (97)` of LIGGGHTS, `Pair    | min | avg | max | ...` of LAMMPS.
fn pair(line: &str) -> Option<f64> {
    after(line, "Pair  time (%) = ").or_else(|| {
        let mut columns = line.strip_prefix("Pair ")?.split('|');
        columns.nth(2)?.trim().parse().ok()
    })
}

/// The number that follows some words.
fn after<T: std::str::FromStr>(line: &str, words: &str) -> Option<T> {
    line.strip_prefix(words)?.split_whitespace().next()?.parse().ok()
}

/// What the batched path did in a run, all ranks together, and the memory it needs beside LIGGGHTS's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Account {
    pub passes: u64,
    pub contacts: u64,
    pub neighbours: u64,
    pub bytes: u64,
}

impl Account {
    /// The longest run of a log; the words are those of `batch.hpp`.
    pub(super) fn read(log: &str) -> Option<Account> {
        let lines = log.lines().filter_map(|l| l.strip_prefix("granlaw: batched path ends: "));
        let read = |line: &str| {
            let mut numbers = line.split(", ").map(|part| part.split(' ').next()?.parse().ok());
            let mut next = || numbers.next().flatten();
            Some(Account { passes: next()?, contacts: next()?, neighbours: next()?, bytes: next()? })
        };
        lines.filter_map(read).max_by_key(|a| a.passes)
    }
}

/// The name that the batched path gives its width.
pub(super) fn lanes(log: &str) -> Option<String> {
    log.lines().find_map(|l| l.strip_prefix("granlaw: batched path, ")).map(str::to_string)
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
        let clock = Clock { pair: 32.25, whole: 33.5, steps: 500, spheres: 16384, builds: 3 };
        assert_eq!(Clock::read(log), Some(clock));
        assert_eq!(Clock::read("ERROR: Unknown command"), None);
    }

    #[test]
    fn lammps_has_a_table() {
        let log = "Loop time of 4.5 on 1 procs for 500 steps with 16384 atoms\n\nSection |  min time  |  avg time  |  max time  |%varavg| %total\n\
            Pair    | 4.125      | 4.25       | 4.375      |   0.0 | 94.00\nNeigh   | 0 | 0 | 0 | 0.0 | 0\n\
            Neighbor list builds = 1\n";
        let clock = Clock { pair: 4.25, whole: 4.5, steps: 500, spheres: 16384, builds: 1 };
        assert_eq!(Clock::read(log), Some(clock));
    }

    #[test]
    fn the_plugin_counts() {
        let log = "granlaw: batched path, 4 contacts at a time, AVX2\n\
            granlaw: batched path ends: 501 steps, 52280352 contacts, 104352 neighbours, 1000 bytes\n\
            granlaw: batched path ends: 1 steps, 104352 contacts, 104352 neighbours, 1000 bytes\n";
        let account = Account { passes: 501, contacts: 52280352, neighbours: 104352, bytes: 1000 };
        assert_eq!(Account::read(log), Some(account));
        assert_eq!(lanes(log).as_deref(), Some("4 contacts at a time, AVX2"));
        assert_eq!(Account::read("granlaw: batched path ends: soon"), None);
    }
}
