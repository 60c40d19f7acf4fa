//! Advice on the time step from a probe made by hand.
use granlaw::critical::{SAFE, SAFE_BOND};
use granlaw::model::Mode;
use granlaw_tools::probe::{Contacts, ParticleType, Probe};
use granlaw_tools::study::timestep::{advise, Advice, Asked};
use granlaw_tools::trace::{Header, LawSpec, Property};
use std::f64::consts::PI;

type Given<'a> = &'a [(&'a str, &'a str, f64)];

fn law(kind: &str, keyword: &str, offset: usize, given: Given<'_>) -> LawSpec {
    let property = |(name, shape, value): &(&str, &str, f64)| Property {
        name: (*name).into(),
        unit: "1".into(),
        shape: (*shape).into(),
        values: vec![*value],
    };
    let properties = given.iter().map(property).collect();
    let (kind, keyword) = (kind.into(), keyword.into());
    LawSpec { kind, keyword, taken_over: true, known: true, offset, properties, ..LawSpec::default() }
}

/// A chain of hysteresis and friction; dt = 1 µs.
fn header(who: &str) -> Header {
    let normal: Given<'_> = &[
        ("youngsModulus", "peratomtype", 5e6),
        ("poissonsRatio", "peratomtype", 0.45),
        ("characteristicVelocity", "scalar", 2.0),
        ("coefficientRestitution", "peratomtypepair", 0.9),
        ("coefficientMaxElasticStiffness", "peratomtypepair", 100.0),
        ("coefficientAdhesionStiffness", "peratomtypepair", 0.5),
        ("coefficientPlasticityDepth", "peratomtypepair", 0.05),
    ];
    Header {
        who: who.into(),
        units: "si".into(),
        ranks: 1,
        types: 1,
        nktv2p: 1.0,
        dt: 1e-6,
        slots: ["deltaMax", "shearx", "sheary", "shearz"].map(String::from).to_vec(),
        laws: vec![
            law("normal", "hooke/hysteresis", 0, normal),
            law("tangential", "history", 1, &[("coefficientFriction", "peratomtypepair", 0.5)]),
        ],
        ..Header::default()
    }
}

fn probe(headers: Vec<Header>, fastest: f64) -> Probe {
    let chain = |header| Contacts { header, share: 1, ..Contacts::default() };
    let grains = vec![ParticleType { kind: 1, count: 9, radius: [0.005; 2], density: [2500.0; 2], fastest }];
    Probe { chains: headers.into_iter().map(chain).collect(), grains, ..Probe::default() }
}

fn asked(probe: &Probe, speed: Option<f64>) -> Advice {
    advise(probe, &Asked { accuracy: 0.01, speed, bonds: 12 })
}

#[test]
fn the_stiffest_unloading_decides_not_the_loading() {
    let scene = probe(vec![header("pair")], 0.05);
    let (slow, fast) = (asked(&scene, None), asked(&scene, Some(20.0)));
    let normal = |a: &Advice| a.contacts[0].limits[0];
    // Far beyond the plastic limit the branch of unloading is k2max, a hundred times the loading.
    let l = normal(&fast);
    let kn = l.mode.stiffness / 100.0;
    let tangential = fast.contacts[0].limits[1];
    approx::assert_relative_eq!(tangential.mode.stiffness, kn, max_relative = 1e-9);
    approx::assert_relative_eq!(tangential.mode.mass, 2.0 / 7.0 * l.mode.mass, max_relative = 1e-12);
    // A slow impact does not get there.
    let less = normal(&slow).mode.stiffness;
    assert!(kn < less && less < 20.0 * kn && slow.contacts[0].speed == 0.1, "{slow:?}");
    let mode = Mode { stiffness: 100.0 * kn, ..l.mode };
    approx::assert_relative_eq!(l.critical, mode.step(), max_relative = 1e-12);
    approx::assert_relative_eq!(l.safe, SAFE * PI / mode.frequency(), max_relative = 1e-12);
    // LIGGGHTS's check knows nothing of it.
    let stock = fast.stock.expect("elastic constants");
    assert!(!stock.warns(1.2 * l.critical, (0.2, 0.2)) && stock.warns(0.21 * stock.rayleigh, (0.2, 0.2)));
}

