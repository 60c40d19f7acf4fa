//! `check same-as`: a deck on a law of ours against another on LIGGGHTS's, and faults planted in the other.

use crate::built::{built, has, here, said, source};
use std::fs;
use std::path::Path;
use std::process::Command;

const DECK: &str = "cdt_jkr_unequal.in";
const TWIN: &str = "cdt_jkr_unequal_stock.in";

/// What verify says of the deck beside its twin, each with texts changed, and the exit code.
fn verified(deck: &[(&str, &str)], twin: &[(&str, &str)]) -> (String, Option<i32>) {
    let dir = tempfile::tempdir().unwrap();
    for (name, changes) in [(DECK, deck), (TWIN, twin)] {
        let mut text = fs::read_to_string(source().join("liggghts_inputs").join(name)).unwrap();
        for (from, to) in changes {
            assert!(text.contains(from), "{name} has no {from:?} to change");
            text = text.replace(from, to);
        }
        fs::write(dir.path().join(name), text).unwrap();
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_granlaw"));
    command.args(["verify", "--require-liggghts", DECK]).current_dir(dir.path());
    command.env("GRANLAW_PLUGIN", built().join("libgranlaw_liggghts.so")).env_remove("LD_PRELOAD");
    let out = command.output().unwrap();
    (said(&out), out.status.code())
}

fn can(test: &str) -> bool {
    let found = has("liggghts") && Path::new("/usr/include/liggghts").exists();
    here(test, found, "no liggghts or libliggghts-dev; install them")
}

#[test]
fn the_equivalent_coefficient_gives_the_same_bits() {
    if can("the_equivalent_coefficient_gives_the_same_bits") {
        let (said, code) = verified(&[], &[]);
        assert!(code == Some(0) && said.contains(&format!("same as {TWIN} identical")), "{said}");
    }
}

#[test]
fn a_coefficient_off_in_its_last_digits_turns_red() {
    if can("a_coefficient_off_in_its_last_digits_turns_red") {
        // Three units in the last place, of the pair of unlike types only.
        let text = fs::read_to_string(source().join("liggghts_inputs").join(TWIN)).unwrap();
        let line = text.lines().find(|l| l.contains("coefficientRollingFriction peratomtypepair")).unwrap();
        let told: Vec<_> = line.split_whitespace().rev().take(4).collect();
        let off = told[1].parse::<f64>().unwrap() * (1.0 + 7e-16);
        let (said, code) = verified(&[], &[(told[1], &format!("{off:?}"))]);
        assert!(code == Some(1) && said.contains(&format!("same as {TWIN} DISAGREED: dump.txt:")), "{said}");
    }
}

#[test]
fn another_convention_turns_red() {
    if can("another_convention_turns_red") {
        let (said, code) = verified(&[("cdtJkrConvention documented", "cdtJkrConvention upstream")], &[]);
        assert!(code == Some(1) && said.contains(&format!("same as {TWIN} DISAGREED")), "{said}");
    }
}

#[test]
fn what_cannot_be_compared_is_no_agreement() {
    if can("what_cannot_be_compared_is_no_agreement") {
        let (said, code) = verified(&[], &[("\ndump ", "\n#dump "), ("\ndump_modify ", "\n#dump_modify ")]);
        assert!(code == Some(2) && said.contains("writes no text dump to compare"), "{said}");
        let (said, code) = verified(&[], &[("pair_coeff", "pair_coef")]);
        assert!(code == Some(2) && said.contains("run to compare with"), "{said}");
        let (said, code) = verified(&[(TWIN, "absent.in")], &[]);
        assert!(code == Some(2) && said.contains("check same-as absent.in: cannot read it"), "{said}");
    }
}
