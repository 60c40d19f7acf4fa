//! Contacts simulated again, against closed forms and against what the run made of them.
use super::made::{
    bed, friction, header, hertz, hooke, hysteresis, impact, pressed, rolling, scene, MASS, RADIUS,
};
use approx::assert_relative_eq;
use granlaw_tools::advise::loaded::hold;
use granlaw_tools::advise::simulated;
use granlaw_tools::probe::{Partners, Pressed};
use std::f64::consts::PI;

const DT: f64 = 1e-7;

/// kn of [`hooke`] for R* and m*: 16/15 √R* E* (15 m* vc²/(16 √R* E*))^(1/5).
fn stiffness(reff: f64, meff: f64) -> f64 {
    let root = reff.sqrt() * 5e6 / (2.0 * (1.0 - 0.45 * 0.45));
    16.0 / 15.0 * root * (15.0 * meff / (16.0 * root)).powf(0.2)
}

#[test]
fn a_linear_impact_has_its_restitution_and_its_time() {
    for (wall, reff, meff) in [(false, 0.5 * RADIUS, 0.5 * MASS), (true, RADIUS, MASS)] {
        let h = header(DT, vec![hooke(0.8)]);
        let (mut chain, mut laws) = (h.chain().unwrap(), h.chain().unwrap());
        let seen =
            simulated::impact(&mut chain, Some(&mut laws), &impact(wall, [-0.5, 0.0, 0.0]), (DT, 0.3, 1.0));
        let omega = (stiffness(reff, meff) / meff).sqrt();
        assert_relative_eq!(seen.omega, omega, max_relative = 1e-12);
        // First order in a step of some thousandth of the contact.
        assert_relative_eq!(seen.restitution, 0.8, max_relative = 1e-3);
        let log = 0.8f64.ln();
        let damped = omega * (1.0 - log * log / (log * log + PI * PI)).sqrt();
        assert_relative_eq!(seen.time, PI / damped, max_relative = 1e-3);
    }
}

#[test]
fn a_hertz_impact_takes_its_time() {
    let h = header(DT, vec![hertz(1.0)]);
    let seen =
        simulated::impact(&mut h.chain().unwrap(), None, &impact(false, [-0.5, 0.0, 0.0]), (DT, 0.5, 1.0));
    let young = 5e6 / (2.0 * (1.0 - 0.45 * 0.45));
    let time = 2.868265 * (0.25 * MASS * MASS / (0.5 * RADIUS * young * young * 0.5)).powf(0.2);
    assert_relative_eq!(seen.time, time, max_relative = 1e-5);
    assert_relative_eq!(seen.restitution, 1.0, max_relative = 1e-5);
    assert_eq!(seen.omega, 0.0, "nobody was asked");
}

#[test]
fn what_does_not_part_sticks() {
    let h = header(DT, vec![hooke(0.8)]);
    let short =
        simulated::impact(&mut h.chain().unwrap(), None, &impact(false, [-0.5, 0.0, 0.0]), (DT, 0.5, 2e-4));
    assert_eq!((short.restitution, short.time), (0.0, f64::INFINITY));
}

#[test]
fn an_impact_of_the_run_comes_out_as_in_the_run() {
    let h = header(1e-6, vec![hooke(0.7), friction(0.3), rolling(0.02)]);
    let probe = scene(&h, &[[0.4, 0.3, 0.1]]);
    let example = probe.chains[0].pairs[0].impacts[0].examples[0].what;
    let seen = simulated::impact(&mut h.chain().unwrap(), None, &example, (1e-6, 0.37, 1.0));
    // The first step goes straight here, and there along a normal that it turns a little.
    assert_relative_eq!(seen.restitution, example.end.restitution, max_relative = 1e-5);
    assert!((seen.time / 1e-6 - example.end.steps as f64).abs() < 1.0);
}

