//! The programs behind a study's document.
use super::in_liggghts::Bench;
use crate::codes::RunError;
use crate::report::{About, Check, Outcome, Shows};

/// Programs and machine; if LIGGGHTS was not used, the reason.
pub fn about(command: &str, bench: Result<&Bench, &RunError>) -> About {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
    let mut about = About {
        granlaw: env!("CARGO_PKG_VERSION").into(),
        machine: format!("{os} {arch}, {cores} cores"),
        command: command.into(),
        ..About::default()
    };
    if let Ok(bench) = bench {
        about.liggghts = Some(bench.host.version.clone());
        about.plugin = Some(bench.plugin.path.display().to_string());
    }
    about
}

/// A check that LIGGGHTS did all that it was asked to do; skipped if it was not there.
pub fn ran(bench: Result<&Bench, &RunError>, trouble: &[String]) -> Check {
    let outcome = match (bench, trouble) {
        (Err(e), _) => Outcome::Skipped(format!("nothing was run in LIGGGHTS: {e}")),
        (_, []) => Outcome::Agreed,
        (_, some) => Outcome::CouldNotRun(some.join("; ")),
    };
    let name = "runs of LIGGGHTS".into();
    Check { name, shows: Shows::Boundary, outcome, tolerance: None, worst: None }
}
