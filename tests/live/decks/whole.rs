//! `granlaw verify` over all decks, and everything that it leaves behind.
use crate::built::source;
use crate::common::{case, live, report, Said, Scratch};
use granlaw_tools::deck::Deck;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the comments of a deck ask for: the first word of each check, with blanks in it as in the report.
fn asked(deck: &Path) -> Vec<String> {
    let text = fs::read_to_string(deck).unwrap();
    let checks = text.lines().filter_map(|l| l.strip_prefix("# granlaw: check "));
    checks.map(|c| c.split(' ').next().unwrap().replace("same-as", "same as")).collect()
}

fn words(case: &Value, field: &str) -> Vec<String> {
    case["checks"].as_array().unwrap().iter().map(|c| c[field].as_str().unwrap().to_string()).collect()
}

/// The case agreed in everything that its deck asks for, and it had something to agree on.
fn complete(case: &Value, asked: &[String]) -> Result<(), String> {
    if case["verdict"]["is"] != "agreed" {
        return Err(format!("verdict {}", case["verdict"]));
    }
    let names = words(case, "name");
    for wanted in asked.iter().map(String::as_str).chain(["recorded"]) {
        if !names.iter().any(|n| n.starts_with(wanted)) {
            return Err(format!("no check {wanted} among {names:?}"));
        }
    }
    if names.len() < asked.len() + 1 {
        return Err(format!("{} checks asked for, but {names:?}", asked.len()));
    }
    let other = case["checks"].as_array().unwrap().iter().find(|c| c["outcome"]["is"] != "agreed");
    if let Some(check) = other {
        return Err(format!("{check}"));
    }
    // Decks about the time step see a contact of some dozen steps.
    if case["calls"].as_u64() < Some(20) {
        return Err(format!("only {} contact calls", case["calls"]));
    }
    let described = ["laws", "parameters"].iter().all(|f| !case[f].as_array().unwrap().is_empty());
    described.then_some(()).ok_or("no laws or no parameters".into())
}

/// The answers whose histories are in the CSV of a case, each with so many points.
fn answers(csv: &Path, points: usize) -> BTreeSet<String> {
    let mut table = csv::Reader::from_path(csv).unwrap_or_else(|e| panic!("{}: {e}", csv.display()));
    let answers: Vec<String> = table.records().map(|r| r.unwrap()[0].to_string()).collect();
    let often = |a: &&String| answers.iter().filter(|b| b == a).count() >= points;
    answers.iter().filter(often).cloned().collect()
}

/// The plots of a case show every answer that was worked out.
fn plotted(folder: &Path, deck: &Path, page: &str, asked: &[String]) {
    let name = deck.file_stem().unwrap().to_str().unwrap();
    // Where steps are sampled, few of them see the contact that is followed.
    let points = if Deck::read(deck).unwrap().every == 1 { 10 } else { 1 };
    let found = answers(&folder.join("csv").join(format!("{name}.csv")), points);
    let mut wanted = vec!["stock", "plugin"];
    wanted.extend(asked.iter().map(String::as_str).filter(|a| ["replay", "two-body"].contains(a)));
    let section = page.split(&format!("<section class=\"case\" id=\"{name}\">")).nth(1).expect(name);
    let section = section.split("</section>").next().unwrap();
    assert_eq!(section.matches("<svg").count(), 4, "{name}: force, overlap, loop and errors");
    for answer in wanted {
        assert!(found.contains(answer), "{name}: {answer} is not in the CSV: {found:?}");
        assert!(section.contains(&format!("data-answer=\"{answer}\"")), "{name}: {answer} is not plotted");
    }
}

#[test]
fn every_deck_agrees_and_the_report_is_complete() {
    if !live("every_deck_agrees_and_the_report_is_complete") {
        return;
    }
    let inputs = source().join("liggghts_inputs");
    let decks = Deck::find(std::slice::from_ref(&inputs)).unwrap();
    let s = Scratch::new();
    let summary = format!("{} cases", decks.len());
    // A long limit, so that a machine which is busy with something else fails nothing.
    let options = ["--out", "out", "--require-liggghts", "--time-limit", "900"];
    s.granlaw(&[&["verify", inputs.to_str().unwrap()], &options[..]].concat())
        .ends(0, &[&summary, "0 disagreed, 0 could not run, 0 skipped"]);
    assert_eq!(s.left(), [""; 0]);

    let out = s.path("out");
    let (report, page) = (report(&out), s.read("out/index.html"));
    assert_eq!(report["cases"].as_array().unwrap().len(), decks.len());
    let mut checks = 0;
    for deck in &decks {
        let (name, asked) = (deck.file_stem().unwrap().to_str().unwrap(), asked(deck));
        let case = case(&report, name);
        complete(case, &asked).unwrap_or_else(|e| panic!("{name}: {e}"));
        checks += case["checks"].as_array().unwrap().len();
        plotted(&out, deck, &page, &asked);
    }
    assert_eq!(report["counts"]["agreed"], checks);
    assert!(decks.len() >= 50 && checks >= 4 * decks.len(), "{} decks, {checks} checks", decks.len());
    let junit = quick_junit::Report::deserialize_from_str(&s.read("out/junit.xml")).unwrap();
    assert_eq!((junit.tests, junit.failures, junit.errors), (checks, 0, 0));
    assert!(s.read("out/report.md").contains(&format!("**✓ all {} cases agreed**", decks.len())));
}

#[test]
fn a_case_that_proves_less_than_its_deck_asks_for_is_seen() {
    let check = |name: &str, is: &str| serde_json::json!({"name": name, "outcome": {"is": is}});
    let whole = serde_json::json!({"verdict": {"is": "agreed"}, "calls": 500, "laws": ["normal hooke"],
        "parameters": ["E"], "checks": [check("recorded", "agreed"), check("replay", "agreed")]});
    let asked = ["replay".to_string()];
    let with = |field: &str, value: Value| {
        let mut case = whole.clone();
        case[field] = value;
        complete(&case, &asked).unwrap_err()
    };
    assert_eq!(complete(&whole, &asked), Ok(()));
    assert!(with("verdict", serde_json::json!({"is": "disagreed"})).contains("disagreed"));
    assert!(with("checks", serde_json::json!([check("recorded", "agreed")])).contains("no check replay"));
    let skipped = serde_json::json!([check("recorded", "agreed"), check("replay", "skipped")]);
    assert!(with("checks", skipped).contains("skipped"));
    assert!(with("calls", 3.into()).contains("only 3"));
    assert!(with("laws", serde_json::json!([])).contains("no laws"));
}

#[test]
fn where_liggghts_is_missing_a_live_test_is_skipped_by_name_or_fails() {
    let require = "GRANLAW_REQUIRE_LIGGGHTS";
    let mut tests = Command::new(std::env::current_exe().unwrap());
    tests.args(["--exact", "decks::planted::each_fault_turns_its_own_check_red"]).env("PATH", "/nowhere");
    Said::of(tests.env_remove(require))
        .ends(0, &["skipped: each_fault_turns_its_own_check_red: liggghts is not in PATH", "1 passed"]);
    Said::of(tests.env(require, "1"))
        .ends(101, &["each_fault_turns_its_own_check_red cannot be skipped: liggghts is not in PATH"]);
}
