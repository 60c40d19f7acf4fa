//! LIGGGHTS as a process: a deck, perhaps our plugin, and a time limit go in; files or a clear error come out.
//!
//! Each run has its own folder. LIGGGHTS itself is never changed: the plugin enters through `LD_PRELOAD`.
use crate::compare::is_dump;
use crate::deck::Deck;
use std::collections::HashMap;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};
use tempfile::TempDir;

mod error;
pub(crate) mod host;
mod plugin;
pub(crate) mod process;

pub use error::RunError;
pub use host::Host;
pub use plugin::Plugin;
pub use process::interrupt;

/// Whose laws answer to which names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Laws {
    /// `/rs` names are ours, stock names LIGGGHTS's own.
    #[default]
    Own,
    /// Ours take over the stock names.
    Rust,
    /// As `Own`, but stock laws run in our chain, so that their calls can be recorded.
    Stock,
}

/// How the pair style goes through the contacts of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// All of them in one call; LIGGGHTS stops with the reason where that is not possible.
    Batched,
    /// One by one.
    Contact,
}

/// The plugin and what it is to do.
#[derive(Clone, Debug)]
pub struct Preload<'a> {
    /// The plugin.
    pub plugin: &'a Plugin,
    /// Whose laws run.
    pub laws: Laws,
    /// Where contact calls are recorded, if they are.
    pub record: Option<PathBuf>,
    /// Every how many steps they are.
    pub every: u64,
    /// Where a probe of the contacts is written, if it is.
    pub probe: Option<PathBuf>,
    /// The largest difference allowed where every call is held against the Rust laws, if it is.
    pub shadow: Option<f64>,
    /// File name of the deck, for the traces.
    pub deck: Option<String>,
    /// Whether the probe follows as many contacts as it has room for, at any cost.
    pub closely: bool,
    /// A probed run ends in order after so many steps.
    pub steps: Option<u64>,
    /// Whether to warn when the time step is too long for a contact.
    pub alarm: bool,
    /// How the pair style goes through its contacts; without it, batched where possible.
    pub route: Option<Route>,
    /// How many contacts go side by side, 1, 4, 8 or `widest`; without it, as many as suit the processor and the scene.
    pub lanes: Option<String>,
}

impl<'a> Preload<'a> {
    /// The plugin with its laws, and nothing else to do.
    pub fn new(plugin: &'a Plugin, laws: Laws) -> Preload<'a> {
        let (record, every, probe, shadow, deck) = (None, 1, None, None, None);
        let (closely, steps, alarm, route, lanes) = (false, None, false, None, None);
        Preload { plugin, laws, record, every, probe, closely, shadow, deck, steps, alarm, route, lanes }
    }

    /// The environment that carries this to the plugin.
    pub fn env(&self) -> Vec<(&'static str, String)> {
        let laws = match self.laws {
            Laws::Own => "own",
            Laws::Rust => "rust",
            Laws::Stock => "stock",
        };
        let mut env =
            vec![("LD_PRELOAD", self.plugin.path.display().to_string()), ("GRANLAW_LAWS", laws.into())];
        if let Some(path) = &self.record {
            env.push(("GRANLAW_RECORD", path.display().to_string()));
            env.push(("GRANLAW_EVERY", self.every.to_string()));
        }
        let route = self.route.map(|r| if r == Route::Batched { "batched" } else { "contact" });
        env.extend(route.map(|r| ("GRANLAW_PATH", r.into())));
        env.extend(self.lanes.iter().map(|n| ("GRANLAW_LANES", n.clone())));
        env.extend(self.steps.map(|n| ("GRANLAW_STEPS", n.to_string())));
        env.extend(self.alarm.then(|| ("GRANLAW_TIMESTEP", "warn".into())));
        env.extend(self.probe.iter().map(|p| ("GRANLAW_PROBE", p.display().to_string())));
        env.extend(self.closely.then(|| ("GRANLAW_FOLLOW", "all".into())));
        if let Some(tolerance) = self.shadow {
            env.push(("GRANLAW_SHADOW", "on".into()));
            env.push(("GRANLAW_TOLERANCE", format!("{tolerance:e}")));
        }
        env.extend(self.deck.iter().map(|d| ("GRANLAW_DECK", d.clone())));
        env
    }
}

/// A folder of its own for a run, gone when dropped.
#[derive(Debug)]
pub struct Folder {
    temp: TempDir,
}

/// What a run left behind.
#[derive(Debug)]
pub struct Ran {
    /// Wall-clock time \[s\].
    pub seconds: f64,
    /// The text dumps that it wrote, relative to the folder, in alphabetic order.
    pub dumps: Vec<PathBuf>,
    /// The traces that it wrote, in alphabetic order.
    pub traces: Vec<PathBuf>,
    /// The warnings that LIGGGHTS printed.
    pub warnings: Vec<String>,
}

/// The file in which a run's own words stand.
pub(crate) const LOG: &str = "log.liggghts";

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

