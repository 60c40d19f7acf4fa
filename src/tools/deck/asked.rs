//! What the comments of a deck ask for.
use std::path::PathBuf;

/// A deck and what its comments ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct Deck {
    /// Where it is.
    pub path: PathBuf,
    /// One line for people; the file name where the deck gives none.
    pub title: String,
    /// MPI ranks to run it on.
    pub ranks: usize,
    /// Values for variables of the deck, by name, as LIGGGHTS's option -var gives them.
    pub variables: Vec<(String, String)>,
    /// The deck of the same folder that writes the restart file with which this one begins.
    pub after: Option<After>,
    /// Every how many steps contact calls are recorded.
    pub every: u64,
    /// What to check.
    pub checks: Vec<Asked>,
}

/// The deck that must run before.
#[derive(Clone, Debug, PartialEq)]
pub struct After {
    /// Its file name, in the same folder.
    pub deck: String,
    /// The line that names it.
    pub line: usize,
}

/// One check that a deck asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// What to check.
    pub what: What,
    /// Why the limit is what it is.
    pub reason: String,
    /// The line that asks for it; 0 for a check that every deck gets.
    pub line: usize,
}

/// What can be checked.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// Every recorded contact call is evaluated again by the Rust laws.
    Replay {
        /// Largest error relative to the peak of each quantity.
        limit: f64,
    },
    /// A run on the Rust laws writes the same dump files as one on LIGGGHTS's own, byte for byte.
    Plugin,
    /// Our own integration of two particles, from the recorded first state, gives the same motion.
    TwoBody {
        /// Largest error relative to the peak of each quantity.
        limit: f64,
    },
    /// One number of the last frame of the deck's dump is as expected.
    Final(Final),
    /// Another deck writes the same dump files, byte for byte.
    SameAs {
        /// Its file name, in the same folder.
        deck: String,
    },
}

/// One number of the last frame of the deck's dump, and what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Final {
    /// Column of the dump.
    pub column: String,
    /// Particle id.
    pub id: i64,
    /// The expected value, in the units of the deck.
    pub value: f64,
    /// Largest error: relative to `value`, or absolute if that is 0.
    pub limit: f64,
}
