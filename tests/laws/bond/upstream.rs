//! The upstream convention against what the header of LIGGGHTS-INL gave inside LIGGGHTS, call by call.
use granlaw_tools::replay::{replay, replay_from, Replay};
use granlaw_tools::trace::{Reader, Row, Writer};
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

fn traces() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reference_data/bond");
    let all = fs::read_dir(folder).unwrap().map(|f| f.unwrap().path());
    let is = |p: &PathBuf| p.file_name().unwrap().to_str().unwrap().starts_with("upstream_");
    let found: Vec<_> = all.filter(|p| is(p) && p.extension().is_some_and(|e| e == "csv")).collect();
    assert_eq!(found.len(), 12);
    found
}

/// Operations stand in the header's order: forces, torques and all 27 slots agree to the last bit.
#[test]
fn every_recorded_call_of_the_header_comes_out_bit_for_bit() {
    let mut calls = 0;
    for path in traces() {
        let r = replay(&path).unwrap_or_else(|e| panic!("{e}"));
        assert!(r.bit_equal(), "{}: {:?}", path.display(), r.worst().unwrap().report());
        let felt =
            ["force", "torque", "after.r0"].map(|n| r.quantities.iter().find(|q| q.name == n).unwrap().peak);
        assert!(felt[2] > 0.0 && felt[0].max(felt[1]) > 0.0 || r.touches < 20, "{}", path.display());
        calls += r.touches;
    }
    assert!(calls > 700, "only {calls} calls with a bond");
}

/// A trace with one property off by a millionth.
fn spoilt(path: &Path, property: &str) -> Replay {
    let mut trace = Reader::open(path).unwrap();
    let mut header = trace.header().clone();
    for law in &mut header.laws {
        for p in law.properties.iter_mut().filter(|p| p.name == property) {
            p.values.iter_mut().for_each(|v| *v *= 1.0 + 1e-6);
        }
    }
    let mut bytes = Vec::new();
    let mut out = Writer::new(&mut bytes, "spoilt.csv", &header).unwrap();
    let mut row = Row::default();
    while trace.read(&mut row).unwrap() {
        out.row(&row).unwrap();
    }
    out.finish().unwrap();
    replay_from(Reader::new(Cursor::new(bytes), "spoilt.csv").unwrap(), "spoilt.csv").unwrap()
}

#[test]
fn each_property_off_by_a_millionth_turns_red_in_some_case() {
    let mut names = Vec::new();
    for path in traces() {
        for law in &Reader::open(&path).unwrap().header().laws {
            names.extend(
                law.properties
                    .iter()
                    .map(|p| p.name.clone())
                    .filter(|n| n.contains("stiffness") || n.contains("ondnonlinear")),
            );
        }
    }
    names.sort();
    names.dedup();
    // Distances and strengths decide whether, not how much; the step of creation is a whole number.
    let decisive = |n: &String| !n.contains("Distance") && !n.contains("max") && !n.contains("tsCreate");
    assert!(names.len() >= 20, "{names:?}");
    for name in names.iter().filter(|n| decisive(n)) {
        assert!(traces().iter().any(|p| spoilt(p, name).error() > 1e-9), "{name} may be anything");
    }
}
