//! The rules for laws that act across a gap. Their history means something only if they made it themselves, so that
//! whole paths are held against each other: the same motion seen otherwise.
use super::motion::{evaluate, follow, undisturbed, Answers, Path, STEPS};
use super::recipe::{chain_of, for_all_of, Draw, Fault, Laws, Recipe, Switches};
use super::rules::{close, close3, vectors, Outcome};
use super::{names, CASES};
use granlaw::laws::LAWS;
use granlaw::model::*;
use nalgebra::{Rotation3, Vector3};
use std::cell::RefCell;
use std::panic::{catch_unwind, AssertUnwindSafe};

const DRAWS: usize = 400;

/// The largest force and torque of a path; a bond whose modes are switched off is held against a thousandth of a newton.
fn peaks(path: &Path, answers: &Answers) -> (f64, f64) {
    let force = answers.iter().map(|(s, _)| s.force.norm()).fold(1e-3, f64::max);
    let torque = answers.iter().map(|(s, _)| s.torque_i.norm().max(s.torque_j.norm())).fold(0.0, f64::max);
    (force, torque.max(force * path.arm()))
}

type Turn<'a> = &'a dyn Fn(&Vector3<f64>) -> Vector3<f64>;

/// Forces and torques of two paths agree, the first seen through `turn`.
fn same(path: &Path, a: &Answers, b: &Answers, tolerance: f64, turn: Turn<'_>) -> Outcome {
    let (force, torque) = peaks(path, a);
    for ((a, _), (b, _)) in a.iter().zip(b) {
        close3("force", &turn(&a.force), &b.force, tolerance, force)?;
        close3("torque on i", &turn(&a.torque_i), &b.torque_i, tolerance, torque)?;
        close3("torque on j", &turn(&a.torque_j), &b.torque_j, tolerance, torque)?;
    }
    Ok(())
}

/// Positions round off by 1e-17 m where overlaps are 1e-6 m, and √δ magnifies that near zero, as strains here are small;
/// damping at rest has no direction. What breaks a rule breaks it by percents.
const LOOSE: f64 = 1e-6;

/// i and j change places, for the whole path or half of it: to the last bit, as every operation is odd or symmetric.
fn swap(r: &Recipe, path: &Path, _: &mut Draw<'_>) -> Outcome {
    if path.gaps[0].call.is_wall {
        return Ok(());
    }
    let a = undisturbed(r, path);
    let mirrored = path.other(|g| std::mem::swap(&mut g.i, &mut g.j));
    let turn = |h: &mut [f64]| {
        for (h, s) in h.iter_mut().zip(r.subject().slots.iter()) {
            *h *= if s.newton == Newton::Odd { -1.0 } else { 1.0 };
        }
    };
    for from in [0, path.gaps.len() / 2] {
        let mut mixed = path.clone();
        mixed.gaps[from..].copy_from_slice(&mirrored.gaps[from..]);
        mixed.types = (path.types.1, path.types.0);
        if from > 0 && path.types.0 != path.types.1 {
            continue; // One path has one order of types.
        }
        let b = follow(r, &mixed, |k, _, h| {
            if k == from {
                turn(h)
            }
        });
        for ((a, ha), (b, hb)) in a.iter().zip(&b).skip(from) {
            close3("force", &a.force, &-b.force, 0.0, 1.0)?;
            close3("torque on i", &a.torque_i, &b.torque_j, 0.0, 1.0)?;
            close3("torque on j", &a.torque_j, &b.torque_i, 0.0, 1.0)?;
            let mut back = hb.clone();
            turn(&mut back);
            if *ha != back {
                return Err(format!("history: {ha:?} against {back:?}"));
            }
        }
    }
    Ok(())
}

