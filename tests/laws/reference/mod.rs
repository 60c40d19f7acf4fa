//! Recorded calls of LIGGGHTS's own laws through the Rust laws, without LIGGGHTS; and faults planted in them.
mod cdt_jkr;

use granlaw_tools::replay::{replay, replay_from, Replay, ReplayError};
use granlaw_tools::trace::{Header, Reader, Row, Writer};
use std::collections::BTreeSet;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// Rounding of a different order of operations would be 1e-16 of the peak for each; a wrong law is far above.
const LIMIT: f64 = 1e-14;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("reference_data")
}

fn files(extension: &str) -> Vec<PathBuf> {
    let all = fs::read_dir(folder()).unwrap().map(|f| f.unwrap().path());
    let mut found: Vec<_> = all.filter(|p| p.extension().is_some_and(|e| e == extension)).collect();
    found.sort();
    found
}

fn traces() -> Vec<PathBuf> {
    let found = files("csv");
    assert!(found.len() >= 8, "only {} traces in {}", found.len(), folder().display());
    found
}

fn text(name: &str) -> String {
    fs::read_to_string(folder().join(name)).unwrap()
}

fn replayed(text: String) -> Result<Replay, ReplayError> {
    replay_from(Reader::new(Cursor::new(text), "changed.csv")?, "changed.csv")
}

/// A trace with its header and rows changed.
fn changed(name: &str, head: impl Fn(&mut Header), each: impl Fn(usize, &mut Row)) -> Replay {
    let mut trace = Reader::open(&folder().join(name)).unwrap();
    let mut header = trace.header().clone();
    head(&mut header);
    let mut bytes = Vec::new();
    let mut out = Writer::new(&mut bytes, name, &header).unwrap();
    let mut row = Row::default();
    let mut k = 0;
    while trace.read(&mut row).unwrap() {
        each(k, &mut row);
        out.row(&row).unwrap();
        k += 1;
    }
    out.finish().unwrap();
    replayed(String::from_utf8(bytes).unwrap()).unwrap()
}

fn same_head(_: &mut Header) {}
fn same_rows(_: usize, _: &mut Row) {}

#[test]
fn every_recorded_call_comes_out_bit_for_bit() {
    for path in traces() {
        let r = replay(&path).unwrap_or_else(|e| panic!("{e}"));
        assert!(r.touches > 50, "{}: only {} calls in contact", path.display(), r.touches);
        let worst = r.worst().unwrap();
        assert!(r.error() <= LIMIT, "{}: {:?}", path.display(), worst.report());
        assert!(r.bit_equal(), "{}: {:?}", path.display(), worst.report());
        let loads =
            r.quantities.iter().filter(|q| ["force", "fn", "kn", "after.deltaMax"].contains(&&*q.name));
        assert!(loads.filter(|q| q.peak > 0.0).count() == 4, "{}: nothing to compare", path.display());
    }
}

#[test]
fn copying_a_trace_through_the_writer_changes_nothing() {
    for path in traces() {
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(changed(name, same_head, same_rows).bit_equal(), "{name}");
    }
}

#[test]
fn a_stiffness_off_by_a_thousandth_turns_red() {
    for path in traces() {
        let name = path.file_name().unwrap().to_str().unwrap();
        // kn goes with the modulus to the power 4/5.
        let stiffer = |h: &mut Header| {
            let young = h.laws[0].properties.iter_mut().find(|p| p.name == "youngsModulus").unwrap();
            young.values.iter_mut().for_each(|e| *e *= 1.001_f64.powf(1.25));
        };
        let r = changed(name, stiffer, same_rows);
        let kn = r.quantities.iter().find(|q| q.name == "kn").unwrap();
        assert!((kn.error() - 1e-3).abs() < 1e-6, "{name}: {}", kn.error());
        assert!(r.error() > LIMIT && !r.bit_equal(), "{name}");
        let force = r.quantities.iter().find(|q| q.name == "force").unwrap();
        assert!(force.error() > 1e-4, "{name}: the force hides it: {}", force.error());
    }
}

#[test]
fn one_odd_slot_with_the_wrong_sign_turns_red() {
    for name in ["oblique.csv", "wall.csv", "unequal.csv"] {
        let flip = |when: &'static str| {
            changed(name, same_head, move |k, row| {
                if k == 40 {
                    let history = if when == "before" { &mut row.before } else { &mut row.after };
                    assert!(history[1] != 0.0, "nothing to flip in {name}");
                    history[1] = -history[1];
                }
            })
        };
        for when in ["before", "after"] {
            let r = flip(when);
            assert!(r.error() > 1e-3, "{name} {when}: {}", r.error());
        }
        let after = flip("after");
        let spoilt: Vec<_> = after.quantities.iter().filter(|q| !q.identical()).collect();
        assert_eq!(spoilt.len(), 1, "{name}");
        assert_eq!(spoilt[0].name, "after.shearx");
    }
}

#[test]
fn one_force_that_differs_in_the_last_bits_turns_red_and_is_named() {
    // 1e-13 of the peak is ten times the limit.
    let expected = replay(&folder().join("oblique.csv")).unwrap();
    let peak = expected.quantities[0].peak;
    let r = changed("oblique.csv", same_head, |k, row| {
        if k == 50 {
            row.force_j.y += 1e-13 * peak;
        }
    });
    assert!(r.error() > LIMIT && r.error() < 2e-13, "{}", r.error());
    let worst = r.worst().unwrap().report().unwrap();
    assert_eq!(worst.what, "force.y of 1-2");
    let mut trace = Reader::open(&folder().join("oblique.csv")).unwrap();
    assert_eq!(worst.step, trace.nth(50).unwrap().unwrap().close.call.step);
}

