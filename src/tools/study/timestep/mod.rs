//! How long the time step of a deck may be: critical steps of every mode of every pair of types, the longest step for an
//! accuracy, and what LIGGGHTS's own check says. It reads a probe of the first steps of the deck.
mod accurate;
mod bond;
mod contact;
mod limit;
mod stock;

pub use accurate::{accurate, Search};
pub use limit::{Asked, Contact, Limit};
pub use stock::Stock;

use crate::probe::{Contacts, ParticleType, Probe};
use serde::Serialize;

/// The answer for a deck.
#[derive(Clone, Debug, Serialize)]
pub struct Advice {
    /// The deck's time step \[s\].
    pub dt: f64,
    /// The error that was asked for.
    pub accuracy: f64,
    /// How many bonds each particle is assumed to have.
    pub bonds: u32,
    /// The particles by type.
    pub grains: Vec<ParticleType>,
    /// Every pair of types, and every type with every wall.
    pub contacts: Vec<Contact>,
    /// LIGGGHTS's check; `None` where the deck has no elastic constants.
    pub stock: Option<Stock>,
    /// What could not be considered, and what was assumed.
    pub notes: Vec<String>,
}

impl Advice {
    /// The contact that needs the shortest step.
    pub fn shortest(&self) -> Option<&Contact> {
        self.contacts.iter().min_by(|a, b| a.recommended().total_cmp(&b.recommended()))
    }

    /// The longest step \[s\] that is stable, creates no energy and is as accurate as asked for.
    pub fn recommended(&self) -> Option<f64> {
        self.shortest().map(Contact::recommended)
    }
}

/// The chains, merged over different time steps, as a deck may change the step.
fn chains(probe: &Probe) -> Vec<Contacts> {
    let mut all: Vec<Contacts> = Vec::new();
    for chain in &probe.chains {
        let mut chain = chain.clone();
        chain.header.dt = 0.0;
        match all.iter_mut().find(|c| c.header == chain.header) {
            Some(known) => known.merge(chain),
            None => all.push(chain),
        }
    }
    all
}

/// Gives the steps for the contacts that a probe saw.
pub fn advise(probe: &Probe, asked: &Asked) -> Advice {
    let mut notes = Vec::new();
    let mut contacts = Vec::new();
    for chain in &chains(probe) {
        contacts.extend(contact::of_chain(chain, &probe.grains, asked, &mut notes));
    }
    if probe.grains.is_empty() {
        notes.push("no particle was there in these steps; let more be watched (--steps)".into());
    }
    let dt = probe.chains.iter().map(|c| c.header.dt).fold(0.0, f64::max);
    let units = probe.chains.first().map_or("si", |c| c.header.units.as_str());
    if units != "si" {
        notes.push(format!("all numbers are in the deck's units, {units}"));
    }
    let stock = stock::of(probe).filter(|_| units == "si");
    Advice {
        dt,
        accuracy: asked.accuracy,
        bonds: asked.bonds,
        grains: probe.grains.clone(),
        contacts,
        stock,
        notes,
    }
}
