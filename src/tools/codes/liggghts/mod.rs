//! LIGGGHTS, which is never changed: our plugin enters through `LD_PRELOAD`.
use super::launch::{answer, which};
use super::said::own_error;
use super::{Code, RunError, Said, Times};
use crate::deck::Deck;
use std::path::{Path, PathBuf};

mod plugin;
mod preload;
mod resolve;

pub use plugin::Plugin;
pub use preload::{Laws, Preload, Route};
pub use resolve::resolve;

/// LIGGGHTS, found on this machine.
#[derive(Clone, Debug)]
pub struct Liggghts {
    /// The program.
    pub program: PathBuf,
    /// What it calls itself.
    pub version: String,
}

impl Liggghts {
    /// LIGGGHTS, as the first `liggghts` of PATH.
    ///
    /// # Errors
    /// There is none.
    pub fn find() -> Result<Liggghts, RunError> {
        let install = "on Debian install the package liggghts (apt-get install liggghts)";
        let program = which("liggghts").ok_or(RunError::NoProgram { program: "liggghts", install })?;
        Liggghts::open(&program)
    }

    /// A certain program.
    ///
    /// # Errors
    /// It is not LIGGGHTS.
    pub fn open(program: &Path) -> Result<Liggghts, RunError> {
        let [out, err] = answer(program, &["-log", "none", "-h"])?;
        let program = program.to_path_buf();
        match version_of(&out) {
            Some(version) => Ok(Liggghts { program, version }),
            None => {
                let said = beginning(&format!("{out}\n{err}"));
                Err(RunError::WrongProgram { code: "LIGGGHTS", program, said })
            }
        }
    }
}

impl Code for Liggghts {
    fn name(&self) -> &'static str {
        "LIGGGHTS"
    }

    fn program(&self) -> &Path {
        &self.program
    }

    fn version(&self) -> &str {
        &self.version
    }

    fn arguments(&self, deck: &Deck) -> Vec<String> {
        let variables = deck.variables.iter().flat_map(|(name, value)| ["-var", name, value]);
        ["-in", &deck.file()].into_iter().chain(variables).map(str::to_string).collect()
    }

    fn log(&self) -> &'static str {
        "log.liggghts"
    }

    fn text(&self, bytes: &[u8]) -> String {
        readable(bytes)
    }

    fn error(&self, said: &Said) -> Option<String> {
        let own = [&said.out, &said.err, &said.log].into_iter().find_map(|t| own_error(t));
        own.or_else(|| plugins_error(&said.err))
    }

    fn times(&self, said: &Said) -> Vec<Times> {
        Times::read(said.main())
    }
}

/// `LIGGGHTS-PUBLIC 3.8.0, compiled …` of LIGGGHTS's first line.
fn version_of(text: &str) -> Option<String> {
    let begin = text.strip_prefix("LIGGGHTS (Version ")?;
    let line = begin.lines().next()?;
    Some(line.split(", git").next()?.trim_end_matches(')').to_string())
}

/// The first line that says something.
fn beginning(text: &str) -> String {
    let says = |l: &&str| l.contains(char::is_alphanumeric);
    text.lines().find(says).unwrap_or("nothing").trim().chars().take(200).collect()
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

/// What the plugin says where it ends a run that LIGGGHTS thinks well of.
fn plugins_error(err: &str) -> Option<String> {
    err.lines().find_map(|l| l.strip_prefix("granlaw: ")).map(str::to_string)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn version_line() {
        let said = "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd, git commit x)\n\nCommand";
        let version = "LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd";
        assert_eq!(version_of(said).as_deref(), Some(version));
        assert_eq!(version_of("usage: something else"), None);
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
    fn what_the_plugin_says_last_counts() {
        let ours = "a warning\ngranlaw: no probe was written\n";
        assert_eq!(plugins_error(ours).unwrap(), "no probe was written");
    }
}
