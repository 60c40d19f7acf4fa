//! `scripts/install.sh` and `scripts/uninstall.sh`: what is put under a prefix works from there and goes away again.

use crate::built::{built, has, here, must, said, source};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

const INSTALLED: [&str; 8] = [
    "bin/granlaw",
    "include/granlaw.h",
    "lib/granlaw/libgranlaw_liggghts.so",
    "lib/granlaw/manifest",
    "lib/libgranlaw.a",
    "lib/libgranlaw.so",
    "lib/libgranlaw.so.1",
    "lib/pkgconfig/granlaw.pc",
];

fn script(name: &str, prefix: &Path) -> Command {
    let mut command = Command::new(source().join("scripts").join(name));
    command.arg("--prefix").arg(prefix).env_remove("DESTDIR");
    command
}

/// From the libraries of this build.
fn install(prefix: &Path) -> Command {
    let mut command = script("install.sh", prefix);
    command.arg("--from").arg(built());
    command
}

fn installed() -> (TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let prefix = dir.path().join("usr");
    must(&mut install(&prefix));
    (dir, prefix)
}

/// Every file below a folder, and every empty folder.
fn below(folder: &Path) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        let inside: Vec<_> = fs::read_dir(&next).unwrap().map(|e| e.unwrap().path()).collect();
        if inside.is_empty() && next != folder {
            all.insert(next.strip_prefix(folder).unwrap().display().to_string());
        }
        for path in inside {
            if path.is_dir() {
                open.push(path);
            } else {
                all.insert(path.strip_prefix(folder).unwrap().display().to_string());
            }
        }
    }
    all
}

fn set(files: &[&str]) -> BTreeSet<String> {
    files.iter().map(|f| f.to_string()).collect()
}

fn fails(command: &mut Command, with: &str) {
    let out = command.output().unwrap();
    assert_eq!(out.status.code(), Some(2), "{}", said(&out));
    assert!(said(&out).contains(with), "no {with:?} in: {}", said(&out));
}

#[test]
fn everything_arrives_and_goes_again() {
    // The plugin is left out where LIGGGHTS's headers are missing.
    let test = "everything_arrives_and_goes_again";
    if !here(test, Path::new("/usr/include/liggghts").exists(), "no headers of LIGGGHTS") {
        return;
    }
    let (_dir, prefix) = installed();
    assert_eq!(below(&prefix), set(&INSTALLED));
    must(&mut install(&prefix)); // a second time over the first
    must(&mut script("uninstall.sh", &prefix));
    assert_eq!(below(&prefix), set(&[]));
}

#[test]
fn what_others_put_there_stays() {
    let dir = tempfile::tempdir().unwrap();
    let prefix = dir.path();
    fs::create_dir_all(prefix.join("lib/pkgconfig")).unwrap(); // empty, and not ours
    fs::create_dir_all(prefix.join("include")).unwrap();
    fs::write(prefix.join("include/other.h"), "").unwrap();
    must(&mut install(prefix));
    fs::write(prefix.join("lib/granlaw/notes"), "").unwrap();
    fs::write(prefix.join("lib/libother.so"), "").unwrap();
    must(&mut script("uninstall.sh", prefix));
    assert_eq!(
        below(prefix),
        set(&["include/other.h", "lib/granlaw/notes", "lib/libother.so", "lib/pkgconfig"])
    );
}

#[test]
fn destdir_is_a_root_of_its_own() {
    let stage = tempfile::tempdir().unwrap();
    let prefix = Path::new("/opt/granlaw");
    must(install(prefix).env("DESTDIR", stage.path()));
    let pc = fs::read_to_string(stage.path().join("opt/granlaw/lib/pkgconfig/granlaw.pc")).unwrap();
    assert!(pc.starts_with("prefix=/opt/granlaw\n"), "{pc}");
    assert!(!prefix.exists());
    must(script("uninstall.sh", prefix).env("DESTDIR", stage.path()));
    assert_eq!(below(stage.path()), set(&["opt/granlaw"]));
}

