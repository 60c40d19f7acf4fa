//! The main job on the real LIGGGHTS: every deck of ours agrees, and what is wrong with a deck turns the verdict.
#[path = "built/mod.rs"]
mod built;
#[path = "live/mod.rs"]
mod live;
#[path = "decks/planted.rs"]
mod planted;
#[path = "decks/stopped.rs"]
mod stopped;
#[path = "decks/whole.rs"]
mod whole;
