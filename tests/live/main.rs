//! What was built, as it is used: the command line, the C library, the scripts, and the plugin inside the real LIGGGHTS. What
//! is not installed is skipped by name, or fails where `GRANLAW_REQUIRE_LIGGGHTS` is set.
mod abi;
mod advise;
mod batched;
mod bond;
mod built;
mod cli;
mod common;
mod decks;
mod dropin;
mod environment;
mod install;
mod packages;
mod probe;
mod refusals;
mod same_as;
mod shadow;
mod study;
