//! Bonds inside LIGGGHTS: in every chain of laws, counted on one rank and on two, and what becomes of bad input.
mod bad;
mod bench;
mod chains;
mod counter;
mod same;
