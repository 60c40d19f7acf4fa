//! What a follower says of contacts that were counted by hand.
use super::scene::{feed, followed, hand, header, on_a_plane, probed, start, MASS, MU, RADIUS};
use approx::assert_relative_eq;
use granlaw::pair::{Partner, Start, State};
use granlaw_tools::probe::{Contacts, Counts, Follower, Probe, Session, TypePair, FORMAT};
use nalgebra::Vector3;

/// The states from the first with contact to the one after the last.
fn contact(all: &[State]) -> &[State] {
    let first = all.iter().position(|s| s.touching).expect("they touch");
    let n = all[first..].iter().position(|s| !s.touching).expect("they part");
    assert!(all[first + n..].iter().all(|s| !s.touching), "one contact");
    &all[first..=first + n]
}

/// Kinetic energy at the half step that the laws see.
fn energy(s: &State, start: &Start) -> f64 {
    let g = &s.contact.close;
    let n = if start.partner == Partner::Free { 2 } else { 1 };
    let of = |b: &granlaw::model::Body| {
        0.5 * MASS * b.v.norm_squared() + 0.2 * MASS * RADIUS * RADIUS * b.omega.norm_squared()
    };
    [&g.i, &g.j].into_iter().take(n).map(of).sum()
}

fn only(c: &Contacts) -> &TypePair {
    assert_eq!(c.pairs.len(), 1);
    &c.pairs[0]
}

fn starts() -> Vec<Start> {
    let frozen = {
        let mut s = start();
        (s.partner, s.bodies[1].v, s.bodies[1].omega) = (Partner::Frozen, Vector3::zeros(), Vector3::zeros());
        s
    };
    vec![start(), on_a_plane(), frozen]
}

#[test]
fn work_is_the_change_of_kinetic_energy() {
    for start in starts() {
        let all = followed(&start);
        let seen = contact(&all);
        let change = energy(seen.last().unwrap(), &start) - energy(&seen[0], &start);
        assert!(change < -1e-5);
        let probe = probed(&all, |_| ());
        let pair = only(&probe);
        // A thousand rounded steps.
        assert_relative_eq!(pair.work.sum(), change, max_relative = 1e-11);
        let laws: f64 = pair.laws.iter().map(|l| l.work).sum();
        assert_relative_eq!(laws, change, max_relative = 1e-11);
        assert_eq!(probe.residual, 0.0);
        // Every direction has its share, and torques have theirs in the law that makes them.
        assert!([pair.work.normal, pair.work.tangential, pair.work.rolling].iter().all(|w| *w < 0.0));
        assert_relative_eq!(pair.laws[2].work, pair.work.rolling + pair.work.torsion, max_relative = 1e-9);
        let damped = pair.laws[0].damped;
        assert!(damped > 0.0 && damped < -pair.laws[0].work, "the rest is plastic");
    }
}

#[test]
fn a_force_that_is_not_of_the_laws_is_noticed() {
    let all = followed(&start());
    let seen = contact(&all);
    let change = energy(seen.last().unwrap(), &start()) - energy(&seen[0], &start());
    let probe = probed(&all, |c| c.force *= 1.001);
    assert!((only(&probe).work.sum() / change - 1.0).abs() > 1e-4);
    assert_relative_eq!(probe.residual, 0.001 / 1.001, max_relative = 1e-6);
}

