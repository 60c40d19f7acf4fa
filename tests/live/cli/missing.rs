//! Machines on which something is missing: LIGGGHTS, the plugin, or one that fits.
use crate::built::source;
use crate::common::{deck, live, plugin, program, report, Said, Scratch};
use granlaw_tools::codes::liggghts::Plugin;
use granlaw_tools::deck::Deck;
use serde_json::Value;
use std::fs;
use std::path::Path;

const NO_LIGGGHTS: &str = "liggghts is not in PATH; on Debian install the package liggghts";

/// granlaw where no other program can be found.
fn alone(s: &Scratch, program: &Path, args: &[&str]) -> Said {
    Said::of(s.command(program).args(args).env("PATH", s.path("nothing")))
}

fn skipped(report: &Value) -> usize {
    let cases = report["cases"].as_array().unwrap();
    let checks = cases.iter().flat_map(|c| c["checks"].as_array().unwrap());
    checks.filter(|c| c["outcome"]["is"] == "skipped").count()
}

#[test]
fn without_liggghts_recorded_traces_stand_in_and_what_that_leaves_out_is_told() {
    let s = Scratch::new();
    let inputs = source().join("liggghts_inputs");
    let decks = Deck::find(std::slice::from_ref(&inputs)).unwrap();
    let said = alone(&s, program(), &["verify", inputs.to_str().unwrap(), "--out", "out"]);
    let not_run = format!("decks that were not run: {} (", decks.len());
    let said = said.ends(0, &["recorded traces only", NO_LIGGGHTS, "replayed in their place", &not_run]);
    let report = report(&s.path("out"));
    let cases = report["cases"].as_array().unwrap();
    assert!(cases.len() >= 8 && skipped(&report) >= 2 * cases.len(), "{said}");
    assert_eq!(report["counts"]["skipped"], skipped(&report));
    assert!(said.out.contains(&format!("{} skipped", skipped(&report))), "{said}");
    for text in [s.read("out/report.md"), s.read("out/index.html"), said.out] {
        assert!(decks.iter().all(|d| text.contains(d.file_stem().unwrap().to_str().unwrap())));
        assert!(text.contains("recorded, plugin and final"));
    }
}

#[test]
fn without_liggghts_a_spoilt_trace_turns_the_verdict() {
    let s = Scratch::new();
    // An installed granlaw looks for traces beside itself.
    let installed = s.path("bin/granlaw");
    fs::create_dir(s.path("bin")).unwrap();
    fs::copy(program(), &installed).unwrap();
    let traces = "share/granlaw/reference_data";
    for name in ["oblique.csv", "oblique.in", "wall.csv", "wall.in"] {
        s.file(
            &format!("{traces}/{name}"),
            &fs::read_to_string(source().join("reference_data").join(name)).unwrap(),
        );
    }
    s.file("deck.in", "units si\n");
    let verify = || alone(&s, &installed, &["verify", "deck.in", "--out", "out"]);
    verify().ends(0, &["2 cases, 2 checks agreed"]);
    let spoilt = s.read(&format!("{traces}/wall.csv")).replacen(
        "youngsModulus\"\n# unit = \"Pa\"\n# shape = \"peratomtype\"\n# values = [5000000.0",
        "youngsModulus\"\n# unit = \"Pa\"\n# shape = \"peratomtype\"\n# values = [5006252.7",
        1,
    );
    s.file(&format!("{traces}/wall.csv"), &spoilt);
    verify().ends(1, &["DISAGREED     wall", "replay DISAGREED: ", "1 disagreed"]);
}

