//! The codes that run decks, behind one door.
//!
//! A deck, an environment that is made for it, a time limit and a [`Folder`] of its own go into [`run`]; times, dumps, traces and
//! warnings come out, or an error with the code's own last words. What is particular to a code is in its file: how it is found,
//! its arguments, and how its words are read. To add one, write such a file and add its line to [`CODES`].
use std::path::Path;

mod code;
pub mod environment;
mod error;
mod folder;
pub mod lammps;
mod launch;
pub mod liggghts;
mod process;
mod run;
mod said;
#[cfg(test)]
mod tests;
mod times;

pub use code::Code;
pub use error::RunError;
pub use folder::Folder;
pub use launch::{command, Around};
pub use process::interrupt;
pub use run::{run, Ran, Run};
pub use said::Said;
pub use times::Times;

/// Finds a code: the program that is named, or else that of PATH.
pub type Find = fn(Option<&Path>) -> Result<Box<dyn Code>, RunError>;

/// All codes, by the words for them on the command line.
pub const CODES: &[(&str, Find)] = &[
    ("liggghts", |named| {
        Ok(Box::new(named.map_or_else(liggghts::Liggghts::find, liggghts::Liggghts::open)?))
    }),
    ("lammps", |named| Ok(Box::new(lammps::Lammps::find(named)?))),
];