#[test]
fn impact_duration_restitution_overlap_load_and_tension() {
    let all = followed(&start());
    let seen = contact(&all);
    let probe = probed(&all, |_| ());
    let pair = only(&probe);
    assert_eq!(pair.counts, Counts { began: 1, parted: 1, ..Counts::default() });
    let (first, after) = (&seen[0], seen.last().unwrap());
    let en = seen[seen.len() - 2].contact.surface.en;
    let out = en.dot(&(after.contact.close.i.v - after.contact.close.j.v));
    let steps = seen.len() - 1;
    let one = |h: &granlaw_tools::probe::Histogram| {
        assert_eq!(h.count(), 1);
        h.mean().unwrap()
    };
    assert_eq!(one(&pair.steps), steps as f64);
    assert_eq!(one(&pair.impact_speed), -first.contact.surface.vn);
    assert_eq!(one(&pair.impact_slip), first.contact.surface.vtr.norm());
    assert_relative_eq!(one(&pair.restitution), out / -first.contact.surface.vn, max_relative = 1e-12);
    let peak = |f: &dyn Fn(&State) -> f64| seen[..steps].iter().map(f).fold(f64::MIN, f64::max);
    let overlap = peak(&|s| s.contact.surface.deltan);
    assert_relative_eq!(one(&pair.overlap), overlap / (0.5 * RADIUS), max_relative = 1e-14);
    // δlim = k2max/(k2max − kn) φF 2R*.
    assert_relative_eq!(one(&pair.load), overlap / (5.0 / 4.0 * 0.05 * RADIUS), max_relative = 1e-12);
    let normal = |s: &State| s.response.force.dot(&s.contact.surface.en);
    let pull = peak(&|s| -normal(s)) / peak(&normal);
    assert!(pull > 0.01);
    assert_relative_eq!(one(&pair.tension), pull, max_relative = 1e-12);
    let example = pair.impacts[0].examples[0].what;
    assert_eq!((example.end.steps, example.end.overlap), (steps as u64, overlap));
}

#[test]
fn time_slip_and_branches() {
    let all = followed(&start());
    let seen = contact(&all);
    let steps = seen.len() - 1;
    let probe = probed(&all, |_| ());
    let pair = only(&probe);
    assert_relative_eq!(pair.time, steps as f64 * 1e-6, max_relative = 1e-12);
    let slips = |s: &State| {
        let (f, en) = (s.response.force, s.contact.surface.en);
        (f - en * f.dot(&en)).norm() >= MU * s.response.fn_.abs() * (1.0 - 1e-9)
    };
    let slipping = seen[..steps].iter().filter(|s| slips(s)).count();
    assert!(slipping > 10 && slipping < steps, "{slipping} of {steps}");
    assert_relative_eq!(pair.slip, slipping as f64 * 1e-6, max_relative = 1e-12);
    let branches: Vec<_> = pair.laws[0].branches.iter().collect();
    let sum: f64 = branches.iter().map(|(_, t)| t).sum();
    assert_eq!(branches.len(), 3, "{branches:?}");
    assert_relative_eq!(sum, pair.time, max_relative = 1e-12);
    // Loading lasts until the overlap is at its limit, beyond which the law goes up and down one line.
    let limit = 5.0 / 4.0 * 0.05 * RADIUS;
    let loads = seen[..steps].iter().take_while(|s| s.contact.surface.deltan < limit).count();
    assert!(loads < steps / 2);
    let loading = branches.iter().find(|(b, _)| *b == "loading").unwrap().1;
    assert_relative_eq!(loading, loads as f64 * 1e-6, max_relative = 1e-9);
}

#[test]
fn an_overlap_at_the_start_is_no_impact() {
    let mut s = start();
    s.bodies[0].x.x += 2e-5;
    let probe = probed(&followed(&s), |_| ());
    let pair = only(&probe);
    assert_eq!(pair.counts, Counts { found: 1, parted: 1, ..Counts::default() });
    assert_eq!((pair.impact_speed.count(), pair.restitution.count(), pair.impacts.len()), (0, 0, 0));
}

