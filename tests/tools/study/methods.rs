//! Better integrators against closed forms, and orders against what is claimed of them.
use granlaw_tools::study::adaptive::{self, Aim};
use granlaw_tools::study::speed::{cases, claims, Case, Claim, Curve, Measure, Method, Truth};
use granlaw_tools::study::{located, speed};
use std::collections::BTreeMap;
use std::sync::Mutex;

fn case(name: &str) -> Case {
    cases().into_iter().find(|c| c.name == name).expect("a case")
}

/// Restitution by closed forms: kn/k2 of the loop, e of the dashpot.
const EXACT: [&str; 10] = [
    "undamped",
    "damped-0.9",
    "damped-0.5",
    "damped-0.5-wall",
    "hertz-0.5",
    "plastic-below",
    "adhesive",
    "bond",
    "bond-damped",
    "bond-pressed",
];

#[test]
fn adaptive_extrapolation_meets_closed_forms() {
    for name in EXACT {
        let truth = Truth::of(&case(name));
        assert_eq!(truth.source, "closed form", "{name}");
        // Hertz's dashpot begins with the fourth root of the time, where extrapolation gains least.
        assert!(truth.error < 1e-8, "{name}: {:e}", truth.error);
    }
}

#[test]
fn a_closed_form_of_another_case_is_not_met() {
    let (one, other) = (Truth::of(&case("adhesive")), Truth::of(&case("plastic-below")));
    assert!(((one.outcome.restitution - other.value) / other.value).abs() > 1e-2);
}

#[test]
fn a_tighter_tolerance_brings_a_smaller_error() {
    let case = case("damped-0.5");
    let error = |tolerance| {
        let aim = Aim { tolerance, duration: 1.2e-3, longest: 0.3, with_force: false };
        let (o, calls) = adaptive::impact(&mut case.matter.chain().unwrap(), &case.collision, &aim);
        assert!(o.parted && calls > 0);
        (o.restitution - 0.5).abs()
    };
    assert!(error(1e-10) < 0.05 * error(1e-6) && error(1e-10) < 1e-9);
}

#[test]
fn steps_that_end_at_events_meet_the_turning_point_of_a_plastic_contact() {
    let case = case("plastic-below");
    let truth = Truth::of(&case);
    let (o, _) = located::impact(
        &mut case.matter.chain().unwrap(),
        &case.collision,
        truth.outcome.duration / 400.0,
        false,
    );
    // Second order: (π/400)²/12 of a quantity of order one.
    assert!((o.restitution - truth.value).abs() < 1e-4 * truth.value, "{}", o.restitution);
    assert!((o.peak - truth.outcome.peak).abs() < 1e-4 * o.peak);
}

/// The curve of a method, without repeated timings.
fn curve(claim: &Claim) -> (Curve, f64) {
    // Converged solutions take their time, and several claims share one.
    static TRUTHS: Mutex<BTreeMap<&str, Truth>> = Mutex::new(BTreeMap::new());
    let case = case(claim.case);
    let truth = TRUTHS.lock().unwrap().entry(claim.case).or_insert_with(|| Truth::of(&case)).clone();
    (
        speed::curve(claim.method, &case, &truth, 48, 1).expect("the method does the case"),
        truth.error.max(1e-13),
    )
}

fn here(claim: &Claim) -> bool {
    !claim.method.is_live()
}

#[test]
fn orders_are_as_claimed() {
    let ours: Vec<Claim> = claims().into_iter().filter(here).collect();
    assert!(ours.len() >= 14);
    for claim in &ours {
        let (curve, floor) = curve(claim);
        claim.check(curve.order(claim.from, floor)).unwrap();
    }
}

/// A chain in its slowest mode comes back as two do, whatever its bonds do on the way.
#[test]
fn chains_of_bonds_and_vibrations_meet_closed_forms() {
    for name in ["bond-chain", "bond-chain-damped", "bond-vibration"] {
        let truth = Truth::of(&case(name));
        // Second order: 20,000 steps a swing, ten swings of the vibration.
        assert!(truth.source == "closed form" && truth.error < 1e-6, "{name}: {:e}", truth.error);
    }
    let (two, chain) = (Truth::of(&case("bond")), Truth::of(&case("bond-chain")));
    approx::assert_relative_eq!(two.value, 0.4f64.sqrt(), max_relative = 1e-12);
    assert_eq!(two.value, chain.value);
    // Planted: another bond's answer is not met.
    let other = Truth::of(&case("bond-chain-damped"));
    assert!((other.outcome.restitution - chain.value).abs() > 0.1);
}

/// Planted: a first-order method under a label of second order, and the other way round.
#[test]
fn a_wrong_label_is_seen() {
    for (case, method, order) in [
        ("damped-0.5", Method::Verlet, 2.0),
        ("hertz-0.5", Method::Verlet, 2.0),
        ("stick-slip-td-off", Method::Verlet, 2.0),
        ("damped-0.5", Method::VerletTimed, 1.0),
        ("undamped", Method::VerletTimed, 2.0),
        ("bond-damped", Method::Verlet, 1.0),
        ("bond-pressed", Method::Verlet, 2.0),
    ] {
        let claim = Claim { case, method, order, from: 100.0 };
        let (curve, floor) = curve(&Claim { from: 12.0, ..claim });
        let error = claim.check(curve.order(12.0, floor)).expect_err("not seen");
        assert!(error.contains("is claimed"), "{error}");
    }
    let claim = Claim { case: "damped-0.5", method: Method::Verlet, order: 1.0, from: 100.0 };
    assert!(claim.check(None).unwrap_err().contains("too few points"));
}

#[test]
fn the_settings_need_a_tenth_of_the_steps() {
    for name in ["damped-0.9", "damped-0.5"] {
        let case = case(name);
        let truth = Truth::of(&case);
        let steps = |m| speed::curve(m, &case, &truth, 48, 1).unwrap().reach(1e-4).unwrap().n;
        assert!(10.0 * steps(Method::VerletTimed) <= steps(Method::Verlet), "{name}");
    }
}

#[test]
fn single_precision_is_right_to_its_digits() {
    let case = case("damped-0.9");
    let truth = Truth::of(&case);
    let at = |m| speed::curve(m, &case, &truth, 16, 1).unwrap().points[3].error.at;
    let (double, single) = (at(Method::Verlet), at(Method::Single));
    assert!(double != single && (double - single).abs() < 1e-4, "{double:e} {single:e}");
    assert_eq!(case.measure, Measure::Restitution);
}
