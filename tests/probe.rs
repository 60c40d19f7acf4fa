//! A probe against what it is meant to say: two bodies counted by hand, samples, ranks, and runs inside LIGGGHTS
//! against their traces.
#[path = "built/mod.rs"]
mod built;
#[path = "probe/counts.rs"]
mod counts;
#[path = "probe/inside.rs"]
mod inside;
#[path = "probe/scene.rs"]
mod scene;
