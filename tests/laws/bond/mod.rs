//! `cohesion bond/nonlinear` against an oracle in arbitrary precision, the figures of the upstream header, and the points
//! in which the two conventions differ.
mod bench;
mod dynamics;
mod oracle;
mod points;
mod turned;
mod upstream;
mod used;
