//! Why a run failed, in LIGGGHTS's own words and with the line of the deck.
use super::process::End;
use super::Plugin;
use crate::deck::Deck;
use std::fs;
use std::io;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::time::Duration;
use thiserror::Error;

/// Why there is no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// LIGGGHTS is not installed.
    #[error("liggghts is not in PATH; on Debian install the package liggghts (apt-get install liggghts)")]
    NoLiggghts,
    /// Something else has its name.
    #[error("{} does not answer -h as LIGGGHTS does but says {said:?}; put LIGGGHTS first in PATH, or mend what keeps it from starting", program.display())]
    NotLiggghts {
        /// The program.
        program: PathBuf,
        /// The beginning of its answer.
        said: String,
    },
    /// There is no mpirun.
    #[error(
        "mpirun is not in PATH and {ranks} ranks are asked for; on Debian install the package openmpi-bin"
    )]
    NoMpirun {
        /// How many ranks.
        ranks: usize,
    },
    /// The plugin is not there.
    #[error("the LIGGGHTS plugin was not found; looked for\n  {}\nbuild it with `cargo build --workspace` where the package libliggghts-dev is installed, or name it in GRANLAW_PLUGIN", list(looked))]
    NoPlugin {
        /// Where it was looked for.
        looked: Vec<PathBuf>,
    },
    /// What is there is not the plugin.
    #[error("the plugin {} {why}; build it from the same source as this granlaw (ABI version {}) where libliggghts-dev is installed, or name another in GRANLAW_PLUGIN", path.display(), Plugin::ABI)]
    WrongPlugin {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// The files of the deck cannot be had.
    #[error("{0}")]
    Deck(String),
    /// LIGGGHTS refused the deck or died.
    #[error("{deck}{}: {message}", place(at))]
    Failed {
        /// Path of the deck.
        deck: String,
        /// The line of the deck that LIGGGHTS read last, with its text.
        at: Option<(usize, String)>,
        /// LIGGGHTS's own error.
        message: String,
        /// The end of what it said.
        log: String,
    },
    /// It ran too long.
    #[error(
        "{deck}{}: stopped after the time limit of {seconds} s; shorten the run or raise --time-limit",
        place(at)
    )]
    TimedOut {
        /// Path of the deck.
        deck: String,
        /// The line of the deck that LIGGGHTS read last, with its text.
        at: Option<(usize, String)>,
        /// The limit \[s\].
        seconds: f64,
        /// The end of what it said.
        log: String,
    },
    /// We were asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// The system refused something.
    #[error("cannot {doing} {}: {source}", path.display())]
    Io {
        /// What was tried.
        doing: &'static str,
        /// On what.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}

fn list(paths: &[PathBuf]) -> String {
    paths.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join("\n  ")
}

fn place(at: &Option<(usize, String)>) -> String {
    at.as_ref().map(|(line, text)| format!(":{line}: `{text}`")).unwrap_or_default()
}

impl RunError {
    /// For `map_err`: what was tried on which path.
    pub(crate) fn io(doing: &'static str, path: &Path) -> impl FnOnce(io::Error) -> RunError {
        let path = path.to_path_buf();
        move |source| RunError::Io { doing, path, source }
    }

    /// Whether LIGGGHTS has no contact model of a name in the deck, so that it can only run with the plugin, if at all.
    pub fn lacks_model(&self) -> bool {
        matches!(self, RunError::Failed { message, .. } if message.contains("Invalid model specified"))
    }

    /// The end of what LIGGGHTS said, where it ran.
    pub fn log(&self) -> Option<&str> {
        match self {
            RunError::Failed { log, .. } | RunError::TimedOut { log, .. } => Some(log),
            _ => None,
        }
    }
}

/// Everything that a run printed.
pub(super) struct Said {
    log: String,
    out: String,
    err: String,
}

impl Said {
    pub(super) fn read(log: &Path, outputs: &[PathBuf; 2]) -> Said {
        let read = |path: &Path| readable(&fs::read(path).unwrap_or_default());
        Said { log: read(log), out: read(&outputs[0]), err: read(&outputs[1]) }
    }

    pub(super) fn warnings(&self) -> Vec<String> {
        let mut found: Vec<_> =
            self.out.lines().filter(|l| l.starts_with("WARNING")).map(str::to_string).collect();
        found.dedup();
        found
    }

    /// Whether the run is good.
    pub(super) fn judge(&self, deck: &Deck, end: End, limit: Duration) -> Result<(), RunError> {
        let text = fs::read(&deck.path).unwrap_or_default();
        let at = last_read(&String::from_utf8_lossy(&text), &self.log);
        let (name, log) = (deck.path.display().to_string(), self.tail());
        match end {
            // The loader only grumbles and goes on without it; what ran then was not what was asked for.
            End::Exited(_) if self.err.contains("cannot be preloaded") => {
                let grumble =
                    self.err.lines().find(|l| l.contains("cannot be preloaded")).unwrap_or_default();
                Err(RunError::Failed { deck: name, at: None, message: grumble.trim().into(), log })
            }
            End::Exited(status) if status.success() => Ok(()),
            End::Interrupted => Err(RunError::Interrupted),
            End::TimedOut => Err(RunError::TimedOut { deck: name, at, seconds: limit.as_secs_f64(), log }),
            End::Exited(status) => {
                let how = match (status.signal(), status.code()) {
                    (Some(signal), _) => format!("LIGGGHTS was ended by signal {signal}"),
                    (_, code) => format!("LIGGGHTS ended with status {}", code.unwrap_or(-1)),
                };
                let said = [&self.out, &self.err, &self.log].into_iter().find_map(|t| own_error(t));
                let said = said.or_else(|| plugins_error(&self.err));
                let message = said.unwrap_or_else(|| format!("{how} and gave no reason"));
                Err(RunError::Failed { deck: name, at, message, log })
            }
        }
    }

    /// The last lines of log, output and errors, for people.
    fn tail(&self) -> String {
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
        let out = if self.log.is_empty() {
            part("standard output", &self.out)
        } else {
            part("log.liggghts", &self.log)
        };
        out + &part("standard error", &self.err)
    }
}

/// Text without the line that LIGGGHTS puts behind one error in five: a jest that it reads from memory freed before, and
/// so a few bytes that are no text. It ends with the place in the source, as the error does.
fn readable(bytes: &[u8]) -> String {
    let (mut kept, mut place) = (String::new(), None);
    for line in String::from_utf8_lossy(bytes).split_inclusive('\n') {
        let error = line.starts_with("ERROR");
        let end = line.trim_end().rsplit_once(" (").map(|(_, end)| end.to_string());
        if error || end.is_none() || end != place {
            kept.push_str(line);
        }
        place = end.filter(|_| error);
    }
    kept
}

/// LIGGGHTS's error; it may run over a few lines and ends where its source is named.
fn own_error(text: &str) -> Option<String> {
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

/// What the plugin says where it ends a run that LIGGGHTS thinks well of.
fn plugins_error(err: &str) -> Option<String> {
    err.lines().find_map(|l| l.strip_prefix("granlaw: ")).map(str::to_string)
}

/// The last command of the deck that the log repeats: its line and its text.
fn last_read(deck: &str, log: &str) -> Option<(usize, String)> {
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
    fn what_is_no_text_behind_an_error_is_left_out() {
        let error = "run 1\nERROR: Invalid pair style (./src/force.cpp:247)\n";
        let jest = [error.as_bytes(), b"\x01\xbe\x05 (./src/force.cpp:247)\nmore\n"].concat();
        assert_eq!(readable(&jest), format!("{error}more\n"));
        let others = format!("{error}ERROR: Again (./src/force.cpp:247)\nwarning (see above)\n");
        assert_eq!(readable(others.as_bytes()), others);
    }

    #[test]
    fn an_error_is_quoted_whole() {
        let one = "x\nERROR: Unknown command: foo (./src/input.cpp:259)\nmore";
        assert_eq!(own_error(one).unwrap(), "ERROR: Unknown command: foo (./src/input.cpp:259)");
        let two = "ERROR on proc 0: Could not\nfind it (./src/fix.cpp:1)\n";
        assert_eq!(own_error(two).unwrap(), "ERROR on proc 0: Could not find it (./src/fix.cpp:1)");
        assert_eq!(own_error("fine\n"), None);
        let ours = "a warning\ngranlaw: no probe was written\n";
        assert_eq!(plugins_error(ours).unwrap(), "no probe was written");
    }
}
