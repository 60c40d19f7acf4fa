//! What the plugin refuses inside LIGGGHTS, for pairs and walls: the words that the user reads, and the exit status.
mod deck;
mod host;
mod own;
mod runs;

use deck::{can, chain_with, each_side, Deck};
use granlaw::laws::LAWS;

#[test]
fn a_good_deck_runs() {
    if can("a_good_deck_runs") {
        for side in each_side("model hooke/rs tangential history/rs") {
            side.runs();
        }
    }
}

/// Our own range, read through LIGGGHTS's creator of that property.
#[test]
fn a_property_out_of_range() {
    if !can("a_property_out_of_range") {
        return;
    }
    let wanted = "hooke/hysteresis/rs: coefficientMaxElasticStiffness = 0.5 (types 1-2) must be at least 1; change it in fix property/global coefficientMaxElasticStiffness";
    for side in each_side("model hooke/hysteresis/rs tangential history/rs") {
        side.with(
            "MaxElasticStiffness peratomtypepair 2 5 5 5 5",
            "MaxElasticStiffness peratomtypepair 2 5 0.5 0.5 5",
        )
        .refused(1, wanted);
    }
    // LIGGGHTS's own check of its own property comes first.
    for side in each_side("model hooke/rs") {
        side.with(
            "coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5",
            "coefficientRestitution peratomtypepair 2 2 2 2 2",
        )
        .refused(1, "0.05 < coefficientRestitution <= 1 required");
    }
}

#[test]
fn a_property_that_is_missing() {
    if !can("a_property_that_is_missing") {
        return;
    }
    for (law, property, deck) in [
        ("hooke/hysteresis/rs", "coefficientPlasticityDepth", "model hooke/hysteresis/rs"),
        ("history/rs", "coefficientFriction", "model hooke/rs tangential history/rs"),
        ("cdt/rs", "coefficientRollingFriction", "model hooke/rs rolling_friction cdt/rs"),
    ] {
        let wanted = format!(
            "Could not locate a fix/property storing value(s) for {property} as requested by model {law}"
        );
        for side in each_side(deck) {
            side.without(property).refused(1, &wanted);
        }
    }
}

#[test]
fn a_word_that_does_not_exist() {
    if !can("a_word_that_does_not_exist") {
        return;
    }
    let chain = "model hooke/rs tangential history/rs";
    for side in each_side(&format!("{chain} hastings on")) {
        side.refused(1, "Unknown argument or wrong keyword order: 'hastings'");
    }
    for side in each_side(&format!("{chain} limitForce maybe")) {
        side.refused(
            1,
            "while parsing 'limitForce' argument: unknown option or wrong keyword order: 'maybe'",
        );
    }
    for side in each_side(&format!("{chain} limitForce")) {
        side.refused(1, "Setting limitForce has no value");
    }
    for side in each_side("model hooke/rz tangential history/rs") {
        side.refused(1, "Invalid model specified");
    }
    for side in each_side(&format!("{chain} surface multicontact")) {
        side.refused(1, "granlaw's laws need 'surface default'");
    }
}

#[test]
fn newton_must_be_off_for_history() {
    if can("newton_must_be_off_for_history") {
        let deck = Deck::new("model hooke/rs tangential history/rs", "model hooke/rs");
        deck.with("newton          off", "newton          on").refused(1, "requires newton pair off");
    }
}

/// Every setting of every law that LIGGGHTS knows and ours does not do, under both names.
#[test]
fn settings_that_are_not_done_are_refused_by_name() {
    if !can("settings_that_are_not_done_are_refused_by_name") {
        return;
    }
    let mut seen = 0;
    for law in LAWS {
        let meta = law.meta;
        for setting in law.liggghts.refused {
            for taken_over in [false, true] {
                if taken_over && law.liggghts.stock_id.is_none() {
                    continue;
                }
                let option = setting.options[1];
                let chain = format!("{} {} {option}", chain_with(meta, taken_over), setting.name);
                let wanted = format!(": setting {} {option} is not supported (", setting.name);
                for side in each_side(&chain) {
                    let side = if taken_over { side.taken_over() } else { side };
                    side.refused(1, &wanted);
                    seen += 1;
                }
            }
        }
    }
    assert!(seen >= 20, "only {seen} settings were tried");
}

/// Where LIGGGHTS reads a setting and ignores it, the law that took its name over says so and does the same.
#[test]
fn an_ignored_setting_warns_under_the_stock_name() {
    if !can("an_ignored_setting_warns_under_the_stock_name") {
        return;
    }
    let warning = "WARNING: hooke/hysteresis: LIGGGHTS reads the setting limitForce and ignores it, so it has no effect here either; use hooke/hysteresis/rs for it";
    let stock = each_side("model hooke/hysteresis tangential history limitForce on");
    let own = each_side("model hooke/hysteresis/rs tangential history/rs limitForce on");
    for (stock, own) in stock.into_iter().zip(own) {
        let taken_over = stock.clone().taken_over().runs();
        assert!(taken_over.said.contains(warning), "{}", taken_over.said);
        assert!(taken_over.dump == stock.runs_on_stock().dump, "not what stock does");
        // Under our own name it works, and so changes the answer.
        let own = own.runs();
        assert!(!own.said.contains("LIGGGHTS reads the setting"), "{}", own.said);
        assert!(own.dump != taken_over.dump, "limitForce has no effect under our own name");
    }
}

#[test]
fn a_contact_that_is_not_finite_stops_the_run() {
    if !can("a_contact_that_is_not_finite_stops_the_run") {
        return;
    }
    let [pair, wall] = each_side("model hooke/rs tangential history/rs");
    // LIGGGHTS reads 1e999 as infinite.
    let words =
        "hooke + history: the contact of particle 1 with particle 2 at step 0 is not finite (overlap ";
    let ran = pair.with("vx 0.3", "vx 1e999").refused(1, words);
    assert!(ran.log.contains(words), "not in the log: {}", ran.log);
    let words = "hooke + history: the contact of particle 2 with a wall at step 0 is not finite (overlap ";
    let ran = wall.with("vx -0.3 vy 0 vz -0.3", "vx -0.3 vy 0 vz -1e999").refused(1, words);
    assert!(ran.log.contains(words), "not in the log: {}", ran.log);
}

#[test]
fn the_environment_is_checked() {
    if !can("the_environment_is_checked") {
        return;
    }
    let deck = || Deck::new("model hooke/rs", "model hooke/rs");
    for (name, value, wanted) in [
        ("GRANLAW_LAWS", "rusty", "granlaw: GRANLAW_LAWS=rusty must be own, rust or stock"),
        ("GRANLAW_EVERY", "0", "granlaw: GRANLAW_EVERY=0 must be a whole number of at least 1"),
        ("GRANLAW_EVERY", "ten", "granlaw: GRANLAW_EVERY=ten must be a whole number of at least 1"),
        ("GRANLAW_FOLLOW", "some", "granlaw: GRANLAW_FOLLOW=some must be all"),
        ("GRANLAW_STEPS", "0", "granlaw: GRANLAW_STEPS=0 must be a whole number of at least 1"),
        ("GRANLAW_TIMESTEP", "on", "granlaw: GRANLAW_TIMESTEP=on must be warn"),
    ] {
        deck().env(name, value).refused(2, wanted);
    }
}
