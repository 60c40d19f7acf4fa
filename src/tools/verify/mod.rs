//! The main job: decks in, a verdict on each out.
//!
//! Every deck runs on LIGGGHTS's own laws, once alone and once recorded; the recorded calls are replayed through the
//! Rust laws; the deck runs on the Rust laws inside LIGGGHTS; two free particles are integrated by our own code. Which of
//! the answers differ tells whether the law, the boundary or the integration is at fault.
use crate::codes::liggghts::{Liggghts, Plugin};
use crate::codes::RunError;
use crate::deck::Deck;
use crate::report::{About, Case, Report};
use rayon::prelude::*;
use std::path::PathBuf;
use std::time::Duration;

mod answers;
mod attempt;
mod checks;
mod error;
mod offline;
mod trial;
mod two_body;

pub use error::VerifyError;

/// What to verify, and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// Decks, and folders of decks.
    pub decks: Vec<PathBuf>,
    /// How many decks run at the same time; 0 stands for one per core.
    pub jobs: usize,
    /// `(k, n)`: only every n-th deck, beginning with the k-th, from 1.
    pub shard: Option<(usize, usize)>,
    /// The longest that a single run may take.
    pub limit: Duration,
    /// How many contacts of the Rust laws go side by side: 1, 4, 8 or `widest`.
    pub lanes: String,
    /// Whether to refuse to go on without LIGGGHTS and plugin.
    pub require_liggghts: bool,
    /// The command line, for the report.
    pub command: String,
}

/// A verification that is ready to begin.
pub struct Plan {
    options: Options,
    decks: Vec<(String, Deck)>,
    tools: Result<(Liggghts, Plugin), RunError>,
}

impl Plan {
    /// Read the decks and look for LIGGGHTS and plugin, so that what is wrong is known before anything runs.
    ///
    /// # Errors
    /// A deck cannot be used; the plugin is of another version; LIGGGHTS or plugin is missing and required.
    pub fn new(options: Options) -> Result<Plan, VerifyError> {
        let paths = Deck::find(&options.decks)?;
        let read = paths.iter().map(|p| Deck::read(p)).collect::<Result<Vec<_>, _>>()?;
        let all = read.len();
        let mut decks = named(read);
        if let Some((k, n)) = options.shard {
            decks = decks.into_iter().skip(k - 1).step_by(n).collect();
            if decks.is_empty() {
                return Err(VerifyError::EmptyShard { k, n, decks: all });
            }
        }
        let tools = match Liggghts::find().and_then(|host| Ok((host, Plugin::find()?))) {
            Err(e @ (RunError::NoProgram { .. } | RunError::NoPlugin { .. }))
                if !options.require_liggghts =>
            {
                Err(e)
            }
            found => Ok(found?),
        };
        Ok(Plan { options, decks, tools })
    }

    /// How many cases there are.
    pub fn cases(&self) -> usize {
        self.decks.len()
    }

    /// The plugin that is used.
    pub fn plugin(&self) -> Option<&Plugin> {
        self.tools.as_ref().ok().map(|t| &t.1)
    }

    /// What is missing, if anything is.
    pub fn missing(&self) -> Option<&RunError> {
        self.tools.as_ref().err()
    }

    /// Runs all cases; `done` is called for each when it is finished.
    ///
    /// # Errors
    /// There is neither LIGGGHTS nor a recorded trace, or it was interrupted.
    pub fn run(&self, done: &(dyn Fn(&Case) + Sync)) -> Result<Report, VerifyError> {
        let mut about = self.about();
        let cases = match &self.tools {
            Ok((host, plugin)) => {
                about.liggghts = Some(host.version.clone());
                about.plugin = Some(format!("{} for LIGGGHTS {}", plugin.path.display(), plugin.liggghts));
                let (limit, lanes) = (self.options.limit, self.options.lanes.as_str());
                self.live(&trial::Bench { host, plugin, limit, lanes }, done)?
            }
            Err(missing) => {
                let cases = offline::cases(missing)?;
                cases.iter().for_each(done);
                about.notes = offline::notes(missing, &self.decks, cases.len());
                cases
            }
        };
        Ok(Report { about, cases })
    }

    fn live(
        &self,
        bench: &trial::Bench<'_>,
        done: &(dyn Fn(&Case) + Sync),
    ) -> Result<Vec<Case>, VerifyError> {
        let jobs = self.options.jobs;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
        let pool = pool.map_err(|e| VerifyError::Threads { jobs, why: e.to_string() })?;
        let one = |(name, deck): &(String, Deck)| {
            let case = bench.case(name, deck)?;
            done(&case);
            Ok(case)
        };
        // One deck at a time per thread: decks differ much in length.
        pool.install(|| self.decks.par_iter().with_max_len(1).map(one).collect())
    }

    fn about(&self) -> About {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
        About {
            granlaw: env!("CARGO_PKG_VERSION").into(),
            machine: format!("{os} {arch}, {cores} cores"),
            command: self.options.command.clone(),
            ..About::default()
        }
    }
}

/// A name for each deck: its file name without extension, with a number where that is not unique.
fn named(decks: Vec<Deck>) -> Vec<(String, Deck)> {
    let mut named: Vec<(String, Deck)> = Vec::with_capacity(decks.len());
    for deck in decks {
        let stem = deck.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let safe = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' };
        let stem: String = stem.chars().map(safe).collect();
        let numbers = std::iter::once(stem.clone()).chain((2..).map(|n| format!("{stem}-{n}")));
        let name = numbers.into_iter().find(|name| named.iter().all(|(known, _)| known != name));
        named.push((name.unwrap_or(stem), deck));
    }
    named
}