/// The whole picture is turned.
fn rotation(r: &Recipe, path: &Path, d: &mut Draw<'_>) -> Outcome {
    let q = Rotation3::new(d.direction() * 2.0);
    let turned = path.other(|g| {
        for b in [&mut g.i, &mut g.j] {
            (b.x, b.v, b.omega) = (q * b.x, q * b.v, q * b.omega);
        }
    });
    let (a, b) = (undisturbed(r, path), undisturbed(r, &turned));
    same(path, &a, &b, LOOSE, &|v| q * v)?;
    let slots = r.subject().slots;
    let ((_, ha), (_, hb)) = (a.last().unwrap(), b.last().unwrap());
    for k in vectors(&slots) {
        let (va, vb) = (Vector3::from_column_slice(&ha[k..k + 3]), Vector3::from_column_slice(&hb[k..k + 3]));
        // What stays at zero but for rounding is held against something small.
        let size =
            a.iter().map(|(_, h)| Vector3::from_column_slice(&h[k..k + 3]).norm()).fold(1e-6, f64::max);
        close3(slots[k].name, &(q * va), &vb, LOOSE, size)?;
    }
    Ok(())
}

/// Everything is shifted, and gets the same velocity.
fn galilean(r: &Recipe, path: &Path, d: &mut Draw<'_>) -> Outcome {
    let (shift, velocity) = (d.vector(0.02), d.vector(2.0));
    let moved = path.other(|g| {
        let by = shift + velocity * (g.call.step as f64 * g.call.dt);
        for b in [&mut g.i, &mut g.j] {
            (b.x, b.v) = (b.x + by, b.v + velocity);
        }
    });
    same(path, &undisturbed(r, path), &undisturbed(r, &moved), LOOSE, &|v| *v)
}

/// Another metre, kilogram and second.
fn units(r: &Recipe, path: &Path, _: &mut Draw<'_>) -> Outcome {
    // Even powers of two scale without rounding, half powers included.
    let (m, kg, s) = (2f64.powi(6), 2f64.powi(-4), 2f64.powi(8));
    let of = |u: &Unit| m.sqrt().powi(u.m2.into()) * kg.powi(u.kg.into()) * s.powi(u.s.into());
    let mut other = r.clone();
    for setup in &mut other.setups {
        for (p, values) in setup.law.meta.props.iter().zip(&mut setup.values.of) {
            values.iter_mut().for_each(|v| *v *= of(&p.unit));
        }
    }
    let scaled = path.other(|g| {
        g.call.dt *= s;
        for b in [&mut g.i, &mut g.j] {
            (b.radius, b.mass, b.x) = (b.radius * m, b.mass * kg, b.x * m);
            (b.v, b.omega) = (b.v * (m / s), b.omega / s);
        }
    });
    let (a, b) = (undisturbed(r, path), undisturbed(&other, &scaled));
    let back = |v: &Vector3<f64>| v / of(&Unit::N);
    let b: Answers = b
        .into_iter()
        .map(|(t, h)| {
            let (i, j) = (back(&t.torque_i) / m, back(&t.torque_j) / m);
            (Response { force: back(&t.force), torque_i: i, torque_j: j, ..t }, h)
        })
        .collect();
    // The normal law's fifth root rounds anew.
    same(path, &a, &b, 1e-12, &|v| *v)?;
    for (k, slot) in r.subject().slots.iter().enumerate() {
        let size = a.iter().map(|(_, h)| h[k].abs()).fold(0.0, f64::max);
        let ((_, ha), (_, hb)) = (a.last().unwrap(), b.last().unwrap());
        close(slot.name, ha[k], hb[k] / of(&slot.unit), 1e-12, size)?;
    }
    Ok(())
}

/// The pair's angular momentum stays: lever arm × force and both torques cancel.
fn angular_momentum(r: &Recipe, path: &Path, _: &mut Draw<'_>) -> Outcome {
    let answers = undisturbed(r, path);
    let (_, scale) = peaks(path, &answers);
    for (gap, (s, _)) in path.gaps.iter().zip(&answers).filter(|(g, _)| !g.call.is_wall) {
        let total = gap.delta.cross(&s.force) + s.torque_i + s.torque_j;
        // Round-off of a handful of operations.
        close3("total torque", &total, &Vector3::zeros(), 1e-14, scale)?;
    }
    Ok(())
}

