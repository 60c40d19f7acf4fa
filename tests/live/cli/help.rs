//! Help that teaches, and `granlaw laws`.
use crate::common::Scratch;
use granlaw::laws::LAWS;
use granlaw::model::Kind;
use serde_json::Value;

/// The names of all commands, from the help of the program.
fn commands(s: &Scratch) -> Vec<String> {
    let help = s.granlaw(&["--help"]).ends(0, &["Usage: granlaw <COMMAND>", "2 something could not run"]).out;
    let list = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names = list.lines().filter_map(|l| l.strip_prefix("  ")?.split(' ').next().map(String::from));
    names.filter(|n| !n.is_empty() && n != "help").collect()
}

#[test]
fn every_command_has_help_with_an_example_of_itself() {
    let s = Scratch::new();
    let commands = commands(&s);
    assert!(
        ["laws", "run", "replay", "verify"].iter().all(|c| commands.iter().any(|d| c == d)),
        "{commands:?}"
    );
    for command in commands {
        let help = s.granlaw(&[&command, "--help"]).ends(0, &["Usage: granlaw", "Examples:"]).out;
        let examples = help.split("Examples:").nth(1).unwrap();
        assert!(examples.contains(&format!("  granlaw {command}")), "{help}");
        // Options without a word of explanation help nobody.
        let options: Vec<_> = help.split("Options:").nth(1).unwrap().lines().collect();
        for (k, line) in options.iter().enumerate().filter(|(_, l)| l.starts_with("      --")) {
            let explained = options.get(k + 1).is_some_and(|l| l.starts_with("        "));
            assert!(explained || line.trim().contains("  "), "{command}: {line}");
        }
    }
}

#[test]
fn what_is_mistyped_is_answered_with_what_is_right() {
    let s = Scratch::new();
    s.granlaw(&[]).ends(2, &["Usage: granlaw <COMMAND>"]);
    s.granlaw(&["verfy"]).ends(2, &["verfy", "verify"]);
    s.granlaw(&["laws", "hook"]).ends(2, &["unknown law hook, did you mean hooke?"]);
    s.granlaw(&["run", "-in", "deck.in"]).ends(2, &["unexpected argument"]);
    s.granlaw(&["run", "--laws", "russt", "--", "-in", "x"]).ends(2, &["russt", "rust", "stock"]);
    s.granlaw(&["run", "--every", "2", "--", "-in", "x"]).ends(2, &["--record"]);
    s.granlaw(&["run", "--np", "0", "--", "-in", "x"]).ends(2, &["--np", "0"]);
    s.granlaw(&["replay"]).ends(2, &["<TRACE>"]);
    s.granlaw(&["replay", "--tolerance=-1", "x"]).ends(2, &["must be a number, 0 or above"]);
    for shard in ["3/2", "0/2", "1", "a/b"] {
        s.granlaw(&["verify", "--shard", shard]).ends(2, &["must be K/N with 1 <= K <= N"]);
    }
    for limit in ["0", "nan", "soon"] {
        s.granlaw(&["verify", "--time-limit", limit]).ends(2, &["must be a number of seconds above 0"]);
    }
}

#[test]
fn laws_lists_every_law_and_explains_one() {
    let s = Scratch::new();
    let list = s.granlaw(&["laws"]).ends(0, &[]).out;
    for e in LAWS {
        let line = list.lines().find(|l| l.contains(&format!(" {} ", e.meta.called(false))));
        assert!(line.is_some_and(|l| l.contains(e.meta.summary)), "{list}");
    }
    insta::assert_snapshot!(s.granlaw(&["laws", "cdt"]).ends(0, &[]).out, @r##"
    rolling_friction cdt/rs
      constant directional torque

    Properties (fix ID all property/global <name> <shape> <values>):
      coefficientRollingFriction peratomtypepair  μ_r [1], at least 0
          coefficient of rolling friction

    Settings (behind the models in pair_style gran and fix wall/gran):
      torsionTorque off|on  default off
          also resist spin about the normal

    Sources:
      J. Ai, J.-F. Chen, J.M. Rotter, J.Y. Ooi, Powder Technology 206 (2011) 269, model A

    Exception to the rule Continuous: the torque keeps its size and changes sign with the spin
    "##);
    // With and without its ending it is the same law.
    assert_eq!(s.granlaw(&["laws", "hooke/rs"]).out, s.granlaw(&["laws", "hooke"]).out);
}

#[test]
fn laws_as_json_hold_all_that_the_laws_say_of_themselves() {
    let s = Scratch::new();
    let all: Vec<Value> = serde_json::from_str(&s.granlaw(&["laws", "--json"]).ends(0, &[]).out).unwrap();
    assert_eq!(all.len(), LAWS.len());
    for (json, law) in all.iter().zip(LAWS) {
        let meta = law.meta;
        assert_eq!((&json["kind"], &json["stock_keyword"]), (&meta.kind.name().into(), &meta.keyword.into()));
        let names = |field: &str| -> Vec<&str> {
            json[field].as_array().unwrap().iter().map(|p| p["name"].as_str().unwrap()).collect()
        };
        assert_eq!(names("properties"), meta.props.iter().map(|p| p.name).collect::<Vec<_>>());
        assert_eq!(names("settings"), law.settings().map(|s| s.name).collect::<Vec<_>>());
        assert_eq!(names("history"), meta.slots.iter().map(|p| p.name).collect::<Vec<_>>());
        assert_eq!(json["exceptions"].as_array().unwrap().len(), meta.exceptions.len());
    }
    assert!(LAWS.iter().any(|e| e.meta.kind == Kind::Rolling));
    insta::assert_snapshot!(s.granlaw(&["laws", "cdt", "--json"]).ends(0, &[]).out, @r##"
    [
      {
        "coarse_graining": false,
        "exceptions": [
          {
            "rule": "Continuous",
            "why": "the torque keeps its size and changes sign with the spin"
          }
        ],
        "history": [],
        "id": 49,
        "keyword": "cdt/rs",
        "kind": "rolling",
        "per_atom": [],
        "per_atom_output": [],
        "properties": [
          {
            "doc": "coefficient of rolling friction",
            "name": "coefficientRollingFriction",
            "needed": "",
            "range": "at least 0",
            "shape": "peratomtypepair",
            "symbol": "μ_r",
            "unit": "1",
            "usual": [
              0.0,
              0.5
            ]
          }
        ],
        "references": [
          "J. Ai, J.-F. Chen, J.M. Rotter, J.Y. Ooi, Powder Technology 206 (2011) 269, model A"
        ],
        "selected_by": "rolling_friction",
        "settings": [
          {
            "default": "off",
            "doc": "also resist spin about the normal",
            "name": "torsionTorque",
            "options": [
              "off",
              "on"
            ],
            "support": "Full"
          }
        ],
        "stock_id": 1,
        "stock_keyword": "cdt",
        "stress_strain_exponent": 0.0,
        "summary": "constant directional torque"
      }
    ]
    "##);
}
