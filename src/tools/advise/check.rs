//! Checks advice on the whole scene: the deck and the advised deck run, and their bulk observables and times are compared.
use super::bulk::{compare, Observable};
use super::ladder::Candidate;
use super::rewrite::RewriteError;
use crate::codes::liggghts::{Laws, Liggghts, Plugin, Preload};
use crate::codes::{run, Folder, Ran, Run, RunError};
use crate::deck::Deck;
use crate::probe::{Probe, ProbeError};
use crate::trace::{Header, LawSpec};
use rayon::prelude::*;
use serde::Serialize;
use std::time::Duration;
use thiserror::Error;

/// The result of a check.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    /// The advised deck.
    pub advised: String,
    /// How often each deck ran, every time with another seed.
    pub runs: usize,
    /// Bulk observables, of several runs their means.
    pub observables: Vec<Observable>,
    /// Largest difference that is allowed.
    pub bound: f64,
    /// Wall-clock times of the deck and of the advised one, without a probe \[s\].
    pub seconds: [f64; 2],
    /// The predicted time of the advised deck relative to the deck.
    pub predicted: Option<f64>,
}

impl Check {
    /// Whether every observable is within the bound.
    pub fn holds(&self) -> bool {
        !self.observables.is_empty() && self.observables.iter().all(|o| o.within(self.bound))
    }

    /// The measured time of the advised deck relative to the deck.
    pub fn measured(&self) -> f64 {
        self.seconds[1] / self.seconds[0]
    }
}

/// Why a check has no result.
#[derive(Debug, Error)]
pub enum CheckError {
    /// A run failed.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A run left no probe.
    #[error(transparent)]
    Probe(#[from] ProbeError),
    /// The advised deck cannot be made from the deck.
    #[error(transparent)]
    Rewrite(#[from] RewriteError),
    /// A file cannot be written.
    #[error("cannot write the deck: {0}")]
    Write(#[from] std::io::Error),
    /// The advised deck is not what was advised.
    #[error("the advised deck did not become what was advised: {0}; write it by hand and name it with --advised FILE")]
    Other(String),
    /// Two runs should have differed and did not.
    #[error("a run with {0} had the very contacts of the first; let the deck draw its start from a variable and name it with --fresh NAME=VALUE")]
    Same(String),
}

/// Runs a deck, and changed versions of it.
pub struct Runner<'a> {
    /// LIGGGHTS.
    pub host: &'a Liggghts,
    /// The plugin.
    pub plugin: &'a Plugin,
    /// The deck; the files beside it are there in each run.
    pub deck: &'a Deck,
    /// Time limit of a run.
    pub limit: Duration,
}

impl Runner<'_> {
    /// Runs this text in place of the deck, with a probe, and returns what the probe saw. `closely` follows all contacts.
    ///
    /// # Errors
    /// The run fails.
    pub fn probe(&self, text: &str, closely: bool) -> Result<Probe, CheckError> {
        let folder = self.folder(text)?;
        let path = folder.path().join("granlaw-probe.json");
        let preload =
            Preload { laws: Some(Laws::Stock), probe: Some(path.clone()), closely, ..self.preload() };
        self.run(&preload, &folder)?;
        Ok(Probe::read(&path)?)
    }

    /// The same for several texts. They run at the same time, unless each needs several processors.
    ///
    /// # Errors
    /// A run fails.
    pub fn probes(&self, texts: &[String], closely: bool) -> Result<Vec<Probe>, CheckError> {
        if self.deck.ranks > 1 {
            return texts.iter().map(|t| self.probe(t, closely)).collect();
        }
        texts.par_iter().with_max_len(1).map(|t| self.probe(t, closely)).collect()
    }

    /// The time of a run without a probe \[s\].
    ///
    /// # Errors
    /// The run fails.
    pub fn time(&self, text: &str) -> Result<f64, CheckError> {
        Ok(self.run(&self.preload(), &self.folder(text)?)?.seconds)
    }

    fn run(&self, preload: &Preload<'_>, folder: &Folder) -> Result<Ran, RunError> {
        run(self.host, &Run { deck: self.deck, environment: preload.env(), limit: self.limit }, folder)
    }

    fn folder(&self, text: &str) -> Result<Folder, CheckError> {
        let folder = Folder::new(self.deck)?;
        std::fs::write(folder.path().join(self.deck.file()), text)?;
        Ok(folder)
    }

    fn preload(&self) -> Preload<'_> {
        Preload { deck: Some(self.deck.file()), ..Preload::new(self.plugin, Laws::Own) }
    }
}

