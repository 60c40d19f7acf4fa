//! The runs, round by round.
use super::account::{lanes, Account};
use super::{Options, Scene, Side, Timed};
use crate::codes::liggghts::{Laws, Liggghts, Plugin, Preload, Route};
use crate::codes::{self, Code, Folder, Ran, Run, RunError, Times};
use crate::compare;
use crate::deck::{Deck, DeckError};
use crate::report::Outcome;
use std::fs;
use std::path::{Path, PathBuf};

/// What a deck says where its two sides are not the same law; it sees its side in the variable `rust`, 0 or 1.
const DIFFERS: &str = "# bench: dumps differ";
/// What a deck says where the law that takes stock's place is ours too.
const BOTH_OURS: &str = "# bench: plugin on both sides";
/// What the plugin says where a chain has no batched path.
const NO_BATCH: &str = "the batched path was asked for and cannot be taken: ";

/// A run and what became of it.
struct Done {
    folder: Folder,
    ran: Ran,
}

/// Measures all decks; `done` is told of each scene as it ends, `doing` of each run as it begins.
///
/// # Errors
/// A deck that cannot be read, or an interruption. What goes wrong in a run is told in its [`Timed::outcome`].
pub fn run(
    options: &Options,
    (host, plugin): (&Liggghts, &Plugin),
    doing: &dyn Fn(&str),
    done: &dyn Fn(&Scene),
) -> Result<Vec<Scene>, RunError> {
    let wrong = |e: DeckError| RunError::Deck(e.to_string());
    let paths = Deck::find(&options.decks).map_err(wrong)?;
    let decks = paths.iter().map(|p| Deck::read(p)).collect::<Result<Vec<_>, _>>().map_err(wrong)?;
    if let Some(deck) = decks.iter().find(|d| d.after.is_some()) {
        let path = deck.path.display();
        return Err(RunError::Deck(format!(
            "{path} continues another deck; a deck that is timed must stand alone"
        )));
    }
    let mut scenes = Vec::new();
    for deck in &decks {
        for ranks in &options.ranks {
            let deck = Deck { ranks: *ranks, ..deck.clone() };
            let mut job = Job::new(options, host, plugin, deck);
            job.rounds(doing)?;
            done(&job.scene);
            scenes.push(job.scene);
        }
    }
    Ok(scenes)
}

/// A scene on its way.
struct Job<'a> {
    options: &'a Options,
    host: &'a Liggghts,
    plugin: &'a Plugin,
    deck: Deck,
    /// Whether all sides must write the same.
    same: bool,
    /// Whether stock's place is taken by a law of ours, contact by contact.
    ours: bool,
    scene: Scene,
    /// The first run of stock.
    first: Option<Done>,
}

