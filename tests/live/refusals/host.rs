//! Hosts that the plugin must not enter, and coarse-graining, which no deck of this LIGGGHTS can switch on.
use super::deck::{can, chain_with, each_side, Deck};
use crate::built::{must, source};
use granlaw::laws::LAWS;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn deck() -> Deck {
    Deck::new("model hooke/rs", "model hooke/rs")
}

/// The library that holds LIGGGHTS's code.
fn library() -> PathBuf {
    let out = must(Command::new("sh").args(["-c", "ldd \"$(command -v liggghts)\""]));
    let text = String::from_utf8(out.stdout).unwrap();
    let line = text.lines().find(|l| l.contains("libliggghts.so.3")).expect("liggghts has a library");
    PathBuf::from(line.split_whitespace().nth(2).unwrap())
}

/// A copy of the library with some bytes changed, in a folder for LD_LIBRARY_PATH.
fn doctored(from: &str, to: &str) -> tempfile::TempDir {
    assert_eq!(from.len(), to.len());
    let mut bytes = fs::read(library()).unwrap();
    let mut changed = 0;
    for at in 0..bytes.len() - from.len() {
        if bytes[at..].starts_with(from.as_bytes()) {
            bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
            changed += 1;
        }
    }
    assert!(changed > 0 || from == to, "the library does not say {from:?}");
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("libliggghts.so.3"), bytes).unwrap();
    dir
}

#[test]
fn another_version_is_not_entered() {
    if !can("another_version_is_not_entered") {
        return;
    }
    let enter = |dir: &Path| deck().env("LD_LIBRARY_PATH", dir.to_str().unwrap());
    let words = "granlaw: this plugin is made for LIGGGHTS-PUBLIC 3.8.0 (Debian package liggghts); build it against your LIGGGHTS's headers";
    let other = doctored("LIGGGHTS-PUBLIC 3.8.0", "LIGGGHTS-PUBLIC 3.9.1");
    let ran = enter(other.path()).refused(2, words);
    assert!(!ran.said.contains("Created"), "LIGGGHTS ran on: {}", ran.said);
    // A copy that says nothing else is entered, so it was the version that was refused.
    enter(doctored("", "").path()).runs();
}

/// A library with one symbol more.
fn with_symbol(name: &str, dir: &Path) -> PathBuf {
    let (source, out) = (dir.join("symbol.c"), dir.join("symbol.so"));
    fs::write(&source, format!("void {name}(void) {{}}\n")).unwrap();
    must(Command::new("cc").args(["-shared", "-fPIC", "-o"]).arg(&out).arg(&source));
    out
}

#[test]
fn another_layout_is_not_entered() {
    if !can("another_layout_is_not_entered") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let words =
        "granlaw: this LIGGGHTS is built for non-spherical particles, whose structs are laid out otherwise";
    for class in ["19AtomVecSuperquadric", "17AtomVecConvexHull"] {
        let also = with_symbol(&format!("_ZN9LAMMPS_NS{class}C1EPNS_6LAMMPSE"), dir.path());
        deck().refused_with(also.to_str().unwrap(), 2, words);
    }
    let also = with_symbol("_ZN9LAMMPS_NS13AtomVecSphereX", dir.path());
    deck().runs_with(also.to_str().unwrap());
}

/// The plugin gets through a program that starts LIGGGHTS, and not on to what LIGGGHTS starts.
#[test]
fn the_plugin_goes_as_far_as_liggghts() {
    if !can("the_plugin_goes_as_far_as_liggghts") {
        return;
    }
    let look = "shell printenv LD_PRELOAD > memory.txt || echo none > memory.txt\nrun             200";
    let deck = deck().with("run             200", look);
    for wrapper in ["timeout 600 liggghts", "nice env A=1 liggghts", "liggghts"] {
        // Without the plugin LIGGGHTS does not know the names of this deck.
        let ran =
            deck.clone().program("sh".into()).arguments(&["-c", &format!("{wrapper} -in deck.in")]).runs();
        assert_eq!(ran.memory.trim(), "none", "under {wrapper}");
    }
}

/// LIGGGHTS with a coarse-graining factor of 2.
fn coarse(dir: &Path) -> PathBuf {
    let mpi = |ask: &str| {
        let out = must(Command::new("mpicxx").arg(format!("--showme:{ask}")));
        String::from_utf8(out.stdout).unwrap().split_whitespace().map(String::from).collect::<Vec<_>>()
    };
    let out = dir.join("coarse");
    let mut cxx = Command::new("c++");
    cxx.args(["-std=gnu++17", "-w", "-DOMPI_SKIP_MPICXX", "-I/usr/include/liggghts"]).args(mpi("compile"));
    cxx.arg(source().join("tests/live/refusals/coarse.cpp"));
    must(cxx.arg("-lliggghts").args(mpi("link")).arg("-o").arg(&out));
    out
}

/// What LIGGGHTS's law refuses under coarse-graining, ours refuses too, in the same words.
#[test]
fn coarse_graining_is_refused_as_stock_does() {
    if !can("coarse_graining_is_refused_as_stock_does") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let coarse = coarse(dir.path());
    let mut refused = 0;
    for law in LAWS {
        let meta = law.meta;
        for side in each_side(&chain_with(meta, false)) {
            let side = side.without("run ").program(coarse.clone());
            if meta.coarse_graining {
                side.runs();
            } else {
                let name = meta.called(false);
                let words = format!("does not yield consistent results with coarse-graining: model {name}");
                side.refused(1, &words);
                refused += 1;
            }
        }
        let Some(_) = law.liggghts.stock_id else { continue };
        let stock = Deck::new(&chain_with(meta, true), "model hertz").without("run ").program(coarse.clone());
        if meta.coarse_graining {
            stock.runs_on_stock();
        } else {
            stock.stock_refuses("does not yield consistent results with coarse-graining");
        }
    }
    assert!(refused > 0, "no law refuses coarse-graining");
}
