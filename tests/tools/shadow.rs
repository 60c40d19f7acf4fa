//! The shadow of a run: what counts as a difference, how large it is, and what is told of it.
use granlaw::model::Body;
use granlaw::pair::{states, Opened, Partner, Start};
use granlaw_tools::shadow::{Session, Shadow, Verdict};
use granlaw_tools::trace::{Handed, Header, LawSpec, Property, Row};
use nalgebra::Vector3;

/// `hooke` and `history`, as LIGGGHTS runs them under its own names.
fn header(who: &str) -> Header {
    let law = |kind: &str, keyword: &str, properties: &[(&str, &str, f64)]| LawSpec {
        kind: kind.into(),
        keyword: keyword.into(),
        taken_over: true,
        known: true,
        properties: properties
            .iter()
            .map(|(name, shape, x)| Property {
                name: name.to_string(),
                unit: "1".into(),
                shape: shape.to_string(),
                values: vec![*x],
            })
            .collect(),
        ..LawSpec::default()
    };
    let normal = [
        ("youngsModulus", "peratomtype", 5e6),
        ("poissonsRatio", "peratomtype", 0.45),
        ("characteristicVelocity", "scalar", 2.0),
        ("coefficientRestitution", "peratomtypepair", 0.8),
    ];
    Header {
        who: who.into(),
        ranks: 2,
        types: 1,
        nktv2p: 1.0,
        dt: 1e-6,
        slots: ["shearx", "sheary", "shearz"].map(String::from).to_vec(),
        laws: vec![
            law("normal", "hooke", &normal),
            law("tangential", "history", &[("coefficientFriction", "peratomtypepair", 0.2)]),
        ],
        ..Header::default()
    }
}

/// The calls of an oblique impact with the answers of the very laws that judge them.
fn rows() -> Vec<Row> {
    let body = |tag, x, v: [f64; 3]| Body {
        tag,
        radius: 0.005,
        mass: 1.3e-3,
        x: Vector3::new(x, 0.0, 0.0),
        v: v.into(),
        ..Body::default()
    };
    let start = Start {
        bodies: [body(7, -0.005003, [0.6, 0.3, 0.0]), body(8, 0.005003, [-0.4, 0.0, 0.1])],
        types: (0, 0),
        partner: Partner::Free,
        dt: 1e-6,
        steps: 3000,
        first: 0,
        gravity: Vector3::zeros(),
        opened: Opened::Keeps,
    };
    let all = states(&mut header("pair").chain().unwrap(), &start);
    let touching = all.windows(2).filter(|w| w[1].touching);
    let rows: Vec<_> = touching
        .map(|w| {
            let (s, x) = (&w[1].response, &w[1].contact);
            Row {
                computeflag: 1,
                shearupdate: 1,
                touch: true,
                close: x.close,
                surface: x.surface,
                before: w[0].history.clone(),
                after: w[1].history.clone(),
                handed: Handed::from(s),
                force_i: s.force,
                force_j: -s.force,
                torque_i: s.torque_i,
                torque_j: s.torque_j,
                has_force: true,
                ..Row::default()
            }
        })
        .collect();
    assert!(rows.len() > 100);
    rows
}

/// What a shadow says of rows with changes.
fn shadow(change: impl Fn(usize, &mut Row)) -> Shadow {
    let mut session = Session::default();
    let at = session.chain(header("pair"));
    for (k, mut row) in rows().into_iter().enumerate() {
        change(k, &mut row);
        session.call(at, &row, 1.0);
    }
    session.finish()
}

#[test]
fn the_same_answers_are_equal() {
    let s = shadow(|_, row| row.torque_i.x = if row.torque_i.x == 0.0 { -0.0 } else { row.torque_i.x });
    assert_eq!((s.calls(), s.left_out(), s.error()), (rows().len() as u64, 0, 0.0));
    assert_eq!((s.chains[0].differing, s.verdict(0.0)), (0, Verdict::Agreed));
    assert_eq!(s.verdict(0.0).exit_code(), 0);
}