impl<'a> Job<'a> {
    fn new(options: &'a Options, host: &'a Liggghts, plugin: &'a Plugin, deck: Deck) -> Job<'a> {
        let mut sides = vec![Side::Stock, Side::Contact, Side::Batched];
        sides.extend(options.lanes.iter().map(|n| Side::Lanes(*n)));
        if options.lammps.is_some() && deck.ranks == 1 && for_lammps(&deck.path).is_file() {
            sides.push(Side::Lammps);
        }
        let text = fs::read_to_string(&deck.path).unwrap_or_default();
        let timed = |side| Timed { side, pair: Vec::new(), whole: Vec::new(), outcome: Outcome::Agreed };
        let scene = Scene {
            name: deck.path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
            title: deck.title.clone(),
            ranks: deck.ranks,
            sides: sides.into_iter().map(timed).collect(),
            clock: None,
            account: None,
            lanes: None,
        };
        let says = |line: &str| text.lines().any(|l| l.trim_end() == line);
        let (same, ours) = (!says(DIFFERS), says(BOTH_OURS));
        Job { options, host, plugin, deck, same, ours, scene, first: None }
    }

    fn rounds(&mut self, doing: &dyn Fn(&str)) -> Result<(), RunError> {
        let n = self.scene.sides.len();
        for round in 0..self.options.pairs {
            for k in 0..n {
                // Stock comes first in the first round: the others are held against it.
                let k = if round % 2 == 0 { k } else { n - 1 - k };
                if matches!(self.scene.sides[k].outcome, Outcome::Disagreed(_) | Outcome::CouldNotRun(_)) {
                    continue;
                }
                // A side that was skipped did not run at all.
                if round > 0 && self.scene.sides[k].pair.is_empty() {
                    continue;
                }
                let side = self.scene.sides[k].side;
                doing(&format!("{}: {side}, {} of {}", self.scene.label(), round + 1, self.options.pairs));
                self.turn(k, side)?;
                if self.first.is_none() {
                    return Ok(());
                }
            }
        }
        Ok(())
    }

    /// One run of a side.
    fn turn(&mut self, k: usize, side: Side) -> Result<(), RunError> {
        let outcome = match self.attempt(side) {
            Err(RunError::Interrupted) => return Err(RunError::Interrupted),
            Err(e) if side == Side::Lammps => Outcome::CouldNotRun(format!("LAMMPS failed: {e}")),
            Err(e) => failure(&e),
            Ok(done) => self.judge(k, side, done),
        };
        self.scene.sides[k].outcome = outcome;
        if side == Side::Stock && self.first.is_none() {
            let why = Outcome::Skipped("there is nothing to hold it against: stock did not run".into());
            self.scene.sides[1..].iter_mut().for_each(|t| t.outcome = why.clone());
        }
        Ok(())
    }

    fn attempt(&self, side: Side) -> Result<Done, RunError> {
        match &self.options.lammps {
            Some(lammps) if side == Side::Lammps => {
                let deck = Deck { path: for_lammps(&self.deck.path), ..self.deck.clone() };
                self.run(lammps, &deck, Vec::new())
            }
            _ => self.liggghts(side),
        }
    }

    fn run(
        &self,
        code: &dyn Code,
        deck: &Deck,
        environment: Vec<(&'static str, String)>,
    ) -> Result<Done, RunError> {
        let folder = Folder::new(deck)?;
        let ran = codes::run(code, &Run { deck, environment, limit: self.options.limit }, &folder)?;
        Ok(Done { ran, folder })
    }

    fn liggghts(&self, side: Side) -> Result<Done, RunError> {
        let batched = Some(Route::Batched);
        let (route, lanes) = match side {
            Side::Stock | Side::Contact => (Some(Route::Contact), None),
            Side::Lanes(n) => (batched, Some(n.to_string())),
            _ => (batched, None),
        };
        let preload =
            Preload { deck: Some(self.deck.file()), route, lanes, ..Preload::new(self.plugin, Laws::Rust) };
        let rust = side != Side::Stock;
        let deck = Deck { variables: vec![("rust".into(), u8::from(rust).to_string())], ..self.deck.clone() };
        self.run(self.host, &deck, if rust || self.ours { preload.env() } else { Vec::new() })
    }

    /// Takes down the times of a run and compares what it wrote.
    fn judge(&mut self, k: usize, side: Side, done: Done) -> Outcome {
        let Some(clock) = Times::longest(&done.ran.times) else {
            return Outcome::CouldNotRun(match side {
                Side::Lammps => "LAMMPS printed no times".into(),
                _ => "LIGGGHTS printed no times; does the deck have a run command?".into(),
            });
        };
        let timed = &mut self.scene.sides[k];
        timed.pair.push(clock.pair);
        timed.whole.push(clock.whole);
        if side == Side::Lammps {
            return Outcome::Skipped("not compared: a law of its own".into());
        }
        if side == Side::Batched {
            self.scene.account = Account::read(&done.ran.log).or(self.scene.account);
            self.scene.lanes = lanes(&done.ran.log).or(self.scene.lanes.take());
        }
        let Some(first) = &self.first else {
            self.scene.clock = Some(clock);
            if done.ran.dumps.is_empty() {
                return Outcome::CouldNotRun("it wrote no dump, so that nothing can be compared".into());
            }
            self.first = Some(done);
            return Outcome::Agreed;
        };
        match self.same || side == Side::Stock {
            true => same(&done, first),
            false => Outcome::Skipped("not compared: the deck sets one law against another".into()),
        }
    }
}

/// The scene for LAMMPS that belongs to a deck.
fn for_lammps(deck: &Path) -> PathBuf {
    deck.with_extension("lammps")
}

fn failure(error: &RunError) -> Outcome {
    let text = error.to_string();
    match text.split_once(NO_BATCH) {
        Some((_, why)) => Outcome::Skipped(why.split(" (").next().unwrap_or(why).into()),
        None => Outcome::CouldNotRun(text),
    }
}

/// Whether a run wrote the dumps of another, byte for byte.
fn same(done: &Done, first: &Done) -> Outcome {
    if done.ran.dumps != first.ran.dumps {
        return Outcome::Disagreed("it wrote other dump files than stock".into());
    }
    for name in &first.ran.dumps {
        let [got, expected] = [done, first].map(|d| d.folder.path().join(name));
        match compare::dumps(&got, &expected) {
            Err(e) => return Outcome::CouldNotRun(e.to_string()),
            Ok(dumps) => {
                if let Some(d) = dumps.difference {
                    let who = d.id.map_or(String::new(), |id| format!(", particle {id}"));
                    let (name, step, column) = (name.display(), d.step, d.column);
                    return Outcome::Disagreed(format!(
                        "{name}, step {step}{who}, {column}: {} where stock has {}",
                        d.got, d.expected
                    ));
                }
            }
        }
    }
    Outcome::Agreed
}
