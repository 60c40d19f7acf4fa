//! What a run printed: its warnings, its error, and how far it came in the deck.

/// Everything that a run printed.
#[derive(Clone, Debug, Default)]
pub struct Said {
    /// Its log file.
    pub log: String,
    /// Its standard output.
    pub out: String,
    /// Its standard error.
    pub err: String,
}

impl Said {
    /// The log, or standard output where there is none.
    pub fn main(&self) -> &str {
        if self.log.is_empty() {
            &self.out
        } else {
            &self.log
        }
    }

    /// The warnings in standard output.
    pub(super) fn warnings(&self) -> Vec<String> {
        let mut found: Vec<_> =
            self.out.lines().filter(|l| l.starts_with("WARNING")).map(str::to_string).collect();
        found.dedup();
        found
    }

    /// The last lines of the log of this name, or else of the output, and of the errors, for people.
    pub(super) fn tail(&self, log: &str) -> String {
        let part = |name: &str, text: &str| {
            let lines: Vec<_> = text.lines().collect();
            let last = &lines[lines.len().saturating_sub(40)..];
            if last.is_empty() {
                String::new()
            } else {
                format!("--- {name}\n{}\n", last.join("\n"))
            }
        };
        // The log repeats the output; the output alone is worth showing only where there is no log.
        let out = if self.log.is_empty() { part("standard output", &self.out) } else { part(log, &self.log) };
        out + &part("standard error", &self.err)
    }
}

/// The error of LIGGGHTS or LAMMPS in a text; it may run over a few lines and ends where its source is named.
pub(super) fn own_error(text: &str) -> Option<String> {
    let named = |l: &str| l.contains(".cpp:") || l.contains(".h:");
    let mut lines = text.lines().skip_while(|l| !l.starts_with("ERROR")).map(str::trim_end);
    let mut message = lines.next()?.to_string();
    let more: Vec<_> = lines.take(3).collect();
    let end = more.iter().position(|l| named(l));
    if let (false, Some(end)) = (named(&message), end) {
        more[..=end].iter().for_each(|l| message = format!("{message} {l}"));
    }
    Some(message)
}

/// The last command of the deck that the log repeats: its line and its text.
pub(super) fn last_read(deck: &str, log: &str) -> Option<(usize, String)> {
    let commands = commands(deck);
    let mut next = 0;
    for said in log.lines().map(squeezed) {
        let here = |from: &[(usize, String)]| from.iter().position(|(_, c)| *c == said);
        // Mostly the next one; an earlier one where the deck loops.
        let found = here(&commands[next..]).map(|k| next + k).or_else(|| here(&commands));
        next = found.map_or(next, |k| k + 1);
    }
    commands.get(next.checked_sub(1)?).cloned()
}

/// The commands of a deck with the numbers of the lines on which they begin; a line may end in `&` and go on.
fn commands(deck: &str) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    let mut goes_on = false;
    for (k, line) in deck.lines().enumerate() {
        let (text, more) = match line.trim_end().strip_suffix('&') {
            Some(text) => (text, true),
            None => (line, false),
        };
        match found.last_mut().filter(|_| goes_on) {
            Some((_, command)) => command.push_str(text),
            None => found.push((k + 1, text.to_string())),
        }
        goes_on = more;
    }
    found
        .into_iter()
        .map(|(k, c)| (k, squeezed(&c)))
        .filter(|(_, c)| !c.is_empty() && !c.starts_with('#'))
        .collect()
}

fn squeezed(line: &str) -> String {
    line.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const DECK: &str = "units si\n# a comment\nfix p all property/global &\n  youngsModulus peratomtype 5e6\nrun 10\nrun 10\nfoo\n";

    #[test]
    fn the_last_command_read_is_found() {
        let log =
            "LIGGGHTS (Version 1)\nunits si\nfix p all property/global   youngsModulus peratomtype 5e6\n";
        assert_eq!(last_read(DECK, log).unwrap().0, 3);
        let log = format!("{log}run 10\nStep Atoms\nrun 10\n");
        assert_eq!(last_read(DECK, &log), Some((6, "run 10".into())));
        assert_eq!(last_read(DECK, "LIGGGHTS\n"), None);
    }

    #[test]
    fn an_error_is_quoted_whole() {
        let one = "x\nERROR: Unknown command: foo (./src/input.cpp:259)\nmore";
        assert_eq!(own_error(one).unwrap(), "ERROR: Unknown command: foo (./src/input.cpp:259)");
        let two = "ERROR on proc 0: Could not\nfind it (./src/fix.cpp:1)\n";
        assert_eq!(own_error(two).unwrap(), "ERROR on proc 0: Could not find it (./src/fix.cpp:1)");
        assert_eq!(own_error("fine\n"), None);
    }
}
