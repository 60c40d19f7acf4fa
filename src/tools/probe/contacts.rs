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
    /// At the end of the run, one in this many pairs of particles was followed.
    pub share: u64,
    /// Number of contact calls with overlapping surfaces, set-up evaluations included.
    pub calls: u64,
    /// Number of calls of contacts that were followed.
    pub followed: u64,
    /// Largest difference between the force of the Rust laws and that of the run, relative to the larger; 0 without Rust
    /// laws.
    pub residual: f64,
    /// The contacts of each pair of atom types.
    pub pairs: Vec<TypePair>,
}

impl Contacts {
    /// Adds what another rank, or another wall, saw of the same chain.
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
