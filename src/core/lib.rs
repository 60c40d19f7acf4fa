//! Contact laws for granular simulation (DEM) that plug into LIGGGHTS.
//!
//! The rooms: [`model`] says what a law is, [`laws`] holds one file per law, [`lane`] the numbers their hot functions are
//! written in, [`chain`] runs the chosen laws over one contact, [`pair`] moves two bodies under a chain, [`critical`] knows
//! the longest stable time steps. What proves the laws right is the crate `granlaw-tools`.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

// For what `derive(Lanes)` writes.
extern crate self as granlaw;

pub mod chain;
pub mod critical;
pub mod lane;
pub mod laws;
pub mod model;
pub mod pair;
