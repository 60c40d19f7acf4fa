//! What was found, and whether it holds.
use super::check::Check;
use super::fresh::Fresh;
use super::group::Group;
use super::ladder::Rung;
use super::lines::Line;
use super::options::Options;
use super::rank::Term;
use serde::Serialize;

/// What was found.
#[derive(Debug, Serialize)]
pub struct Advice {
    /// File name of the deck.
    pub deck: String,
    /// Time step of the run \[s\].
    pub dt: f64,
    /// What was asked for.
    pub options: Options,
    /// What each term contributes, the largest first.
    pub terms: Vec<Term>,
    /// The classes of contacts that were lived through again.
    pub groups: Vec<Group>,
    /// Share of impacts, and of the momentum of all contacts, that they stand for, where changes are tried.
    pub covered: (f64, f64),
    /// Laws that act across gaps, in words with what was measured of them.
    pub untried: Vec<String>,
    /// The models on trial; the first is the deck as it is.
    pub ladder: Vec<Rung>,
    /// The one that is recommended, by its place; `None` if not even the deck's own is good enough in any step.
    pub chosen: Option<usize>,
    /// Lines for the deck.
    pub lines: Vec<Line>,
    /// Why, in sentences with numbers.
    pub reasons: Vec<String>,
}

/// Advice, with what came of holding it to the scene.
#[derive(Debug, Serialize)]
pub struct Found {
    /// The advice.
    pub advice: Advice,
    /// The deck and the advised deck in full.
    pub check: Option<Check>,
    /// Contacts of another run.
    pub fresh: Option<Fresh>,
}

impl Found {
    /// Whether there is advice, and it holds wherever it was held to something.
    pub fn holds(&self) -> bool {
        self.advice.chosen.is_some()
            && self.check.as_ref().is_none_or(Check::holds)
            && self.fresh.as_ref().is_none_or(Fresh::holds)
    }
}