#[test]
fn what_must_run_does_not_go_on_without_liggghts() {
    let s = Scratch::new();
    s.file("deck.in", "units si\n");
    alone(&s, program(), &["verify", "deck.in", "--require-liggghts", "--out", "out"])
        .ends(2, &[NO_LIGGGHTS]);
    assert!(!s.path("out").exists());
    // Something else of that name is not taken for it.
    s.file("bin/liggghts", "#!/bin/sh\necho usage: something else\n");
    fs::set_permissions(s.path("bin/liggghts"), std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    let other = Said::of(s.command(program()).args(["verify", "deck.in"]).env("PATH", s.path("bin")));
    other.ends(2, &["bin/liggghts does not answer -h as LIGGGHTS does but says \"usage: something else\""]);
}

#[test]
fn run_says_what_is_missing() {
    if !live("run_says_what_is_missing") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck("head_on_below_limit.in", &[]));
    let run = ["run", "--laws", "rust", "--", "-in", "deck.in"];
    alone(&s, program(), &run).ends(2, &[NO_LIGGGHTS]);
    // Everything but mpirun.
    fs::create_dir(s.path("bin")).unwrap();
    for dir in std::env::split_paths(&std::env::var_os("PATH").unwrap()) {
        for entry in fs::read_dir(dir).into_iter().flatten().flatten().filter(|e| e.file_name() != "mpirun") {
            // The first of a name is the one that counts.
            let _ = std::os::unix::fs::symlink(entry.path(), s.path("bin").join(entry.file_name()));
        }
    }
    let within = |args: &[&str]| Said::of(s.command(program()).args(args).env("PATH", s.path("bin")));
    within(&run).ends(0, &[]);
    let ranks = ["run", "--laws", "rust", "--np", "2", "--", "-in", "deck.in"];
    within(&ranks).ends(2, &["mpirun is not in PATH and 2 ranks are asked for", "openmpi-bin"]);
}

#[test]
fn a_plugin_that_is_missing_or_does_not_fit_is_refused() {
    if !live("a_plugin_that_is_missing_or_does_not_fit_is_refused") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck("head_on_below_limit.in", &[]));
    fs::create_dir(s.path("bin")).unwrap();
    let lonely = s.path("bin/granlaw");
    fs::copy(program(), &lonely).unwrap();
    let commands: [&[&str]; 2] =
        [&["run", "--laws", "rust", "--", "-in", "deck.in"], &["verify", "deck.in", "--require-liggghts"]];
    for args in commands {
        let said = Said::of(s.command(&lonely).args(args));
        said.ends(
            2,
            &[
                "the LIGGGHTS plugin was not found; looked for",
                "bin/libgranlaw_liggghts.so",
                "libliggghts-dev",
            ],
        );
    }
    let abi = Plugin::ABI;
    let mark = format!("granlaw-plugin abi={abi} liggghts=3.8.0 end");
    let whole = fs::read(plugin().unwrap().path).unwrap();
    let at = whole.windows(mark.len()).position(|w| w == mark.as_bytes()).expect("the mark of the plugin");
    let marked = |text: &str| [&whole[..at], text.as_bytes(), &whole[at + mark.len()..]].concat();
    for (bytes, says) in [
        (
            marked("granlaw-plugin abi=999 liggghts=3.8.0 end"),
            &format!("has ABI version 999, this granlaw needs {abi}")[..],
        ),
        (
            marked(&format!("granlaw-plugin abi={abi} liggghts=none end")),
            "was built without LIGGGHTS's headers",
        ),
        (b"\x7fELF, but of someone else".to_vec(), "is not a granlaw plugin"),
    ] {
        fs::write(s.path("other.so"), bytes).unwrap();
        for args in commands {
            let said = Said::of(s.command(program()).args(args).env("GRANLAW_PLUGIN", s.path("other.so")));
            said.ends(2, &["other.so", says, "build it from the same source"]);
        }
        // Even where LIGGGHTS is not required, a wrong plugin is a mistake and nothing to go on without.
        let said = Said::of(
            s.command(program()).args(["verify", "deck.in"]).env("GRANLAW_PLUGIN", s.path("other.so")),
        );
        said.ends(2, &[says]);
    }
    assert!(!s.path("dump.txt").exists(), "LIGGGHTS ran all the same");
}
