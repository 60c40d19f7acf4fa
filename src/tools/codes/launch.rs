//! How a program is found and started.
use super::environment::isolated;
use super::RunError;
use std::env;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Whose environment a program gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Around {
    /// One that is made for it: see [`isolated`].
    Made,
    /// That of the user, without what he preloads.
    Users,
}

/// The command that starts a program on so many ranks, with variables of environment beside those around it that the program
/// gets and `mpirun` does not; its arguments are still to be added.
///
/// # Errors
/// More than one rank is asked for and there is no mpirun.
pub fn command(
    program: &Path,
    ranks: usize,
    around: Around,
    variables: &[(&str, String)],
) -> Result<Command, RunError> {
    let mpirun = (ranks > 1).then(|| which("mpirun").ok_or(RunError::NoMpirun { ranks })).transpose()?;
    let mut command = Command::new(mpirun.as_deref().unwrap_or(program));
    match around {
        Around::Made => command.env_clear().envs(isolated(env::vars_os(), ranks)),
        Around::Users => command.env_remove("LD_PRELOAD"),
    };
    if mpirun.is_none() {
        command.envs(variables.iter().map(|(name, value)| (name, value)));
        return Ok(command);
    }
    command.args(["--oversubscribe", "--bind-to", "none"]);
    if rustix::process::geteuid().is_root() {
        command.arg("--allow-run-as-root");
    }
    command.arg("-np").arg(ranks.to_string());
    for (name, value) in variables {
        command.arg("-x").arg(format!("{name}={value}"));
    }
    command.arg(program);
    Ok(command)
}

/// What a program prints to standard output and to standard error when it is asked something.
pub(super) fn answer(program: &Path, question: &[&str]) -> Result<[String; 2], RunError> {
    let mut command = command(program, 1, Around::Made, &[])?;
    let said =
        command.args(question).stdin(Stdio::null()).output().map_err(RunError::io("start", program))?;
    Ok([said.stdout, said.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()))
}

/// The first executable file of that name in PATH.
pub(super) fn which(name: &str) -> Option<PathBuf> {
    let runs = |p: &Path| p.metadata().is_ok_and(|m| m.is_file() && m.permissions().mode() & 0o111 != 0);
    env::split_paths(&env::var_os("PATH")?).map(|d| d.join(name)).find(|p| runs(p))
}
