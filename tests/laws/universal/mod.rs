//! Every law against the rules that all laws obey. A new law in `LAWS` is tested by this without a line more.
mod beyond;
mod foreign;
mod lanes;
mod motion;
mod paths;
mod planted;
mod recipe;
mod refusals;
mod rules;
mod switches;

use granlaw::laws::LAWS;
use granlaw::model::{Kind, Reach, Rule};
use recipe::{chain_of, chains, for_all, Check, Laws, Switches};

const CASES: u32 = 300;

/// The rules that a law may break if its `META` says so.
const DECLARED: [(Rule, Check); 5] = [
    (Rule::QueryLeavesHistory, rules::query),
    (Rule::ApartClearsHistory, rules::clears),
    (Rule::Continuous, paths::continuous),
    (Rule::CycleDissipates, paths::cycle),
    (Rule::DampingOdd, rules::odd_damping),
];

fn excepted(laws: &Laws, rule: Rule) -> bool {
    laws.iter().any(|e| e.meta.exception(rule).is_some())
}

fn names(laws: &Laws) -> String {
    laws.iter().map(|e| e.meta.keyword).collect::<Vec<_>>().join(" + ")
}

fn every_chain(check: Check) {
    for laws in chains() {
        for_all(&laws, Switches::Any, CASES, None, check).unwrap_or_else(|e| panic!("{}: {e}", names(&laws)));
    }
}

#[test]
fn i_and_j_change_places() {
    every_chain(rules::swap);
}

#[test]
fn the_frame_turns() {
    every_chain(rules::rotation);
}

#[test]
fn the_frame_moves() {
    every_chain(rules::galilean);
}

#[test]
fn units_scale() {
    every_chain(rules::units);
}

#[test]
fn angular_momentum_stays() {
    every_chain(rules::angular_momentum);
}

#[test]
fn numbers_that_are_none_do_no_harm() {
    every_chain(rules::survives);
}

#[test]
fn a_wall_is_a_partner_without_end() {
    every_chain(rules::wall_limit);
}

#[test]
fn a_normal_law_tells_its_stiffness_damping_and_energy() {
    for e in LAWS.iter().filter(|e| e.meta.kind == Kind::Normal) {
        // What limitForce cuts off is not told.
        for_all(&vec![e], Switches::Default, CASES, None, paths::observed).unwrap();
    }
}

/// Undeclared rules hold under every setting.
#[test]
fn rules_without_exception_hold() {
    let mut held = 0;
    for (rule, check) in DECLARED {
        for laws in chains().into_iter().filter(|laws| !excepted(laws, rule)) {
            for_all(&laws, Switches::Any, CASES, None, check)
                .unwrap_or_else(|e| panic!("{rule:?} of {}: {e}", names(&laws)));
            held += 1;
        }
    }
    assert!(held >= 40, "only {held} chains were asked");
}

/// A declared exception occurs; one that does not is to be struck off.
#[test]
fn declared_exceptions_occur() {
    // Those of laws that act across a gap are asked for along paths, in `beyond`.
    for meta in LAWS.iter().map(|e| e.meta).filter(|m| m.reach == Reach::Overlap) {
        for exception in meta.exceptions {
            let check = DECLARED.iter().find(|(rule, _)| *rule == exception.rule).expect("a check").1;
            let occurs = chains()
                .iter()
                .filter(|laws| {
                    laws.iter().all(|e| {
                        *e.meta.keyword == *meta.keyword || e.meta.exception(exception.rule).is_none()
                    })
                })
                .filter(|laws| laws.iter().any(|e| e.meta.keyword == meta.keyword))
                .any(|laws| for_all(laws, Switches::Any, CASES, None, check).is_err());
            assert!(occurs, "{}: {:?} never occurs", meta.keyword, exception.rule);
        }
    }
}

/// Where an exception hangs on a setting or a partner law, the rule holds without it.
#[test]
fn exceptions_are_no_wider_than_they_say() {
    let rules: [(&[&str], Switches, Check); 11] = [
        (&["hooke"], Switches::With("viscous", "off"), rules::odd_damping),
        (&["hooke/hysteresis"], Switches::With("viscous", "off"), rules::odd_damping),
        (&["hooke", "history", "cdt"], Switches::With("viscous", "off"), paths::cycle),
        (&["hooke/hysteresis", "history", "cdt"], Switches::With("viscous", "off"), paths::cycle),
        (&["hertz"], Switches::Any, paths::cycle),
        (&["hertz", "no_history", "cdt"], Switches::Any, paths::cycle),
        (&["hooke", "history"], Switches::With("tangential_damping", "off"), paths::continuous),
        (&["hooke/hysteresis", "history"], Switches::With("tangential_damping", "off"), paths::continuous),
        (&["hertz", "cdt_jkr"], Switches::With("restTorqueLimit", "on"), paths::continuous),
        (&["hertz", "no_history", "cdt_jkr"], Switches::With("restTorqueLimit", "on"), paths::continuous),
        (&["hertz", "no_history", "cdt_jkr"], Switches::Any, paths::cycle),
    ];
    for (laws, switches, check) in rules {
        for_all(&chain_of(laws), switches, CASES, None, check).unwrap_or_else(|e| panic!("{laws:?}: {e}"));
    }
}

/// Each slot of history comes to hold something.
#[test]
fn every_slot_is_written() {
    for laws in chains() {
        assert_eq!(rules::written(&laws, None), Ok(()), "{}", names(&laws));
    }
}
