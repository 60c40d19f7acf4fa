//! LAMMPS beside the others, where it is present: the same scene, a law of its own.
use super::clock::Clock;
use crate::liggghts::host::which;
use crate::liggghts::process::{run, End};
use crate::liggghts::RunError;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// LAMMPS: the program that was named, which must be there, or the `lmp` of PATH, if there is one.
///
/// # Errors
/// The named program is not there.
pub fn find(named: Option<&Path>) -> Result<Option<PathBuf>, RunError> {
    let Some(named) = named else { return Ok(which("lmp")) };
    let path = named.canonicalize().map_err(RunError::io("find LAMMPS as", named))?;
    Ok(Some(path))
}

/// The scene for LAMMPS that belongs to a deck.
pub(super) fn scene(deck: &Path) -> PathBuf {
    deck.with_extension("lammps")
}

/// Run a scene on one rank and one thread.
pub(super) fn time(program: &Path, scene: &Path, limit: Duration) -> Result<Clock, String> {
    let place = tempfile::tempdir().map_err(|e| format!("no folder for it: {e}"))?;
    let out = place.path().join("out");
    let file = || File::create(&out).map_err(|e| format!("cannot write {}: {e}", out.display()));
    let name = scene.file_name().unwrap_or_default();
    let folder = scene.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut command = Command::new(program);
    command.arg("-in").arg(name).args(["-log", "none"]).current_dir(folder);
    command.env("OMP_NUM_THREADS", "1").env_remove("LD_PRELOAD").env("TMPDIR", place.path());
    command.stdin(Stdio::null()).stdout(file()?).stderr(Stdio::null());
    let end = run(&mut command, limit).map_err(|e| format!("cannot start {}: {e}", program.display()))?;
    let said = std::fs::read_to_string(&out).unwrap_or_default();
    match end {
        End::Exited(status) if status.success() => {
            Clock::read(&said).ok_or_else(|| "LAMMPS printed no times".into())
        }
        End::Exited(_) => {
            let error = said.lines().find(|l| l.contains("ERROR")).unwrap_or("and gave no reason");
            Err(format!("LAMMPS failed: {error}"))
        }
        End::TimedOut => Err(format!("LAMMPS was stopped after {} s", limit.as_secs_f64())),
        End::Interrupted => Err("interrupted".into()),
    }
}
