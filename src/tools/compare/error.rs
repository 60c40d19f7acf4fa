//! Why a comparison cannot be made.
use std::io;
use thiserror::Error;

/// Why a comparison cannot be made.
#[derive(Debug, Error)]
pub enum CompareError {
    /// A file cannot be read.
    #[error("{file}: {source}; check the path and the permissions")]
    Io {
        /// The file.
        file: String,
        /// What the operating system says.
        source: io::Error,
    },
    /// A trace is damaged.
    #[error(transparent)]
    Trace(#[from] crate::trace::TraceError),
    /// Not a dump.
    #[error("{file}: line 1 is not 'ITEM: TIMESTEP', so this is not a text dump of LIGGGHTS; write one with dump ID all custom 1 dump.txt ...")]
    NotADump {
        /// The file.
        file: String,
    },
    /// A dump that is damaged or cut short.
    #[error("{file}:{line}: {what}; the run that wrote it may not have finished, run the deck again")]
    Damaged {
        /// The file.
        file: String,
        /// The line.
        line: u64,
        /// What is wrong.
        what: String,
    },
    /// A column that the dump does not have.
    #[error(
        "{file}: the dump has no column {column}; it has {known}. Add it to the dump command of the deck"
    )]
    NoColumn {
        /// The file.
        file: String,
        /// The column.
        column: String,
        /// The columns that there are.
        known: String,
    },
    /// A particle that the last frame does not have.
    #[error(
        "{file}: step {step}, the last of the dump, has no particle {id}; it may have left the box of the deck"
    )]
    NoParticle {
        /// The file.
        file: String,
        /// The step.
        step: i64,
        /// The particle.
        id: i64,
    },
}
