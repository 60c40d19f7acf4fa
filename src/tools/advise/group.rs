//! A class of contacts that is tried, with its examples.
use super::loaded::Held;
use super::simulated::Rebound;
use crate::probe::{Impact, Pressed};
use serde::Serialize;

/// A class of contacts that is repeated.
#[derive(Clone, Debug, Serialize)]
pub struct Group {
    /// Which contacts, in words.
    pub name: String,
    /// The chain that they belong to.
    pub chain: usize,
    /// Atom types from 1, the lower first.
    pub types: [usize; 2],
    /// Share of all impacts; 0 for loads.
    pub count: f64,
    /// The share that it may have in another run: the number of contacts is a matter of chance, and may differ by its square root.
    #[serde(skip)]
    pub likely: f64,
    /// Share of the momentum exchanged along normals by all contacts.
    pub impulse: f64,
    /// Share of the work that all contacts took out of the motion.
    pub dissipated: f64,
    /// The contacts, with what the present chain makes of them in very small steps.
    #[serde(skip)]
    pub contacts: Contacts,
}

/// The contacts of a class.
#[derive(Clone, Debug)]
pub enum Contacts {
    /// Impacts.
    Impacts(Vec<(Impact, Rebound)>),
    /// Loads.
    Loads(Vec<(Pressed, Held)>),
}
