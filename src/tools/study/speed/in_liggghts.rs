//! Runs the same collisions in LIGGGHTS, and measures the cost of a contact there, in a bed of many.
use super::bonds::{calls, steps};
use super::case::{Case, Measure};
use super::costs::quartiles;
use super::curves::{judge, phases, worth, Curve, STEPS};
use super::found::{Found, PerStep, Study};
use super::methods::{Method, Runner};
use crate::report::page::Spread;
use crate::study::collision::Outcome;
use crate::study::in_liggghts::{Bench, LiveError, Who};
use crate::study::matter::{Matter, Names};
use granlaw::model::Kind;
use rayon::prelude::*;

const METHODS: [(Method, Who); 3] =
    [(Method::Stock, Who::Stock), (Method::Plugin, Who::TakenOver), (Method::PluginTimed, Who::Own)];

/// The methods that can run these laws. Laws that LIGGGHTS lacks run on our own alone, and without settings that they do not have.
fn ways(matter: &Matter) -> impl Iterator<Item = (Method, Who)> {
    let lacks = matter.needs_ours();
    let all = METHODS.into_iter().filter(move |(m, _)| !lacks || *m == Method::Plugin);
    all.map(move |(m, who)| (m, if lacks { Who::Own } else { who }))
}

/// The law that a case is about: its bond, or its normal law.
fn about(matter: &Matter) -> &'static str {
    let bond = matter.laws.iter().find(|(kind, _)| *kind == Kind::Cohesion);
    bond.unwrap_or(&matter.laws[0]).1
}

/// Steps per contact, unless the study is full.
const FEW: [f64; 9] = [12.0, 25.0, 100.0, 200.0, 400.0, 800.0, 1600.0, 3200.0, 6400.0];

/// Spheres along an edge of the bed, four per cell.
const CELLS: usize = 8;
/// Blocks of steps that are timed.
const BLOCKS: usize = 9;
const BLOCK: usize = 40;
/// Phases of the end of a row's swing.
const ENDS: usize = 5;

/// Adds curves, costs and trouble to the study.
pub fn add(bench: &Bench, study: &mut Study, count: usize, full: bool, done: &(dyn Fn(&str) + Sync)) {
    // Nothing else runs while this is timed.
    study.per_step = costs(bench, study);
    done("cost per contact in LIGGGHTS");
    let steps = if full { &STEPS[..] } else { &FEW };
    let jobs: Vec<(usize, Method, Who)> = (0..study.found.len())
        .flat_map(|c| ways(&study.found[c].case.matter).map(move |(m, w)| (c, m, w)))
        .collect();
    let found = &study.found;
    let per_step = &study.per_step;
    let curves: Vec<_> = jobs
        .into_par_iter()
        .map(|(c, method, who)| {
            let curve = curve(bench, &found[c], (method, who), per_step, steps, count);
            if method == Method::PluginTimed {
                done(&format!("{} in LIGGGHTS", found[c].case.name));
            }
            (c, curve)
        })
        .collect();
    for (c, curve) in curves {
        match curve {
            Ok((curve, apart)) => {
                study.apart = Some(study.apart.unwrap_or(0.0).max(apart));
                study.found[c].curves.push(curve);
            }
            Err(e) => study.trouble.push(format!("{}: {e}", study.found[c].case.name)),
        }
    }
}

