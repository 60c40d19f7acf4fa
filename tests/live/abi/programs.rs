//! C programs that use the library as a stranger would, compiled and run against the static library.
use crate::built::{built, has, here, must, said, source};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

fn include() -> PathBuf {
    source().join("ffi/capi/include")
}

fn compile(program: &str, include: &Path, into: &TempDir) -> PathBuf {
    let out = into.path().join(program);
    let mut cc = Command::new("cc");
    cc.args(["-std=c11", "-O1", "-g", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"]).arg(include);
    cc.arg(source().join(format!("tests/live/abi/{program}.c"))).arg("-o").arg(&out);
    cc.arg(built().join("libgranlaw.a")).args(["-lm", "-lpthread", "-ldl", "-lgcc_s"]);
    must(&mut cc);
    out
}

/// Compile and run; `valgrind` makes any leak or bad access a failure.
fn run(program: &str, arguments: &[&str], valgrind: bool) -> Output {
    let dir = tempfile::tempdir().unwrap();
    let path = compile(program, &include(), &dir);
    let mut command = Command::new(if valgrind { Path::new("valgrind") } else { &path });
    if valgrind {
        command.args(["-q", "--error-exitcode=9", "--leak-check=full"]);
        command.arg("--errors-for-leak-kinds=definite,possible").arg(&path);
    }
    command.args(arguments).output().unwrap()
}

fn passes(program: &str) {
    let out = run(program, &[], false);
    assert!(out.status.success(), "{program}: {}\n{}", out.status, said(&out));
}

#[test]
fn laws_describe_themselves() {
    passes("laws");
}

#[test]
fn a_chain_follows_the_equations() {
    passes("chain");
    let planted = run("chain", &["planted"], false);
    assert_eq!(planted.status.code(), Some(1), "a spring 0.1 % too stiff was not seen");
}

#[test]
fn refusals_have_their_status_and_words() {
    passes("refusals");
}

#[test]
fn errors_belong_to_their_thread() {
    passes("threads");
}

#[test]
fn another_abi_is_seen() {
    let dir = tempfile::tempdir().unwrap();
    let header = fs::read_to_string(include().join("granlaw.h")).unwrap();
    let (before, after) = header.split_once("#define GRANLAW_ABI_VERSION ").unwrap();
    let rest = after.split_once('\n').unwrap().1;
    let other = format!("{before}#define GRANLAW_ABI_VERSION 999\n{rest}");
    fs::write(dir.path().join("granlaw.h"), other).unwrap();
    let out = Command::new(compile("laws", dir.path(), &dir)).output().unwrap();
    assert_eq!(out.status.code(), Some(3), "{}", said(&out));
    assert!(said(&out).contains("granlaw.h has ABI version 999, the library "), "{}", said(&out));
}

#[test]
fn nothing_leaks_under_valgrind() {
    if !here("nothing_leaks_under_valgrind", has("valgrind"), "no valgrind; install it") {
        return;
    }
    for program in ["again", "chain", "refusals", "threads", "laws"] {
        let out = run(program, &[], true);
        assert!(out.status.success(), "{program}: {}\n{}", out.status, said(&out));
    }
    assert_eq!(
        run("again", &["planted"], true).status.code(),
        Some(9),
        "a chain that is not freed was not seen"
    );
}

#[test]
fn the_header_is_c99_and_cpp() {
    let header = include().join("granlaw.h");
    for (compiler, standard) in [("cc", "c99"), ("c++", "c++11"), ("c++", "c++20")] {
        let language = if compiler == "cc" { "c" } else { "c++" };
        let strict = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-x", language];
        must(Command::new(compiler).arg(format!("-std={standard}")).args(strict).arg(&header));
    }
}
