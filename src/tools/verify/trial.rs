//! One deck, with LIGGGHTS and plugin at hand.
use super::attempt::Attempt;
use super::checks::{self, Limit};
use super::{answers, two_body};
use crate::codes::liggghts::{Laws, Liggghts, Plugin, Preload};
use crate::codes::{run, Folder, Run, RunError};
use crate::deck::{Asked, Deck, Final, What};
use crate::report::{Case, Curve, Shows};
use std::path::PathBuf;
use std::time::{Duration, Instant};

const RECORDED: &str = "the same laws give the same bits whether or not their calls are recorded";

/// What every case needs.
pub(super) struct Bench<'a> {
    pub host: &'a Liggghts,
    pub plugin: &'a Plugin,
    pub limit: Duration,
    pub lanes: &'a str,
}

/// A run that ends the case: which, and why.
struct Stopped(&'static str, RunError);

/// The case so far.
struct Trial<'a> {
    bench: &'a Bench<'a>,
    deck: &'a Deck,
    first: Option<Deck>,
    /// Whose laws run where ours stay out: `None`, LIGGGHTS alone, unless it lacks laws of the deck.
    plain: Option<Laws>,
    case: Case,
}

impl Bench<'_> {
    /// Everything that the deck asks for. Only an interruption is an error: whatever else goes wrong is a result.
    pub fn case(&self, name: &str, deck: &Deck) -> Result<Case, RunError> {
        let begun = Instant::now();
        let path = deck.path.display().to_string();
        let case = Case { name: name.into(), title: deck.title.clone(), deck: path, ..Case::default() };
        let first = deck.first().map_err(|e| RunError::Deck(e.to_string()))?;
        let mut trial = Trial { bench: self, deck, first, plain: None, case };
        match trial.run() {
            Ok(()) => {}
            Err(Stopped(_, RunError::Interrupted)) => return Err(RunError::Interrupted),
            Err(Stopped(which, error)) => {
                trial.case.log = error.log().map(str::to_string);
                trial.case.checks.push(checks::could_not(which, Shows::Boundary, error.to_string()));
            }
        }
        trial.case.seconds = begun.elapsed().as_secs_f64();
        Ok(trial.case)
    }
}