#[test]
fn nan_in_a_trace_turns_red() {
    let r = changed("oblique.csv", same_head, |k, row| {
        if k == 10 {
            row.torque_i.z = f64::NAN;
        }
    });
    assert_eq!(r.error(), f64::INFINITY);
}

#[test]
fn a_surface_that_the_bodies_do_not_make_turns_red() {
    let r = changed("wall.csv", same_head, |_, row| row.close.i.omega.x += 1e-9);
    let q = |name: &str| r.quantities.iter().find(|q| q.name == name).unwrap();
    assert!(!q("surface velocity").identical() && !q("surface roll").identical());
    assert!(q("force").identical(), "the laws work on the recorded surface");
}

#[test]
fn coefficients_that_change_between_rows_are_prepared_again() {
    let (first, second) = (text("oblique.csv"), text("unequal.csv"));
    let body = |t: &str| {
        let from = t.find("\n62,").or_else(|| t.find("\n30,")).unwrap() + 1;
        t[from..t.rfind("# end").unwrap()].to_string()
    };
    let head = |t: &str| t[..t.find("step,").unwrap()].to_string();
    let columns = first.lines().find(|l| l.starts_with("step,")).unwrap();
    let (a, b) = (body(&first), body(&second));
    let end = format!("# end {}\n", a.lines().count() + b.lines().count());
    let joined =
        [head(&first), format!("{columns}\n"), a.clone(), head(&second), b.clone(), end.clone()].concat();
    let r = replayed(joined).unwrap();
    assert!(r.bit_equal() && r.calls as usize == a.lines().count() + b.lines().count());
    let without = [head(&first), format!("{columns}\n"), a, b, end].concat();
    assert!(replayed(without).unwrap().error() > 1e-3, "friction differs between the two");
}

#[test]
fn traces_that_cannot_be_replayed_say_why() {
    let whole = text("oblique.csv");
    let unknown = whole.replace("\"hooke/hysteresis\"", "\"adams_nowhere\"");
    let cases = [
        (whole[..whole.len() / 2].to_string(), "cut short"),
        ("id,x\n1,2\n".to_string(), "this is not a trace"),
        (whole.replacen("# granlaw trace 1", "# granlaw trace 9", 1), "format \"9\""),
        (whole.replacen(",rsq,", ",r,", 1), "is \"r\" where \"rsq\" belongs"),
        (unknown, "the trace has normal adams_nowhere, which granlaw does not have; it has normal hooke"),
        (whole.replacen("known = true", "known = false", 1), "which granlaw does not have"),
        (whole.replacen("viscous = \"off\"", "viscous = \"on\"", 1), "FluidViscosity was not given"),
    ];
    for (trace, says) in cases {
        let why = replayed(trace).expect_err(says).to_string();
        assert!(why.contains("changed.csv") && why.contains(says), "{why}");
    }
}

#[test]
fn every_trace_is_small_and_has_its_deck_and_certificate() {
    for path in traces() {
        let size = fs::metadata(&path).unwrap().len();
        assert!(size < 200 * 1024, "{}: {size} bytes", path.display());
        let header = Reader::open(&path).unwrap().header().clone();
        let deck = fs::read_to_string(folder().join(&header.deck)).unwrap();
        assert!(deck.contains("pair_style gran model hooke/hysteresis"), "{}", header.deck);
        let certificate = fs::read_to_string(path.with_extension("toml")).unwrap();
        let certificate: toml::Table = certificate.parse().unwrap();
        assert_eq!(certificate["deck"].as_str(), Some(header.deck.as_str()));
        let rows = Reader::open(&path).unwrap().count() as i64;
        assert_eq!(certificate["thinned"]["rows"].as_integer(), Some(rows), "{}", path.display());
        let readme = text("README.md");
        let name = path.file_stem().unwrap().to_str().unwrap();
        assert!(readme.contains(&format!("`{name}`")), "{name} is not in the README");
    }
    let names: BTreeSet<_> = traces().iter().map(|p| p.with_extension("")).collect();
    assert_eq!(names, files("toml").iter().map(|p| p.with_extension("")).collect());
}

#[test]
fn together_they_reach_every_branch_of_the_law() {
    let mut seen = BTreeSet::new();
    for path in traces() {
        let mut trace = Reader::open(&path).unwrap();
        let mut chain = trace.header().chain().unwrap();
        let mut row = Row::default();
        while trace.read(&mut row).unwrap() {
            seen.insert(chain.observe(row.types, &row.contact(), &row.before)[0].branch);
        }
    }
    assert_eq!(seen, BTreeSet::from(["adhesive", "loading", "unloading"]));
}

/// Contact `k` of a trace as LIGGGHTS would see it after the surfaces have parted.
fn part(row: &mut Row) {
    let zero = Row::default();
    (row.touch, row.has_force) = (false, false);
    (row.surface, row.handed) = (zero.surface, zero.handed);
    row.after.fill(0.0);
    (row.force_i, row.force_j) = (zero.force_i, zero.force_j);
    (row.torque_i, row.torque_j) = (zero.torque_i, zero.torque_j);
}

#[test]
fn calls_without_contact_are_replayed_too() {
    let parted = |keeps: f64| {
        changed("oblique.csv", same_head, move |k, row| {
            if k == 50 {
                part(row);
                row.after[0] = keeps;
            }
        })
    };
    let (clears, keeps) = (parted(0.0), parted(1e-6));
    assert!(clears.bit_equal() && clears.touches == clears.calls - 1);
    assert!(keeps.error() > 1e-3, "a history that is not cleared: {}", keeps.error());
}
