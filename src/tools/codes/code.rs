//! What a code is: a program that runs a deck.
use super::said::Said;
use super::times::Times;
use crate::deck::Deck;
use std::fmt::Debug;
use std::path::Path;

/// A program of this machine that runs decks. [`run`](super::run) does with it all that is the same for every code.
pub trait Code: Debug + Send + Sync {
    /// What people call it.
    fn name(&self) -> &'static str;

    /// The program.
    fn program(&self) -> &Path;

    /// What it says of its version.
    fn version(&self) -> &str;

    /// The arguments with which it runs a deck in the folder that the deck is in.
    fn arguments(&self, deck: &Deck) -> Vec<String>;

    /// The file of that folder in which it writes down what it does.
    fn log(&self) -> &'static str;

    /// What it printed, as text.
    fn text(&self, bytes: &[u8]) -> String {
        String::from_utf8_lossy(bytes).into_owned()
    }

    /// Its own words for why it failed.
    fn error(&self, said: &Said) -> Option<String>;

    /// What its runs took.
    fn times(&self, said: &Said) -> Vec<Times>;
}