/// Queries between the evaluations change nothing, to the last bit.
fn query(r: &Recipe, path: &Path, d: &mut Draw<'_>) -> Outcome {
    let (strange, types) = (Path::draw(d), path.types);
    let a = undisturbed(r, path);
    let b = follow(r, path, |k, subject, h| {
        // LIGGGHTS asks again where bodies are; a law alone may be asked anything.
        let elsewhere = r.setups.len() == 1 && strange.gaps[k].call.is_wall == path.gaps[k].call.is_wall;
        let mut gap = if elsewhere { strange.gaps[k] } else { path.gaps[k.saturating_sub(1)] };
        gap.call = Call { update: false, counts: false, ..path.gaps[k].call };
        evaluate(subject, types, &gap, h);
    });
    if a.iter().zip(&b).any(|((_, a), (_, b))| a != b) {
        return Err("queries changed the history".into());
    }
    same(path, &a, &b, 0.0, &|v| *v)
}

/// Separation clears the history.
fn clears(r: &Recipe, path: &Path, _: &mut Draw<'_>) -> Outcome {
    let answers = undisturbed(r, path);
    let mut open = path.gaps.iter().zip(&answers).filter(|(g, _)| g.rsq.sqrt() > g.i.radius + g.j.radius);
    match open.find(|(_, (_, h))| h.iter().any(|h| *h != 0.0)) {
        None => Ok(()),
        Some((g, _)) => Err(format!("history is kept across a gap in step {}", g.call.step)),
    }
}

/// Whatever comes in, the law answers.
fn survives(r: &Recipe, path: &Path, d: &mut Draw<'_>) -> Outcome {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, f64::MAX][(d.unit() * 5.0) as usize];
    let (at, k) = ((d.unit() * STEPS as f64) as usize, (d.unit() * 14.0) as usize);
    let mut spoilt = path.clone();
    let g = &mut spoilt.gaps[at];
    let fields = [
        &mut g.i.x.x,
        &mut g.i.v.y,
        &mut g.i.omega.z,
        &mut g.i.radius,
        &mut g.i.mass,
        &mut g.j.x.y,
        &mut g.j.v.x,
        &mut g.j.omega.x,
        &mut g.j.radius,
        &mut g.j.mass,
        &mut g.call.dt,
        &mut g.delta.x,
        &mut g.rsq,
        &mut g.meff,
    ];
    if let Some(field) = fields.into_iter().nth(k) {
        *field = bad;
    }
    let run = || undisturbed(r, &spoilt);
    catch_unwind(AssertUnwindSafe(run)).map(drop).map_err(|_| format!("panics on {bad} in place {k}"))
}

fn laws() -> Vec<Laws> {
    let beyond = LAWS.iter().filter(|e| e.meta.reach == Reach::Beyond);
    beyond
        .flat_map(|m| {
            let [before, after] = [chain_of(&["hertz"]), chain_of(&["history"])];
            [vec![m], vec![before[0], m, after[0]]]
        })
        .collect()
}

