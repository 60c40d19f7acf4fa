//! `cohesion bond/nonlinear` against an oracle in arbitrary precision, the figures of the upstream header, and the points
//! in which the two conventions differ.
#[path = "bond/bench.rs"]
mod bench;
#[path = "bond/oracle.rs"]
mod oracle;
