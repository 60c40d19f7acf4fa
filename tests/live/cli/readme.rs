//! The README's own commands, run as they stand there.
use crate::built::source;
use crate::common::{deck, live, program, Said, Scratch};
use granlaw_tools::deck::Deck;
use std::fs;
use std::path::Path;

fn readme() -> String {
    fs::read_to_string(source().join("README.md")).unwrap()
}

/// The lines of all code blocks of a language under a heading.
fn block(heading: &str, language: &str) -> Vec<String> {
    let text = readme();
    let section = text.split(&format!("\n## {heading}\n")).nth(1).expect("the heading");
    let section = section.split("\n## ").next().unwrap();
    let blocks =
        section.split("```").skip(1).step_by(2).filter_map(|b| b.strip_prefix(&format!("{language}\n")));
    let lines: Vec<_> = blocks.flat_map(str::lines).map(String::from).collect();
    assert!(!lines.is_empty(), "no {language} under {heading}");
    lines
}

/// A line of the README in a shell, with what was built in the place of what is installed.
fn shell(s: &Scratch, line: &str) -> Said {
    let built = program().parent().unwrap().display().to_string();
    let line = line
        .replace("/usr/local/lib/granlaw", &built)
        .replace("mpirun", "mpirun --allow-run-as-root --oversubscribe");
    let path = format!("{built}:{}", std::env::var("PATH").unwrap());
    Said::of(s.command(Path::new("sh")).args(["-c", &line]).env("PATH", path))
}

#[test]
fn the_commands_of_use_it_work_as_written() {
    if !live("the_commands_of_use_it_work_as_written") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck("oblique_slip.in", &[]));
    s.file("liggghts_inputs/a.in", &deck("stiffness_ratio_1000.in", &[]));
    s.file("liggghts_inputs/b.in", &deck("stiffness_ratio_50.in", &[]));
    s.file("benchmarks/a.in", &deck("oblique_stick.in", &[]));
    let lines = block("Use it", "sh");
    let ours: Vec<_> =
        lines.iter().filter(|l| !l.starts_with("cargo ") && !l.starts_with("export ")).collect();
    assert!(ours.len() >= 8, "{ours:?}");
    for line in ours {
        shell(&s, line).ends(0, &[]);
    }
    assert!(s.read("report/report.md").contains("deck"));
    assert!(s.path("granlaw-bench/index.html").exists());
    assert!(s.path("trace.csv").exists() && s.path("granlaw-report/index.html").exists());
}

#[test]
fn a_deck_as_the_readme_writes_it_runs() {
    if !live("a_deck_as_the_readme_writes_it_runs") {
        return;
    }
    let s = Scratch::new();
    // The chain of the README in the place of the deck's own.
    let lines = block("Use it", "");
    let (pair, wall) = (&lines[0], &lines[1]);
    assert!(pair.starts_with("pair_style  gran") && wall.starts_with("fix floor all wall/gran"), "{lines:?}");
    let ours = deck("primitive_wall.in", &[]);
    let mut rolling = ours.contains("coefficientRollingFriction");
    let swapped = ours.lines().fold(String::new(), |mut all, line| {
        let line = match line {
            l if l.starts_with("pair_style") => pair,
            l if l.starts_with("fix             floor") => wall,
            l => l,
        };
        if line.starts_with("pair_style") && !rolling {
            all += "fix readme all property/global coefficientRollingFriction peratomtypepair 1 0.1\n";
            rolling = true;
        }
        all + line + "\n"
    });
    assert!(swapped.contains(pair) && swapped.contains(wall));
    s.file("deck.in", &swapped);
    s.granlaw(&["run", "--", "-in", "deck.in"]).ends(0, &["Loop time"]);
}

#[test]
fn the_comments_of_the_readme_are_comments_that_decks_may_have() {
    let s = Scratch::new();
    let path = s.file("deck.in", &block("Decks that check themselves", "").join("\n"));
    let deck = Deck::read(&path).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((deck.title.as_str(), deck.checks.len()), ("Head-on below the plastic limit", 4));
}

#[test]
fn the_first_command_makes_a_report() {
    if !live("the_first_command_makes_a_report") {
        return;
    }
    assert_eq!(
        block("Two commands", "sh").iter().map(|l| l.split(' ').next().unwrap()).collect::<Vec<_>>(),
        ["scripts/verify.sh", "scripts/test.sh"]
    );
    let s = Scratch::new();
    let path = s.file("deck.in", &deck("stiffness_ratio_1000.in", &[]));
    let mut script = s.command(&source().join("scripts/verify.sh"));
    script.args([&path, Path::new("--out"), &s.path("out")]);
    Said::of(&mut script).ends(0, &["1 cases", "0 skipped", "report: "]);
    assert!(s.path("out/index.html").exists());
    for script in ["verify.sh", "test.sh"] {
        Said::of(s.command(&source().join("scripts").join(script)).arg("--help"))
            .ends(0, &["Example: scripts/"]);
    }
}
