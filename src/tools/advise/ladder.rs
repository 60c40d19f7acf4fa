//! The ladder of models: what each leaves out, its errors, the largest step that it allows, and its cost.
use super::change::{simpler, Change};
use super::cost;
use super::errors::{Errors, Sure};
use super::fit::fit;
use super::options::Options;
use super::rules::{sure, CRITICAL, LARGER, SMALLER};
use super::scene::Scene;
use crate::trace::{Header, HeaderError};
use granlaw::model::Kind;
use serde::Serialize;

/// A model on trial.
#[derive(Clone, Debug, Serialize)]
pub struct Candidate {
    /// Its changes to the deck.
    pub changes: Vec<Change>,
    /// The chains.
    #[serde(skip)]
    pub chains: Vec<Header>,
    /// The errors of the laws themselves, in very small steps.
    pub model: Trial,
    /// Whether the laws are good enough, in very small steps.
    pub holds: bool,
    /// The largest step in which all classes are within the accuracy \[s\]; `None` if there is none.
    pub step: Option<f64>,
    /// The errors in that step.
    pub at_step: Option<Trial>,
    /// Time to evaluate the laws on the contacts of the scene \[ns per contact\].
    pub cost: f64,
    /// Predicted time of a run, relative to the deck as it is; `None` without a step.
    pub predicted: Option<f64>,
    /// Why it was not tried: the message of the law that refused.
    pub refused: Option<String>,
}

/// The result of trying all classes.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Trial {
    /// Errors of each class, in the order of the scene's groups.
    pub errors: Vec<Errors>,
    /// The worst error: of which quantity, how large, and the index of its class.
    pub worst: Option<(&'static str, f64, usize)>,
    /// Highest circular frequency met \[rad/s\].
    #[serde(skip)]
    pub omega: f64,
}

impl Candidate {
    /// Its changes in words.
    pub fn name(&self) -> String {
        if self.changes.is_empty() {
            return "as it is".into();
        }
        self.changes.iter().map(Change::name).collect::<Vec<_>>().join(", ")
    }
}

impl Candidate {
    /// Its size, by which the simplest model is chosen: numbers of laws, of history slots, and of changes to the deck.
    pub(super) fn size(&self) -> (usize, usize, usize) {
        let sum = |of: fn(&Header) -> usize| self.chains.iter().map(of).sum();
        (sum(|h| h.laws.len()), sum(|h| h.slots.len()), self.changes.len())
    }
}

/// All models: the deck as it is, every single change, and every combination of those changes that hold alone.
pub(super) fn climb(scene: &Scene, o: &Options) -> Result<Vec<Candidate>, HeaderError> {
    let mut candidates = vec![candidate(scene, o, Vec::new(), &[])?];
    let (stay, tried): (Vec<_>, Vec<_>) = (0..scene.chains.len()).partition(|k| scene.stays(*k));
    let tried: Vec<_> = tried.into_iter().map(|k| scene.chains[k].clone()).collect();
    // A fitted property belongs to all chains, so fitting it would also change a chain that is to stay as it is.
    for c in simpler(&tried).into_iter().filter(|c| stay.is_empty() || !fits(c)) {
        candidates.push(candidate(scene, o, vec![c], &[])?);
    }
    let good: Vec<_> = candidates[1..].iter().filter(|r| r.holds).map(|r| r.changes[0].clone()).collect();
    for many in combinations(&good) {
        let next = candidate(scene, o, many, &candidates)?;
        candidates.push(next);
    }
    let (cost, dt) = (candidates[0].cost, scene.dt());
    for r in &mut candidates {
        r.predicted = r.step.map(|step| scene.run_time.relative((cost, r.cost), dt / step));
    }
    Ok(candidates)
}

/// Whether a change comes with properties that are fitted.
fn fits(c: &Change) -> bool {
    matches!(c, Change::Law(Kind::Normal, _))
}

