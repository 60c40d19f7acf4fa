//! A deck: an ordinary LIGGGHTS input whose `# granlaw:` comments say how to run it and what must come out.
//!
//! LIGGGHTS alone understands the rest of the file; nothing here looks at it.
use std::fs;
use std::path::{Path, PathBuf};

mod asked;
mod error;
mod parse;

pub use asked::{After, Asked, Deck, Final, What};
pub use error::DeckError;

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

    /// Checks that another deck of the same folder can be run: it must be there, and not itself continue a third.
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
