//! The pieces of the law by themselves: branches and their switches, the disc of bending, reach, what is refused.
use super::bend::Disc;
use super::coeffs::{Breaks, Coeffs, Line};
use super::{normal, twist, BondNonlinear};
use crate::model::*;
use nalgebra::Vector3;

static LAW: Entry = Entry::gap_law::<BondNonlinear>();

/// Sound values by name; settings at their defaults, documented unless said otherwise.
fn setup(values: &[(&str, f64)], settings: &[(&str, &str)]) -> Setup {
    let mut chosen = Settings::new(&LAW, false);
    chosen.set("bondConvention", "documented").unwrap();
    settings.iter().for_each(|(name, option)| chosen.set(name, option).unwrap());
    let value = |p: &Prop| values.iter().find(|(name, _)| *name == p.name).map_or(p.usual.0, |(_, v)| *v);
    let of = LAW.meta.props.iter().map(|p| vec![value(p)]).collect();
    Setup { law: &LAW, settings: chosen, values: Values { types: 1, of }, nktv2p: 1.0 }
}

fn coeffs(values: &[(&str, f64)], settings: &[(&str, &str)]) -> Result<Coeffs, LawError> {
    let setup = setup(values, settings);
    setup.check()?;
    BondNonlinear::coeffs(&setup.pair(0, 0))
}

fn lines() -> Coeffs {
    Coeffs {
        compression: Line::of(4e7, 8e7, 2e7),
        tension: Line::of(1e10, 2e10, 5e9),
        ..coeffs(&[], &[]).unwrap()
    }
}

/// (6) branch by branch, its range as in the sheet.
#[test]
fn the_six_branches_are_those_of_the_table() {
    let c = lines();
    let (max, min) = (4e-6, -4e-6);
    let (left1, left2) = ((4e7f64 / 1e8).powi(2) * max, (1e10 / 2.5e10) * min);
    let expected = |delta: f64| match delta {
        d if d <= min => 1e10 * d,
        d if d < left2 => 2e10 * d - 1e10 * min,
        d if d < 0.0 => -5e9 * d,
        d if d < left1 => -2e7 * d.sqrt(),
        d if d < max => 8e7 * d.sqrt() - 4e7 * max.sqrt(),
        d => 4e7 * d.sqrt(),
    };
    let mut seen = std::collections::BTreeSet::new();
    for k in -500..=500 {
        let delta = k as f64 * 1e-8;
        let (max, min) = (f64::max(max, delta), f64::min(min, delta));
        let stress = normal::stress(&c, delta, max, min);
        approx::assert_relative_eq!(stress, expected(delta), max_relative = 1e-14, epsilon = 1e-9);
        seen.insert(normal::branch_name(&c, delta, max, min));
    }
    assert_eq!(seen.len(), 6, "{seen:?}");
}

/// The stress is the same from both sides of every switch, and the tangent is its slope between them.
#[test]
fn branches_meet_and_tangents_are_slopes() {
    let c = lines();
    let (max, min) = (4e-6f64, -4e-6f64);
    let (left1, left2) = ((4e7f64 / 1e8).powi(2) * max, (1e10 / 2.5e10) * min);
    let at = |d: f64| normal::stress(&c, d, max.max(d), min.min(d));
    for switch in [min, left2, 0.0, left1, max] {
        let step = 1e-13f64;
        // The steepest line is √δ from 0.
        let tolerance = if switch == 0.0 { 2e7 * step.sqrt() } else { 1e8 / 1e-6f64.sqrt() * 2.0 * step };
        assert!((at(switch + step) - at(switch - step)).abs() <= 1.01 * tolerance, "jump at {switch:e}");
    }
    for d in [-5e-6, -3e-6, -1e-6, 3e-7, 2e-6, 5e-6] {
        let slope = (at(d + 1e-12) - at(d - 1e-12)) / 2e-12;
        let told = normal::tangent(&c, d, max.max(d), min.min(d));
        // Differences of 1e-12 m in 4e-6 m, squared, and rounding of 1e-16/1e-6.
        assert!((told - slope).abs() < 1e-6 * slope.abs(), "{told:e} against {slope:e} at {d:e}");
    }
}