impl Trial<'_> {
    fn run(&mut self) -> Result<(), Stopped> {
        let deck = self.deck;
        let stock = self.plainly().map_err(|e| Stopped("stock run", e))?;
        let recorded =
            self.attempt(self.plain, Some((Laws::Stock, true))).map_err(|e| Stopped("recorded run", e))?;
        self.recorded(&stock, &recorded);
        for asked in &deck.checks {
            match &asked.what {
                What::Replay { limit } => self.replay(&recorded.ran.traces, Limit::new(*limit, asked)),
                What::Plugin => self.plugin(&stock, &recorded, asked)?,
                What::TwoBody { limit } => {
                    let (check, curve) = two_body::check(&recorded.ran.traces, Limit::new(*limit, asked));
                    self.case.checks.push(check);
                    self.case.curves.extend(curve);
                }
                What::Final(wanted) => self.last(&stock, wanted, asked),
                What::SameAs { deck } => self.same_as(deck, &stock, asked)?,
            }
        }
        Ok(())
    }

    /// The run that the others are held against: LIGGGHTS alone, or with the plugin where the deck has laws that only
    /// granlaw has.
    fn plainly(&mut self) -> Result<Attempt, RunError> {
        match self.attempt(None, None) {
            Err(e) if e.lacks_model() => {
                self.plain = Some(Laws::Own);
                self.attempt(self.plain, Some((Laws::Own, false)))
            }
            run => run,
        }
    }

    /// One run from the beginning: the deck before this one, if there is one, then this one. `first` and `mode` say
    /// whose laws run in each, and whether this one is recorded; `None` is LIGGGHTS alone.
    fn attempt(&self, first: Option<Laws>, mode: Option<(Laws, bool)>) -> Result<Attempt, RunError> {
        let Bench { host, plugin, limit, lanes } = *self.bench;
        let preload = |deck: &Deck, laws, record: bool| Preload {
            record: record.then(Folder::record),
            every: Some(deck.every),
            deck: Some(deck.file()),
            lanes: Some(lanes.into()),
            ..Preload::new(plugin, laws)
        };
        let folder = Folder::new(self.deck)?;
        let run = |deck: &Deck, preload: Option<Preload<'_>>| {
            let environment = preload.map(|p| p.env()).unwrap_or_default();
            run(host, &Run { deck, environment, limit }, &folder)
        };
        if let Some(before) = &self.first {
            run(before, first.map(|laws| preload(before, laws, false)))?;
        }
        let ran = run(self.deck, mode.map(|(laws, record)| preload(self.deck, laws, record)))?;
        Ok(Attempt { folder, ran })
    }

    /// What the traces say of the chain, and whether recording left the run as it was.
    fn recorded(&mut self, stock: &Attempt, recorded: &Attempt) {
        let name = "recorded";
        let traces = &recorded.ran.traces;
        let (calls, touches) = match answers::describe(traces, &mut self.case) {
            Ok(counts) => counts,
            Err(why) => return self.case.checks.push(checks::could_not(name, Shows::Boundary, why)),
        };
        self.case.calls = calls;
        let check = match () {
            _ if touches == 0 => checks::could_not(
                name,
                Shows::Boundary,
                "no contact: no two surfaces touched in a recorded step and no bond held, so nothing is proved; let them meet, or record more steps (# granlaw: every)",
            ),
            _ if stock.ran.dumps.is_empty() => {
                checks::skipped(name, Shows::Boundary, "the deck writes no text dump to compare")
            }
            _ => answers::dumps(name, Shows::Boundary, RECORDED, recorded, stock),
        };
        self.case.checks.push(check);
    }

    fn replay(&mut self, traces: &[PathBuf], limit: Limit<'_>) {
        // Laws that LIGGGHTS lacks were recorded as the plugin ran them.
        let shows = if self.plain.is_none() { Shows::Port } else { Shows::Boundary };
        let (check, curves) = answers::replay(traces, shows, limit);
        self.case.checks.push(check);
        self.case.curves.splice(0..0, curves);
    }

    /// The run on the Rust laws. Where the deck continues another, either may run on either's laws.
    fn plugin(&mut self, stock: &Attempt, recorded: &Attempt, asked: &Asked) -> Result<(), Stopped> {
        let (rust, plain) = (Some((Laws::Rust, false)), self.plain.map(|laws| (laws, false)));
        let runs: &[_] = match self.first {
            None => &[("plugin", None, rust)],
            Some(_) => &[
                ("plugin, stock then Rust", self.plain, rust),
                ("plugin, Rust then stock", Some(Laws::Rust), plain),
                ("plugin, Rust then Rust", Some(Laws::Rust), rust),
            ],
        };
        let traced = self.attempt(self.plain, Some((Laws::Rust, true))).map_err(|e| Stopped("plugin", e))?;
        let (difference, curves) = answers::traces(&traced.ran.traces, &recorded.ran.traces);
        let stocked = self.case.curves.iter().any(|c| c.answer == "stock");
        self.case.curves.extend(curves.into_iter().filter(|c: &Curve| !stocked || c.answer != "stock"));
        if stock.ran.dumps.is_empty() {
            let reason =
                format!("{} (the deck writes no dump: every recorded call is compared)", asked.reason);
            self.case.checks.push(checks::identical("plugin", Shows::Boundary, &reason, difference));
            return Ok(());
        }
        // The dumps say where the runs part, the traces where they are furthest apart.
        let furthest = difference.and_then(|(_, worst)| worst);
        for (name, first, mode) in runs {
            let ran = self.attempt(*first, *mode).map_err(|e| Stopped("plugin", e))?;
            let mut check = answers::dumps(name, Shows::Boundary, &asked.reason, &ran, stock);
            if *mode == rust && check.worst.is_some() {
                check.worst = furthest.clone().or(check.worst);
            }
            self.case.checks.push(check);
        }
        Ok(())
    }

    /// Another deck, run plainly, must have dumped the same.
    fn same_as(&mut self, other: &str, stock: &Attempt, asked: &Asked) -> Result<(), Stopped> {
        let name = format!("same as {other}");
        let failed = |e| Stopped("run to compare with", e);
        let deck = Deck::read(&self.deck.folder().join(other));
        let deck = deck.map_err(|e| failed(RunError::Deck(e.to_string())))?;
        let mut there =
            Trial { bench: self.bench, deck: &deck, first: None, plain: None, case: Case::default() };
        let ran = there.plainly().map_err(failed)?;
        // Where LIGGGHTS alone lacks laws of the other deck too, two of our own are compared.
        let shows = if there.plain.is_none() { Shows::Port } else { Shows::Boundary };
        let check = if ran.ran.dumps.is_empty() {
            checks::could_not(
                &name,
                shows,
                format!("{other} writes no text dump to compare; add a dump custom"),
            )
        } else {
            answers::dumps(&name, shows, &asked.reason, stock, &ran)
        };
        self.case.checks.push(check);
        Ok(())
    }

    fn last(&mut self, stock: &Attempt, wanted: &Final, asked: &Asked) {
        self.case.checks.push(answers::last(stock, wanted, Limit::new(wanted.limit, asked)));
    }
}
