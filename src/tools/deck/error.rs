//! Why a deck cannot be used.
use std::path::PathBuf;
use thiserror::Error;

/// Why a deck cannot be used.
#[derive(Debug, Error)]
pub enum DeckError {
    /// It cannot be read.
    #[error("cannot read the deck {}: {source}; name a LIGGGHTS input file or a folder of *.in files", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A folder has no deck.
    #[error("no deck in {}: a folder of decks holds files that end in .in", path.display())]
    Empty {
        /// The folder.
        path: PathBuf,
    },
    /// A comment cannot be understood.
    #[error("{}:{line}: {what}", path.display())]
    Comment {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// What is wrong and what would be right.
        what: String,
    },
}