#[test]
fn modes_switched_off_carry_nothing() {
    let on = |setting: &str, delta: f64| {
        let c = coeffs(&[], &[(setting, "off")]).unwrap();
        normal::stress(&c, delta, delta.max(0.0), delta.min(0.0)) != 0.0
    };
    assert_eq!([on("tensionStress", -1e-6), on("tensionStress", 1e-6)], [false, true]);
    assert_eq!([on("compressionStress", -1e-6), on("compressionStress", 1e-6)], [true, false]);
}

/// A 1D path of angles that loads, unloads, reverses and loads again.
fn path() -> Vec<f64> {
    let corners = [0.0, 3e-3, 1e-3, 2.5e-3, -2e-3, 1e-3, -4e-3, 5e-3, -1e-3];
    let leg = |w: &[f64]| (1..=50).map(|k| w[0] + (w[1] - w[0]) * k as f64 / 50.0).collect::<Vec<_>>();
    corners.windows(2).flat_map(leg).collect()
}

fn turn() -> Line {
    Line::of(4e9, 8e9, 2e9)
}

/// Bending in one plane follows the two-sided law of twist.
#[test]
fn bending_in_a_plane_is_the_law_of_twist() {
    let way = Vector3::new(0.6, 0.0, -0.8);
    let (mut disc, mut max, mut min) = (Disc { centre: Vector3::zeros(), rho: 0.0 }, 0.0f64, 0.0f64);
    for angle in path() {
        (max, min) = (max.max(angle), min.min(angle));
        disc.visit(&(way * angle));
        let (g, f) = (disc.stress(&turn(), &(way * angle)), twist::stress(&turn(), angle, max, min));
        assert!((g - way * f).norm() < 2e-15 * 8e9 * 5e-3, "{g} against {f:e} at {angle:e}");
    }
}

#[test]
fn twist_is_the_same_in_both_senses() {
    let (mut max, mut min) = (0.0f64, 0.0f64);
    for angle in path() {
        (max, min) = (max.max(angle), min.min(angle));
        assert_eq!(twist::stress(&turn(), angle, max, min), -twist::stress(&turn(), -angle, -min, -max));
    }
}

/// Bending round and round: the torque never jumps, its tangents stay within [−kc, ku], and from rest to rest work is
/// taken.
#[test]
fn bending_in_all_directions_is_continuous_and_takes_work() {
    let mut disc = Disc { centre: Vector3::zeros(), rho: 0.0 };
    let (mut last, mut stress, mut work, mut moved) = (Vector3::zeros(), Vector3::zeros(), 0.0, 0.0);
    let n = 40_000;
    for k in 1..=n {
        let t = k as f64 / n as f64;
        let size = 4e-3 * (std::f64::consts::PI * t).sin();
        let angle = 17.0 * t + 3.0 * (11.0 * t).sin();
        let theta = Vector3::new(size * angle.cos(), size * angle.sin(), 0.0);
        disc.visit(&theta);
        let (now, step) = (disc.stress(&turn(), &theta), theta - last);
        let change: Vector3<f64> = now - stress;
        // Of first loading, kinks aside, at most ku.
        assert!(change.norm() <= 1.0001 * turn().ku * step.norm(), "jump at {t}");
        let along = change.dot(&step) / step.norm_squared();
        assert!(along >= -1.0001 * turn().kc, "tangent {along:e} at {t}");
        let w = 0.5 * (now + stress).dot(&step);
        (work, moved) = (work + w, moved + w.abs());
        (last, stress) = (theta, now);
    }
    assert!(work > 0.05 * moved, "{work:e} of {moved:e}");
}

#[test]
fn the_reach_is_that_of_the_sheet() {
    let values = [
        ("createDistanceBondnonlinear", 1.1e-3),
        ("maxDistanceBondnonlinear", 1.5e-3),
        ("stiffnessPerUnitAreaK_fn2", 1e10),
        ("maxSigmaBondnonlinear", 1e6),
        ("maxTauBondnonlinear", 1e6),
        ("ratioTensionCompressionBondnonlinear", 3.0),
    ];
    let reach = |settings: &[(&str, &str)]| {
        let c = coeffs(&values, settings).unwrap();
        [c.reach(false), c.reach(true)]
    };
    assert_eq!(reach(&[]), [1.5e-3, 0.75e-3]);
    let stress = reach(&[("stressBreak", "on")]);
    approx::assert_relative_eq!(stress[0], 1.1e-3 + 1e-4);
    approx::assert_relative_eq!(stress[1], 0.55e-3 + 1e-4);
    let ratio = reach(&[("stressBreak", "on"), ("ratioTensionCompressionBond", "on")]);
    approx::assert_relative_eq!(ratio[0], 1.1e-3 + 3e-4);
    let none = coeffs(&[&values[..], &[("radiusMultiplierBondnonlinear", 0.0)]].concat(), &[]).unwrap();
    assert_eq!(none.reach(false), 0.0);
}