#[test]
fn every_number_of_the_answer_counts() {
    type Fault = (usize, &'static str, fn(&mut Row));
    let faults: [Fault; 5] = [
        (0, "force_i.y", |r| r.force_i.y *= 1.001),
        (0, "force_j.x", |r| r.force_j.x += 1e-6),
        (1, "torque_i.z", |r| r.torque_i.z *= 1.001),
        (1, "torque_j.z", |r| r.torque_j.z = f64::from_bits(r.torque_j.z.to_bits() + 1)),
        (2, "after.sheary", |r| r.after[1] *= 1.0 + 1e-15),
    ];
    for (measure, what, fault) in faults {
        let s = shadow(|k, row| {
            if k == 40 {
                fault(row)
            }
        });
        let chain = &s.chains[0];
        assert_eq!(
            (chain.differing, s.verdict(0.0), s.verdict(0.0).exit_code()),
            (1, Verdict::Differs, 3),
            "{what}"
        );
        let worst = chain.worst[measure].as_ref().expect(what);
        assert_eq!((worst.what.as_str(), worst.tags, worst.step), (what, (7, 8), rows()[40].close.call.step));
        assert!(worst.error > 0.0 && worst.error < 1e-2 && s.verdict(1e-2) == Verdict::Agreed, "{worst:?}");
        assert_eq!(chain.worst.iter().flatten().count(), 1, "{what}");
    }
}

#[test]
fn what_is_not_finite_is_wrong_on_either_side_and_on_both() {
    for x in [f64::NAN, f64::INFINITY] {
        let s = shadow(|k, row| {
            if k == 9 {
                row.force_i.x = x
            }
        });
        assert_eq!((s.error(), s.verdict(1e300)), (f64::INFINITY, Verdict::Differs));
        // The same NaN or infinity in both answers.
        let s = shadow(|k, row| {
            if k == 9 {
                row.surface.deltan = x;
                (row.force_i.x, row.force_j.x) = (x, -x);
            }
        });
        assert_eq!(s.verdict(1e300), Verdict::Differs);
        // It does not spoil the measure of what follows.
        let s = shadow(|k, row| {
            if k == 9 {
                row.after[0] = x
            }
        });
        assert_eq!((s.chains[0].differing, s.chains[0].worst[2].as_ref().unwrap().error), (1, f64::INFINITY));
    }
}

#[test]
fn a_difference_is_held_against_what_the_laws_add_up() {
    // A force a thousandth too large is off by a thousandth while it pushes against the spring ...
    let s = shadow(|k, row| {
        if k == 40 {
            row.force_i *= 1.001
        }
    });
    let error = s.chains[0].worst[0].as_ref().unwrap().error;
    assert!((5e-4..=1.0e-3).contains(&error), "{error}");
    // ... and round-off is round-off where the parts cancel.
    let rows = rows();
    let part = |r: &Row| r.force_i.norm() / (r.handed.kn * r.surface.deltan);
    let (weakest, row) = rows.iter().enumerate().min_by(|a, b| part(a.1).total_cmp(&part(b.1))).unwrap();
    assert!(part(row) < 0.5, "no part cancels another");
    let off = 1e-15 * row.handed.kn * row.surface.deltan;
    let s = shadow(|k, row| {
        if k == weakest {
            row.force_i.x += off
        }
    });
    assert!(s.error() > 0.0 && s.error() <= 2e-15, "{}", s.error());
}

#[test]
fn no_difference_is_lost_to_its_scale() {
    // Too small for the quotient, too large for the length of a vector, and without any scale.
    let faults: [fn(&mut Row); 3] = [
        |r| r.after[0] = f64::from_bits(r.after[0].to_bits() + 1),
        |r| r.force_i = Vector3::repeat(1e200),
        |r| r.torque_i.x = 5e-324,
    ];
    for fault in faults {
        let s = shadow(|k, row| {
            if k == 0 {
                fault(row)
            }
        });
        assert_eq!((s.chains[0].differing, s.verdict(0.0)), (1, Verdict::Differs));
    }
}

#[test]
fn the_worst_of_all_ranks_is_kept_and_counts_are_summed() {
    let mild = shadow(|k, row| {
        if k == 3 {
            row.force_i.x *= 1.0 + 1e-9
        }
    });
    let grave = shadow(|k, row| {
        if k == 5 {
            row.force_i.x *= 1.0 + 1e-3
        }
    });
    let merged = |a: &Shadow, b: &Shadow| {
        let mut whole = a.clone();
        // As it goes from rank to rank.
        whole.merge(serde_json::from_str(&serde_json::to_string(b).unwrap()).unwrap());
        whole
    };
    for whole in [merged(&mild, &grave), merged(&grave, &mild)] {
        assert_eq!((whole.calls(), whole.chains.len()), (2 * mild.calls(), 1));
        assert_eq!((whole.chains[0].differing, whole.error()), (2, grave.error()));
        assert_eq!(whole.chains[0].worst[0], grave.chains[0].worst[0]);
    }
    let nan = shadow(|k, row| {
        if k == 3 {
            row.force_i.x = f64::NAN
        }
    });
    assert_eq!(merged(&mild, &nan).error(), f64::INFINITY);
}

#[test]
fn a_chain_without_a_twin_is_not_compared() {
    let mut lacking = header("wall a");
    lacking.laws[1].known = false;
    let mut own = header("wall b");
    own.laws[0].taken_over = false;
    let mut refused = header("wall c");
    refused.laws[1].properties[0].values[0] = -1.0;
    for (other, why) in [
        (lacking, "granlaw has no tangential history"),
        (own, "the deck itself runs granlaw's normal hooke/rs; take LIGGGHTS's law, without /rs"),
        (refused, "history: coefficientFriction = -1 (types 1-1) must be at least 0"),
    ] {
        let mut session = Session::default();
        let (pair, wall) = (session.chain(header("pair")), session.chain(other));
        let row = &rows()[10];
        session.call(wall, row, 1.0);
        let s = session.finish();
        assert_eq!((s.verdict(0.0), s.verdict(0.0).exit_code(), s.left_out()), (Verdict::Nothing, 2, 1));
        assert!(s.chains[wall].left_out.as_ref().unwrap().contains(why), "{:?}", s.chains[wall].left_out);
        assert!(s.text(0.0).contains("NOTHING COMPARED; 1 calls not compared"), "{}", s.text(0.0));
        assert_eq!(s.chains[pair].calls, 0);
    }
}

#[test]
fn coefficients_that_change_go_on_in_the_same_count() {
    let mut session = Session::default();
    let rows = rows();
    let at = session.chain(header("pair"));
    session.call(at, &rows[10], 1.0);
    let mut stiffer = header("pair");
    stiffer.laws[0].properties[0].values[0] *= 2.0;
    assert_eq!(session.chain(stiffer), at);
    session.call(at, &rows[11], 1.0);
    assert_eq!(session.chain(header("pair")), at);
    session.call(at, &rows[12], 1.0);
    let s = session.finish();
    assert_eq!((s.chains.len(), s.chains[0].calls, s.chains[0].differing), (1, 3, 1));
}

#[test]
fn a_share_of_a_wall_counts_in_part() {
    let mut session = Session::default();
    let at = session.chain(header("wall mesh"));
    let mut row = rows()[10].clone();
    // As seen from a wall: no force on it, and nothing of it but its velocity.
    row.close.call.is_wall = true;
    let mut chain = header("wall mesh").chain().unwrap();
    let mut response = granlaw::model::Response::default();
    row.after.clone_from(&row.before);
    chain.surfaces_intersect((0, 0), &row.contact(), &mut row.after, &mut response);
    (row.force_i, row.torque_i) = (response.force * 0.25, response.torque_i * 0.25);
    (row.force_j, row.torque_j) = (Vector3::zeros(), response.torque_j);
    session.call(at, &row, 0.25);
    assert_eq!(session.finish().error(), 0.0);
}

#[test]
fn what_is_told_of_the_worst() {
    let s = shadow(|k, row| {
        if k == 40 {
            row.force_i.y *= 1.001;
            row.after[1] += 1.0;
        }
    });
    let text = s.text(1e-6);
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines[0], "granlaw shadow: LIGGGHTS's laws and the Rust laws on the same inputs, 2 ranks");
    assert_eq!(lines[1], "  pair: normal hooke, tangential history");
    assert_eq!(lines[2], format!("    {} calls compared, one contact at a time: 1 differ", rows().len()));
    assert!(lines[3].starts_with("    force: ") && lines[3].contains(" of its scale at step "), "{text}");
    assert!(lines[3].contains(", particles 7 and 8: force_i.y is "), "{text}");
    assert!(lines[4].starts_with("    history: 1e0 of its scale"), "{text}");
    // What went in can be typed into anything, to the last digit.
    let row = &rows()[40];
    let inputs = lines[5].split(": ").nth(1).unwrap();
    for (name, value) in
        [("x_i.x", row.close.i.x.x), ("deltan", row.surface.deltan), ("before.sheary", row.before[1])]
    {
        let told = inputs.split(' ').find_map(|w| w.strip_prefix(&format!("{name}="))).expect(name);
        assert_eq!(told.parse::<f64>().unwrap(), value, "{name}");
    }
    assert!(!inputs.contains("force_") && !inputs.contains("after."), "{inputs}");
    assert!(
        lines[6].starts_with("  DIFFERS: ") && lines[6].ends_with(", worst difference 1e0, allowed 1e-6"),
        "{text}"
    );
    assert_eq!(lines.len(), 7);
}
