//! Every reason in `Batch::obstacle` (`ffi/liggghts/cpp/batch.hpp`): a run goes on contact by contact with the bits of LIGGGHTS,
//! and says why, once; one that was asked for the batched path stops with the same words.
use super::{dump, stock};
use crate::built::{alone, must, source};
use crate::common::{deck, live, plugin, Said, Scratch};
use std::path::{Path, PathBuf};
use std::process::Command;

const DECK: &str = "oblique_slip.in";
const RUN: &str = "run             4000";

/// A reason, and what brings it about.
struct Case {
    why: &'static str,
    deck: &'static str,
    changes: &'static [(&'static str, &'static str)],
    options: &'static [&'static str],
}

const CASES: [Case; 8] = [
    Case {
        why: "every call is recorded, counted or compared",
        deck: DECK,
        changes: &[],
        options: &["--record", "calls.csv"],
    },
    Case { why: "a law of the chain is LIGGGHTS's own", deck: "stock_rolling_epsd2.in", changes: &[], options: &[] },
    Case { why: "a law of the chain takes one contact at a time", deck: "bond_overlap.in", changes: &[], options: &[] },
    Case {
        why: "contacts reach beyond the surfaces (contact_distance_factor)",
        deck: DECK,
        changes: &[("neigh_modify    delay 0", "neigh_modify    delay 0 contact_distance_factor 1.2")],
        options: &[],
    },
    Case {
        why: "the virial or an energy is wanted in this step",
        deck: DECK,
        changes: &[("thermo          4000", "compute s all stress/atom pair\ncompute r all reduce sum c_s[1]\nthermo_style custom step c_r\nthermo 100")],
        options: &[],
    },
    Case {
        why: "a compute looks at each contact (pair/gran/local)",
        deck: DECK,
        changes: &[("thermo          4000", "compute c all pair/gran/local force\ndump each all local 50 local.txt c_c[1] c_c[2] c_c[3]\nthermo 4000")],
        options: &[],
    },
    Case {
        why: "contact forces are stored for a stress",
        deck: DECK,
        changes: &[("thermo          4000", "fix w all continuum/weighted kernel_radius 0.02 kernel_type Top_Hat compute stress\nthermo 4000")],
        options: &[],
    },
    Case {
        why: "normal forces are summed",
        deck: DECK,
        changes: &[("fix             p1", "fix n all property/atom sum_normal_force_ scalar yes yes no 0\nfix             p1")],
        options: &[],
    },
];

/// The reasons that stand in the source.
fn written() -> Vec<String> {
    let source = std::fs::read_to_string(source().join("ffi/liggghts/cpp/batch.hpp")).unwrap();
    let body = source.split("const char *obstacle(").nth(1).unwrap().split("return nullptr;").next().unwrap();
    body.split("return \"").skip(1).map(|r| r.split('"').next().unwrap().to_string()).collect()
}

#[test]
fn every_reason_has_a_case() {
    let written = written();
    assert!(written.len() >= 8, "{written:?}");
    for why in &written {
        let tried = CASES.iter().any(|c| c.why == why) || STORED.iter().any(|(_, w)| w == why);
        assert!(tried, "nothing here brings about {why:?}");
    }
}

fn check(why: &str, reference: &str, run: impl Fn(&str) -> Said, dump: impl Fn() -> String) {
    let said = run("").ends(0, &[]);
    let words = format!(", as {why} (said once)");
    assert_eq!(said.out.matches(&words).count(), 1, "{why}: {said}");
    assert!(dump() == reference, "{why}: not the dump of LIGGGHTS");
    run("batched").ends(1, &["the batched path was asked for and cannot be taken: ", why]);
    // Who asks for the contact path knows why.
    let said = run("contact").ends(0, &[]);
    assert!(!said.out.contains("contact by contact") && dump() == reference, "{why}: {said}");
}

#[test]
fn what_the_batched_path_does_not_do_goes_contact_by_contact() {
    if !live("what_the_batched_path_does_not_do_goes_contact_by_contact") {
        return;
    }
    for case in CASES {
        let s = Scratch::new();
        s.file("deck.in", &deck(case.deck, case.changes));
        let run = |path: &str| {
            let path: &[&str] = if path.is_empty() { &[] } else { &["--path", path] };
            s.granlaw(&[&["run", "--laws", "rust"], case.options, path, &["--", "-in", "deck.in"]].concat())
        };
        // LIGGGHTS lacks bonds: there the contact path is the reference.
        let reference = if case.deck == "bond_overlap.in" {
            run("contact").ends(0, &[]);
            dump(&s)
        } else {
            stock(&s)
        };
        check(case.why, &reference, run, || dump(&s));
    }
}

/// Reasons that no deck can bring about in LIGGGHTS-PUBLIC, but a LIGGGHTS with fixes of its own can.
const STORED: [(&str, &str); 2] =
    [("forces", "contact forces are stored"), ("multicontact", "a multicontact model changes the radii")];

fn host(s: &Scratch) -> PathBuf {
    let mpi = |ask: &str| {
        let out = must(Command::new("mpicxx").arg(format!("--showme:{ask}")));
        String::from_utf8(out.stdout).unwrap().split_whitespace().map(String::from).collect::<Vec<_>>()
    };
    let out = s.path("liggghts-stores");
    let mut cxx = Command::new("c++");
    cxx.args(["-std=gnu++17", "-w", "-DOMPI_SKIP_MPICXX", "-I/usr/include/liggghts"]).args(mpi("compile"));
    cxx.arg(source().join("tests/live/batched/stored.cpp"));
    must(cxx.arg("-lliggghts").args(mpi("link")).arg("-o").arg(&out));
    out
}

#[test]
fn what_fixes_of_others_store_is_stored() {
    if !live("what_fixes_of_others_store_is_stored") {
        return;
    }
    let s = Scratch::new();
    s.file("deck.in", &deck(DECK, &[(RUN, "")]));
    let host = host(&s);
    for (what, why) in STORED {
        let run = |path: &str, plugin: &Path| {
            let mut command = alone(&host, &s.path(""));
            command.args([what, "-in", "deck.in"]).env("LD_PRELOAD", plugin);
            Said::of(command.env("GRANLAW_LAWS", "rust").env("GRANLAW_PATH", path))
        };
        run("", Path::new("")).ends(0, &[]);
        let reference = dump(&s);
        check(why, &reference, |path| run(path, &plugin().unwrap().path), || dump(&s));
    }
}