#[test]
fn it_does_not_matter_who_is_held() {
    let h = header(1e-6, vec![hooke(0.7), friction(0.3), rolling(0.02)]);
    let mut one = impact(false, [-0.4, 0.3, 0.1]);
    (one.omega_i, one.omega_j) = ([3.0, 20.0, -40.0], [0.0; 3]);
    (one.partners.mass, one.partners.meff) = ([MASS, 0.0], MASS);
    // The same from the other side: half a turn about z.
    let mut other = one;
    other.partners = Partners { mass: [0.0, MASS], ..one.partners };
    other.v = [-0.4, 0.3, -0.1];
    (other.omega_i, other.omega_j) = ([0.0; 3], [-3.0, -20.0, -40.0]);
    let live = |i| simulated::impact(&mut h.chain().unwrap(), None, i, (1e-6, 0.4, 1.0));
    let (a, b) = (live(&one), live(&other));
    assert!(a.restitution > 0.5 && a.spin[0].norm() > 10.0);
    assert_eq!((a.restitution, a.time, a.spin), (b.restitution, b.time, b.spin));
}

#[test]
fn a_load_is_borne_by_spring_friction_and_rolling_resistance() {
    let k = stiffness(0.5 * RADIUS, 0.5 * MASS);
    let load = pressed(0.1, 0.02, k);
    let held = |laws| hold(&mut header(1e-6, laws).chain().unwrap(), &load, 1e-6);
    let all = held(vec![hooke(0.8), friction(0.3), rolling(0.05)]);
    // Loads are raised by hundredths.
    assert_relative_eq!(all.overlap, 0.1 / k, max_relative = 0.011);
    assert_relative_eq!(all.shear, 0.2, max_relative = 0.02);
    assert_relative_eq!(all.torque[0], 0.05, max_relative = 0.011);
    assert_eq!(all.torque[1], 0.0, "torsionTorque is off");
    assert_relative_eq!(all.omega, (k / (0.5 * MASS)).sqrt(), max_relative = 1e-12);
    // More than friction bears.
    let slippery = held(vec![hooke(0.8), friction(0.1)]);
    assert_relative_eq!(slippery.shear, 0.1, max_relative = 0.02);
    assert_eq!(slippery.torque, [0.0; 2]);
    let creeping = super::made::law("tangential", "no_history", &[("coefficientFriction", 0.3)]);
    assert_eq!(held(vec![hooke(0.8), creeping]).shear, 0.0);
}

#[test]
fn attraction_is_borne_as_far_as_it_was_and_needs_adhesion() {
    let k = stiffness(0.5 * RADIUS, 0.5 * MASS);
    let mut load = pressed(0.1, 0.0, k);
    // Pressed ten times as hard before, and never pulled.
    load.push = 1.0;
    let held = |load: &Pressed, laws| hold(&mut header(1e-6, laws).chain().unwrap(), load, 1e-6);
    assert_eq!(held(&load, vec![hysteresis(0.05)]).tension, 0.0);
    load.pull = f64::INFINITY;
    let most = held(&load, vec![hysteresis(0.05)]).tension;
    assert!(most > 1e-3, "{most}");
    load.pull = 0.5 * most * load.normal;
    assert_relative_eq!(held(&load, vec![hysteresis(0.05)]).tension, 0.5 * most, max_relative = 1e-12);
    assert_eq!(held(&load, vec![hooke(0.5)]).tension, 0.0);
    // What was pressed harder stays flatter: the overlap under the same load is larger.
    let soft = held(&pressed(0.1, 0.0, k), vec![hysteresis(0.05)]).overlap;
    assert!(held(&load, vec![hysteresis(0.05)]).overlap > 1.01 * soft);
    assert_relative_eq!(held(&load, vec![hooke(0.5)]).overlap, 0.1 / k, max_relative = 2e-3);
    // A spring that has no force once the surfaces part, pressed a thousand times harder before: δ goes with F^(2/3).
    let [mut little, mut much] = [pressed(1e-3, 0.0, k), pressed(1.0, 0.0, k)];
    (little.push, much.push) = (1.0, 1.0);
    let [little, much] = [little, much].map(|l| held(&l, vec![hertz(0.5)]).overlap);
    assert_relative_eq!(much / little, 100.0, max_relative = 0.01);
}

#[test]
fn a_sphere_that_lies_is_pressed_and_one_that_bounces_is_not() {
    let h = header(1e-6, vec![hooke(0.3), friction(0.3)]);
    let probe = bed(&h, &[[0.3, 0.0, 0.0]], &[[0.05, 0.0]]);
    let pair = &probe.chains[0].pairs[0];
    assert_eq!((pair.impacts.len(), pair.pressed.len()), (1, 1));
    assert_relative_eq!(pair.pressed[0].examples[0].what.normal, 0.05, max_relative = 0.05);
}
