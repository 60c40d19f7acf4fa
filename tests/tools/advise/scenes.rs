//! Scenes for which the right advice is known.
use super::made::{bed, friction, header, hertz, hooke, hysteresis, rolling, scene};
use approx::assert_relative_eq;
use granlaw::model::Kind;
use granlaw_tools::advise::fresh::fresh;
use granlaw_tools::advise::{advise, Advice, AdviceError, Candidate, Change, Options, Scene};
use granlaw_tools::probe::Probe;
use granlaw_tools::trace::HeaderError;

fn advice(probe: &Probe) -> Advice {
    advise(probe, Options::default()).expect("advice").0
}

fn candidate<'a>(a: &'a Advice, changes: &[Change]) -> &'a Candidate {
    a.ladder.iter().find(|r| r.changes == changes).unwrap_or_else(|| panic!("{changes:?} was not tried"))
}

fn values(r: &Candidate, name: &str) -> Vec<f64> {
    let all = r.chains[0].laws.iter().flat_map(|l| &l.properties);
    all.filter(|p| p.name == name).flat_map(|p| p.values.clone()).collect()
}

/// Speeds over four octaves, head-on or with slip, twelve impacts in each.
fn speeds(slip: f64, spin: f64) -> Vec<[f64; 3]> {
    (0..48).map(|k| ((f64::from(k) + 0.5) / 12.0 - 4.0).exp2()).map(|v| [v, slip * v, spin * v]).collect()
}

#[test]
fn impacts_without_slip_need_neither_friction_nor_rolling_resistance() {
    let h = header(1e-6, vec![hooke(0.8), friction(0.5), rolling(0.1)]);
    let a = advice(&scene(&h, &speeds(0.0, 0.0)));
    let off = candidate(&a, &[Change::Off(Kind::Tangential)]);
    assert!(off.holds, "{:?}", off.model.worst.map(|w| (w.0, w.1, &a.groups[w.2])));
    let both = candidate(&a, &[Change::Off(Kind::Rolling), Change::Off(Kind::Tangential)]);
    assert!(both.holds && both.chains[0].laws.len() == 1);
    // The same with slip: both do something there.
    let a = advice(&scene(&h, &speeds(1.0, 0.3)));
    for k in [Kind::Tangential, Kind::Rolling] {
        let r = candidate(&a, &[Change::Off(k)]);
        let (what, error, _) = r.model.worst.unwrap();
        assert!(!r.holds && error > 0.02, "{k:?} {what} {error}");
        assert!(k == Kind::Rolling || (what, error > 0.1) == ("spin", true), "{k:?} {what} {error}");
        assert!(
            a.reasons.iter().any(|t| t.contains("is not good enough") && t.contains(k.name())),
            "{:?}",
            a.reasons
        );
    }
    assert!(a.ladder[a.chosen.unwrap()].changes.iter().all(|c| *c == Change::Timed));
}

#[test]
fn hysteresis_far_below_its_limit_is_a_linear_spring() {
    // δ/δlim stays below 1/150, and with it what is lost beyond the dashpot: e² falls by 4 times that.
    let h = header(1e-6, vec![hysteresis(5.0)]);
    let a = advice(&scene(&h, &speeds(0.0, 0.0)));
    let linear = candidate(&a, &[Change::Law(Kind::Normal, "hooke")]);
    assert!(linear.holds, "{:?}", linear.model.worst);
    assert_relative_eq!(values(linear, "coefficientRestitution")[0], 0.9, max_relative = 0.02);
    // The same velocity gives the same stiffness.
    assert_relative_eq!(values(linear, "characteristicVelocity")[0], 1.0, max_relative = 0.05);
    // Near its limit the restitution falls with the speed, and no linear spring does that.
    let h = header(1e-6, vec![hysteresis(0.05)]);
    let a = advice(&scene(&h, &speeds(0.0, 0.0)));
    let linear = candidate(&a, &[Change::Law(Kind::Normal, "hooke")]);
    assert!(!linear.holds && linear.model.worst.unwrap().1 > 0.1, "{:?}", linear.model.worst);
}

#[test]
fn hertz_impacts_of_one_speed_are_those_of_a_fitted_linear_spring() {
    let h = header(1e-6, vec![hertz(0.7)]);
    let narrow: Vec<_> = (0..6).map(|k| [0.3 + 0.002 * f64::from(k), 0.0, 0.0]).collect();
    let a = advice(&scene(&h, &narrow));
    let linear = candidate(&a, &[Change::Law(Kind::Normal, "hooke")]);
    assert!(linear.holds, "{:?}", linear.model.worst);
    assert_relative_eq!(values(linear, "coefficientRestitution")[0], 0.7, max_relative = 5e-3);
    // Contact times over four octaves of speed differ by 2^(4/5), those of a linear spring do not.
    let a = advice(&scene(&h, &speeds(0.0, 0.0)));
    let linear = candidate(&a, &[Change::Law(Kind::Normal, "hooke")]);
    let (what, error, _) = linear.model.worst.unwrap();
    assert!(!linear.holds && what == "contact time" && (0.1..0.4).contains(&error), "{what} {error}");
    // Where contact times do not matter, it is good enough.
    let careless = Options { time: 20.0, ..Options::default() };
    let a = advise(&scene(&h, &speeds(0.0, 0.0)), careless).unwrap().0;
    assert!(candidate(&a, &[Change::Law(Kind::Normal, "hooke")]).holds);
}

