//! What the contacts of one chain did.
use super::tally::TypePair;
use crate::trace::Header;
use serde::{Deserialize, Serialize};

/// What the contacts of one chain did.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contacts {
    /// The laws and coefficients as LIGGGHTS resolved them, as in a trace.
    pub header: Header,
    /// One in so many pairs of particles was followed at the end.
    pub share: u64,
    /// Contact calls with overlapping surfaces, set-up evaluations included.
    pub calls: u64,
    /// Calls of followed contacts.
    pub followed: u64,
    /// Largest difference between the force of the Rust laws and that of the run, relative to the larger; 0 without Rust
    /// laws.
    pub residual: f64,
    /// Per pair of atom types.
    pub pairs: Vec<TypePair>,
}

impl Contacts {
    /// Adds what was seen elsewhere of the same chain.
    pub(crate) fn merge(&mut self, other: Contacts) {
        self.share = self.share.max(other.share);
        self.calls += other.calls;
        self.followed += other.followed;
        self.residual = self.residual.max(other.residual);
        for pair in other.pairs {
            match self.pairs.iter_mut().find(|p| p.types == pair.types) {
                Some(mine) => mine.merge(pair),
                None => self.pairs.push(pair),
            }
        }
        self.pairs.sort_by_key(|p| p.types);
    }
}