/// Tries these changes. If one of them was fitted before, that fit is kept.
fn candidate(
    scene: &Scene,
    o: &Options,
    changes: Vec<Change>,
    before: &[Candidate],
) -> Result<Candidate, HeaderError> {
    let fitted = before
        .iter()
        .find(|r| r.changes.len() == 1 && fits(&r.changes[0]) && changes.contains(&r.changes[0]));
    let mut chains = fitted.map_or(&scene.chains, |r| &r.chains).clone();
    for c in &changes {
        let changed = |(k, h): (usize, &Header)| {
            Some(h).filter(|_| !scene.stays(k)).and_then(|h| c.apply(h)).unwrap_or_else(|| h.clone())
        };
        chains = chains.iter().enumerate().map(changed).collect();
    }
    let none = |why: HeaderError, chains| Candidate {
        changes: changes.clone(),
        chains,
        model: Trial::default(),
        holds: false,
        step: None,
        at_step: None,
        cost: f64::NAN,
        predicted: None,
        refused: Some(why.to_string()),
    };
    let to_fit = fitted.is_none() && changes.iter().any(fits);
    if let Err(why) = if to_fit { fit(scene, &mut chains) } else { Ok(()) } {
        return Ok(none(why, chains));
    }
    let model = match trial(scene, &chains, scene.fine(), (None, sure), o) {
        Ok(model) => model,
        Err(why) => return Ok(none(why, chains)),
    };
    let holds = within(&model, o);
    let (step, at_step) = if holds { largest(scene, &chains, &model, o)? } else { (None, None) };
    let cost = cost::per_contact(scene, &chains)?;
    Ok(Candidate { changes, chains, model, holds, step, at_step, cost, predicted: None, refused: None })
}

/// The largest step up to which every class is within the accuracy in all steps that are tried.
fn largest(
    scene: &Scene,
    chains: &[Header],
    model: &Trial,
    o: &Options,
) -> Result<(Option<f64>, Option<Trial>), HeaderError> {
    // With a law that acts across gaps no other step can be tried; the deck's own is the one it ran with.
    if !scene.untried.is_empty() {
        return Ok((Some(scene.dt()), Some(model.clone())));
    }
    let critical = CRITICAL * 2.0 / model.omega;
    let try_out = |m: &f64| -> Result<Option<(f64, Trial)>, HeaderError> {
        let step = m * scene.dt();
        if step > critical {
            return Ok(None);
        }
        let t = trial(scene, chains, step, (Some(model), sure), o)?;
        Ok(within(&t, o).then_some((step, t)))
    };
    let mut found = None;
    for m in &LARGER {
        let Some(good) = try_out(m)? else { break };
        found = Some(good);
    }
    for m in &SMALLER {
        if found.is_some() {
            break;
        }
        found = try_out(m)?;
    }
    Ok(found.unzip())
}

/// Tries all classes in steps of `dt`. The errors of loads are taken from another trial, if there was one.
pub(super) fn trial(
    scene: &Scene,
    chains: &[Header],
    dt: f64,
    (before, sure): (Option<&Trial>, Sure),
    o: &Options,
) -> Result<Trial, HeaderError> {
    let (errors, omega) = scene.try_out(chains, dt, before.map(|t| &t.errors[..]), sure)?;
    let worst = errors.iter().enumerate().map(|(k, e)| {
        let (what, size) = e.worst(o.time);
        (what, size, k, if what == "contact time" { size / o.time } else { size })
    });
    let worst = worst.max_by(|a, b| a.3.total_cmp(&b.3)).map(|(what, size, k, _)| (what, size, k));
    Ok(Trial { errors, worst, omega })
}

fn within(t: &Trial, o: &Options) -> bool {
    t.errors.iter().all(|e| e.within(o.accuracy, o.time))
}

/// All combinations of two or more changes to different kinds of law.
fn combinations(of: &[Change]) -> Vec<Vec<Change>> {
    let mut all: Vec<Vec<Change>> = vec![Vec::new()];
    for c in of {
        let with: Vec<_> = all
            .iter()
            .filter(|some| some.iter().all(|s| s.of() != c.of()))
            .map(|some| [&some[..], std::slice::from_ref(c)].concat())
            .collect();
        all.extend(with);
    }
    all.retain(|some| some.len() > 1);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_change_every_kind_once() {
        let [a, b] = [Change::Off(Kind::Tangential), Change::Law(Kind::Tangential, "no_history")];
        let (c, d) = (Change::Off(Kind::Rolling), Change::Timed);
        let all = combinations(&[a.clone(), b.clone(), c.clone(), d.clone()]);
        assert_eq!(all.len(), 7);
        assert!(all.contains(&vec![b, c, d]) && !all.iter().any(|s| s.contains(&a) && s.len() > 3));
    }
}
