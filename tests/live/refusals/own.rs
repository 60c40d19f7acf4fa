//! Properties and settings that only our laws have, by the example of `cdt_jkr`.
use super::deck::{can, each_side, Deck};

const CHAIN: &str = "model hertz/rs rolling_friction cdt_jkr";
const WHO: [&str; 2] = ["pair_style gran: ", "fix floor wall/gran: "];

fn sides(settings: &str) -> [Deck; 2] {
    let fixes = "fix w all property/global workOfAdhesion peratomtypepair 2 5 5 5 5\n\
        fix h all property/global adhesionHysteresis peratomtypepair 2 1 1 1 1\npair_style      gran";
    each_side(format!("{CHAIN} {settings}").trim()).map(|d| d.with("pair_style      gran", fixes))
}

#[test]
fn a_law_that_liggghts_lacks_answers_to_either_name() {
    if !can("a_law_that_liggghts_lacks_answers_to_either_name") {
        return;
    }
    for side in sides("cdtJkrConvention documented restTorqueLimit on") {
        let dump = side.clone().runs().dump;
        assert!(!dump.is_empty() && dump == side.with("cdt_jkr", "cdt_jkr/rs").runs().dump);
    }
}

#[test]
fn a_setting_without_default_must_be_chosen() {
    if !can("a_setting_without_default_must_be_chosen") {
        return;
    }
    for (side, who) in sides("").into_iter().zip(WHO) {
        let wanted = format!("{who}cdt_jkr/rs: setting cdtJkrConvention must be given, one of documented, upstream: documented is the published law, with pi");
        side.refused(1, &wanted);
    }
}

#[test]
fn a_word_that_is_no_option_is_answered_with_those_that_are() {
    if !can("a_word_that_is_no_option_is_answered_with_those_that_are") {
        return;
    }
    for side in sides("cdtJkrConvention documentd") {
        let wanted = "cdt_jkr/rs: setting cdtJkrConvention documentd: must be one of documented, upstream";
        side.refused(1, wanted);
    }
    for side in sides("cdtJkrConvention") {
        side.refused(1, "Setting cdtJkrConvention has no value");
    }
}

#[test]
fn a_property_of_our_own_that_is_missing_or_out_of_range() {
    if !can("a_property_of_our_own_that_is_missing_or_out_of_range") {
        return;
    }
    for (side, who) in sides("cdtJkrConvention upstream").into_iter().zip(WHO) {
        let wanted = format!("{who}cdt_jkr/rs: property workOfAdhesion was not given; set it with fix ID all property/global workOfAdhesion peratomtypepair");
        side.clone().without("workOfAdhesion").refused(1, &wanted);
        let wanted = format!("{who}cdt_jkr/rs: workOfAdhesion = -1 (types 1-2) must be at least 0; change it in fix property/global workOfAdhesion");
        let bad = ("workOfAdhesion peratomtypepair 2 5 5 5 5", "workOfAdhesion peratomtypepair 2 5 -1 -1 5");
        side.clone().with(bad.0, bad.1).refused(1, &wanted);
        let wanted = format!("{who}cdt_jkr/rs: adhesionHysteresis = -0.5 (types 1-1) must be at least 0");
        let bad = ("adhesionHysteresis peratomtypepair 2 1", "adhesionHysteresis peratomtypepair 2 -0.5");
        side.with(bad.0, bad.1).refused(1, &wanted);
    }
}
