//! Recorded calls of the `cdt_jkr` of LIGGGHTS_Flexible_Fibers through ours under `cdtJkrConvention upstream`.
use super::{changed, folder, same_head, same_rows};
use granlaw_tools::replay::{replay, Replay};
use granlaw_tools::trace::{Header, Reader};
use std::fs;

const CASES: [&str; 5] = ["pair_free", "twist_off", "twist_on", "oblique_off", "wall"];

/// A few rounding errors of the peak, as the order of operations is a private matter of that code.
const LIMIT: f64 = 1e-13;

fn name(case: &str) -> String {
    format!("cdt_jkr/{case}.csv")
}

fn quantity<'a>(r: &'a Replay, name: &str) -> &'a granlaw_tools::compare::Quantity {
    r.quantities.iter().find(|q| q.name == name).unwrap()
}

#[test]
fn every_recorded_evaluation_of_upstream_comes_out() {
    for case in CASES {
        let r = replay(&folder().join(name(case))).unwrap_or_else(|e| panic!("{e}"));
        assert!(r.touches > 40 && quantity(&r, "torque").peak > 1e-6, "{case}: nothing to compare");
        assert!(r.error() <= LIMIT, "{case}: {:?}", r.worst().unwrap().report());
        // More than asked for: the same operations in the same order after all.
        assert!(r.bit_equal(), "{case}: {:?}", r.worst().unwrap().report());
    }
}

#[test]
fn all_that_was_recorded_is_here_with_its_certificate() {
    let mut found: Vec<_> =
        fs::read_dir(folder().join("cdt_jkr")).unwrap().map(|f| f.unwrap().path()).collect();
    found.retain(|p| p.extension().is_some_and(|e| e == "csv"));
    assert_eq!(found.len(), CASES.len());
    let readme = super::text("README.md");
    for case in CASES {
        let path = folder().join(name(case));
        assert!(fs::metadata(&path).unwrap().len() < 200 * 1024, "{case}");
        let certificate: toml::Table = super::text(&format!("cdt_jkr/{case}.toml")).parse().unwrap();
        let rows = Reader::open(&path).unwrap().count() as i64;
        assert_eq!(certificate["thinned"]["rows"].as_integer(), Some(rows), "{case}");
        let deck = super::text(&format!("cdt_jkr/{}", certificate["deck"].as_str().unwrap()));
        assert!(deck.contains("rolling_friction cdt_jkr"), "{case}");
        assert!(readme.contains(&format!("`cdt_jkr/{case}`")), "{case} is not in the README");
    }
}

fn with_eta(by: f64) -> impl Fn(&mut Header) {
    move |h| {
        let rolling = h.laws.iter_mut().find(|l| l.keyword == "cdt_jkr").unwrap();
        let eta = rolling.properties.iter_mut().find(|p| p.name == "adhesionHysteresis").unwrap();
        eta.values.iter_mut().for_each(|e| *e *= by);
    }
}

#[test]
fn a_hysteresis_off_by_one_in_a_million_million_turns_red() {
    for case in ["twist_off", "twist_on", "oblique_off"] {
        let r = changed(&name(case), with_eta(1.0 + 1e-12), same_rows);
        let error = quantity(&r, "torque").error();
        // Of the largest component, relative to the length.
        assert!(error > 5.0 * LIMIT && error < 1.001e-12, "{case}: {error}");
    }
}

#[test]
fn one_recorded_torque_off_by_two_limits_turns_red_and_is_named() {
    let peak = quantity(&replay(&folder().join(name("wall"))).unwrap(), "torque").peak;
    let r = changed(&name("wall"), same_head, |k, row| {
        if k == 20 {
            row.torque_i.y += 2.0 * LIMIT * peak;
        }
    });
    assert!(r.error() > LIMIT && r.error() < 3.0 * LIMIT, "{}", r.error());
    assert!(r.worst().unwrap().report().unwrap().what.starts_with("torque"));
}

#[test]
fn the_documented_convention_is_another_law() {
    let documented = |h: &mut Header| {
        let rolling = h.laws.iter_mut().find(|l| l.keyword == "cdt_jkr").unwrap();
        rolling.settings.insert("cdtJkrConvention".into(), "documented".into());
    };
    for case in CASES {
        let error = quantity(&changed(&name(case), documented, same_rows), "torque").error();
        // π where nothing turns about the normal, and more where something does; friction may have most of the peak.
        assert!(error > 0.1, "{case}: {error}");
    }
}
