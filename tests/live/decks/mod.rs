//! The main job on the real LIGGGHTS: every deck of ours agrees, and what is wrong with a deck turns the verdict.
mod planted;
mod stopped;
mod whole;
