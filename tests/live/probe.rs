//! Probes of runs inside LIGGGHTS against the traces of the same decks.
use crate::built::{built, has, here, must, source};
use granlaw_tools::probe::{Call, Probe, Session};
use granlaw_tools::trace::{Reader, Row};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder with a deck's files, and what ran there.
struct Place(tempfile::TempDir);

impl Place {
    fn new(deck: &str) -> Place {
        let place = Place(tempfile::tempdir().expect("a folder"));
        let inputs = source().join("liggghts_inputs");
        for file in [deck, "plane.stl"] {
            std::fs::copy(inputs.join(file), place.file(file)).expect("the deck is there");
        }
        place
    }
    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }
    fn run(&self, deck: &str, options: &[&str]) {
        let mut command = Command::new(built().join("granlaw"));
        command.arg("run").args(options).args(["--", "-in", deck]).current_dir(self.0.path());
        must(&mut command);
    }
    fn probe(&self) -> Probe {
        Probe::read(&self.file("probe.json")).expect("a probe")
    }
}

fn liggghts(test: &str) -> bool {
    here(test, has("liggghts"), "liggghts is not in PATH")
}

/// The rows of a trace through a session, one after the other.
fn retraced(session: &mut Session, trace: &Path) {
    let mut reader = Reader::open(trace).expect("a trace");
    let at = session.chain(reader.header().clone());
    let mut row = Row::default();
    while reader.read(&mut row).expect("a row") {
        let follower = session.follower(at);
        if !row.touch && row.close.call.update {
            follower.across(row.types, &row.close, &row.before);
        }
        if !row.touch || !follower.sees((row.close.i.tag, row.close.j.tag)) || !row.close.call.update {
            continue;
        }
        let x = row.contact();
        follower.touched(&Call {
            types: row.types,
            contact: &x,
            place: 0,
            share: 1.0,
            before: &row.before,
            handed: row.handed,
            force: row.force_i,
            torque_i: row.torque_i,
            torque_j: row.torque_j,
        });
    }
}

#[test]
fn a_probe_says_what_the_trace_says() {
    if !liggghts("a_probe_says_what_the_trace_says") {
        return;
    }
    for deck in
        ["oblique_slip.in", "two_types.in", "hertz_history_damped.in", "several_runs.in", "frozen_partner.in"]
    {
        let place = Place::new(deck);
        place.run(deck, &["--laws", "stock", "--record", "calls.csv", "--probe", "probe.json"]);
        let mut session = Session::default();
        retraced(&mut session, &place.file("calls.csv"));
        let live = place.probe();
        session.finish().write(&place.file("traced.json")).expect("a file");
        let traced = Probe::read(&place.file("traced.json")).expect("a probe");
        assert!(live.chains[0].followed > 100, "{deck}");
        // Not assert_eq: nobody could read what it prints.
        assert!(live.chains == traced.chains, "{deck}");
        // The Rust laws stand in their place and give the same.
        place.run(deck, &["--laws", "rust", "--probe", "probe.json"]);
        assert!(place.probe().chains == traced.chains, "{deck}");
        // Another coefficient does not.
        let text = std::fs::read_to_string(place.file(deck)).unwrap();
        let changed = text.replace("youngsModulus peratomtype 5", "youngsModulus peratomtype 6");
        assert_ne!(text, changed, "{deck}");
        std::fs::write(place.file(deck), changed).unwrap();
        place.run(deck, &["--probe", "probe.json"]);
        assert!(place.probe().chains[0].pairs != traced.chains[0].pairs, "{deck}");
    }
}