#[test]
fn a_sphere_at_rest_on_a_plane_is_pressed_by_its_weight() {
    let mut s = on_a_plane();
    (s.bodies[0].v, s.bodies[0].omega) = (Vector3::x() * 1e-3, Vector3::zeros());
    s.bodies[0].x.x = -RADIUS;
    (s.gravity, s.steps) = (Vector3::new(9.81, 1.0, 0.0), 200_000);
    let probe = probed(&followed(&s), |_| ());
    let pair = only(&probe);
    assert_eq!((pair.counts.open, pair.impacts.len()), (1, 0));
    let load = pair.pressed[0].examples[0].what;
    // The mean of a contact that swings for the first thousandth of its time.
    assert_relative_eq!(load.normal, MASS * 9.81, max_relative = 1e-2);
}

#[test]
fn a_sample_stands_for_all() {
    let all = followed(&start());
    let (pairs, every) = (3000i64, 3);
    let mut follower = Follower::new(header(), 64);
    // Each pair begins a little later, so that some four hundred touch at a time.
    for step in 1..all.len() as i64 + pairs * every {
        for k in 0..pairs {
            let at = step - k * every;
            if (1..all.len() as i64).contains(&at) {
                let (before, state) = (&all[at as usize - 1].history, &all[at as usize]);
                hand(&mut follower, before, state, [2 * k, 2 * k + 1], k * every, |_| ());
            }
        }
    }
    let (sampled, whole) = (follower.finish(), probed(&all, |_| ()));
    let (some, one) = (only(&sampled), only(&whole));
    assert!(sampled.share >= 4 && sampled.followed * 4 < sampled.calls, "{}", sampled.share);
    // A binomial sample of one in `share`, with four of its standard deviations.
    let spread = 4.0 * (sampled.share as f64 / pairs as f64).sqrt();
    assert_relative_eq!(some.counts.began as f64, pairs as f64, max_relative = spread);
    assert_relative_eq!(some.counts.parted as f64, pairs as f64, max_relative = spread);
    assert_relative_eq!(some.work.sum(), pairs as f64 * one.work.sum(), max_relative = spread);
    assert_relative_eq!(
        some.restitution.mean().unwrap(),
        one.restitution.mean().unwrap(),
        max_relative = 1e-12
    );
    assert_eq!(some.impacts[0].examples.len(), granlaw_tools::probe::KEPT);
}

#[test]
fn ranks_add_up_and_files_read_back() {
    let all = followed(&start());
    let session = |tags: &[[i64; 2]]| {
        let mut session = Session::default();
        let at = session.chain(header());
        tags.iter().for_each(|t| feed(session.follower(at), &all, *t, t[0], |_| ()));
        session.finish()
    };
    let tags: Vec<_> = (0..4).map(|k| [10 * k, 10 * k + 1]).collect();
    let whole = session(&tags);
    let mut merged = session(&tags[..2]);
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("rank.json");
    session(&tags[2..]).write(&path).unwrap();
    merged.merge(Probe::read(&path).unwrap());
    let (a, b) = (only(&merged.chains[0]), only(&whole.chains[0]));
    assert_eq!((a.counts, merged.chains[0].calls), (b.counts, whole.chains[0].calls));
    assert_relative_eq!(a.work.sum(), b.work.sum(), max_relative = 1e-14);
    assert!(a.friction.bins().eq(b.friction.bins()));
    assert_eq!(a.impacts[0].examples, b.impacts[0].examples);
    let mut files: Vec<_> = std::fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(files.pop().unwrap(), "rank.json");
    assert!(files.is_empty());
}

#[test]
fn another_file_is_refused_in_words() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("x.json");
    for (text, says) in [
        ("step,dt\n", "it is no JSON"),
        ("{}", "it has no format"),
        (r#"{"format":"granlaw probe 0"}"#, "its format is \"granlaw probe 0\""),
        (&format!(r#"{{"format":"{FORMAT}"}}"#), "missing field"),
    ] {
        std::fs::write(&path, text).unwrap();
        let error = Probe::read(&path).unwrap_err().to_string();
        assert!(error.contains(says) && error.contains("granlaw run --probe"), "{error}");
    }
    assert!(Probe::read(&dir.path().join("none")).unwrap_err().to_string().contains("cannot read"));
}
