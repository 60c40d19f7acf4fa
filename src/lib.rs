//! Contact laws for granular simulation, and what proves them right.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod report;