#[test]
fn a_fault_is_told_and_nothing_is_removed() {
    let (_dir, prefix) = installed();
    let manifest = prefix.join("lib/granlaw/manifest");
    let good = fs::read_to_string(&manifest).unwrap();
    for bad in ["file ../../etc/passwd", "file /etc/passwd", "rm bin/granlaw"] {
        fs::write(&manifest, format!("{good}{bad}\n")).unwrap();
        fails(&mut script("uninstall.sh", &prefix), "nothing was removed");
        assert!(prefix.join("bin/granlaw").exists(), "{bad}");
    }
    fails(&mut script("uninstall.sh", Path::new("/nowhere")), "granlaw is not installed under /nowhere");
    fails(script("install.sh", &prefix.join("bin/granlaw")).arg("--from").arg(built()), "cannot write to");
    fails(script("install.sh", &prefix).args(["--from", "/nowhere"]), "there is no /nowhere/granlaw");
    fails(script("install.sh", &prefix).arg("--quick"), "unknown argument --quick");
}

/// Compile a program of `tests/abi` as the README says, and run it.
fn with_pkg_config(prefix: &Path, program: &str, how: &str, asked: &str) -> Output {
    let out = prefix.join("program");
    let line =
        format!("cc {how} \"$0\" -o \"$1\" $(pkg-config {asked} --cflags --libs granlaw) -lm -lpthread");
    let mut cc = Command::new("sh");
    cc.args(["-c", &line]).arg(source().join(format!("tests/live/abi/{program}.c"))).arg(&out);
    must(cc.env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig")));
    Command::new(&out).env("LD_LIBRARY_PATH", prefix.join("lib")).output().unwrap()
}

#[test]
fn a_c_program_finds_the_library_through_pkg_config() {
    let (_dir, prefix) = installed();
    for program in ["laws", "chain", "threads"] {
        let shared = with_pkg_config(&prefix, program, "", "");
        assert!(shared.status.success(), "{program}: {}", said(&shared));
    }
    let needed = said(&must(Command::new("readelf").arg("-d").arg(prefix.join("program"))));
    assert!(needed.contains("[libgranlaw.so.1]"), "not linked by its soname:\n{needed}");

    // Without the shared library only a static program runs.
    let program = prefix.join("program");
    fs::rename(prefix.join("lib/libgranlaw.so.1"), prefix.join("away")).unwrap();
    let lost = Command::new(&program).env("LD_LIBRARY_PATH", prefix.join("lib")).output().unwrap();
    assert!(!lost.status.success(), "the shared program ran without its library");
    let fixed = with_pkg_config(&prefix, "chain", "-static", "--static");
    assert!(fixed.status.success(), "static: {}", said(&fixed));
}

#[test]
fn each_library_has_its_own_soname() {
    for (file, soname) in [("libgranlaw.so", "[libgranlaw.so.1]"), ("libgranlaw_liggghts.so", "")] {
        let dynamic = said(&must(Command::new("readelf").arg("-d").arg(built().join(file))));
        let line = dynamic.lines().find(|l| l.contains("(SONAME)")).unwrap_or_default();
        assert!(line.ends_with(soname) && line.is_empty() == soname.is_empty(), "{file}: {line}");
    }
}

#[test]
fn the_installed_program_finds_its_plugin() {
    if !here("the_installed_program_finds_its_plugin", has("liggghts"), "no liggghts; install it") {
        return;
    }
    let (_dir, prefix) = installed();
    let deck = fs::read_to_string(source().join("liggghts_inputs/hooke_damped.in")).unwrap();
    assert!(deck.contains("model hooke "), "the deck has no stock name to change");
    fs::write(prefix.join("deck.in"), deck.replace("model hooke ", "model hooke/rs ")).unwrap();
    let run = || {
        let mut granlaw = Command::new(prefix.join("bin/granlaw"));
        granlaw.args(["run", "--", "-in", "deck.in"]).current_dir(&prefix).env_remove("GRANLAW_PLUGIN");
        granlaw.output().unwrap()
    };
    let out = run();
    assert!(out.status.success() && prefix.join("dump.txt").exists(), "{}", said(&out));
    fs::remove_file(prefix.join("lib/granlaw/libgranlaw_liggghts.so")).unwrap();
    let lost = run();
    assert_eq!(lost.status.code(), Some(2), "{}", said(&lost));
    assert!(said(&lost).contains("lib/granlaw/libgranlaw_liggghts.so"), "{}", said(&lost));
}
