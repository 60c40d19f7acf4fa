//! The tools on top of the laws, each on input made here: no LIGGGHTS, no compiler, no program of ours.
mod advise;
mod layout;
mod probe;
mod readme;
mod report;
mod shadow;
mod study;
