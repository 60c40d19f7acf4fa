//! The report folder: written in a temporary folder beside its final place, then moved there.
use super::Report;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// One format of the report.
pub trait Writer {
    /// Writes its files into `dir`, an empty or freshly begun folder.
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError>;
}

/// A kind of folder: the names that its writers leave in it, and how its `report.json` begins. A folder with any other name in it is
/// not one of ours.
pub(super) struct Kind {
    pub ours: &'static [&'static str],
    pub format: &'static str,
    pub what: &'static str,
}

/// Why a report was not written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file or folder could not be made.
    #[error("failed to write {path}: {source}")]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The report could not be turned into JSON or XML.
    #[error("failed to format the report: {0}")]
    Format(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The place is taken by something that is not an earlier report.
    #[error("{dir} {why}; name a new folder, or one that holds an earlier {what} and nothing else")]
    Taken {
        /// Where the report should have gone.
        dir: PathBuf,
        /// What is in the way.
        why: String,
        /// What would have been replaced.
        what: &'static str,
    },
}

impl ReportError {
    pub(super) fn io(path: &Path, source: io::Error) -> Self {
        ReportError::Io { path: path.into(), source }
    }
}

/// Lets `write` fill a new folder, and moves that to `dir`.
pub(super) fn place(
    dir: &Path,
    kind: &Kind,
    write: impl FnOnce(&Path) -> Result<(), ReportError>,
) -> Result<(), ReportError> {
    let io = |e| ReportError::io(dir, e);
    kind.check(dir)?;
    let target = std::path::absolute(dir).map_err(io)?;
    let (Some(parent), Some(_)) = (target.parent(), target.file_name()) else {
        return Err(kind.taken(dir, "has no name of its own".into()));
    };
    fs::create_dir_all(parent).map_err(io)?;
    // It is beside `dir`, so that the last step is a rename within one file system; it is removed when dropped.
    let temporary = tempfile::Builder::new().prefix(".granlaw-report-").tempdir_in(parent).map_err(io)?;
    let fresh = temporary.path().join("new");
    fs::create_dir(&fresh).map_err(io)?;
    write(&fresh)?;
    // Someone may have put something there while the report was being written.
    kind.check(dir)?;
    let old = temporary.path().join("old");
    let replaced = target.exists();
    if replaced {
        fs::rename(&target, &old).map_err(io)?;
    }
    fs::rename(&fresh, &target).map_err(|e| {
        if replaced {
            // If this fails too, the first error is still the one to report.
            let _ = fs::rename(&old, &target);
        }
        io(e)
    })
}

/// Writes one file.
pub(super) fn save(path: &Path, content: &str) -> Result<(), ReportError> {
    fs::write(path, content).map_err(|e| ReportError::io(path, e))
}

impl Kind {
    fn taken(&self, dir: &Path, why: String) -> ReportError {
        ReportError::Taken { dir: dir.into(), why, what: self.what }
    }

    /// Whether a folder of this kind may be put there.
    pub(super) fn check(&self, dir: &Path) -> Result<(), ReportError> {
        let taken = |why: String| Err(self.taken(dir, why));
        let entries = match fs::read_dir(dir) {
            Ok(entries) => entries,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(()),
            Err(e) if e.kind() == io::ErrorKind::NotADirectory => return taken("is not a folder".into()),
            Err(e) => return Err(ReportError::io(dir, e)),
        };
        if std::path::absolute(dir)
            .is_ok_and(|d| std::env::current_dir().is_ok_and(|here| here.starts_with(d)))
        {
            return taken("is the folder you are in".into());
        }
        let mut names = Vec::new();
        for entry in entries {
            names.push(entry.map_err(|e| ReportError::io(dir, e))?.file_name());
        }
        let stranger = names.iter().find(|name| !self.ours.iter().any(|ours| name.as_os_str() == *ours));
        let what = self.what;
        match stranger {
            _ if names.is_empty() => Ok(()),
            Some(name) => taken(format!("holds {}, which no {what} of ours does", name.to_string_lossy())),
            None if self.made(dir) => Ok(()),
            None => taken(format!("is no {what} of ours (it has no report.json that says so)")),
        }
    }

    /// Whether the folder's `report.json` begins as ours do.
    fn made(&self, dir: &Path) -> bool {
        let family = self.format.trim_end_matches(|c: char| c != '/');
        fs::read_to_string(dir.join("report.json"))
            .is_ok_and(|text| text.chars().take(80).collect::<String>().contains(family))
    }
}