#[test]
fn walls_are_heavier_and_the_shortest_of_all_is_recommended() {
    let a = asked(&probe(vec![header("pair"), header("wall floor")], 1.0), None);
    let mass = |k: usize| a.contacts[k].limits[0].mode.mass;
    assert_eq!((a.contacts.len(), a.contacts[1].who.as_str()), (2, "wall floor"));
    approx::assert_relative_eq!(mass(1), 2.0 * mass(0), max_relative = 1e-12);
    assert_eq!((a.contacts[0].speed, a.contacts[1].speed), (2.0, 1.0));
    let each = a.contacts.iter().map(|c| c.accurate.unwrap().min(c.safe()));
    assert_eq!(a.recommended(), each.reduce(f64::min));
    // A deck that changes its step has each kind of contact once.
    let later = Header { dt: 2e-6, ..header("pair") };
    let twice = asked(&probe(vec![header("pair"), later], 1.0), None);
    assert_eq!((twice.contacts.len(), twice.dt), (1, 2e-6));
}

#[test]
fn centred_damping_bears_what_no_damping_does() {
    let with = |option: &str| {
        let mut h = header("pair");
        h.laws.iter_mut().for_each(|l| l.taken_over = false);
        h.laws[0].properties[3].values = vec![0.3];
        h.laws[0].settings.insert("centredDamping".into(), option.into());
        asked(&probe(vec![h], 1.0), None).contacts[0].limits[0]
    };
    let (off, on) = (with("off"), with("on"));
    approx::assert_relative_eq!(on.critical, off.mode.step_centred(), max_relative = 1e-12);
    assert!(on.critical > 1.01 * off.critical);
}

#[test]
fn what_cannot_be_looked_at_is_told() {
    let mut strange = header("pair");
    strange.laws.push(LawSpec { known: false, ..law("rolling", "epsd2", 4, &[]) });
    let a = asked(&probe(vec![strange.clone()], 0.0), None);
    let notes = a.notes.join("; ");
    assert!(notes.contains("rolling epsd2 is left out") && notes.contains("impacts at 2 m/s"), "{notes}");
    assert_eq!(a.contacts[0].speed, 2.0);
    strange.laws.iter_mut().for_each(|l| l.known = false);
    let nothing = asked(&probe(vec![strange], 1.0), None);
    assert!(
        nothing.recommended().is_none() && nothing.notes.iter().any(|n| n.contains("nothing can be said"))
    );
    let empty = Probe { grains: Vec::new(), ..probe(vec![header("pair")], 1.0) };
    assert!(asked(&empty, None).notes.iter().any(|n| n.contains("no particle was there")));
}

#[test]
fn a_tighter_accuracy_takes_a_shorter_step() {
    let scene = probe(vec![header("pair")], 1.0);
    let at =
        |accuracy| advise(&scene, &Asked { accuracy, speed: None, bonds: 12 }).contacts[0].accurate.unwrap();
    assert!(at(0.01) < asked(&scene, None).contacts[0].critical() && at(0.001) < 0.5 * at(0.01));
}

