//! A deck: an ordinary LIGGGHTS input whose `# granlaw:` comments say how to run it and what must come out.
//!
//! LIGGGHTS alone understands the rest of the file; nothing here looks at it.
use std::fs;
use std::path::{Path, PathBuf};
use thiserror::Error;

mod parse;

/// A deck and what its comments ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct Deck {
    /// Where it is.
    pub path: PathBuf,
    /// One line for people; the file name where the deck gives none.
    pub title: String,
    /// MPI ranks to run it on.
    pub ranks: usize,
    /// Values for variables of the deck, by name, as LIGGGHTS's option -var gives them.
    pub variables: Vec<(String, String)>,
    /// The deck of the same folder that writes the restart file with which this one begins.
    pub after: Option<After>,
    /// Every how many steps contact calls are recorded.
    pub every: u64,
    /// What to check.
    pub checks: Vec<Asked>,
}

/// The deck that must run before.
#[derive(Clone, Debug, PartialEq)]
pub struct After {
    /// Its file name, in the same folder.
    pub deck: String,
    /// The line that names it.
    pub line: usize,
}

/// One check that a deck asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// What to check.
    pub what: What,
    /// Why the limit is what it is.
    pub reason: String,
    /// The line that asks for it; 0 for a check that every deck gets.
    pub line: usize,
}

/// What can be checked.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// Every recorded contact call again through the Rust laws.
    Replay {
        /// Largest error relative to the peak of each quantity.
        limit: f64,
    },
    /// The dump files of a run on the Rust laws against those of a run on LIGGGHTS's own, byte for byte.
    Plugin,
    /// Our own integration of two particles from the recorded first state.
    TwoBody {
        /// Largest error relative to the peak of each quantity.
        limit: f64,
    },
    /// One number of the last frame of the deck's dump.
    Final(Final),
    /// The dump files against those of another deck, byte for byte.
    SameAs {
        /// Its file name, in the same folder.
        deck: String,
    },
}

/// One number of the last frame of the deck's dump, held against a known one.
#[derive(Clone, Debug, PartialEq)]
pub struct Final {
    /// Column of the dump.
    pub column: String,
    /// Particle id.
    pub id: i64,
    /// What it should be, in the units of the deck.
    pub value: f64,
    /// Largest error: relative to `value`, absolute where that is 0.
    pub limit: f64,
}

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
    /// A comment that means nothing.
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

const REPLAY_REASON: &str =
    "the same operations in the same order may differ by a few rounding errors of the peak";
const PLUGIN_REASON: &str = "the same operations on the same numbers give the same bits";

impl Deck {
    /// Read the comments of a deck.
    ///
    /// # Errors
    /// The file cannot be read, or a comment is wrong.
    pub fn read(path: &Path) -> Result<Deck, DeckError> {
        let bytes =
            fs::read(path).map_err(|source| DeckError::Unreadable { path: path.to_path_buf(), source })?;
        let deck = parse::deck(path, &String::from_utf8_lossy(&bytes))?;
        for asked in &deck.checks {
            if let What::SameAs { deck: other } = &asked.what {
                deck.needs("check same-as", other, asked.line)?;
            }
        }
        if let Some(after) = &deck.after {
            deck.needs("after", &after.deck, after.line)?;
        }
        Ok(deck)
    }

    /// Another deck of the same folder can be run: it is there, and does not itself continue a third.
    fn needs(&self, word: &str, other: &str, line: usize) -> Result<(), DeckError> {
        let wrong = |what| DeckError::Comment { path: self.path.clone(), line, what };
        let path = self.folder().join(other);
        let text = fs::read(&path).map_err(|e| {
            wrong(format!("{word} {other}: cannot read it: {e}; it must lie beside this deck"))
        })?;
        match parse::deck(&path, &String::from_utf8_lossy(&text))?.after {
            None => Ok(()),
            Some(_) => Err(wrong(format!(
                "{word} {other}: that deck itself continues another; only one step is possible"
            ))),
        }
    }

    /// The name of the file.
    pub fn file(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// The folder of the file.
    pub fn folder(&self) -> &Path {
        match self.path.parent() {
            Some(p) if !p.as_os_str().is_empty() => p,
            _ => Path::new("."),
        }
    }

    /// The deck that must run before.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn first(&self) -> Result<Option<Deck>, DeckError> {
        self.after.as_ref().map(|a| Deck::read(&self.folder().join(&a.deck))).transpose()
    }

    /// The files that may be needed beside the deck: all files of its folder that are not decks.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn beside(&self) -> Result<Vec<PathBuf>, DeckError> {
        let unreadable = |source| DeckError::Unreadable { path: self.folder().to_path_buf(), source };
        let entries = fs::read_dir(self.folder()).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        let files = entries.map_err(unreadable)?.into_iter().map(|e| e.path());
        Ok(files.filter(|p| p.is_file() && !is_deck(p)).collect())
    }

    /// The decks that paths stand for: a file is a deck, a folder stands for its `*.in` files in alphabetic order.
    ///
    /// # Errors
    /// The first path that is neither.
    pub fn find(paths: &[PathBuf]) -> Result<Vec<PathBuf>, DeckError> {
        let mut found = Vec::new();
        for path in paths {
            let unreadable = |source| DeckError::Unreadable { path: path.clone(), source };
            if !fs::metadata(path).map_err(unreadable)?.is_dir() {
                found.push(path.clone());
                continue;
            }
            let entries =
                fs::read_dir(path).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(unreadable)?;
            let mut decks: Vec<_> =
                entries.into_iter().map(|e| e.path()).filter(|p| is_deck(p) && p.is_file()).collect();
            if decks.is_empty() {
                return Err(DeckError::Empty { path: path.clone() });
            }
            decks.sort();
            found.append(&mut decks);
        }
        Ok(found)
    }
}

fn is_deck(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "in")
}
