//! What our plugin adds to the log of a run.

/// What the batched path did in a run, all ranks together, and what it needs beside LIGGGHTS.
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

/// What the batched path calls its width.
pub(super) fn lanes(log: &str) -> Option<String> {
    log.lines().find_map(|l| l.strip_prefix("granlaw: batched path, ")).map(str::to_string)
}

#[cfg(test)]
mod tests {
    use super::*;

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
