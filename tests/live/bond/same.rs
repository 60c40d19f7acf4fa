//! Whatever LIGGGHTS does with particles and histories on the way, a bond goes on with the same bits; the header's does
//! not, so that each of these comparisons is seen to tell.
use super::bench::{run, scratch};
use crate::common::{deck, live};

/// A stiffness in compression of the header is that of the sheet times the area of the bond, about 5e-7 m².
const UPSTREAM: [(&str, &str); 4] = [
    ("bondConvention documented", "bondConvention upstream"),
    ("AreaK_fn1 peratomtypepair 1 40000000", "AreaK_fn1 peratomtypepair 1 20"),
    ("AreaKu_fn1 peratomtypepair 1 80000000", "AreaKu_fn1 peratomtypepair 1 40"),
    ("AreaKc_fn1 peratomtypepair 1 20000000", "AreaKc_fn1 peratomtypepair 1 10"),
];

/// Sorted by place every 100 steps, the two particles change places in memory, and i and j with them.
const SORTED: [(&str, &str); 2] = [
    ("sort 0 0", "sort 100 0.0004"),
    (
        "run             60000",
        "compute i all pair/gran/local id\ndump i all local 1000 ids.dump c_i[1]\nrun 60000",
    ),
];

#[test]
fn a_bond_goes_on_with_the_same_bits() {
    if !live("a_bond_goes_on_with_the_same_bits") {
        return;
    }
    let dump = |name: &str, ranks: usize, changes: &[(&str, &str)]| {
        let s = scratch(&deck(name, changes));
        let said = run(&s, ranks, "").ends(0, &[]);
        if name.starts_with("bond_migrates") {
            assert!(!said.out.contains("Neighbor list builds = 0"), "{name}: nothing was built anew");
        }
        if changes.contains(&SORTED[0]) {
            let ids = s.read("ids.dump");
            assert!(ids.contains("\n1 \n") && ids.contains("\n2 \n"), "i and j kept their places: {ids}");
        }
        let dump = s.read("dump.txt");
        assert!(dump.lines().count() > 100);
        dump
    };
    for (name, other, ranks, more) in [
        ("bond_tumbles.in", "bond_tumbles_two_runs.in", 1, &[][..]),
        ("bond_tumbles.in", "bond_tumbles_queried.in", 1, &[]),
        ("bond_migrates.in", "bond_migrates_two_ranks.in", 2, &[]),
        ("bond_migrates.in", "bond_migrates.in", 1, &SORTED),
    ] {
        let same = |changes: &[(&str, &str)]| {
            dump(name, 1, changes) == dump(other, ranks, &[changes, more].concat())
        };
        assert!(same(&[]), "{other} {more:?} differs from {name}");
        assert!(!same(&UPSTREAM), "{other} {more:?} shows nothing: the header's dumps are the same too");
    }
}
