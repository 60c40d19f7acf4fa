//! The plugin as a file: where it is, and whether it is one for us.
use crate::codes::RunError;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

const NAME: &str = "libgranlaw_liggghts.so";
const MARK: &[u8] = b"granlaw-plugin abi=";

/// The plugin, found and fit for use.
#[derive(Clone, Debug)]
pub struct Plugin {
    /// The shared object, as an absolute path.
    pub path: PathBuf,
    /// The LIGGGHTS that it was built for.
    pub liggghts: String,
}

impl Plugin {
    /// The version of the agreement between plugin and command line.
    pub const ABI: u32 = 3;

    /// The plugin that `GRANLAW_PLUGIN` names; else the one beside this executable, in `../lib/granlaw` or in `../lib`.
    ///
    /// # Errors
    /// There is none, or it is not one for this version.
    pub fn find() -> Result<Plugin, RunError> {
        if let Some(path) = env::var_os("GRANLAW_PLUGIN") {
            return Plugin::open(Path::new(&path));
        }
        let here = env::current_exe().and_then(|p| p.canonicalize()).unwrap_or_default();
        let here = here.parent().unwrap_or(Path::new("."));
        let looked: Vec<_> =
            ["", "../lib/granlaw", "../lib"].iter().map(|d| here.join(d).join(NAME)).collect();
        match looked.iter().find(|p| p.is_file()) {
            Some(path) => Plugin::open(path),
            None => Err(RunError::NoPlugin { looked }),
        }
    }

    /// The plugin in a certain file.
    ///
    /// # Errors
    /// The file cannot be read or is not a plugin for this version.
    pub fn open(path: &Path) -> Result<Plugin, RunError> {
        let refuse = |why| RunError::WrongPlugin { path: path.to_path_buf(), why, abi: Plugin::ABI };
        let bytes = fs::read(path).map_err(|e| refuse(format!("cannot be read: {e}")))?;
        let (abi, liggghts) = marks(&bytes).ok_or_else(|| refuse("is not a granlaw plugin".into()))?;
        if abi != Plugin::ABI {
            let ours = Plugin::ABI;
            return Err(refuse(format!("has ABI version {abi}, this granlaw needs {ours}")));
        }
        if liggghts == "none" {
            return Err(refuse("was built without LIGGGHTS's headers and so cannot enter LIGGGHTS".into()));
        }
        let path = path.canonicalize().map_err(|e| refuse(format!("cannot be read: {e}")))?;
        Ok(Plugin { path, liggghts })
    }
}

/// The ABI version and the LIGGGHTS version that a plugin carries as text among its bytes.
fn marks(bytes: &[u8]) -> Option<(u32, String)> {
    // The bare mark may stand in the file too, as the constant above does in ours: only a complete one counts.
    bytes.windows(MARK.len()).enumerate().filter(|(_, w)| *w == MARK).find_map(|(at, _)| {
        let rest = &bytes[at + MARK.len()..];
        let text = String::from_utf8_lossy(&rest[..rest.len().min(200)]).into_owned();
        let (text, _) = text.split_once(" end")?;
        let (abi, liggghts) = text.split_once(" liggghts=")?;
        Some((abi.parse().ok()?, liggghts.to_string()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_complete_mark_counts() {
        let bytes = b"\0granlaw-plugin abi=\0x\0granlaw-plugin abi=7 liggghts=3.8.0 end\0";
        assert_eq!(marks(bytes), Some((7, "3.8.0".into())));
        assert_eq!(marks(b"granlaw-plugin abi=7"), None);
        assert_eq!(marks(b"nothing of ours"), None);
    }

    #[test]
    fn a_foreign_file_is_refused_in_words() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("x.so");
        for (bytes, says) in [
            ("\x7fELF", "is not a granlaw plugin"),
            ("granlaw-plugin abi=9 liggghts=3.8.0 end", "has ABI version 9, this granlaw needs 3"),
            ("granlaw-plugin abi=3 liggghts=none end", "without LIGGGHTS's headers"),
        ] {
            fs::write(&path, bytes).unwrap();
            let error = Plugin::open(&path).unwrap_err().to_string();
            assert!(error.contains(says) && error.contains("x.so"), "{error}");
        }
        assert!(Plugin::open(&dir.path().join("none.so"))
            .unwrap_err()
            .to_string()
            .contains("cannot be read"));
    }
}
