//! The list against the sources: what they read, and where.
use crate::built::source;
use granlaw_tools::codes::environment::{Reader, VARIABLES};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// What may name a variable.
const WHERE: [&str; 8] = ["src", "ffi", "tests", "scripts", ".ci", "README.md", "DESIGN.md", "CHANGELOG.md"];

/// All files below some places, by their paths from the source, with their text.
fn files(places: &[&str]) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open: Vec<_> = places.iter().map(|p| source().join(p)).collect();
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(fs::read_dir(&path).unwrap().map(|e| e.unwrap().path()));
            continue;
        }
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
        found.push((path.strip_prefix(source()).unwrap().display().to_string(), text));
    }
    found
}

/// The words of a text that begin as our variables do.
fn words(text: &str) -> BTreeSet<String> {
    let begin = concat!("GRAN", "LAW_");
    let word = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    let from = |(at, _)| {
        let rest: &str = &text[at..];
        rest[..rest.find(|c| !word(c)).unwrap_or(rest.len())].to_string()
    };
    text.match_indices(begin).map(from).filter(|w| w.len() > begin.len()).collect()
}

/// The names among them that C and C++ have given to something else: all of the C interface, and macros.
fn of_c(files: &[(String, String)]) -> BTreeSet<String> {
    let macros = |text: &str| -> BTreeSet<String> {
        let defines =
            |l: &&str| l.trim_start().starts_with("#define") || l.trim_start().starts_with("#ifndef");
        text.lines().filter(defines).flat_map(|l| words(l.split('(').next().unwrap())).collect()
    };
    let all = files.iter().map(|(path, text)| match path.ends_with("granlaw.h") {
        true => words(text),
        false => macros(text),
    });
    all.flatten().collect()
}

fn variables(files: &[(String, String)]) -> BTreeSet<String> {
    let others = of_c(files);
    files.iter().flat_map(|(_, text)| words(text)).filter(|w| !others.contains(w)).collect()
}

fn listed(reader: impl Fn(Reader) -> bool) -> BTreeSet<String> {
    VARIABLES.iter().filter(|v| reader(v.reader)).map(|v| v.name.to_string()).collect()
}

/// The files among these whose text holds one of the words.
fn holding(files: &[(String, String)], words: &[&str]) -> Vec<String> {
    let mut found: Vec<_> =
        files.iter().filter(|(_, t)| words.iter().any(|w| t.contains(w))).map(|(p, _)| p.clone()).collect();
    found.sort();
    found
}

#[test]
fn what_stands_in_the_sources_stands_in_the_list_and_the_other_way_round() {
    let mut files = files(&WHERE);
    files.retain(|(path, _)| !path.starts_with("tests/environment"));
    assert!(files.len() > 200, "{} files", files.len());
    let outside: Vec<_> =
        files.iter().filter(|(p, _)| !p.ends_with("codes/environment.rs")).cloned().collect();
    assert_eq!(variables(&outside), listed(|_| true));
    // Each is read where the list says that it is.
    let read = |place: &str| -> BTreeSet<String> {
        outside.iter().filter(|(p, _)| p.starts_with(place)).flat_map(|(_, text)| words(text)).collect()
    };
    let there = |reader| listed(|r| r == reader);
    assert!(read("ffi/liggghts/cpp/modes.hpp").is_superset(&there(Reader::Plugin)));
    assert!(read("src/tools/codes/liggghts/plugin.rs").is_superset(&there(Reader::CommandLine)));
    assert!(read("tests").is_superset(&there(Reader::Tests)));
    // A name that is put together from parts could not be found; these two speak of constants of the C interface.
    let parts = [concat!("GRAN", "LAW_{"), concat!("GRAN", "LAW_%")];
    let of_c = ["ffi/liggghts/src/bin/granlaw-dropin.rs"];
    assert_eq!(holding(&files, &parts), of_c);
}

#[test]
fn the_environment_is_read_and_programs_are_started_in_one_room() {
    let ours = files(&["src", "ffi/liggghts/cpp", "ffi/liggghts/src", "ffi/lanes/src", "ffi/capi/src"]);
    let reads = ["env::var", "getenv(", "option_env!"];
    let where_read = [
        "ffi/liggghts/cpp/modes.hpp",
        "ffi/liggghts/cpp/plugin.cpp",
        "src/tools/codes/launch.rs",
        "src/tools/codes/liggghts/plugin.rs",
    ];
    assert_eq!(holding(&ours, &reads), where_read);
    // The second is a test of its own.
    let starts = ["src/tools/codes/launch.rs", "src/tools/codes/process.rs"];
    assert_eq!(holding(&ours, &["Command::new("]), starts);
}

#[test]
fn a_variable_that_is_not_listed_is_seen() {
    let file = |path: &str, text: &str| (path.to_string(), text.replace("OUR", concat!("GRAN", "LAW")));
    let files = [
        file("ffi/granlaw.h", "enum { OUR_OK = 0, OUR_LATE = 5 };"),
        file("ffi/a.hpp", "#ifndef OUR_A_HPP\n#define OUR_HERE(what) OUR_SECRET\n"),
        file("src/a.rs", "env::var(\"OUR_QUIETLY\"); OUR_OK; OUR_HERE; // OUR_ and OUR_*"),
    ];
    let expected = ["GRAN_QUIETLY", "GRAN_SECRET"].map(|n| n.replace("GRAN", concat!("GRAN", "LAW")));
    assert_eq!(variables(&files), BTreeSet::from(expected));
    assert_eq!(holding(&files, &["env::var"]), ["src/a.rs"]);
    assert!(!Path::new("src/a.rs").is_file());
}
