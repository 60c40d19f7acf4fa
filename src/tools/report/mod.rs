//! One typed [`Report`], and one writer for each format. Nothing here depends on physics.
//!
//! [`write_all`] makes the folder: `index.html` for people, `report.md` for pull requests, `report.json` and
//! `junit.xml` for programs, `csv/<case>.csv` with the numbers behind the plots.
mod axis;
mod csv;
mod escape;
mod figures;
mod folder;
mod frame;
mod html;
mod json;
mod junit;
mod markdown;
mod numbers;
pub mod page;
mod plot;
mod summary;
mod write;

pub(crate) use escape::rough;

pub use folder::{ReportError, Writer};
use serde::Serialize;
pub use write::{check_target, write_all};

/// What `granlaw verify` found, case by case.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Report {
    /// The programs that were compared, and the machine.
    pub about: About,
    /// One entry per deck, in the order given.
    pub cases: Vec<Case>,
}

/// The programs behind a report.
#[derive(Clone, Debug, Default, Serialize)]
pub struct About {
    /// Version of granlaw.
    pub granlaw: String,
    /// The version of LIGGGHTS, in its own words; `None` if it was not found.
    pub liggghts: Option<String>,
    /// The plugin that was preloaded; `None` if there was none.
    pub plugin: Option<String>,
    /// Operating system, architecture and number of cores.
    pub machine: String,
    /// The command line that made the report.
    pub command: String,
    /// What the whole run left out, and why.
    pub notes: Vec<String>,
}

/// One deck.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Case {
    /// File name of the deck without its extension; the writers add `-2`, `-3` … where two decks share it.
    pub name: String,
    /// Its title, one line.
    pub title: String,
    /// Path of the deck as given.
    pub deck: String,
    /// The laws of the chain, for instance `normal hooke/hysteresis`.
    pub laws: Vec<String>,
    /// Coefficients as LIGGGHTS resolved them.
    pub parameters: Vec<Parameter>,
    /// What was checked.
    pub checks: Vec<Check>,
    /// Histories to plot, one per answer. They are long: `report.json` leaves them to `csv/<case>.csv`.
    #[serde(skip)]
    pub curves: Vec<Curve>,
    /// Contact calls that were compared.
    pub calls: u64,
    /// Wall-clock time of the case \[s\].
    #[serde(serialize_with = "numbers::number")]
    pub seconds: f64,
    /// The output of LIGGGHTS, kept if a run failed.
    pub log: Option<String>,
}

/// One coefficient of the chain.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Parameter {
    /// The name in the deck, for instance `youngsModulus`.
    pub name: String,
    /// The usual symbol.
    pub symbol: String,
    /// SI unit, `1` where there is none.
    pub unit: String,
    /// `scalar`, `per type` or `per type pair`.
    pub shape: String,
    /// The values, row by row.
    #[serde(serialize_with = "numbers::numbers")]
    pub values: Vec<f64>,
}

/// One comparison.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    /// Short name, for instance `replay`.
    pub name: String,
    /// What agreement proves.
    pub shows: Shows,
    /// How it ended.
    pub outcome: Outcome,
    /// The limit and why it is what it is.
    pub tolerance: Option<Tolerance>,
    /// Where the two answers are furthest apart.
    pub worst: Option<Worst>,
}

/// What agreement of two answers proves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Shows {
    /// The Rust law does what LIGGGHTS's own law does.
    Port,
    /// The plugin hands LIGGGHTS what the law computed.
    Boundary,
    /// The time integration is understood.
    Integrator,
    /// The answer is right: a closed form or another independent source.
    Physics,
}

/// How a comparison ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "is", content = "why", rename_all = "kebab-case")]
pub enum Outcome {
    /// Within the tolerance.
    Agreed,
    /// Outside the tolerance; the text says by how much and where.
    Disagreed(String),
    /// Not made; the text says why.
    Skipped(String),
    /// Could not be made; the text says what to do.
    CouldNotRun(String),
}

/// A limit with its reason.
#[derive(Clone, Debug, Serialize)]
pub struct Tolerance {
    /// The limit; 0 means identical to the last bit.
    #[serde(serialize_with = "numbers::number")]
    pub limit: f64,
    /// Why this limit and no other.
    pub reason: String,
}

/// Where two answers are furthest apart.
#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    /// Time step.
    pub step: i64,
    /// What was compared there, for instance `f_i.x of 1-2`.
    pub what: String,
    /// The answer on trial.
    #[serde(serialize_with = "numbers::number")]
    pub got: f64,
    /// The reference answer.
    #[serde(serialize_with = "numbers::number")]
    pub expected: f64,
    /// The error in the norm of the check.
    #[serde(serialize_with = "numbers::number")]
    pub error: f64,
    /// The norm, for instance `relative to the peak force`.
    pub norm: String,
}

/// The history of one contact in one answer.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Whose answer: `stock`, `replay`, `plugin` or `two-body`.
    pub answer: String,
    /// Time \[s\].
    pub time: Vec<f64>,
    /// Overlap \[m\].
    pub overlap: Vec<f64>,
    /// Normal force \[N\], positive when it pushes the two apart.
    pub force: Vec<f64>,
    /// Difference from stock relative to the peak force; empty for stock itself.
    pub error: Vec<f64>,
}

/// Counts over a whole report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Checks that agreed.
    pub agreed: usize,
    /// Checks that disagreed.
    pub disagreed: usize,
    /// Checks that were skipped.
    pub skipped: usize,
    /// Checks that could not run.
    pub could_not_run: usize,
}

impl Case {
    /// The worst outcome of the case: could not run, then disagreed, then agreed; a case whose checks were all
    /// skipped, or that has none, could not run.
    pub fn verdict(&self) -> Outcome {
        let find = |f: fn(&Outcome) -> bool| self.checks.iter().map(|c| &c.outcome).find(|o| f(o)).cloned();
        find(|o| matches!(o, Outcome::CouldNotRun(_)))
            .or_else(|| find(|o| matches!(o, Outcome::Disagreed(_))))
            .or_else(|| find(|o| matches!(o, Outcome::Agreed)))
            .unwrap_or_else(|| Outcome::CouldNotRun("nothing was checked".into()))
    }
}

impl Report {
    /// Counts the checks by outcome.
    pub fn counts(&self) -> Counts {
        let mut n = Counts::default();
        for check in self.cases.iter().flat_map(|c| &c.checks) {
            match check.outcome {
                Outcome::Agreed => n.agreed += 1,
                Outcome::Disagreed(_) => n.disagreed += 1,
                Outcome::Skipped(_) => n.skipped += 1,
                Outcome::CouldNotRun(_) => n.could_not_run += 1,
            }
        }
        n
    }

    /// The exit code: 0 all agreed, 1 something disagreed, 2 something could not run (2 wins).
    pub fn exit_code(&self) -> u8 {
        let verdicts: Vec<_> = self.cases.iter().map(Case::verdict).collect();
        match () {
            _ if verdicts.is_empty() || verdicts.iter().any(|v| matches!(v, Outcome::CouldNotRun(_))) => 2,
            _ if verdicts.iter().any(|v| matches!(v, Outcome::Disagreed(_))) => 1,
            _ => 0,
        }
    }
}
