//! What proves granlaw's laws right, and says what they cost. Made for the command line, the plugin and the tests: laws and
//! chains, which others link, are the crate `granlaw`.
//!
//! The rooms: [`deck`] reads what a LIGGGHTS input asks to be checked, [`codes`] run it, [`trace`] keeps what LIGGGHTS
//! did, [`replay`] does that again with the laws here, [`probe`] counts what the contacts of a scene do, [`shadow`] holds
//! every call of a run against LIGGGHTS's own laws, [`compare`] says where two answers differ, [`verify`] puts all that
//! together, [`study`] maps accuracy and stability, [`advise`] tries simpler models, [`bench`] says what it costs,
//! [`report`] writes what was found, [`spelling`] guesses what a misspelt word meant.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod advise;
pub mod bench;
pub mod codes;
pub mod compare;
pub mod deck;
pub mod probe;
pub mod replay;
pub mod report;
pub mod shadow;
pub mod spelling;
pub mod study;
pub mod trace;
pub mod verify;