#[test]
fn bonds_across_gaps_tell_how_much_of_their_strength_they_use() {
    if !liggghts("bonds_across_gaps_tell_how_much_of_their_strength_they_use") {
        return;
    }
    let deck = "bond_breaks_at_a_stress.in";
    let place = Place::new(deck);
    place.run(deck, &["--record", "calls.csv", "--probe", "probe.json"]);
    let mut session = Session::default();
    retraced(&mut session, &place.file("calls.csv"));
    session.finish().write(&place.file("traced.json")).expect("a file");
    let gaps = place.probe().chains[0].pairs[0].gaps.clone();
    assert!(gaps == Probe::read(&place.file("traced.json")).expect("a probe").chains[0].pairs[0].gaps);
    // Pulled until it breaks, it uses all of its strength in the end, and less before.
    let (low, high) = gaps.load.range().expect("a bond");
    assert!(gaps.load.count() > 10 && low < 0.5 && (1.0..1.1).contains(&high), "{low} {high}");
    // Twice as strong, it breaks at the same part of it, later.
    let text = std::fs::read_to_string(place.file(deck)).unwrap();
    let strength = text.lines().find(|l| l.contains("maxSigmaBondnonlinear")).expect("a strength");
    let sigma = strength.split_whitespace().last().unwrap().parse::<f64>().unwrap();
    let stronger = strength.replace(strength.split_whitespace().last().unwrap(), &format!("{}", 2.0 * sigma));
    std::fs::write(place.file(deck), text.replace(strength, &stronger)).unwrap();
    place.run(deck, &["--probe", "probe.json"]);
    let later = place.probe().chains[0].pairs[0].gaps.clone();
    assert!(later.time > 1.2 * gaps.time, "{} {}", later.time, gaps.time);
}

#[test]
fn probing_leaves_a_run_as_it_was_and_sees_all_of_it() {
    if !liggghts("probing_leaves_a_run_as_it_was_and_sees_all_of_it") {
        return;
    }
    let deck = "gas_two_ranks.in";
    let place = Place::new(deck);
    let dump = || std::fs::read(place.file("dump.txt")).expect("a dump");
    place.run(deck, &["--np", "2"]);
    let plain = dump();
    place.run(deck, &["--np", "2", "--probe", "probe.json"]);
    assert!(plain == dump(), "the dumps differ");
    let probe = place.probe();
    assert_eq!(probe.ranks, 2);
    let count: u64 = probe.grains.iter().map(|g| g.count).sum();
    assert_eq!((probe.grains.len(), count), (2, probe.bulk.samples.last().unwrap().particles));
    assert!(probe.grains.iter().all(|g| g.radius[0] == g.radius[1] && g.fastest > 1.0), "{:?}", probe.grains);
    let chain = &probe.chains[0];
    assert_eq!((probe.chains.len(), chain.pairs.len(), chain.residual), (1, 3, 0.0));
    let (first, last) = (probe.bulk.samples.first().unwrap(), probe.bulk.samples.last().unwrap());
    let atoms = field(&plain, "NUMBER OF ATOMS").parse::<u64>().unwrap();
    assert_eq!((first.particles, last.particles), (atoms, atoms));
    assert_eq!((first.step, first.contacts), (0, 0));
    // Contacts found by either rank come to the number of calls, but for those after the last sample.
    assert!(last.contacts <= chain.calls && last.contacts * 100 > chain.calls * 98);
    // Momentum of a periodic gas is what it was; the centre drifts with it and no further.
    assert!(last.kinetic + last.rotational < first.kinetic);
}

/// The line behind `ITEM: <name>` of the first frame.
fn field(dump: &[u8], name: &str) -> String {
    let text = String::from_utf8_lossy(dump);
    let mut lines = text.lines().skip_while(|l| *l != format!("ITEM: {name}"));
    lines.nth(1).expect("a value").trim().to_string()
}

#[test]
fn walls_hand_out_the_weight_of_what_lies_on_them() {
    if !liggghts("walls_hand_out_the_weight_of_what_lies_on_them") {
        return;
    }
    let deck = "mesh_wall.in";
    let place = Place::new(deck);
    place.run(deck, &["--probe", "probe.json"]);
    let probe = place.probe();
    let (first, last) = (probe.bulk.samples.first().unwrap(), probe.bulk.samples.last().unwrap());
    let wall = probe.chains.iter().find(|c| c.header.who.starts_with("wall")).expect("a wall");
    assert_eq!(probe.bulk.walls, std::slice::from_ref(&wall.header.who));
    // One sphere: all the momentum that the wall handed out is the change of its own.
    let speed = |s: &granlaw_tools::probe::Sample| (2.0 * s.kinetic / s.mass).sqrt();
    assert_eq!((first.particles, last.particles), (1, 1));
    let pushed = last.walls[0].map(|i| i / last.mass);
    assert!(pushed[2] > 0.0 && speed(last) < speed(first), "{pushed:?}");
    let pair = &wall.pairs[0];
    assert_eq!((pair.counts.began, pair.counts.parted), (1, 1));
    let (e, v) = (pair.restitution.mean().unwrap(), pair.impact_speed.mean().unwrap());
    approx::assert_relative_eq!(pushed[2], (1.0 + e) * v, max_relative = 1e-9);
}
