//! Decks that ask for what a bond cannot do, and those that look as if they did.
use super::bench::{frames, run, scratch};
use crate::common::{deck, live};

const WALL: &str = "bond_wall.in";
const MOVING: &str = "bond_moving_wall.in";
const STRESS: &str = "bond_breaks_by_ratio.in";
const LINEAR: &str = "linear 0 0 -0.4";

/// A deck, one text in it and what stands there instead, and what LIGGGHTS then stops with.
const REFUSED: [(&str, &str, &str, &str); 22] = [
    (WALL, "radiusMultiplierBondnonlinear peratomtypepair 1 0.8", "radiusMultiplierBondnonlinear peratomtypepair 1 -0.8",
     "pair_style gran: bond/nonlinear/rs: radiusMultiplierBondnonlinear = -0.8 (types 1-1) must be at least 0"),
    (WALL, "AreaKu_fn2 peratomtypepair 1 2e+10", "AreaKu_fn2 peratomtypepair 1 5e9",
     "stiffnessPerUnitAreaKu_fn2 = 5000000000 (types 1-1) must be at least 10000000000"),
    (WALL, "AreaKc_tn peratomtypepair 1 2000000000", "AreaKc_tn peratomtypepair 1 -1",
     "stiffnessPerUnitAreaKc_tn = -1 (types 1-1) must be at least 0"),
    (WALL, "createDistanceBondnonlinear peratomtypepair 1 0.0011", "createDistanceBondnonlinear peratomtypepair 1 0",
     "createDistanceBondnonlinear = 0 (types 1-1) must be above 0"),
    (WALL, "maxDistanceBondnonlinear peratomtypepair 1 0.0015", "maxDistanceBondnonlinear peratomtypepair 1 0.0011",
     "maxDistanceBondnonlinear = 0.0011 (types 1-1) must be above 0.0011"),
    (WALL, "maxDistanceBondnonlinear peratomtypepair 1 0.0015", "maxDistanceBondnonlinear peratomtypepair 1 0.0109",
     "acts up to a distance of 1.09e-2 m, 11.990 times the smallest diameter with a margin of a tenth; LIGGGHTS would look for neighbours that far, 10 times is the most"),
    (WALL, "tsCreateBondnonlinear scalar 1", "tsCreateBondnonlinear scalar 0",
     "tsCreateBondnonlinear = 0 must be at least 1: step 0 only sets the run up"),
    (WALL, "neighbor        0.0005 bin", "neighbor        0.00001 bin",
     "fix floor wall/gran: bond/nonlinear/rs: acts up to a gap of 2.5e-4 m from a wall, but LIGGGHTS lists particles near a primitive wall only up to the skin of 1e-5 m"),
    (WALL, "bondConvention documented dampingBond off\npair_coeff", "dampingBond off\npair_coeff",
     "pair_style gran: bond/nonlinear/rs: setting bondConvention must be given, one of documented, upstream: documented: "),
    (WALL, "zplane 0.0 bondConvention documented", "zplane 0.0",
     "fix floor wall/gran: bond/nonlinear/rs: setting bondConvention must be given"),
    (WALL, "bondConvention documented", "bondConvention documentd",
     "setting bondConvention documentd: must be one of documented, upstream"),
    (WALL, "dampingBond off", "dampingBond on",
     "property dampingNormalForceBondnonlinear was not given; set it with fix ID all property/global dampingNormalForceBondnonlinear peratomtypepair"),
    (WALL, "zplane 0.0", "zcylinder 0.0015 0 0 shear x 0.1",
     "holds particles to a point of a wall, which may move but not turn or change its shape"),
    (WALL, "newton          off", "newton          on", "requires newton pair off"),
    (MOVING, LINEAR, "rotate origin 0 0 0 axis 0 0 1 period 1",
     "fix floor wall/gran: bond/nonlinear/rs: holds particles to a point of a wall, which may move but not turn or change its shape"),
    (MOVING, LINEAR, "riggle origin 0 0 0 axis 0 0 1 period 1 amplitude 1", "which may move but not turn or change its shape"),
    (STRESS, "AreaK_fn2 peratomtypepair 1 1e+10", "AreaK_fn2 peratomtypepair 1 0",
     "stressBreak on (types 1-1) with stiffnessPerUnitAreaK_fn2 = 0 lets a bond stretch without end"),
    (STRESS, "stressBreak on", "stressBreak on tensionStress off",
     "stressBreak on (types 1-1) with tensionStress off lets a bond stretch without end"),
    (STRESS, "maxSigmaBondnonlinear peratomtypepair 1 ", "maxSigmaBondnonlinear peratomtypepair 1 -",
     "(types 1-1) must be above 0"),
    (STRESS, "maxTauBondnonlinear peratomtypepair 1 ", "maxTauBondnonlinear peratomtypepair 1 -",
     "(types 1-1) must be above 0"),
    (STRESS, "ratioTensionCompressionBondnonlinear peratomtypepair 1 ", "ratioTensionCompressionBondnonlinear peratomtypepair 1 -",
     "(types 1-1) must be above 0"),
    ("bond_damped.in", "dampingTangentialTorqueBondnonlinear peratomtypepair 1 ", "dampingTangentialTorqueBondnonlinear peratomtypepair 1 1",
     "(types 1-1) must be within [0, 1]"),
];

#[test]
fn what_a_bond_cannot_do_is_refused_at_set_up() {
    if !live("what_a_bond_cannot_do_is_refused_at_set_up") {
        return;
    }
    for (name, from, to, words) in REFUSED {
        let said = run(&scratch(&deck(name, &[(from, to)])), 1, "").ends(1, &[words]);
        assert!(!said.out.contains("Loop time"), "{name} with {to:?} ran before it was refused");
    }
}

/// Two particles at the same place have no direction: the first evaluation, which sets the run up, says so.
#[test]
fn a_bond_of_no_length_is_refused() {
    if !live("a_bond_of_no_length_is_refused") {
        return;
    }
    let at =
        |x: &str| scratch(&deck("bond_tension.in", &[("single 0.00051 0 0", &format!("single {x} 0 0"))]));
    let words = "the contact of particle 1 with particle 2 at step 0 is not finite (overlap 1e-3 m";
    run(&at("-0.00051"), 1, "").ends(1, &[words]);
    // A rounding apart they bond, and nothing is worse than a number.
    let s = at("-0.00050999999999999");
    run(&s, 1, "").ends(0, &[]);
    let dump = s.read("dump.txt");
    let frames = frames(&dump);
    assert!(frames.values().flatten().flatten().all(|x| x.is_finite()), "{dump}");
    assert!(frames.values().last().unwrap()[0][10] != 0.0, "no force: {dump}");
}

/// What needs no refusal: the same bytes as without.
#[test]
fn some_decks_only_look_bad() {
    if !live("some_decks_only_look_bad") {
        return;
    }
    for (name, from, to) in [
        // Pairs are listed as far as bonds reach, whatever the skin.
        ("bond_tension.in", "neighbor        0.0005 bin", "neighbor        0.00001 bin"),
        // History follows the particles through rebuilds of the lists without a map.
        ("bond_migrates.in", "atom_modify     map array sort 0 0\n", ""),
    ] {
        let dump = |ranks: usize, more: &[(&str, &str)]| {
            let s = scratch(&deck(name, more));
            run(&s, ranks, "").ends(0, &[]);
            s.read("dump.txt")
        };
        let good = dump(1, &[]);
        assert!(good.lines().count() > 100);
        for ranks in [1, 2] {
            assert!(dump(ranks, &[(from, to)]) == good, "{name} with {to:?} on {ranks} ranks");
        }
    }
}
