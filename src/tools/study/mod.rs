//! Studies: what the methods cost and how wrong they are, and where they fail.
pub mod about;
pub mod adaptive;
pub mod bond;
pub mod bonded;
pub mod bonded_row;
pub mod collision;
pub mod in_liggghts;
pub mod located;
pub mod matter;
pub mod modes;
pub mod motion;
pub mod single;
pub mod speed;
pub mod stability;
pub mod timestep;

use crate::codes::RunError;

/// What to study.
#[derive(Debug)]
pub struct Options {
    /// Names of the cases or maps; all of them if there are none.
    pub only: Vec<String>,
    /// A finer study that takes longer.
    pub full: bool,
    /// LIGGGHTS and plugin, or why there is none.
    pub bench: Result<in_liggghts::Bench, RunError>,
    /// The command line, for the page.
    pub command: String,
}

impl Options {
    /// Whether the case or map of this name is asked for.
    fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|o| o == name)
    }
}