/// The chain above with bonds of 0.8 of the radius, all modes but √δ's straight; damped by a tenth.
fn bonded(who: &str) -> Header {
    let pair = "peratomtypepair";
    let numbers = [
        ("radiusMultiplierBondnonlinear", 0.8),
        ("stiffnessPerUnitAreaK_fn1", 4e7),
        ("stiffnessPerUnitAreaKu_fn1", 8e7),
        ("stiffnessPerUnitAreaKc_fn1", 2e7),
        ("stiffnessPerUnitAreaK_fn2", 1e10),
        ("stiffnessPerUnitAreaKu_fn2", 2e10),
        ("stiffnessPerUnitAreaKc_fn2", 5e9),
        ("stiffnessPerUnitAreaK_ft", 4e9),
        ("stiffnessPerUnitAreaK_tn", 4e9),
        ("stiffnessPerUnitAreaKu_tn", 4e9),
        ("stiffnessPerUnitAreaKc_tn", 2e9),
        ("stiffnessPerUnitAreaK_tt", 1e10),
        ("stiffnessPerUnitAreaKu_tt", 1e10),
        ("stiffnessPerUnitAreaKc_tt", 5e9),
        ("dampingNormalForceBondnonlinear", 0.1),
        ("dampingTangentialForceBondnonlinear", 0.1),
        ("dampingNormalTorqueBondnonlinear", 0.1),
        ("dampingTangentialTorqueBondnonlinear", 0.1),
        ("maxDistanceBondnonlinear", 0.015),
        ("createDistanceBondnonlinear", 0.01),
    ];
    let mut given: Vec<(&str, &str, f64)> = numbers.iter().map(|(name, x)| (*name, pair, *x)).collect();
    given.push(("tsCreateBondnonlinear", "scalar", 1.0));
    let mut h = header(who);
    let mut bond = law("cohesion", "bond/nonlinear", h.slots.len(), &given);
    bond.settings.insert("bondConvention".into(), "documented".into());
    let slots =
        ["r0", "deltaMax", "deltaMin", "ftx", "fty", "ftz", "fromx", "fromy", "fromz", "thetatx", "thetaty"];
    h.slots.extend(slots.map(String::from));
    let more = ["thetatz", "thetan", "thetanMax", "thetanMin", "centrex", "centrey", "centrez", "rho"];
    h.slots.extend(more.map(String::from));
    h.laws.push(bond);
    h
}

#[test]
fn bonds_have_a_step_for_each_mode_and_less_with_many_on_each_particle() {
    let at = |bonds| {
        let a = advise(&probe(vec![bonded("pair")], 1.0), &Asked { accuracy: 0.01, speed: None, bonds });
        assert_eq!((a.contacts.len(), a.notes.len()), (2, 0), "{:?}", a.notes);
        (a.recommended().unwrap(), a.contacts[1].clone())
    };
    let (one, bond) = at(1);
    assert!(bond.laws == "bond/nonlinear" && bond.accurate.is_none());
    let names: Vec<&str> = bond.limits.iter().map(|l| l.name).collect();
    assert_eq!(names, ["compression", "tension", "twist", "shear", "bending"]);
    let (r, m) = (0.005f64, 2500.0 * 4.0 / 3.0 * PI * 0.005f64.powi(3));
    let (area, turn) = (PI * (0.8 * r).powi(2), 0.5 * 0.4 * m * r * r);
    let (polar, step) = (0.5 * area * (0.8 * r).powi(2), |k: f64, m: f64| 2.0 * (m / (1.1 * k)).sqrt());
    let expected = [
        step(2e10 * area, 0.5 * m),
        step(4e9 * polar, turn),
        step(4e9 * area, 0.5 * m / 3.5),
        step(1e10 * 0.5 * polar, turn),
    ];
    for (l, expected) in bond.limits[1..].iter().zip(expected) {
        approx::assert_relative_eq!(l.critical, expected, max_relative = 1e-9);
        approx::assert_relative_eq!(l.safe, SAFE_BOND * 0.5 * PI * expected, max_relative = 1e-9);
    }
    assert_eq!(one, bond.safe());
    let (twelve, bond) = at(12);
    approx::assert_relative_eq!(12.0f64.sqrt() * twelve, one, max_relative = 1e-9);
    assert!(bond.critical() > bond.together.unwrap().critical, "two bodies alone bear more");
    // Other types do not bond.
    let mut none = bonded("pair");
    none.laws[2].properties[0].values = vec![0.0];
    assert_eq!(asked(&probe(vec![none], 1.0), None).contacts.len(), 1);
}