    fn empty() -> Result<Folder, RunError> {
        let temp = tempfile::Builder::new().prefix("granlaw-").tempdir();
        let folder = Folder { temp: temp.map_err(RunError::io("create", &std::env::temp_dir()))? };
        fs::create_dir(folder.path()).map_err(RunError::io("create", &folder.path()))?;
        Ok(folder)
    }

    /// Where the run takes place.
    pub fn path(&self) -> PathBuf {
        self.temp.path().join("run")
    }

    /// Run a deck here, on as many ranks as it asks for.
    ///
    /// # Errors
    /// LIGGGHTS cannot be started, fails, or runs past `limit`; nothing that it started is left running.
    pub fn run(
        &self,
        host: &Host,
        deck: &Deck,
        preload: Option<&Preload<'_>>,
        limit: Duration,
    ) -> Result<Ran, RunError> {
        let before = listed(&self.path())?;
        let outputs = ["stdout", "stderr"].map(|name| self.temp.path().join(name));
        let [out, err] = outputs.each_ref().map(|p| File::create(p).map_err(RunError::io("create", p)));
        let env = preload.map(Preload::env).unwrap_or_default();
        let mut command = host.command(deck.ranks, &env)?;
        command.args(["-in", &deck.file()]).current_dir(self.path());
        for (name, value) in &deck.variables {
            command.args(["-var", name, value]);
        }
        if deck.ranks == 1 {
            host::alone(&mut command);
        }
        // MPI keeps a folder of its own, and leaves it where it is stopped.
        command.env("TMPDIR", self.temp.path());
        command.stdin(Stdio::null()).stdout(out?).stderr(err?);
        let begun = Instant::now();
        let end = process::run(&mut command, limit).map_err(RunError::io("start", &host.program))?;
        let said = error::Said::read(&self.path().join(LOG), &outputs);
        said.judge(deck, end, limit)?;
        let after = listed(&self.path())?;
        let new = |path: &PathBuf| after.get(path) != before.get(path);
        let mut dumps: Vec<_> = after
            .keys()
            .filter(|p| new(p) && is_dump(&self.path().join(p)).unwrap_or(false))
            .cloned()
            .collect();
        let mut traces: Vec<_> =
            after.keys().filter(|p| new(p) && is_trace(p)).map(|p| self.path().join(p)).collect();
        dumps.sort();
        traces.sort();
        Ok(Ran { seconds: begun.elapsed().as_secs_f64(), dumps, traces, warnings: said.warnings() })
    }

    /// The name under which [`Folder::run`] looks for traces.
    pub fn record() -> PathBuf {
        PathBuf::from(TRACE)
    }
}

fn is_trace(path: &Path) -> bool {
    let (stem, extension) = TRACE.split_once('.').unwrap_or((TRACE, ""));
    path.extension().is_some_and(|e| e == extension) && path.to_string_lossy().starts_with(stem)
}

/// All files below a folder, with what tells whether they were written to.
fn listed(root: &Path) -> Result<HashMap<PathBuf, (u64, Option<SystemTime>)>, RunError> {
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

/// A command that this process becomes or starts, free of what a plugin in our own environment would leave in it.
fn clean(program: &Path) -> Command {
    let mut command = Command::new(program);
    command.env_remove("LD_PRELOAD");
    for name in
        ["LAWS", "RECORD", "EVERY", "PROBE", "FOLLOW", "STEPS", "TIMESTEP", "SHADOW", "TOLERANCE", "DECK"]
    {
        command.env_remove(format!("GRANLAW_{name}"));
    }
    command
}
