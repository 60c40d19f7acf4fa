//! The shadow of a run: what counts as a difference, and whole runs inside LIGGGHTS with and without a fault planted.
#[path = "built/mod.rs"]
mod built;
#[path = "shadow/differences.rs"]
mod differences;
#[path = "shadow/inside.rs"]
mod inside;
#[path = "live/mod.rs"]
mod live;
