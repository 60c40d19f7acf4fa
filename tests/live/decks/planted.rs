//! Faults planted in decks: each turns one check red, that one and no other.
use crate::common::{case, deck, live, outcome, report, Scratch};
use serde_json::Value;

const HEAD_ON: &str = "head_on_beyond_limit.in";

/// A deck whose Young's modulus comes from a script that knows which of our runs it is in: `when` is a condition of
/// the shell under which the stiffness is off by a thousandth (it goes with the modulus to the power 4/5).
fn two_faced(s: &Scratch, name: &str, when: &str) {
    s.file(
        &format!("red/{name}.sh"),
        &format!(
            "if {when}; then young=5.0062527e6; else young=5e6; fi\necho \"variable young string $young\" > {name}.young\n"
        ),
    );
    let young = "fix             p1 all property/global youngsModulus peratomtype";
    let choice = format!("shell sh {name}.sh\ninclude {name}.young\n{young} ${{young}} #");
    s.file(&format!("red/{name}.in"), &deck(HEAD_ON, &[(young, &choice)]));
}

const RUST: &str = r#"[ "$GRANLAW_LAWS" = rust ]"#;
const RECORDED: &str = r#"[ "$GRANLAW_LAWS" = stock ]"#;

/// The named check disagreed for a reason with these words, and no other check of the case did.
#[track_caller]
fn only(case: &Value, check: &str, words: &[&str]) {
    let (is, why) = outcome(case, check);
    assert_eq!(is, "disagreed", "{check}: {why}");
    for word in words {
        assert!(why.contains(word), "{word:?} is not in {why:?}");
    }
    for other in case["checks"].as_array().unwrap().iter().filter(|c| c["name"] != check) {
        assert!(["agreed", "skipped"].contains(&other["outcome"]["is"].as_str().unwrap()), "{other}");
    }
    assert_eq!(case["verdict"]["is"], "disagreed");
}

#[test]
fn each_fault_turns_its_own_check_red() {
    if !live("each_fault_turns_its_own_check_red") {
        return;
    }
    let s = Scratch::new();
    s.file("red/final.in", &deck(HEAD_ON, &[("= -1.965430651 within", "= -1.965434 within")]));
    let pulled = "fix pull all gravity 9.81 vector 0 0 -1\nfix             move all nve/sphere";
    s.file("red/two_body.in", &deck(HEAD_ON, &[("fix             move all nve/sphere", pulled)]));
    two_faced(&s, "plugin", RUST);
    two_faced(&s, "recorded", RECORDED);
    two_faced(&s, "no_dump", RUST);
    let without: Vec<_> = s.read("red/no_dump.in").lines().map(String::from).collect();
    let kept = without.iter().filter(|l| !l.starts_with("dump") && !l.contains("check final"));
    s.file("red/no_dump.in", &kept.fold(String::new(), |all, line| all + line + "\n"));
    s.granlaw(&["verify", "red", "--out", "out"]).ends(1, &["5 disagreed, 0 could not run", "DISAGREED"]);

    let report = report(&s.path("out"));
    assert_eq!((&report["exit_code"], &report["counts"]["disagreed"]), (&1.into(), &5.into()));
    only(
        case(&report, "final"),
        "final vx of 1",
        &["step 10000", "-1.965434e0 was expected", "allowed 4e-7"],
    );
    only(case(&report, "two_body"), "two-body", &["v_i of 1-2", "allowed 1e-9"]);
    only(case(&report, "plugin"), "plugin", &["dump.txt:21: x of 1 at step 40", "was expected"]);
    only(case(&report, "recorded"), "recorded", &["dump.txt:21: x of 1 at step 40"]);
    only(case(&report, "no_dump"), "plugin", &["calls.trace: "]);
    assert_eq!(
        outcome(case(&report, "no_dump"), "recorded"),
        ("skipped", "the deck writes no text dump to compare")
    );
    assert_eq!(report["counts"]["skipped"], 1);
    // The first difference is tiny, the largest is not: a stiffness off by a thousandth.
    let plugin = &case(&report, "plugin")["checks"].as_array().unwrap()[2];
    let worst = plugin["worst"]["error"].as_f64().unwrap();
    assert!((1e-4..1e-1).contains(&worst), "{plugin}");
}
