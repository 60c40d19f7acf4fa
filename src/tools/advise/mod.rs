//! Advice on a scene: how simple a model is good enough for it, and how large a step.
//!
//! A [`Probe`] says what the contacts of a scene do. Its examples are repeated by two bodies alone, with simpler chains
//! and with larger steps. What stays within the accuracy asked for, in every important class of contacts, is good enough. Nothing is
//! recommended that was not tried, and every recommendation comes with its measurement.
pub mod bulk;
mod change;
pub mod check;
mod classes;
mod cost;
mod errors;
mod fit;
mod found;
pub mod fresh;
mod group;
mod ladder;
mod lines;
pub mod loaded;
mod options;
mod page;
mod rank;
mod reasons;
pub mod rewrite;
pub mod rules;
mod run_time;
mod scene;
pub mod seeds;
pub mod simulated;
mod terminal;

pub use change::Change;
pub use errors::Errors;
pub use found::{Advice, Found};
pub use group::{Contacts, Group};
pub use ladder::{Candidate, Trial};
pub use lines::Line;
pub use options::Options;
pub use page::page;
pub use rank::{rank, Term};
pub use run_time::RunTime;
pub use scene::Scene;
pub use terminal::text;

use crate::probe::Probe;
use crate::trace::HeaderError;
use thiserror::Error;

/// Why there is no advice.
#[derive(Debug, Error)]
pub enum AdviceError {
    /// Nothing touched.
    #[error("no contact was seen, so there is nothing to advise on; probe a run in which surfaces touch")]
    NoContact,
    /// No class of contacts has an example.
    #[error("{calls} contact calls were seen, but no contact began and ended, or lasted, so that it could be repeated; probe a longer run")]
    NoExample {
        /// How many calls.
        calls: u64,
    },
    /// Too much of the scene is in classes too small to count, or in contacts that were not seen whole.
    #[error(
        "the classes of contacts that can be repeated stand for {:.0} % of the impacts and {:.0} % of the momentum \
         exchanged; advice needs {:.0} % of both; probe a longer run", 100.0 * .0, 100.0 * .1, 100.0 * rules::COVERED
    )]
    Covered(f64, f64),
    /// Contacts that the probe could not count.
    #[error("the contacts of {} were not seen, as granlaw has a twin of none of their laws (granlaw laws lists them), so that nothing can be said of them", .0.join(", "))]
    Unseen(Vec<String>),
    /// A law has no Rust twin.
    #[error("what the contacts do is known, but simpler models cannot be tried: {0}")]
    Laws(#[from] HeaderError),
}

/// Gives advice from a probe.
///
/// # Errors
/// There is nothing to advise on, or the laws are not granlaw's.
pub fn advise(probe: &Probe, options: Options) -> Result<(Advice, Scene), AdviceError> {
    if !probe.unseen.is_empty() {
        return Err(AdviceError::Unseen(probe.unseen.clone()));
    }
    let calls: u64 = probe.chains.iter().map(|c| c.calls).sum();
    if calls == 0 {
        return Err(AdviceError::NoContact);
    }
    let scene = Scene::of(probe)?;
    if scene.groups.is_empty() && scene.untried.is_empty() {
        return Err(AdviceError::NoExample { calls });
    }
    let (impacts, momentum) = scene.covered;
    if !scene.groups.is_empty() && impacts.min(momentum) < rules::COVERED {
        return Err(AdviceError::Covered(impacts, momentum));
    }
    let ladder = ladder::climb(&scene, &options)?;
    let chosen = choose(&ladder);
    let lines = chosen.map_or(Vec::new(), |k| lines::lines(&scene, &ladder[k]));
    let mut advice = Advice {
        deck: scene.chains[0].deck.clone(),
        dt: scene.dt(),
        options,
        terms: rank(probe),
        groups: scene.groups.clone(),
        covered: scene.covered,
        untried: scene.untried.iter().map(|(k, law)| measured(&probe.principal()[*k], law)).collect(),
        ladder,
        chosen,
        lines,
        reasons: Vec::new(),
    };
    advice.reasons = reasons::reasons(&advice);
    Ok((advice, scene))
}

/// What a probe says of a law, in words.
fn measured(c: &crate::probe::Contacts, law: &str) -> String {
    let at = c.header.laws.iter().position(|l| l.keyword == law).unwrap_or(0);
    let shares = || c.pairs.iter().filter_map(|p| p.laws.get(at));
    let branch = |wanted: &dyn Fn(&str) -> bool| -> f64 {
        shares().flat_map(|s| s.branches.iter()).filter(|(b, _)| wanted(b)).map(|(_, t)| t).sum()
    };
    let (all, idle) = (branch(&|_| true), branch(&|b| b == "unbonded"));
    let loads = c.pairs.iter().flat_map(|p| [&p.load, &p.gaps.load]);
    let used = loads.filter_map(|load| load.range()).map(|(_, most)| most).fold(0.0, f64::max);
    let impulse: f64 = shares().map(|s| s.impulse).sum();
    let whole: f64 = c.pairs.iter().flat_map(|p| &p.laws).map(|s| s.impulse).sum();
    let share = |x: f64, of: f64| if of > 0.0 { lines::percent(x / of) } else { lines::percent(0.0) };
    let strength =
        if used > 0.0 { format!(", up to {} of its strength", lines::percent(used)) } else { String::new() };
    format!(
        "{law} ({}: at work in {} of the contact time seen, {} of the momentum{strength})",
        c.header.who,
        share(all - idle, all),
        share(impulse, whole),
    )
}

/// The index of the simplest of the models that hold and whose predicted time is about the least.
fn choose(ladder: &[Candidate]) -> Option<usize> {
    let time = |k: &usize| ladder[*k].predicted.unwrap_or(f64::INFINITY);
    let holding = || (0..ladder.len()).filter(|k| time(k).is_finite());
    let least = holding().map(|k| time(&k)).fold(f64::INFINITY, f64::min);
    let fast = holding().filter(|k| time(k) <= (1.0 + rules::EQUAL) * least);
    fast.min_by(|a, b| ladder[*a].size().cmp(&ladder[*b].size()).then(time(a).total_cmp(&time(b))))
}
