//! Where LIGGGHTS is and how it is started.
use super::{clean, RunError};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// LIGGGHTS, found on this machine.
#[derive(Clone, Debug)]
pub struct Host {
    /// The program.
    pub program: PathBuf,
    /// What it calls itself.
    pub version: String,
}

impl Host {
    /// LIGGGHTS, as the first `liggghts` of PATH.
    ///
    /// # Errors
    /// There is none.
    pub fn find() -> Result<Host, RunError> {
        let program = which("liggghts").ok_or(RunError::NoLiggghts)?;
        let said = alone(&mut clean(&program)).args(["-log", "none", "-h"]).stdin(Stdio::null()).output();
        let said = said.map_err(RunError::io("start", &program))?;
        let [out, err] = [&said.stdout, &said.stderr].map(|text| String::from_utf8_lossy(text));
        match version_of(&out) {
            Some(version) => Ok(Host { program, version }),
            None => Err(RunError::NotLiggghts { program, said: beginning(&format!("{out}\n{err}")) }),
        }
    }

    /// The command that starts LIGGGHTS on `ranks` ranks with variables of environment that only it sees; its
    /// arguments are still to be added.
    ///
    /// # Errors
    /// More than one rank is asked for and there is no mpirun.
    pub fn command(&self, ranks: usize, env: &[(&str, String)]) -> Result<Command, RunError> {
        if ranks == 1 {
            let mut command = clean(&self.program);
            command.envs(env.iter().map(|(k, v)| (k, v)));
            return Ok(command);
        }
        let mut command = clean(&which("mpirun").ok_or(RunError::NoMpirun { ranks })?);
        command.args(["--oversubscribe", "--bind-to", "none"]);
        if rustix::process::geteuid().is_root() {
            command.arg("--allow-run-as-root");
        }
        command.arg("-np").arg(ranks.to_string());
        for (name, value) in env {
            command.arg("-x").arg(format!("{name}={value}"));
        }
        command.arg(&self.program);
        Ok(command)
    }
}

/// A rank that is alone talks to nobody. Open MPI then need not look for networks nor start a daemon, which makes it
/// start three times as fast and leaves nothing running when it is stopped; elsewhere these variables mean nothing.
pub(super) fn alone(command: &mut Command) -> &mut Command {
    let settings = [("ess_singleton_isolated", "1"), ("pml", "ob1"), ("btl", "self")];
    command.envs(settings.map(|(name, value)| (format!("OMPI_MCA_{name}"), value)))
}

/// `LIGGGHTS-PUBLIC 3.8.0, compiled …` of LIGGGHTS's first line.
fn version_of(text: &str) -> Option<String> {
    let begin = text.strip_prefix("LIGGGHTS (Version ")?;
    let line = begin.lines().next()?;
    Some(line.split(", git").next()?.trim_end_matches(')').to_string())
}

/// The first line that says something.
fn beginning(text: &str) -> String {
    let says = |l: &&str| l.contains(char::is_alphanumeric);
    text.lines().find(says).unwrap_or("nothing").trim().chars().take(200).collect()
}

/// The first executable file of that name in PATH.
pub(crate) fn which(name: &str) -> Option<PathBuf> {
    let runs = |p: &Path| p.metadata().is_ok_and(|m| m.is_file() && m.permissions().mode() & 0o111 != 0);
    std::env::split_paths(&std::env::var_os("PATH")?).map(|d| d.join(name)).find(|p| runs(p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn version_line() {
        let said = "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd, git commit x)\n\nCommand";
        let version = "LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd";
        assert_eq!(version_of(said).as_deref(), Some(version));
        assert_eq!(version_of("usage: something else"), None);
    }
}
