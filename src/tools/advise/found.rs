//! Advice, and whether it holds.
use super::check::Check;
use super::fresh::Fresh;
use super::group::Group;
use super::ladder::Candidate;
use super::lines::Line;
use super::options::Options;
use super::rank::Term;
use serde::Serialize;

/// Advice on a scene.
#[derive(Debug, Serialize)]
pub struct Advice {
    /// File name of the deck.
    pub deck: String,
    /// Time step of the run \[s\].
    pub dt: f64,
    /// The accuracy that was asked for.
    pub options: Options,
    /// What each term contributes, the largest first.
    pub terms: Vec<Term>,
    /// The classes of contacts that were repeated with other laws and steps.
    pub groups: Vec<Group>,
    /// The shares of all impacts and of all momentum that these classes stand for, in chains in which changes were tried.
    pub covered: (f64, f64),
    /// Laws that act across gaps, in words, with how much they were at work.
    pub untried: Vec<String>,
    /// The models on trial; the first is the deck as it is.
    pub ladder: Vec<Candidate>,
    /// Index of the recommended model in `ladder`; `None` if not even the deck's own is good enough in any step.
    pub chosen: Option<usize>,
    /// Lines for the deck.
    pub lines: Vec<Line>,
    /// The reasons, in sentences with numbers.
    pub reasons: Vec<String>,
}

/// Advice, with the results of its checks.
#[derive(Debug, Serialize)]
pub struct Found {
    /// The advice.
    pub advice: Advice,
    /// The deck and the advised deck, each run in full.
    pub check: Option<Check>,
    /// The advised model on contacts of another run.
    pub fresh: Option<Fresh>,
}

impl Found {
    /// Whether there is advice and it passed every check that was made.
    pub fn holds(&self) -> bool {
        self.advice.chosen.is_some()
            && self.check.as_ref().is_none_or(Check::holds)
            && self.fresh.as_ref().is_none_or(Fresh::holds)
    }
}
