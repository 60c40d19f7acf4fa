//! Contact laws for granular simulation (DEM) that plug into LIGGGHTS, and what proves them right.
//!
//! The rooms: [`law`] says what a law is, [`laws`] holds one file per law, [`lane`] the numbers their hot functions are
//! written in, [`chain`] runs the chosen laws over one contact, [`deck`] reads what a LIGGGHTS input asks to be checked,
//! [`liggghts`] runs it, [`trace`] keeps what LIGGGHTS did, [`replay`] does that again with the laws here, [`pair`] moves
//! two bodies on its own, [`probe`] counts what the contacts of a scene do, [`shadow`] holds every call of a run against
//! LIGGGHTS's own laws, [`compare`] says where two answers differ, [`verify`] puts all that together, [`bench`] says what it
//! costs, [`report`] writes what was found, [`near`] guesses what a misspelt word meant.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod advise;
pub mod bench;
pub mod chain;
pub mod compare;
pub mod critical;
pub mod deck;
pub mod lane;
pub mod law;
pub mod laws;
pub mod liggghts;
pub mod near;
pub mod pair;
pub mod probe;
pub mod replay;
pub mod report;
pub mod shadow;
pub mod study;
pub mod trace;
pub mod verify;