#[test]
fn the_largest_step_is_that_of_the_known_errors() {
    // |Δe| of e = 0.5 is 1.8e-2 at 20 steps per contact and 3.8e-2 at 10, of e = 0.9 1.6e-3 at 20 and 4.0e-3 at 10.
    let contact = |e: f64, dt| {
        let a = advice(&scene(&header(dt, vec![hooke(e)]), &speeds(0.0, 0.0)));
        let whole = a.ladder[0].step.unwrap();
        let period = a.groups.len(); // classes differ in speed only
        assert!(period >= 3);
        (whole, a.ladder[0].model.omega)
    };
    let (step, omega) = contact(0.5, 1e-5);
    let steps = std::f64::consts::PI / omega / step;
    assert!((14.0..30.0).contains(&steps), "{steps}");
    // Little damping bears as large a step as stability: a quarter of the critical one.
    let (step, omega) = contact(0.95, 1e-5);
    assert!(step * omega <= 0.5 && step * omega > 0.3, "{}", step * omega);
}

#[test]
fn lasting_contacts_need_friction_that_remembers() {
    let h = header(1e-6, vec![hooke(0.5), friction(0.5), rolling(0.005)]);
    let loads = [[0.05, 0.02], [0.06, 0.015], [0.04, 0.01]];
    let a = advice(&bed(&h, &[], &loads));
    let r = candidate(&a, &[Change::Law(Kind::Tangential, "no_history")]);
    let (what, error, _) = r.model.worst.unwrap();
    assert!(!r.holds && what == "shear held at rest" && error > 0.1, "{what} {error}");
    // This little rolling resistance is less than what was asked for.
    assert!(candidate(&a, &[Change::Off(Kind::Rolling)]).holds);
}

#[test]
fn lines_say_what_to_put_where() {
    let h = header(1e-6, vec![hooke(0.9), friction(0.5), rolling(0.1)]);
    let a = advice(&scene(&h, &speeds(0.0, 0.0)));
    let r = &a.ladder[a.chosen.unwrap()];
    assert!(r.changes.contains(&Change::Off(Kind::Tangential)), "{}", r.name());
    let timed = r.changes.contains(&Change::Timed);
    let expected = if timed {
        "pair_style gran model hooke/rs centredDamping on touchFraction on"
    } else {
        "pair_style gran model hooke"
    };
    assert_eq!(a.lines[0].text, expected);
    assert!(a.lines.last().unwrap().text.starts_with("timestep "), "{:?}", a.lines);
    let text =
        granlaw_tools::advise::text(&granlaw_tools::advise::Found { advice: a, check: None, fresh: None });
    assert!(text.contains("made.in: what each term contributes") && text.contains(expected), "{text}");
}

#[test]
fn nothing_is_advised_on_nothing() {
    let none = advise(&Probe::default(), Options::default()).unwrap_err();
    assert!(matches!(none, AdviceError::NoContact));
    let h = header(1e-6, vec![hooke(0.9)]);
    let mut probe = scene(&h, &speeds(0.0, 0.0));
    probe.chains[0].pairs[0].impacts.clear();
    assert!(matches!(advise(&probe, Options::default()), Err(AdviceError::NoExample { .. })));
    let mut probe = scene(&h, &speeds(0.0, 0.0));
    probe.chains[0].header.laws[0].keyword = "luding".into();
    let error = advise(&probe, Options::default()).unwrap_err();
    assert!(
        matches!(error, AdviceError::Laws(HeaderError::Lacks { .. })) && error.to_string().contains("luding")
    );
}

#[test]
fn terms_are_ranked_by_what_they_dissipate() {
    let h = header(1e-6, vec![hysteresis(0.05), friction(0.3)]);
    let a = advice(&scene(&h, &speeds(1.0, 0.0)));
    let share =
        |name: &str| a.terms.iter().find(|t| t.term.contains(name)).unwrap_or_else(|| panic!("{name}"));
    let all: f64 = a.terms.iter().map(|t| t.dissipated).sum();
    assert_relative_eq!(all, 1.0, max_relative = 1e-12);
    assert!(a.terms.windows(2).all(|w| w[0].dissipated >= w[1].dissipated));
    assert!(share("history").dissipated > 0.2 && share("spring").dissipated > share("dashpot").dissipated);
    assert_relative_eq!(share("history").impulse + share("spring").impulse, 1.0, max_relative = 1e-12);
}

#[test]
fn advice_holds_on_other_contacts_and_a_wrong_fit_does_not() {
    let h = header(1e-6, vec![hooke(0.8)]);
    let (a, deck) = advise(&scene(&h, &speeds(0.0, 0.0)), Options::default()).unwrap();
    let others: Vec<_> = speeds(0.0, 0.0).iter().map(|[v, ..]| [1.07 * v, 0.0, 0.0]).collect();
    let other = Scene::of(&scene(&h, &others)).unwrap();
    let mut candidate = a.ladder[a.chosen.unwrap()].clone();
    let tried =
        |candidate: &Candidate| fresh(&other, &deck, candidate, "speeds=other", &Options::default()).unwrap();
    let good = tried(&candidate);
    assert!(good.holds() && good.tally(true).1 >= 3 && good.tally(false) == (0, 0));
    for p in candidate.chains.iter_mut().flat_map(|h| &mut h.laws).flat_map(|l| &mut l.properties) {
        if p.name == "coefficientRestitution" {
            p.values = vec![0.7];
        }
    }
    let bad = tried(&candidate);
    assert!(!bad.holds() && bad.tally(true).0 == 0);
}
