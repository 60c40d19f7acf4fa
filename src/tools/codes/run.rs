//! A deck runs on a code, and what it leaves behind.
use super::code::Code;
use super::folder::Folder;
use super::launch::{command, Around};
use super::process::{self, End};
use super::said::{last_read, Said};
use super::times::Times;
use super::RunError;
use crate::deck::Deck;
use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// One run of a deck, in a [`Folder`] that holds its files.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    /// The deck, which says on how many ranks and with which variables it runs.
    pub deck: &'a Deck,
    /// Variables of environment that this run gets beside those that every run gets.
    pub environment: Vec<(&'static str, String)>,
    /// How long it may take.
    pub limit: Duration,
}

/// What a run left behind.
#[derive(Clone, Debug)]
pub struct Ran {
    /// Wall-clock time \[s\].
    pub seconds: f64,
    /// What the code says of the time of each of its runs.
    pub times: Vec<Times>,
    /// The text dumps that it wrote, relative to the folder, in alphabetic order.
    pub dumps: Vec<PathBuf>,
    /// The traces that it wrote, in alphabetic order.
    pub traces: Vec<PathBuf>,
    /// The warnings that the code printed.
    pub warnings: Vec<String>,
    /// Its log.
    pub log: String,
}

/// Run a deck on a code; the one way in which a code is run where its answer counts.
///
/// # Errors
/// The code cannot be started, fails, or runs past the limit; nothing that it started is left running.
pub fn run(code: &dyn Code, run: &Run<'_>, folder: &Folder) -> Result<Ran, RunError> {
    let before = folder.files()?;
    let outputs = folder.outputs();
    let [out, err] = outputs.each_ref().map(|p| File::create(p).map_err(RunError::io("create", p)));
    let mut command = command(code.program(), run.deck.ranks, Around::Made, &run.environment)?;
    command.args(code.arguments(run.deck)).current_dir(folder.path());
    // MPI keeps a folder of its own, and leaves it where it is stopped.
    command.env("TMPDIR", folder.around());
    command.stdin(Stdio::null()).stdout(out?).stderr(err?);
    let begun = Instant::now();
    let end = process::run(&mut command, run.limit).map_err(RunError::io("start", code.program()))?;
    let read = |path: PathBuf| code.text(&fs::read(path).unwrap_or_default());
    let [out, err] = outputs.map(read);
    let said = Said { log: read(folder.path().join(code.log())), out, err };
    judge(code, run, &said, end)?;
    let (dumps, traces) = folder.written_since(&before)?;
    let (times, warnings) = (code.times(&said), said.warnings());
    Ok(Ran {
        seconds: begun.elapsed().as_secs_f64(),
        times,
        dumps,
        traces,
        warnings,
        log: said.main().into(),
    })
}

/// Whether the run is good.
fn judge(code: &dyn Code, run: &Run<'_>, said: &Said, end: End) -> Result<(), RunError> {
    let text = fs::read(&run.deck.path).unwrap_or_default();
    let at = last_read(&String::from_utf8_lossy(&text), &said.log);
    let (deck, log) = (run.deck.path.display().to_string(), said.tail(code.log()));
    match end {
        // The loader only grumbles and goes on without it; what ran then was not what was asked for.
        End::Exited(_) if said.err.contains("cannot be preloaded") => {
            let grumble = said.err.lines().find(|l| l.contains("cannot be preloaded")).unwrap_or_default();
            Err(RunError::Failed { deck, at: None, message: grumble.trim().into(), log })
        }
        End::Exited(status) if status.success() => Ok(()),
        End::Interrupted => Err(RunError::Interrupted),
        End::TimedOut => Err(RunError::TimedOut { deck, at, seconds: run.limit.as_secs_f64(), log }),
        End::Exited(status) => {
            let name = code.name();
            let how = match (status.signal(), status.code()) {
                (Some(signal), _) => format!("{name} was ended by signal {signal}"),
                (_, code) => format!("{name} ended with status {}", code.unwrap_or(-1)),
            };
            let message = code.error(said).unwrap_or_else(|| format!("{how} and gave no reason"));
            Err(RunError::Failed { deck, at, message, log })
        }
    }
}
