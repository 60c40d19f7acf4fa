//! Every rule must be able to turn red: faults planted behind sound laws, each with the rule that sees it.
use super::recipe::{chain_of, for_all, Check, Fault, Switches};
use super::{paths, rules};

/// The rule, asked of a chain with the fault, must fail with these words; without the fault it holds.
fn seen(chain: &[&str], fault: Fault, check: Check, words: &str) {
    let laws = chain_of(chain);
    for_all(&laws, Switches::Default, 300, None, check).expect("holds without the fault");
    let error = for_all(&laws, Switches::Default, 300, Some(fault), check).expect_err("not seen");
    assert!(error.contains(words), "{words:?} is not in: {error}");
}

const SHEAR: [&str; 2] = ["hooke", "history"];

#[test]
fn an_odd_slot_that_comes_out_even() {
    seen(&SHEAR, Fault::Touch(|_, _, h, _| h[1] = h[1].abs()), rules::swap, "history");
}

#[test]
fn a_torque_that_favours_one_side() {
    let fault = Fault::Touch(|_, _, _, s| s.torque_j *= 1.001);
    seen(&SHEAR, fault, rules::swap, "torque");
    seen(&SHEAR, fault, rules::angular_momentum, "total torque");
    seen(&["hooke", "cdt"], fault, rules::angular_momentum, "total torque");
}

#[test]
fn a_preferred_direction() {
    seen(&["hertz"], Fault::Touch(|_, _, _, s| s.force.x *= 1.0 + 1e-6), rules::rotation, "force");
}

#[test]
fn a_force_that_knows_the_absolute_velocity() {
    let fault = Fault::Touch(|x, _, _, s| s.force += x.close.i.v * (1e-6 * s.kn * x.close.i.radius));
    seen(&["hertz"], fault, rules::galilean, "force");
}

#[test]
fn a_constant_with_a_forgotten_unit() {
    seen(&["hooke"], Fault::Touch(|x, _, _, s| s.force += x.surface.en * 1e-9), rules::units, "force");
    seen(&["hooke"], Fault::Touch(|_, _, _, s| s.gamman += 1e-9), rules::units, "γn");
    seen(&SHEAR, Fault::Touch(|_, _, h, _| h[0] += 1e-9), rules::units, "shearx");
}

#[test]
fn history_written_in_a_query() {
    seen(&SHEAR, Fault::Touch(|x, _, h, _| h[2] += 1e-9 * x.surface.deltan), rules::query, "a query made");
}

#[test]
fn history_that_outlives_separation() {
    seen(&SHEAR, Fault::Apart(|h| h[2] = 1e-9), rules::clears, "slot 2 keeps");
}

#[test]
fn a_slot_that_stays_empty() {
    let laws = chain_of(&SHEAR);
    let error = rules::written(&laws, Some(Fault::Touch(|_, _, h, _| h[2] = 0.0))).unwrap_err();
    assert!(error.contains("slot 2 is never written"), "{error}");
}

#[test]
fn a_jump() {
    let slow = Fault::Touch(|x, _, _, s| s.force *= if x.surface.vn > 0.2 { 1.001 } else { 1.0 });
    seen(&["hooke/hysteresis"], slow, paths::continuous, "jumps");
    let old = Fault::Touch(|x, h, _, s| s.force *= if x.surface.deltan > h[0] { 1.001 } else { 1.0 });
    seen(&["hooke/hysteresis"], old, paths::continuous, "jumps");
}

#[test]
fn a_dashpot_that_drives() {
    let fault = Fault::Touch(|x, _, _, s| s.force += x.surface.en * (2.0 * s.gamman * x.surface.vn));
    seen(&["hooke"], fault, paths::cycle, "gives");
}

#[test]
fn friction_that_gives_back_more_than_it_stored() {
    let fault = Fault::Touch(|x, _, _, s| {
        s.force += x.surface.vtr * (0.5 * s.gammat + 1e-5 * s.kn * x.close.call.dt)
    });
    seen(&["hooke"], fault, paths::cycle, "gives");
}

#[test]
fn rebound_damped_more_than_approach() {
    let fault = Fault::Touch(|x, _, _, s| s.gamman *= if x.surface.vn > 0.0 { 1.001 } else { 1.0 });
    seen(&["hooke"], fault, rules::odd_damping, "γn");
    let fault = Fault::Touch(|x, _, _, s| s.fn_ += 1e-3 * s.gamman * x.surface.vn.abs());
    seen(&["hooke"], fault, rules::odd_damping, "damping force");
}

#[test]
fn a_panic_on_a_number_that_is_none() {
    let fault = Fault::Touch(|x, _, _, _| assert!(!x.surface.vn.is_nan(), "planted"));
    seen(&["hooke"], fault, rules::survives, "panics on NaN");
}

#[test]
fn a_number_that_is_none_swept_under_the_rug() {
    let fault = Fault::Touch(|_, _, _, s| s.force.apply(|f| *f = if f.is_nan() { 0.0 } else { *f }));
    seen(&["hooke"], fault, rules::survives, "looks sound");
}

#[test]
fn a_wall_of_another_stiffness() {
    let fault = Fault::Touch(|x, _, _, s| s.force *= if x.close.call.is_wall { 1.0 + 1e-6 } else { 1.0 });
    seen(&["hertz"], fault, rules::wall_limit, "force");
}

#[test]
fn a_law_that_misjudges_itself() {
    for law in ["hooke", "hertz", "hooke/hysteresis"] {
        seen(&[law], Fault::Observe(|t| t.stiffness *= 1.001), paths::observed, "stiffness");
        seen(&[law], Fault::Observe(|t| t.damping *= 1.001), paths::observed, "damping");
        seen(&[law], Fault::Observe(|t| t.stored *= 1.001), paths::observed, "stored energy");
        let stiff = Fault::Touch(|x, _, _, s| s.fn_ += 1e-3 * s.kn * x.surface.deltan);
        seen(&[law], stiff, paths::observed, "stiffness");
    }
}
