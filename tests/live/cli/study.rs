//! The studies as commands: small parts of them, with LIGGGHTS and without.
use crate::common::{live, program, Said, Scratch};
use serde_json::Value;

/// What a study's checks came to, by name.
fn outcomes(s: &Scratch) -> Vec<(String, String)> {
    let report: Value = serde_json::from_str(&s.read("out/report.json")).unwrap();
    let checks = report["checks"].as_array().unwrap().iter();
    let text = |v: &Value| v.as_str().unwrap().to_string();
    checks.map(|c| (text(&c["name"]), text(&c["outcome"]["is"]))).collect()
}

#[test]
fn speed_and_stability_leave_pages_with_numbers() {
    if !live("speed_and_stability_leave_pages_with_numbers") {
        return;
    }
    let s = Scratch::new();
    s.granlaw(&["speed", "--case", "undamped", "--out", "out"])
        .ends(0, &["agreed         orders", "out/index.html"]);
    assert!(
        outcomes(&s).len() >= 4 && outcomes(&s).iter().all(|(_, is)| is == "agreed"),
        "{:?}",
        outcomes(&s)
    );
    assert!(s.read("out/csv/speed-undamped.csv").contains("LIGGGHTS, Rust laws, both settings"));
    assert!(s.read("out/csv/per-step.csv").lines().count() == 4);
    // The same folder again: another study replaces the earlier one.
    let said = s.granlaw(&["stability", "--map", "k2max", "--out", "out"]).ends(0, &["energy is created"]);
    assert!(said.out.contains("agreed         outcome away from borders"), "{said}");
    assert!(s.read("out/csv/asked.csv").lines().count() > 12 && !s.path("out/csv/per-step.csv").exists());
    s.file("out/notes.txt", "mine");
    s.granlaw(&["stability", "--map", "hooke", "--out", "out"]).ends(2, &["notes.txt"]);
}

#[test]
fn without_liggghts_the_studies_say_what_they_left_out() {
    let s = Scratch::new();
    let alone = |args: &[&str]| Said::of(s.command(program()).args(args).env("PATH", s.path("nothing")));
    alone(&["speed", "--case", "undamped", "--out", "out"]).ends(0, &["skipped        runs of LIGGGHTS"]);
    assert!(outcomes(&s).iter().any(|(_, is)| is == "skipped"));
    alone(&["stability", "--map", "rest-normal", "--out", "out"])
        .ends(0, &["skipped        runs of LIGGGHTS"]);
    s.granlaw(&["speed", "--case", "dampd-0.5"]).ends(2, &["dampd-0.5", "damped-0.5"]);
    s.granlaw(&["stability", "--map", "k2"]).ends(2, &["k2", "k2max"]);
}