/// The deck with another value of a variable. The value is set in front, as a variable that is set already keeps its value.
pub fn with(deck: &str, variable: &str, value: &str) -> String {
    format!("variable {variable} index {value}\n{deck}")
}

/// The runs of the deck that the advised deck is compared with.
#[derive(Clone, Copy, Debug)]
pub struct Deeds<'a> {
    /// The run of the deck as it is.
    pub first: &'a Probe,
    /// Runs with other values of the variable. The advised deck is compared with each of them; if `values` is empty, there is
    /// one, which only shows how much two runs of the deck differ.
    pub others: &'a [Probe],
    /// The variable, and the values with which the advised deck runs too.
    pub variable: &'a str,
    /// See `variable`.
    pub values: &'a [String],
}

/// Runs the advised deck as often as the deck, and compares.
///
/// # Errors
/// A run fails, or the advised deck is not what `candidate` says; where `candidate` is `None` it is taken as it is.
pub fn check(
    runner: &Runner<'_>,
    (deck, advised): (&str, &str),
    did: Deeds<'_>,
    candidate: Option<&Candidate>,
    bound: f64,
) -> Result<Check, CheckError> {
    let varied = did.values.iter().map(|v| with(advised, did.variable, v));
    let runs =
        runner.probes(&std::iter::once(advised.to_string()).chain(varied).collect::<Vec<_>>(), false)?;
    let long = |p: &Probe| p.bulk.samples.last().map_or(0.0, |s| s.time);
    let a = long(did.first);
    for run in &runs {
        if let Some(candidate) = candidate {
            as_advised(run, candidate).map_err(CheckError::Other)?;
        }
        let b = long(run);
        if (a - b).abs() > 0.01 * a {
            return Err(CheckError::Other(format!("it ran for {b} s of the scene, the deck for {a} s")));
        }
    }
    let firsts: Vec<_> = std::iter::once(did.first).chain(did.others).map(|p| &p.bulk).collect();
    let seconds: Vec<_> = runs.iter().map(|p| &p.bulk).collect();
    let observables = compare(&firsts[..runs.len()], &seconds, firsts.get(1).copied());
    let seconds = [runner.time(deck)?, runner.time(advised)?];
    let predicted = candidate.and_then(|r| r.predicted);
    Ok(Check { advised: advised.into(), runs: runs.len(), observables, bound, seconds, predicted })
}

/// Whether LIGGGHTS resolved the laws, coefficients and step that were advised.
fn as_advised(probe: &Probe, candidate: &Candidate) -> Result<(), String> {
    for c in probe.principal() {
        let Some(h) = candidate.chains.iter().find(|h| h.who == c.header.who) else {
            return Err(format!("there is a chain {}", c.header.who));
        };
        let step = candidate.step.unwrap_or(h.dt);
        if (c.header.dt / step - 1.0).abs() > 1e-5 {
            return Err(format!("{}: the time step is {} s, not {step} s", h.who, c.header.dt));
        }
        same(h, &c.header).map_err(|what| format!("{}: {what}", h.who))?;
    }
    Ok(())
}

fn same(advised: &Header, run: &Header) -> Result<(), String> {
    let names = |h: &Header| h.laws.iter().map(|l| format!("{} {}", l.kind, l.keyword)).collect::<Vec<_>>();
    if names(advised) != names(run) {
        return Err(format!("its laws are {}, not {}", names(run).join(", "), names(advised).join(", ")));
    }
    for (a, b) in advised.laws.iter().zip(&run.laws) {
        let values = |l: &LawSpec| {
            let mut all: Vec<_> = l.properties.iter().map(|p| (p.name.clone(), p.values.clone())).collect();
            all.sort_by(|x, y| x.0.cmp(&y.0));
            all
        };
        if values(a) != values(b) {
            return Err(format!("{} {} has other properties", b.kind, b.keyword));
        }
        if let Some((name, option)) =
            b.settings.iter().find(|(n, o)| a.settings.get(*n).is_some_and(|x| x != *o))
        {
            return Err(format!("{} {} has {name} {option}", b.kind, b.keyword));
        }
    }
    Ok(())
}
