//! What the tests on built libraries share: the libraries of this very source, compilers, skips that are seen.
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

/// The source of granlaw.
pub fn source() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder with `granlaw`, `libgranlaw.so`, `libgranlaw.a` and the plugin, built from the source as it is now:
/// `cargo test` alone builds no libraries, and those that an earlier build left behind would be tested in their place.
pub fn built() -> &'static Path {
    static BUILT: LazyLock<PathBuf> = LazyLock::new(|| {
        let beside = Path::new(env!("CARGO_BIN_EXE_granlaw")).parent().expect("a folder").to_path_buf();
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--quiet", "--locked", "--workspace"]).current_dir(source());
        build.env("CARGO_TARGET_DIR", beside.parent().expect("a folder"));
        if beside.ends_with("release") {
            build.arg("--release");
        }
        must(&mut build);
        beside
    });
    &BUILT
}

/// Run to the end; anything but success fails the test with what was said.
pub fn must(command: &mut Command) -> Output {
    let out = command.output().unwrap_or_else(|e| panic!("{command:?}: {e}"));
    assert!(out.status.success(), "{command:?}: {}\n{}", out.status, said(&out));
    out
}

/// All that was said, standard output first.
pub fn said(out: &Output) -> String {
    String::from_utf8_lossy(&[&out.stdout[..], b"\n", &out.stderr].concat()).into_owned()
}

/// Whether something that a test needs is here. Without it the test is skipped by its name, or fails where
/// `GRANLAW_REQUIRE_LIGGGHTS` is set.
pub fn here(test: &str, found: bool, missing: &str) -> bool {
    if !found {
        assert!(
            std::env::var_os("GRANLAW_REQUIRE_LIGGGHTS").is_none(),
            "{test} cannot be skipped: {missing}"
        );
        // The test harness hides what goes through eprintln, and a skip must be seen.
        let _ = writeln!(std::io::stderr(), "skipped: {test}: {missing}");
    }
    found
}

/// Whether PATH leads to a program.
pub fn has(program: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|d| d.join(program).is_file())
}

/// LIGGGHTS in a folder. Alone it need not look for networks nor start a daemon, and starts three times as fast; what
/// MPI keeps for itself must then lie apart from that of others.
pub fn alone(program: &Path, folder: &Path) -> Command {
    let mut command = Command::new(program);
    let settings = [("ess_singleton_isolated", "1"), ("pml", "ob1"), ("btl", "self")];
    command.envs(settings.map(|(name, value)| (format!("OMPI_MCA_{name}"), value)));
    command.current_dir(folder).env("TMPDIR", folder);
    command
}
