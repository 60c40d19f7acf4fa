//! Bonds inside LIGGGHTS: in every chain of laws, counted on one rank and on two, and what becomes of bad input.
#[path = "bond_live/bad.rs"]
mod bad;
#[path = "bond_live/bench.rs"]
mod bench;
#[path = "bond_live/chains.rs"]
mod chains;
#[path = "bond_live/counter.rs"]
mod counter;

#[path = "bond_live/same.rs"]
mod same;

#[path = "built/mod.rs"]
mod built;
#[path = "live/mod.rs"]
mod live;
