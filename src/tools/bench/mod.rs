//! What the laws cost inside LIGGGHTS: several sides run the same decks in turn, and must write the same dumps.
//!
//! The speed of a machine drifts, so only runs of the same round are compared, as ratios. The order of the sides is reversed from
//! one round to the next.
mod account;
mod page;
mod run;
mod scene;
mod terminal;

pub use page::{load, page};
pub use run::run;
pub use scene::{Options, Scene, Side, Timed};
pub use terminal::{summary, table};
