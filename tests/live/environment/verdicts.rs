//! Verdicts where the user's environment holds whatever it may.
use super::disturbing;
use crate::common::{deck, live, program, report, Said, Scratch};
use granlaw_tools::codes::environment::{Reader, VARIABLES};
use rayon::prelude::*;
use serde_json::Value;
use std::fs;
use std::os::unix::fs::PermissionsExt;

/// What others than granlaw read, MPI, the loader and LIGGGHTS among them, and values that would stop or change a run.
const OTHERS: [(&str, &str); 10] = [
    ("LD_PRELOAD", "/no/where/fault.so"),
    ("LC_ALL", "de_DE.UTF-8"),
    ("LC_NUMERIC", "de_DE.UTF-8"),
    ("LANG", "de_DE.UTF-8"),
    ("OMP_NUM_THREADS", "3"),
    ("LAMMPS_POTENTIALS", "/no/where"),
    ("OMPI_COMM_WORLD_SIZE", "4"),
    ("OMPI_COMM_WORLD_RANK", "3"),
    ("PMIX_RANK", "3"),
    ("PMIX_NAMESPACE", "another"),
];

/// MPI's settings, which are passed on where there are several ranks only.
const OF_ONE_RANK: [(&str, &str); 2] = [("OMPI_MCA_pml", "none"), ("OMPI_MCA_ess", "none")];

fn written(s: &Scratch) {
    s.file("deck.in", &deck("head_on_at_limit.in", &[]));
}

fn granlaw(s: &Scratch, args: &[&str], variables: &[(&str, &str)]) -> Said {
    Said::of(s.command(program()).args(args).envs(variables.iter().copied()))
}

/// How it ended and the report, without what differs from run to run.
fn verified(s: &Scratch, name: &str, variables: &[(&str, &str)]) -> String {
    let args = ["verify", name, "--require-liggghts", "--out", "out"];
    let code = granlaw(s, &args, variables).code;
    let mut report = report(&s.path("out"));
    for case in report["cases"].as_array_mut().unwrap() {
        case["seconds"] = Value::Null;
    }
    format!("{code:?} {report}")
}

/// The same comes out with all variables set at once; where not, which of them it is.
fn the_same(plain: &str, found: impl Fn(&[(&str, &str)]) -> String, more: &[(&'static str, &'static str)]) {
    let all = [&disturbing()[..], &OTHERS, more].concat();
    if found(&all) == plain {
        return;
    }
    let guilty: Vec<_> = all.into_iter().filter(|v| found(&[*v]) != plain).collect();
    panic!("what comes out depends on {guilty:?}");
}

#[test]
fn no_variable_changes_a_verdict() {
    if !live("no_variable_changes_a_verdict") {
        return;
    }
    let s = Scratch::new();
    for (name, agreed, more) in [("head_on_at_limit.in", 5, &OF_ONE_RANK[..]), ("two_ranks.in", 3, &[])] {
        s.file(name, &deck(name, &[]));
        let plain = verified(&s, name, &[]);
        assert!(plain.contains(&format!("\"agreed\":{agreed},")), "{plain}");
        the_same(&plain, |set| verified(&s, name, set), more);
    }
}

#[test]
fn no_variable_changes_the_step_that_is_advised() {
    if !live("no_variable_changes_the_step_that_is_advised") {
        return;
    }
    let s = Scratch::new();
    written(&s);
    let advised = |set: &[(&str, &str)]| {
        let said = granlaw(&s, &["timestep", "deck.in", "--json"], set);
        format!("{:?} {}", said.code, said.out)
    };
    let plain = advised(&[]);
    assert!(plain.starts_with("Some(0)") && plain.contains("\"accuracy\""), "{plain}");
    the_same(&plain, advised, &OF_ONE_RANK);
}

/// The command line has a variable of its own, and those of the tests are nothing to it.
#[test]
fn what_is_named_counts() {
    if !live("what_is_named_counts") {
        return;
    }
    let s = Scratch::new();
    written(&s);
    let args = ["verify", "deck.in", "--out", "out"];
    granlaw(&s, &args, &[("GRANLAW_PLUGIN", "no/where.so")]).ends(2, &["no/where.so", "cannot be read"]);
    let of_tests = VARIABLES.iter().filter(|v| v.reader == Reader::Tests);
    granlaw(&s, &args, &of_tests.map(|v| (v.name, "1")).collect::<Vec<_>>()).ends(0, &["5 checks agreed"]);
}

/// The values do disturb where they get through: a program in LIGGGHTS's place lets them in.
#[test]
fn a_variable_that_got_through_would_turn_the_verdict() {
    if !live("a_variable_that_got_through_would_turn_the_verdict") {
        return;
    }
    let s = Scratch::new();
    written(&s);
    let leaks = |name: &str, value: &str| {
        let leak = format!("#!/bin/sh\nPATH=${{PATH#*:}}\nexport {name}='{value}'\nexec liggghts \"$@\"\n");
        let bin = format!("leak/{name}");
        let program = s.file(&format!("{bin}/liggghts"), &leak);
        fs::set_permissions(program, fs::Permissions::from_mode(0o755)).unwrap();
        let path = format!("{}:{}", s.path(&bin).display(), std::env::var("PATH").unwrap());
        let args = ["verify", "deck.in", "--jobs", "1", "--out", name];
        granlaw(&s, &args, &[("PATH", &path)])
    };
    disturbing().into_par_iter().for_each(|(name, value)| match name {
        // It is a name in a trace, and no verdict looks at it.
        "GRANLAW_DECK" => drop(leaks(name, value).ends(0, &[])),
        _ => drop(leaks(name, value).ends(2, &["COULD NOT RUN"])),
    });
}
