//! Decks that cannot be judged: exit 2, with a reason that helps, and nothing left behind.
use crate::common::{case, deck, live, outcome, report, Scratch};

const HEAD_ON: &str = "head_on_beyond_limit.in";
const RUN: &str = "run             10000";

/// A deck in which something happens just before the run.
fn before_run(what: &str) -> String {
    deck(HEAD_ON, &[(RUN, &format!("{what}\n{RUN}"))])
}

#[test]
fn what_cannot_be_judged_says_why() {
    if !live("what_cannot_be_judged_says_why") {
        return;
    }
    let s = Scratch::new();
    s.file("in/apart.in", &deck(HEAD_ON, &[("vx 2 vy", "vx -2 vy")]));
    s.file("in/fails.in", &before_run("bogus 12"));
    s.file("in/unequal.in", &before_run("fix p6 all property/global youngsModulus peratomtype -1"));
    let ratio = "coefficientMaxElasticStiffness peratomtypepair 1";
    s.file("in/refused.in", &deck(HEAD_ON, &[(&format!("{ratio} 5"), &format!("{ratio} 0.5"))]));
    s.file("in/no_column.in", &deck(HEAD_ON, &[("check final vx of 1", "check final energy of 1")]));
    s.file(
        "in/no_laws.in",
        "units si\natom_style sphere\natom_modify sort 0 0\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nrun 1\n",
    );
    // The shell that LIGGGHTS starts may stand between the script and LIGGGHTS.
    let kill = "for p in $PPID $(cut -d' ' -f4 /proc/$PPID/stat); do\n  grep -q liggghts /proc/$p/comm && kill -9 $p\ndone\n";
    s.file("in/kill.sh", kill);
    s.file("in/killed.in", &before_run("shell sh kill.sh"));
    s.granlaw(&["verify", "in", "--out", "out"]).ends(2, &["COULD NOT RUN", "7 cases"]);
    assert_eq!(s.left(), [""; 0]);

    let report = report(&s.path("out"));
    let at = |name: &str| {
        let path = format!("in/{name}.in");
        let deck = s.read(&path);
        let line = move |text: &str| deck.lines().position(|l| l.starts_with(text)).unwrap() + 1;
        move |text: &str| format!("{path}:{}: `{text}", line(text))
    };
    for (name, check, words) in [
        ("apart", "recorded", vec!["no contact".into(), "let them meet".into()]),
        ("fails", "stock run", vec![at("fails")("bogus 12"), "ERROR: Unknown command: bogus 12".into()]),
        ("unequal", "stock run", vec![at("unequal")("fix p6"), "ERROR: ".into()]),
        (
            "refused",
            "plugin",
            vec![
                at("refused")("run"),
                "hooke/hysteresis: coefficientMaxElasticStiffness = 0.5 (types 1-1) must be at least 1"
                    .into(),
            ],
        ),
        ("no_column", "final energy of 1", vec!["no column energy; it has id, x, y".into()]),
        ("no_laws", "recorded", vec!["pair_style gran".into()]),
        ("killed", "stock run", vec!["LIGGGHTS was ended by signal 9".into()]),
    ] {
        let case = case(&report, name);
        assert_eq!(case["verdict"]["is"], "could-not-run", "{name}");
        let (is, why) = outcome(case, check);
        assert_eq!(is, "could-not-run", "{name}: {why}");
        for word in words {
            assert!(why.contains(&word), "{name}: {word:?} is not in {why:?}");
        }
    }
    let log = case(&report, "fails")["log"].as_str().unwrap();
    assert!(log.contains("log.liggghts") && log.contains("bogus 12"), "{log}");
    assert!(s.read("out/index.html").contains("What LIGGGHTS said"));
}

#[test]
fn a_run_that_hangs_is_stopped_with_all_that_it_started() {
    if !live("a_run_that_hangs_is_stopped_with_all_that_it_started") {
        return;
    }
    let s = Scratch::new();
    // After the last run, for LIGGGHTS may read on before it notices that it is to stop.
    s.file("in/sleeps.in", &deck(HEAD_ON, &[(RUN, &format!("{RUN}\nshell sleep 3600"))]));
    let two =
        [("# granlaw: title", "# granlaw: ranks 2\n# granlaw: title"), (RUN, "run             2000000000")];
    s.file("in/endless.in", &deck(HEAD_ON, &two));
    let ended = s.granlaw(&["verify", "in", "--out", "out", "--time-limit", "40"]);
    ended.ends(2, &["stopped after the time limit of 40 s", "raise --time-limit"]);
    assert_eq!(s.left(), [""; 0]);
    let report = report(&s.path("out"));
    let why = |name| outcome(case(&report, name), "stock run").1.to_string();
    assert!(why("sleeps").contains("`shell sleep 3600`"), "{}", why("sleeps"));
    assert!(why("endless").contains("`run 2000000000`"), "{}", why("endless"));
}

#[test]
fn decks_that_cannot_be_used_are_told_before_anything_runs() {
    let s = Scratch::new();
    s.file("bad/typo.in", "units si\n# granlaw: check replay <= 1e-14\n");
    s.file("empty/notes.txt", "");
    s.file("bad2/after.in", "# granlaw: after missing.in\n");
    for (deck, says) in [
        ("nowhere.in", vec!["cannot read the deck nowhere.in", "*.in"]),
        ("empty", vec!["no deck in empty", "end in .in"]),
        ("bad", vec!["bad/typo.in:2: ", "because <reason>"]),
        ("bad2/after.in", vec!["bad2/after.in:1: after missing.in", "beside this deck"]),
    ] {
        s.granlaw(&["verify", deck, "--out", "out"]).ends(2, &says);
        assert!(!s.path("out").exists(), "{deck}: a report on nothing");
    }
}