type Along = fn(&Recipe, &Path, &mut Draw<'_>) -> Outcome;

fn asked(laws: &Laws, switches: Switches, fault: Option<Fault>, rule: Along) -> Outcome {
    for_all_of(laws, switches, CASES, fault, DRAWS, |r, d| rule(r, &Path::draw(d), d))
}

fn everywhere(rule: Along) {
    assert!(!laws().is_empty());
    for laws in laws() {
        asked(&laws, Switches::Any, None, rule).unwrap_or_else(|e| panic!("{}: {e}", names(&laws)));
    }
}

#[test]
fn the_frame_moves_on_the_way() {
    everywhere(galilean);
}

#[test]
fn numbers_that_are_none_do_no_harm_on_the_way() {
    everywhere(survives);
}

const DECLARED: [(Rule, Along); 6] = [
    (Rule::PartnersSwap, swap),
    (Rule::AngularMomentum, angular_momentum),
    (Rule::FrameTurns, rotation),
    (Rule::UnitsScale, units),
    (Rule::QueryLeavesHistory, query),
    (Rule::ApartClearsHistory, clears),
];

/// Rules hold unless the law says that it breaks them, and then it does.
#[test]
fn rules_hold_or_are_declared_broken() {
    for laws in laws() {
        for (rule, check) in DECLARED {
            let declared =
                laws.iter().any(|e| e.meta.reach == Reach::Beyond && e.meta.exception(rule).is_some());
            let outcome = asked(&laws, Switches::Any, None, check);
            assert_eq!(outcome.is_err(), declared, "{rule:?} of {}: {outcome:?}", names(&laws));
        }
    }
}

/// The documented convention of the bond breaks none but the one that no bond can keep.
#[test]
fn the_documented_bond_keeps_the_rules() {
    for laws in laws().into_iter().filter(|l| l.iter().any(|e| e.meta.keyword == "bond/nonlinear")) {
        for (rule, check) in DECLARED.into_iter().filter(|(r, _)| *r != Rule::ApartClearsHistory) {
            asked(&laws, Switches::With("bondConvention", "documented"), None, check)
                .unwrap_or_else(|e| panic!("{rule:?} of {}: {e}", names(&laws)));
        }
    }
}

/// Each slot of history that the settings call for comes to hold something.
#[test]
fn every_slot_is_written_on_the_way() {
    for laws in laws() {
        let seen = RefCell::new(std::collections::BTreeMap::new());
        for_all_of(&laws, Switches::Any, CASES, None, DRAWS, |r, d| {
            let path = Path::draw(d);
            let answers = undisturbed(r, &path);
            for (k, slot) in r.subject().slots.iter().enumerate() {
                *seen.borrow_mut().entry(slot.name).or_insert(false) |=
                    answers.iter().any(|(_, h)| h[k] != 0.0);
            }
            Ok(())
        })
        .unwrap();
        let seen = seen.into_inner();
        let all: usize = laws.iter().map(|e| e.meta.slots.len()).sum();
        assert_eq!(seen.len(), all, "{}", names(&laws));
        assert!(seen.values().all(|s| *s), "{}: {seen:?}", names(&laws));
    }
}

/// The rule, asked with the fault, must fail with these words.
fn seen_by(fault: Fault, rule: Along, words: &str) {
    let laws = chain_of(&["bond/nonlinear"]);
    let switches = Switches::With("bondConvention", "documented");
    asked(&laws, switches, None, rule).expect("holds without the fault");
    let error = asked(&laws, switches, Some(fault), rule).expect_err("not seen");
    assert!(error.contains(words), "{words:?} is not in: {error}");
}

#[test]
fn planted_faults_are_seen_on_the_way() {
    seen_by(Fault::Beyond(|_, _, s| s.torque_j *= 1.0001), swap, "torque");
    seen_by(Fault::Beyond(|x, h, _| h[3] = if x.i.tag < x.j.tag { h[3] } else { -h[3] }), swap, "");
    seen_by(Fault::Beyond(|_, _, s| s.force.x *= 1.0001), rotation, "force");
    seen_by(Fault::Beyond(|_, h, _| h[9] *= 1.0001), rotation, "thetat");
    seen_by(Fault::Beyond(|x, _, s| s.force += x.i.v * 1e-3), galilean, "force");
    seen_by(Fault::Beyond(|_, _, s| s.force.y += 1e-6), units, "force");
    seen_by(Fault::Beyond(|_, _, s| s.torque_i *= 1.0001), angular_momentum, "total torque");
    seen_by(Fault::Beyond(|x, h, _| h[2] -= if x.call.update { 0.0 } else { 1e-12 }), query, "history");
    seen_by(Fault::Beyond(|x, _, _| assert!(!x.i.v.y.is_nan(), "planted")), survives, "panics");
}
