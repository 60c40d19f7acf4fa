//! A folder of its own for each run.
use super::RunError;
use crate::compare::{is_dump, CompareError, Frame};
use crate::deck::Deck;
use std::collections::HashMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use tempfile::TempDir;

/// A folder of its own for a run, gone when dropped.
#[derive(Debug)]
pub struct Folder {
    temp: TempDir,
}

/// The files of a folder, with what tells whether they were written to.
pub(super) type Files = HashMap<PathBuf, (u64, Option<SystemTime>)>;

const TRACE: &str = "calls.trace";

impl Folder {
    /// A new folder that holds the deck, the deck it continues, and the files beside them.
    ///
    /// # Errors
    /// A file cannot be copied.
    pub fn new(deck: &Deck) -> Result<Folder, RunError> {
        let files = deck.beside().map_err(|e| RunError::Deck(e.to_string()))?;
        let first = deck.after.iter().map(|a| deck.folder().join(&a.deck));
        let folder = Folder::empty()?;
        for file in files.into_iter().chain(first).chain([deck.path.clone()]) {
            let name = file.file_name().unwrap_or_default();
            fs::copy(&file, folder.path().join(name)).map_err(RunError::io("copy", &file))?;
        }
        Ok(folder)
    }

    /// A new folder with nothing in it.
    ///
    /// # Errors
    /// It cannot be made.
    pub fn empty() -> Result<Folder, RunError> {
        let temp = tempfile::Builder::new().prefix("granlaw-").tempdir();
        let folder = Folder { temp: temp.map_err(RunError::io("create", &env::temp_dir()))? };
        fs::create_dir(folder.path()).map_err(RunError::io("create", &folder.path()))?;
        Ok(folder)
    }

    /// Where the run takes place.
    pub fn path(&self) -> PathBuf {
        self.temp.path().join("run")
    }

    /// The folder around it, for what is no file of the run.
    pub(super) fn around(&self) -> &Path {
        self.temp.path()
    }

    /// Where standard output and standard error go.
    pub(super) fn outputs(&self) -> [PathBuf; 2] {
        ["stdout", "stderr"].map(|name| self.temp.path().join(name))
    }

    /// The name under which traces are looked for.
    pub fn record() -> PathBuf {
        PathBuf::from(TRACE)
    }

    /// The frames of a dump that a run wrote here; there is at least one.
    ///
    /// # Errors
    /// It cannot be read or is damaged.
    pub fn frames(&self, dump: &Path) -> Result<Vec<Frame>, CompareError> {
        let mut all = Vec::new();
        Frame::each(&self.path().join(dump), |frame| all.push(frame))?;
        Ok(all)
    }

    /// All files as they are now.
    pub(super) fn files(&self) -> Result<Files, RunError> {
        listed(&self.path())
    }

    /// The text dumps, relative to the folder, and the traces that were written since there were these files.
    pub(super) fn written_since(&self, before: &Files) -> Result<(Vec<PathBuf>, Vec<PathBuf>), RunError> {
        let after = self.files()?;
        let new: Vec<_> = after.keys().filter(|p| after.get(*p) != before.get(*p)).collect();
        let whole = |p: &Path| self.path().join(p);
        let dump = |p: &&&PathBuf| is_dump(&whole(p)).unwrap_or(false);
        let mut dumps: Vec<_> = new.iter().filter(dump).map(|p| p.to_path_buf()).collect();
        let mut traces: Vec<_> = new.iter().filter(|p| is_trace(p)).map(|p| whole(p)).collect();
        dumps.sort();
        traces.sort();
        Ok((dumps, traces))
    }
}

fn is_trace(path: &Path) -> bool {
    let (stem, extension) = TRACE.split_once('.').unwrap_or((TRACE, ""));
    path.extension().is_some_and(|e| e == extension) && path.to_string_lossy().starts_with(stem)
}

/// All files below a folder, with what tells whether they were written to.
fn listed(root: &Path) -> Result<Files, RunError> {
    let mut files = HashMap::new();
    let mut folders = vec![root.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        for entry in entries.map_err(RunError::io("read", &folder))? {
            let (path, meta) = (entry.path(), entry.metadata().map_err(RunError::io("read", &folder))?);
            if meta.is_dir() {
                folders.push(path);
            } else if let Ok(name) = path.strip_prefix(root) {
                files.insert(name.to_path_buf(), (meta.len(), meta.modified().ok()));
            }
        }
    }
    Ok(files)
}