#[test]
fn what_makes_no_sense_is_refused_in_words() {
    let why =
        |values: &[(&str, f64)], settings: &[(&str, &str)]| coeffs(values, settings).unwrap_err().to_string();
    for (k, ku) in ["fn1", "fn2", "tn", "tt"]
        .map(|m| (format!("stiffnessPerUnitAreaK_{m}"), format!("stiffnessPerUnitAreaKu_{m}")))
    {
        let message = why(&[(&k, 3e10), (&ku, 2e10)], &[]);
        assert!(
            message.contains(&format!("{ku} = 20000000000 (types 1-1) must be at least 30000000000")),
            "{message}"
        );
    }
    let message = why(&[("maxDistanceBondnonlinear", 0.021), ("createDistanceBondnonlinear", 0.021)], &[]);
    assert!(
        message.contains("maxDistanceBondnonlinear = 0.021 (types 1-1) must be above 0.021"),
        "{message}"
    );
    let stress = ("stressBreak", "on");
    for (values, settings) in [
        (vec![], vec![stress, ("tensionStress", "off")]),
        (vec![("stiffnessPerUnitAreaK_fn2", 0.0)], vec![stress]),
    ] {
        let message = why(&values, &settings);
        assert!(message.contains("lets a bond stretch without end"), "{message}");
    }
    let message = why(&[("tsCreateBondnonlinear", 0.0)], &[]);
    assert!(message.contains("at least 1: step 0 only sets the run up"), "{message}");
    assert!(coeffs(&[("tsCreateBondnonlinear", 0.0)], &[("bondConvention", "upstream")]).is_ok());
    let unchosen = Setup { settings: Settings::new(&LAW, false), ..setup(&[], &[]) };
    let message = unchosen.check().unwrap_err().to_string();
    assert!(
        message.contains("bondConvention must be given, one of documented, upstream: documented: "),
        "{message}"
    );
    assert!(message.contains("N/m^2.5") && message.contains("N/m^0.5"), "{message}");
}

#[test]
fn strengths_and_ratio_enter_as_the_settings_say() {
    let values = [
        ("maxSigmaBondnonlinear", 2e5),
        ("maxTauBondnonlinear", 3e5),
        ("ratioTensionCompressionBondnonlinear", 0.5),
    ];
    let breaks = |settings: &[(&str, &str)]| match coeffs(&values, settings).unwrap().breaks {
        Breaks::Distance(_) => None,
        Breaks::Stress { sigma, tau, ratio } => Some((sigma, tau, ratio)),
    };
    assert_eq!(breaks(&[]), None);
    assert_eq!(breaks(&[("stressBreak", "on")]), Some((2e5, 3e5, 1.0)));
    assert_eq!(
        breaks(&[("stressBreak", "on"), ("ratioTensionCompressionBond", "on")]),
        Some((2e5, 3e5, 0.5))
    );
}

#[test]
fn trouble_that_is_allowed_is_remarked_on() {
    let remarks = |values: &[(&str, f64)], settings: &[(&str, &str)]| {
        BondNonlinear::remarks(&setup(values, settings).pair(0, 0)).join("\n")
    };
    assert_eq!(remarks(&[], &[]), "");
    assert!(remarks(&[], &[("createBondAlways", "on")]).contains("begins again in the next step"));
    assert!(remarks(&[("dampingNormalTorqueBondnonlinear", 1.0)], &[])
        .contains("dampingNormalTorqueBondnonlinear = 1 (types 1-1): a deflected bond never comes back"));
    assert_eq!(remarks(&[("dampingNormalTorqueBondnonlinear", 1.0)], &[("dampingBond", "off")]), "");
    let old = remarks(&[("tsCreateBondnonlinear", 0.0)], &[("bondConvention", "upstream")]);
    assert!(old.contains("no bond ever begins") && old.contains("results depend on the axes"), "{old}");
}
