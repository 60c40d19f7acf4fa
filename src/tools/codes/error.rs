//! Why a run failed, in the code's own words and with the line of the deck.
use crate::probe::ProbeError;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why there is no result.
#[derive(Debug, Error)]
pub enum RunError {
    /// A code is not installed.
    #[error("{program} is not in PATH; {install}")]
    NoProgram {
        /// Its program.
        program: &'static str,
        /// How to install it.
        install: &'static str,
    },
    /// Something else has the name of a code's program.
    #[error("{} does not answer -h as {code} does but says {said:?}; put {code} first in PATH, or mend what keeps it from starting", program.display())]
    WrongProgram {
        /// The code.
        code: &'static str,
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
    #[error("the plugin {} {why}; build it from the same source as this granlaw (ABI version {abi}) where libliggghts-dev is installed, or name another in GRANLAW_PLUGIN", path.display())]
    WrongPlugin {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
        /// The ABI version that it should have.
        abi: u32,
    },
    /// The files of the deck cannot be had.
    #[error("{0}")]
    Deck(String),
    /// The code refused the deck or died.
    #[error("{deck}{}: {message}", place(at))]
    Failed {
        /// Path of the deck.
        deck: String,
        /// The line of the deck that was read last, with its text.
        at: Option<(usize, String)>,
        /// The code's own error.
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
        /// The line of the deck that was read last, with its text.
        at: Option<(usize, String)>,
        /// The limit \[s\].
        seconds: f64,
        /// The end of what it said.
        log: String,
    },
    /// What the run should have left is not there or not whole.
    #[error(transparent)]
    Probe(#[from] ProbeError),
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

    /// The end of what the code said, where it ran.
    pub fn log(&self) -> Option<&str> {
        match self {
            RunError::Failed { log, .. } | RunError::TimedOut { log, .. } => Some(log),
            _ => None,
        }
    }
}