/// A curve, and how far LIGGGHTS is from our own integration of the same collisions.
fn curve(
    bench: &Bench,
    found: &Found,
    (method, who): (Method, Who),
    per_step: &[PerStep],
    few: &[f64],
    count: usize,
) -> Result<(Curve, f64), LiveError> {
    let Found { case, truth, .. } = found;
    let duration = truth.outcome.duration;
    let matter = method.matter(case);
    let ours = if method == Method::PluginTimed { Method::VerletTimed } else { Method::Verlet };
    let mut runner = Runner::new(ours, case, truth).expect("our own scheme does every case");
    let law = about(&case.matter);
    let each = per_step.iter().find(|p| p.law == law && p.method == method).map(|p| p.cost);
    let (mut points, mut apart) = (Vec::new(), 0.0f64);
    for n in few.iter().filter(|n| worth(case, **n)) {
        // All phases are in one run of LIGGGHTS, and so have the same step. As only the phases of first touch spread the ends of the
        // contacts, the step is chosen so that a contact is not a whole number of steps.
        let n = n + 0.37;
        let dt = duration / n;
        let count = if case.collision.rest.is_some() { 1 } else { count };
        let mut outcomes = Vec::new();
        if case.collision.row().is_some() {
            // A bond begins at a step, so only the end of its swing has phases.
            let ends = if case.measure == Measure::Spin { 1 } else { ENDS };
            for (_, more) in phases(ends) {
                let o = bench
                    .collide(&matter, &[case.collision], who, steps(case, duration, n + more), &[0.0])?
                    .remove(0);
                apart = apart.max(difference(case, &o, &runner.run(n + more, 0.0, false)));
                outcomes.push(o);
            }
        } else {
            let before: Vec<f64> = phases(count).map(|(before, _)| before).collect();
            // The run goes on for three contact times after the last first touch; a contact that is not over by then is taken as it is.
            let steps = case.collision.rest.map_or(3.0 * n, |r| r.time / dt) as u64;
            outcomes = bench.collide(&matter, &[case.collision], who, (dt, steps), &before)?;
            for (o, b) in outcomes.iter().zip(&before) {
                apart = apart.max(difference(case, o, &runner.run(n, *b, false)));
            }
        }
        let calls = n * calls(case);
        let cost = each.map_or(Spread::exact(f64::NAN), |c| Spread {
            at: c.at * calls,
            low: c.low * calls,
            high: c.high * calls,
        });
        points.push(judge(case, truth, n, &outcomes, cost));
    }
    Ok((Curve { method, points }, apart))
}

fn difference(case: &Case, a: &Outcome, b: &Outcome) -> f64 {
    (case.measure.of(a) - case.measure.of(b)).abs() / case.measure.of(b).abs()
}

/// Pair time per contact and step of every normal law, with each method.
fn costs(bench: &Bench, study: &mut Study) -> Vec<PerStep> {
    let mut matters: Vec<(&'static str, Matter)> = Vec::new();
    for found in &study.found {
        let law = about(&found.case.matter);
        if !matters.iter().any(|(l, _)| *l == law) {
            matters.push((
                law,
                found
                    .case
                    .matter
                    .clone()
                    .with("coefficientFriction", 0.5)
                    .with("coefficientRestitution", 0.9),
            ));
        }
    }
    let mut all = Vec::new();
    for (law, matter) in &matters {
        for (method, who) in ways(matter) {
            let matter = if method == Method::PluginTimed { matter.clone().timed() } else { matter.clone() };
            match bed(bench, &matter, who) {
                Ok(times) => all.push(PerStep { law, method, cost: quartiles(times) }),
                Err(e) => study.trouble.push(format!("cost of {law}: {e}")),
            }
        }
    }
    all
}

/// Pair times per contact and step of a sheared lattice with every neighbour in contact, one per block.
fn bed(bench: &Bench, matter: &Matter, who: Who) -> Result<Vec<f64>, LiveError> {
    let names = if who == Who::Own { Names::Own } else { Names::Stock };
    let text = format!(
        "units si\natom_style granular\natom_modify map array\nboundary p p p\nnewton off\ncommunicate single vel yes\n\
         lattice fcc 0.014\nregion box block 0 {CELLS} 0 {CELLS} 0 {CELLS} units lattice\ncreate_box 1 box\n\
         neighbor 0.001 bin\nneigh_modify delay 0\n{}pair_style gran {}{}\npair_coeff * *\ncreate_atoms 1 box\n\
         set group all diameter 0.01 density 2500\nvelocity all ramp vx -0.1 0.1 x 0 0.1\ntimestep 5e-6\n\
         fix move all nve/sphere\nthermo 1000\nthermo_modify lost ignore norm no\n{}",
        matter.properties(),
        matter.models(names),
        matter.switches(names),
        format!("run {BLOCK}\n").repeat(BLOCKS + 1),
    );
    let (_, ran) = bench.start(&text, who)?;
    // The first block warms up.
    let contacts = (4 * CELLS.pow(3) * 6 * BLOCK) as f64;
    Ok(ran.times.iter().skip(1).map(|t| t.pair / contacts).collect())
}
