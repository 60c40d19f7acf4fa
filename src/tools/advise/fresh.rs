//! Checks advice on contacts that it was not made from: those of another run of the scene.
use super::errors::Errors;
use super::group::Contacts;
use super::ladder::{trial, Candidate};
use super::options::Options;
use super::rules::HELD_OUT;
use super::scene::Scene;
use crate::trace::HeaderError;
use serde::Serialize;

/// A class of fresh contacts.
#[derive(Clone, Debug, Serialize)]
pub struct Class {
    /// Which contacts, in words.
    pub name: String,
    /// Whether they are impacts; if not, they are lasting contacts.
    pub impacts: bool,
    /// The errors of the advised chain on them, in the advised step.
    pub errors: Errors,
    /// Whether all of these are within the accuracy.
    pub within: bool,
}

/// The result for the fresh contacts.
#[derive(Clone, Debug, Serialize)]
pub struct Fresh {
    /// How the other run differs from the first, for instance `seed=32452867`.
    pub run: String,
    /// The classes that count in the other run.
    pub classes: Vec<Class>,
}

impl Fresh {
    /// How many classes are within the accuracy, and how many there are: of impacts, or of lasting contacts.
    pub fn tally(&self, impacts: bool) -> (usize, usize) {
        let of = || self.classes.iter().filter(|c| c.impacts == impacts);
        (of().filter(|c| c.within).count(), of().count())
    }

    /// Whether enough classes of impacts are within the accuracy; without impacts, of lasting contacts.
    pub fn holds(&self) -> bool {
        let (within, all) = match self.tally(true) {
            (_, 0) => self.tally(false),
            some => some,
        };
        all > 0 && within as f64 >= HELD_OUT * all as f64
    }
}

/// Tries a model of the ladder, in its step, on the contacts of another run.
///
/// # Errors
/// A law refuses.
pub fn fresh(
    other: &Scene,
    deck: &Scene,
    candidate: &Candidate,
    run: &str,
    o: &Options,
) -> Result<Fresh, HeaderError> {
    let chains = other.chains.iter().map(|c| {
        let at = deck.chains.iter().position(|d| d.who == c.who);
        // There is no advice on a chain that the first run never used; it stays as it is.
        at.map_or_else(|| c.clone(), |k| candidate.chains[k].clone())
    });
    let chains: Vec<_> = chains.collect();
    let tried = trial(other, &chains, candidate.step.unwrap_or(deck.dt()), (None, |_| 1.0), o)?;
    let classes = other.groups.iter().zip(&tried.errors).map(|(g, e)| Class {
        name: g.name.clone(),
        impacts: matches!(g.contacts, Contacts::Impacts(_)),
        errors: *e,
        within: e.within(o.accuracy, o.time),
    });
    Ok(Fresh { run: run.into(), classes: classes.collect() })
}
