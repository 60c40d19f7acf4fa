//! `cohesion bond/nonlinear` against an oracle in arbitrary precision, the figures of the upstream header, and the points
//! in which the two conventions differ.
#[path = "bond/bench.rs"]
mod bench;
#[path = "bond/dynamics.rs"]
mod dynamics;
#[path = "bond/oracle.rs"]
mod oracle;
#[path = "bond/points.rs"]
mod points;
#[path = "bond/turned.rs"]
mod turned;
#[path = "bond/upstream.rs"]
mod upstream;
#[path = "bond/used.rs"]
mod used;
