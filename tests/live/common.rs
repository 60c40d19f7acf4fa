//! What the tests on the real LIGGGHTS share: whether it is here, decks, scratch folders, and what granlaw said.
use crate::built::{built, here};
use granlaw_tools::codes::environment::VARIABLES;
use granlaw_tools::codes::liggghts::{Liggghts, Plugin};
use granlaw_tools::codes::RunError;
use rustix::process::{kill_process, Pid, Signal};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

/// The program under test.
pub fn program() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_granlaw"))
}

/// Whether LIGGGHTS and its headers are here.
pub fn live(test: &str) -> bool {
    static MISSING: LazyLock<Option<RunError>> =
        LazyLock::new(|| Liggghts::find().and_then(|_| plugin()).err());
    here(test, MISSING.is_none(), &MISSING.as_ref().map(ToString::to_string).unwrap_or_default())
}

/// The plugin, built from the source as it is now.
pub fn plugin() -> Result<Plugin, RunError> {
    Plugin::open(&built().join("libgranlaw_liggghts.so"))
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A deck of ours with lines changed. Every text must occur in it, so that no fault is planted beside the bed.
pub fn deck(name: &str, changes: &[(&str, &str)]) -> String {
    let path = crate::built::source().join("liggghts_inputs").join(name);
    let mut deck = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    for (from, to) in changes {
        assert!(deck.contains(from), "{name} has no {from:?} to change");
        deck = deck.replace(from, to);
    }
    deck
}

/// A folder that goes away, with a corner for the temporary folders of the runs.
pub struct Scratch {
    dir: tempfile::TempDir,
}

impl Scratch {
    pub fn new() -> Scratch {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join("tmp")).unwrap();
        Scratch { dir }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.dir.path().join(name)
    }

    /// Write a file, and the folder that it is in.
    pub fn file(&self, name: &str, text: &str) -> PathBuf {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        path
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// A command that runs here, with nothing in its environment that speaks to granlaw.
    pub fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        VARIABLES.iter().for_each(|v| {
            command.env_remove(v.name);
        });
        // Ranks that wait would take the processors from those that work.
        command.env("OMPI_MCA_mpi_yield_when_idle", "1");
        command.current_dir(self.dir.path()).env("TMPDIR", self.path("tmp"));
        command
    }

    pub fn granlaw(&self, args: &[&str]) -> Said {
        let mut command = self.command(program());
        Said::of(command.args(args))
    }

    /// What is left of the runs: files in their corner, and processes that are still at work here.
    pub fn left(&self) -> Vec<String> {
        let files = fs::read_dir(self.path("tmp")).unwrap().map(|e| e.unwrap().path().display().to_string());
        let named = |p: PathBuf| text(&fs::read(p.join("cmdline")).unwrap_or_default()).replace('\0', " ");
        files.chain(self.at_work().into_iter().map(named)).collect()
    }

    /// The processes at work here, by their folders in /proc.
    fn at_work(&self) -> Vec<PathBuf> {
        let here = self.dir.path().canonicalize().unwrap();
        let works_here = |p: &PathBuf| fs::read_link(p.join("cwd")).is_ok_and(|cwd| cwd.starts_with(&here));
        fs::read_dir("/proc").unwrap().map(|e| e.unwrap().path()).filter(works_here).collect()
    }
}

/// A test that fails must not leave its runs behind: one of them is endless.
impl Drop for Scratch {
    fn drop(&mut self) {
        let ids = self.at_work().into_iter().filter_map(|p| p.file_name()?.to_str()?.parse().ok());
        for id in ids.filter_map(Pid::from_raw) {
            let _ = kill_process(id, Signal::KILL);
        }
    }
}

/// How a command ended and what it said.
pub struct Said {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Said {
    pub fn of(command: &mut Command) -> Said {
        Said::from(command.output().unwrap_or_else(|e| panic!("{command:?}: {e}")))
    }

    /// It ended with this code and said these words.
    #[track_caller]
    pub fn ends(self, code: i32, words: &[&str]) -> Said {
        assert_eq!(self.code, Some(code), "{self}");
        self.says(words)
    }

    #[track_caller]
    pub fn says(self, words: &[&str]) -> Said {
        for word in words {
            assert!(self.out.contains(word) || self.err.contains(word), "{word:?} is not in\n{self}");
        }
        self
    }
}

impl From<Output> for Said {
    fn from(o: Output) -> Said {
        Said { code: o.status.code(), out: text(&o.stdout), err: text(&o.stderr) }
    }
}

impl std::fmt::Display for Said {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "exit {:?}\n{}\n{}", self.code, self.out, self.err)
    }
}

/// The `report.json` of a report folder.
pub fn report(folder: &Path) -> Value {
    let text = fs::read_to_string(folder.join("report.json"));
    serde_json::from_str(&text.unwrap_or_else(|e| panic!("{}: {e}", folder.display()))).unwrap()
}

/// A case of a report by its name.
pub fn case<'a>(report: &'a Value, name: &str) -> &'a Value {
    let cases = report["cases"].as_array().unwrap();
    cases.iter().find(|c| c["name"] == name).unwrap_or_else(|| panic!("no case {name}"))
}

/// How a check of a case ended, as a word, and why.
pub fn outcome<'a>(case: &'a Value, check: &str) -> (&'a str, &'a str) {
    let checks = case["checks"].as_array().unwrap();
    let check = checks.iter().find(|c| c["name"] == check).unwrap_or_else(|| panic!("no {check} in {case}"));
    let outcome = &check["outcome"];
    (outcome["is"].as_str().unwrap(), outcome["why"].as_str().unwrap_or_default())
}
