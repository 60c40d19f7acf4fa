//! `compute bond/nonlinear/counter` against the bonds that `compute pair/gran/local` shows.
use super::bench::{frames, run, scratch, thermo};
use crate::built::{must, source};
use crate::common::{deck, live, Said, Scratch};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A ball of some eighty spheres that is crushed, on its border between two ranks.
fn crushed() -> String {
    deck(
        "bond_agglomerate.in",
        &[
            ("newton          off", "newton          off\nprocessors      * 1 1"),
            ("sphere 0 0 0 0.0039", "sphere 0 0 0 0.0024"),
            ("0 0 -0.0041", "0 0 -0.00264"),
            ("0 0 0.0041", "0 0 0.00264"),
            ("linear 0 0 1", "linear 0 0 5"),
            ("linear 0 0 -1", "linear 0 0 -5"),
            ("thermo          500", "thermo          50"),
            ("local 2000", "local 50"),
            ("run             6000", "run             600"),
        ],
    )
}

/// The three numbers of the counter for pairs at each step, worked out from the dump: the bonds seen so far, those of
/// them that are gone, and those that are there. Columns 7 and 8 are the particles, 12 is r0, 0 without a bond.
fn seen(s: &Scratch) -> Vec<(u64, [f64; 3])> {
    let mut ever = BTreeSet::new();
    let frames = frames(&s.read("bonds.dump"));
    let mut count = |(step, rows): (u64, Vec<Vec<f64>>)| {
        let bonds = rows.iter().filter(|r| r[R0] != 0.0);
        let pair = |r: &Vec<f64>| (r[6].min(r[7]) as u64, r[6].max(r[7]) as u64);
        let there: BTreeSet<_> = bonds.map(pair).collect();
        ever.extend(there.iter().copied());
        (step, [ever.len(), ever.len() - there.len(), there.len()].map(|n| n as f64))
    };
    frames.into_iter().map(&mut count).collect()
}

/// In the dump of `bond_agglomerate.in`.
const R0: usize = 11;

/// The counter and the dump say the same at every step, and there was something to count.
fn agree(s: &Scratch, said: &Said) -> Result<(), String> {
    let (thermo, seen) = (thermo(said), seen(s));
    for (step, expected) in &seen {
        let counted = &thermo[step][2..5];
        if counted != expected {
            return Err(format!("at step {step} {counted:?} were counted, {expected:?} are there"));
        }
    }
    let (_, [begun, ended, there]) = seen[seen.len() - 1];
    let enough = seen.len() > 10 && begun > 200.0 && ended > 10.0 && there > 10.0;
    enough.then_some(()).ok_or(format!("{begun} begun, {ended} ended, {there} there"))
}

/// A library that puts one more on a field of what is counted.
fn miscounting(dir: &Path, field: &str) -> PathBuf {
    let (file, out) = (dir.join(format!("{field}.c")), dir.join(format!("{field}.so")));
    let text = format!(
        "#define _GNU_SOURCE\n#include <dlfcn.h>\n#include \"granlaw.h\"\n\
        granlaw_status granlaw_count_bonds(const granlaw_chain *chain, granlaw_bonds *out) {{\n\
        \tgranlaw_status (*next)(const granlaw_chain *, granlaw_bonds *) = dlsym(RTLD_NEXT, \"granlaw_count_bonds\");\n\
        \tconst granlaw_status status = next(chain, out);\n\
        \tout->{field} += out->begun > 0;\n\treturn status;\n}}\n"
    );
    std::fs::write(&file, text).unwrap();
    let mut cc = Command::new("cc");
    cc.args(["-shared", "-fPIC", "-I"]).arg(source().join("ffi/capi/include"));
    must(cc.arg("-o").arg(&out).arg(&file).arg("-ldl"));
    out
}

#[test]
fn the_counter_counts_what_is_there() {
    if !live("the_counter_counts_what_is_there") {
        return;
    }
    let s = scratch(&crushed());
    for ranks in [1, 2] {
        let said = run(&s, ranks, "").ends(0, &[]);
        agree(&s, &said).unwrap_or_else(|e| panic!("on {ranks} ranks: {e}"));
        for field in ["begun", "ended", "there"] {
            let library = miscounting(&s.path(""), field);
            let said = run(&s, ranks, library.to_str().unwrap()).ends(0, &[]);
            assert!(agree(&s, &said).is_err(), "one {field} too many on {ranks} ranks was not seen");
        }
    }
}

/// Bonds go with the particles that are deleted, without having ended; nothing else changes.
#[test]
fn particles_may_be_deleted_while_they_are_bonded() {
    if !live("particles_may_be_deleted_while_they_are_bonded") {
        return;
    }
    let cut = "run             290\nregion          right block 0.0004 1 INF INF INF INF units box\n\
        delete_atoms    region right COMPRESS\nrun             310";
    let good = crushed().replace("run             600", cut);
    for ranks in [1, 2] {
        let s = scratch(&good.replace("COMPRESS", "compress no"));
        let said = run(&s, ranks, "").ends(0, &[]);
        let (thermo, seen) = (thermo(&said), seen(&s));
        let at = |step: u64| &thermo[&step][2..5];
        let (before, after) = (at(250), at(350));
        assert!(after[0] == before[0] && after[2] < 0.8 * before[2], "{before:?} and {after:?}");
        for (step, expected) in seen {
            assert_eq!(at(step)[2], expected[2], "at step {step} on {ranks} ranks");
        }
        let finite = frames(&s.read("dump.txt")).into_values().flatten().flatten().all(f64::is_finite);
        assert!(finite && thermo[&600][0] < thermo[&0][0] && thermo[&600][1].is_finite());

        // LIGGGHTS's default renumbers, after which bonds would hold others together.
        let s = scratch(&good.replace(" COMPRESS", ""));
        let words = "particles have new numbers since the last run, and LIGGGHTS hands bonds on by number; use delete_atoms ... compress no";
        run(&s, ranks, "").ends(1, &[words]);
    }
}
