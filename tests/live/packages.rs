//! What the packages ask of those who build them: the lowest Rust, and what comes along with the C library.
use crate::built::{has, here, must, said, source};
use serde_json::{json, Value};
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

/// What others build and link with the C library, versions apart.
const LIBRARY: [&str; 26] = [
    "approx",
    "autocfg",
    "bytemuck",
    "bytemuck_derive",
    "granlaw",
    "granlaw-capi",
    "granlaw-derive",
    "libgranlaw",
    "matrixmultiply",
    "nalgebra",
    "num-complex",
    "num-integer",
    "num-rational",
    "num-traits",
    "paste",
    "proc-macro2",
    "quote",
    "rawpointer",
    "safe_arch",
    "simba",
    "syn",
    "thiserror",
    "thiserror-impl",
    "typenum",
    "unicode-ident",
    "wide",
];

/// What is built for a package, as `name version`.
fn tree(package: &str, edges: &str) -> BTreeSet<(String, String)> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["tree", "--locked", "--offline", "--prefix", "none", "--package", package, "--edges", edges]);
    let lines = said(&must(cargo.current_dir(source())));
    let words = lines.lines().filter_map(|l| l.split_once(" v"));
    words.map(|(name, rest)| (name.into(), rest.split(' ').next().unwrap_or_default().into())).collect()
}

fn names(package: &str) -> Vec<String> {
    let mut names: Vec<_> = tree(package, "normal,build").into_iter().map(|(name, _)| name).collect();
    names.dedup();
    names
}

#[test]
fn the_library_brings_along_what_the_laws_need_and_no_more() {
    assert_eq!(names("libgranlaw"), LIBRARY);
    // The same question about the command line must be answered otherwise.
    let whole = names("granlaw-cli");
    for other in ["clap", "ctrlc", "indicatif", "quick-junit", "serde", "csv"] {
        assert!(whole.iter().any(|name| name == other), "{other} is not in {whole:?}");
    }
}

/// All packages that are built here, tests included.
fn metadata() -> Value {
    let machine = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--locked", "--offline", "--format-version", "1", "--filter-platform", &machine]);
    serde_json::from_slice(&must(cargo.current_dir(source())).stdout).unwrap()
}

fn packages(of: &mut Value) -> &mut Vec<Value> {
    of["packages"].as_array_mut().expect("packages")
}

fn rust(package: &Value) -> Option<Vec<u32>> {
    Some(package["rust_version"].as_str()?.split('.').map(|n| n.parse().unwrap()).collect())
}

/// The packages that a Rust does not build, by their own word.
fn beyond(all: &mut Value, stated: &[u32], asked: impl Fn(&Value) -> bool) -> Vec<String> {
    let newer = |p: &&mut Value| asked(p) && rust(p).is_some_and(|r| r[..2] > stated[..2]);
    packages(all).iter_mut().filter(newer).map(|p| format!("{} {}", p["name"], p["rust_version"])).collect()
}

fn stated(all: &mut Value, package: &str) -> Vec<u32> {
    rust(packages(all).iter().find(|p| p["name"] == package).expect(package)).expect("rust-version")
}

/// The packages of the core, which ask for less than the rest.
fn of_the_core() -> impl Fn(&Value) -> bool {
    let core = ["granlaw", "granlaw-capi", "libgranlaw"].map(|p| tree(p, "normal,build,dev"));
    let known: BTreeSet<_> = core.into_iter().flatten().collect();
    move |p| known.iter().any(|(name, version)| p["name"] == **name && p["version"] == **version)
}

#[test]
fn no_package_needs_a_newer_rust_than_is_stated() {
    let mut all = metadata();
    let (whole, core) = (stated(&mut all, "granlaw-cli"), stated(&mut all, "granlaw"));
    assert_eq!(beyond(&mut all, &whole, |_| true), [""; 0]);
    assert_eq!(beyond(&mut all, &core, of_the_core()), [""; 0]);
    let readme = fs::read_to_string(source().join("README.md")).unwrap();
    for (package, version) in [("everything", whole), ("the core", core)] {
        let text = format!("Rust {}.{}", version[0], version[1]);
        assert!(readme.contains(&text), "README does not say that {package} needs {text}");
    }
}

#[test]
fn a_package_that_needs_a_newer_rust_is_seen() {
    let mut all = metadata();
    let (whole, core) = (stated(&mut all, "granlaw-cli"), stated(&mut all, "granlaw"));
    let nalgebra = packages(&mut all).iter_mut().find(|p| p["name"] == "nalgebra").unwrap();
    nalgebra["rust_version"] = json!(format!("1.{}.1", whole[1]));
    assert_eq!(beyond(&mut all, &whole, |_| true), [""; 0]);
    assert_eq!(beyond(&mut all, &core, of_the_core()).len(), 1, "above the core's");
    let clap = packages(&mut all).iter_mut().find(|p| p["name"] == "clap").unwrap();
    clap["rust_version"] = json!(format!("1.{}", whole[1] + 1));
    assert_eq!(beyond(&mut all, &whole, |_| true).len(), 1, "above everything's");
    assert_eq!(beyond(&mut all, &core, of_the_core()).len(), 1, "none of the core's");
}

/// What clippy says of a package that uses a function which came with Rust 1.91.
fn linted(rust: &str, test: bool) -> (bool, String) {
    let dir = tempfile::tempdir().unwrap();
    let head = "[workspace]\n[package]\nname = \"newer\"\nversion = \"0.1.0\"\nedition = \"2021\"\n";
    fs::write(dir.path().join("Cargo.toml"), format!("{head}rust-version = \"{rust}\"\n")).unwrap();
    fs::copy(source().join("clippy.toml"), dir.path().join("clippy.toml")).unwrap();
    fs::create_dir(dir.path().join("src")).unwrap();
    let prefix = "pub fn prefix(p: &std::path::Path) -> bool {\n    p.file_prefix().is_some()\n}\n";
    let tests = "#[cfg(test)]\nmod tests {\n    #[test]\n    fn prefix() {\n        assert!(std::path::Path::new(\"a\").file_prefix().is_some());\n    }\n}\n";
    fs::write(dir.path().join("src/lib.rs"), if test { tests } else { prefix }).unwrap();
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["clippy", "--offline", "--all-targets", "--", "-D", "warnings"]).current_dir(dir.path());
    let out = cargo.env("CARGO_TARGET_DIR", dir.path().join("target")).output().unwrap();
    (out.status.success(), said(&out))
}

#[test]
fn a_function_that_the_stated_rust_lacks_is_seen() {
    let test = "a_function_that_the_stated_rust_lacks_is_seen";
    if !here(test, has("cargo-clippy"), "no clippy; install it with rustup component add clippy") {
        return;
    }
    let whole = stated(&mut metadata(), "granlaw-cli");
    let whole = format!("{}.{}", whole[0], whole[1]);
    for within_tests in [false, true] {
        let (passed, said) = linted(&whole, within_tests);
        assert!(!passed && said.contains("is stable since `1.91.0`"), "{said}");
        let (passed, said) = linted("1.91", within_tests);
        assert!(passed, "{said}");
    }
}
