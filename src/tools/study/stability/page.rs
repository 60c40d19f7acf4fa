//! The study as a document: maps with borders, tables of limits, agreement with LIGGGHTS.
use super::cell::Class;
use super::in_liggghts::{agreement, Agreement};
use super::mapped::{Mapped, Study};
use super::row::Scene;
use super::Options;
use crate::report::page::{Border, Cell, Item, Map, Page, Scale, Section, Spot, Table};
use crate::report::{Check, Outcome, Shows, Tolerance, Worst};
use crate::study::about::{about, ran};
use std::f64::consts::PI;

/// Fraction of all places at which LIGGGHTS must agree with our simulation; further than 10 % from a border all must.
const SHARE: f64 = 0.95;
/// The least number of places at which LIGGGHTS must have run.
const PLACES: usize = 30;

pub(super) fn page(study: &Study, options: &Options) -> Page {
    let programs = about(&options.command, options.bench.as_ref());
    let mut sections = vec![limits(study)];
    sections.extend(study.mapped.iter().map(field));
    sections.push(asked(study));
    let n = agreement(study.mapped.iter().flat_map(|m| &m.asked));
    let whole = options.only.is_empty();
    let mut all = if options.bench.is_ok() { checks(n, whole) } else { Vec::new() };
    all.push(ran(options.bench.as_ref(), &study.trouble));
    Page {
        program: "granlaw stability".into(),
        headline: headline(study, n),
        about: programs,
        checks: all,
        sections,
    }
}

fn headline(study: &Study, n: Agreement) -> String {
    let live = match n.all {
        0 => String::new(),
        _ => format!("; LIGGGHTS does the same at {} of {} places", n.agree, n.all),
    };
    let silent =
        study.mapped.iter().flat_map(|m| m.classes()).filter(|c| *c == Class::CreatesSilently).count();
    format!("energy is created at {silent} places of the maps where LIGGGHTS's own check is silent{live}")
}

impl Mapped {
    fn classes(&self) -> impl Iterator<Item = Class> + '_ {
        let n = self.steps.len();
        self.cells
            .iter()
            .enumerate()
            .map(move |(k, found)| self.field.rows[k / n].class(self.steps[k % n], found))
    }

    /// The smallest and the largest onset of the field, in units of π/ω.
    fn onsets(&self) -> Option<(f64, f64)> {
        let rows = self.field.rows.iter().zip(&self.onset);
        let in_pi = rows.filter_map(|(row, o)| Some((*o)? * in_pi(row)));
        in_pi.fold(None, |range, o| match range {
            None => Some((o, o)),
            Some((low, high)) => Some((f64::min(low, o), f64::max(high, o))),
        })
    }

    /// The shortest step at which the energy doubles anywhere on the map, in units of π/ω.
    fn doubled(&self) -> Option<f64> {
        let n = self.steps.len();
        let first = |(k, row): (usize, &super::Row)| {
            let bad = |f: &super::Found| f.energy > 2.0 || !f.finite;
            let at = self.cells[k * n..(k + 1) * n].iter().position(bad)?;
            Some(self.steps[at] * in_pi(row))
        };
        self.field.rows.iter().enumerate().filter_map(first).reduce(f64::min)
    }

    /// The longest step up to which the error of the measured quantity is below a limit in all rows, in units of π/ω.
    fn accurate(&self, limit: f64) -> Option<f64> {
        let n = self.steps.len();
        let good =
            |k: usize| self.cells.iter().skip(k).step_by(n).all(|f| f.error < limit && f.energy < 1.01);
        let k = (0..n).take_while(|k| good(*k)).last()?;
        Some(self.steps[k] * 2.0 / PI)
    }
}

fn limits(study: &Study) -> Section {
    let columns = [
        "map",
        "linear theory",
        "energy created from",
        "to",
        "largest simple bound c",
        "energy doubled from",
        "error below 10 % up to",
        "below 1 % up to",
        "cells created silently",
    ];
    let row = |m: &Mapped| -> Vec<Cell> {
        let number = |x: Option<f64>| x.map_or("never".into(), Cell::Number);
        let onsets = m.onsets();
        // Of a sphere at rest only the energy is measured.
        let at_rest =
            matches!(m.field.rows[0].scene, Scene::RestNormal | Scene::RestTangential | Scene::Bonded(_));
        let accurate = |limit| if at_rest { "–".into() } else { number(m.accurate(limit)) };
        let silent = m.classes().filter(|c| *c == Class::CreatesSilently).count();
        let theory = m.field.rows.iter().map(|r| theory(r) * in_pi(r)).fold(f64::INFINITY, f64::min);
        vec![
            m.field.title.into(),
            theory.into(),
            number(onsets.map(|o| o.0)),
            number(onsets.map(|o| o.1)),
            onsets.map_or("none needed".into(), |o| Cell::Number((100.0 * o.0).floor() / 100.0)),
            number(m.doubled()),
            accurate(0.1),
            accurate(0.01),
            Cell::Count(silent as u64),
        ]
    };
    let table = Table {
        name: "limits".into(),
        caption: "Longest steps, in units of π/ω of the stiffest normal mode that the contact reaches".into(),
        columns: columns.map(String::from).to_vec(),
        rows: study.mapped.iter().map(row).collect(),
    };
    let text = "A step of dt = c π/ω, with the largest simple bound c of the map, creates no energy anywhere on it. Linear theory is the \
                smallest critical step on the map of a linear oscillator with the stiffest mode, normal or tangential, damping \
                included; an impact takes few steps there, so it fails sooner and otherwise than an oscillator does. Where nothing \
                takes energy out (e = 1), created means that the restitution comes out above 1.005. ω is that of the stiffest normal mode; of bonds, of \
                the fastest mode, compression taken at the speed of the blows, and of a chain all of it. Bonds that neither take damage (ku = k) \
                nor are damped climb slowly at any step.";
    Section {
        title: "How long a step may be".into(),
        text: vec![text.into()],
        items: vec![Item::Table(table)],
    }
}

/// The unit of a row over π/ω of its stiffest normal mode, or for bonds of their fastest mode.
fn in_pi(row: &super::Row) -> f64 {
    match row.scene {
        Scene::Bonded(_) => row.unit() / row.tangential.step_centred() * 2.0 / PI,
        _ => 2.0 / PI,
    }
}

/// The critical step of linear theory over the unit of a row.
fn theory(row: &super::Row) -> f64 {
    let centred = row.matter.settings.iter().any(|(n, o)| *n == "centredDamping" && *o == "on");
    let step = |m: &granlaw::model::Mode| if centred { m.step_centred() } else { m.step() };
    let normal = step(&row.normal) / row.unit();
    let tangential = step(&row.tangential) / row.unit();
    match row.scene {
        Scene::Impact | Scene::RestNormal => normal,
        Scene::RestTangential | Scene::Bonded(_) => tangential,
        _ => normal.min(tangential),
    }
}

fn field(m: &Mapped) -> Section {
    let f = &m.field;
    let params: Vec<f64> = f.rows.iter().map(|r| r.param).collect();
    let line = |name: &str, at: &dyn Fn(usize) -> f64| Border {
        name: name.into(),
        points: (0..f.rows.len()).map(|k| (at(k), f.rows[k].param)).collect(),
    };
    let mut borders = vec![
        line("linear theory", &|k| theory(&f.rows[k])),
        line("LIGGGHTS warns beyond (0.2, 0.2)", &|k| f.rows[k].warns / f.rows[k].unit()),
        line("energy created beyond", &|k| m.onset[k].unwrap_or(f64::NAN)),
    ];
    borders.retain(|b| b.points.iter().any(|p| p.0.is_finite()));
    let words = Class::ALL.iter().map(|c| word(*c, f.rows[0].scene).to_string()).collect();
    let spot = |a: &super::Asked| Spot {
        x: a.place.step,
        y: f.rows[a.place.row].param,
        agrees: a.ours == a.theirs,
        label: format!(
            "dt = {:.3} units, {} = {:.3}: {} in LIGGGHTS, {} here",
            a.place.step,
            f.label,
            f.rows[a.place.row].param,
            word(a.theirs, f.rows[0].scene),
            word(a.ours, f.rows[0].scene)
        ),
    };
    let values =
        |name: &str, of: &dyn Fn(&super::Found) -> f64| (name.to_string(), m.cells.iter().map(of).collect());
    let map = Map {
        name: format!("stability-{}", f.name),
        caption: format!("What becomes of it ({})", f.name),
        x: Scale {
            label: match f.rows[0].scene {
                Scene::Bonded(_) | Scene::Hang(_) => "time step over 2/ω of one bond alone [1]",
                _ => "time step over 2/ω of the stiffest normal mode [1]",
            }
            .into(),
            values: m.steps.clone(),
            log: true,
        },
        y: Scale { label: f.label.into(), values: params, log: f.log },
        classes: words,
        cells: m.classes().map(|c| c as usize).collect(),
        values: vec![
            values("mean_error", &|c| c.error),
            values("largest_energy", &|c| c.energy),
            values("share_astray", &|c| c.astray),
            values("share_without_way_out", &|c| c.missed),
        ],
        borders,
        spots: m.asked.iter().map(spot).collect(),
    };
    Section {
        title: f.title.into(),
        text: vec![measured(f.rows[0].scene).into()],
        items: vec![Item::Map(map)],
    }
}

/// What is measured, in words.
fn measured(scene: Scene) -> &'static str {
    match scene {
        Scene::Impact => "Many phases of first touch at three speeds; the mean error of the restitution, and the largest kinetic energy afterwards.",
        Scene::Oblique => "Many phases of first touch at three speeds; the mean error of the final spin, and the largest kinetic energy afterwards.",
        Scene::RestNormal | Scene::RestTangential => "A push too weak to lift the sphere; its energy after 600 steps.",
        Scene::Roll => "A third longer than it should take to stop; the speed that is left, over that of the beginning.",
        Scene::Bonded(_) => "A few thousand steps (a few hundred of straight bonds); the largest kinetic energy on the way, over that of the beginning. LIGGGHTS is Debian's, with the law in the plugin.",
        Scene::Hang(_) => "200 half periods; the speed that is left, over that at which it falls through its place at first. LIGGGHTS is Debian's, with the law in the plugin.",
    }
}

/// A class in words.
fn word(class: Class, scene: Scene) -> &'static str {
    match (class, scene) {
        (Class::Fine, Scene::RestNormal | Scene::RestTangential) => "stays at rest",
        (Class::Fine, Scene::Bonded(_)) => "no energy created",
        (Class::Fine, Scene::Roll | Scene::Hang(_)) => "less than 1e-4 of the speed left",
        (Class::Rough, Scene::Roll | Scene::Hang(_)) => "1e-4 to 1 % left",
        (Class::Wrong, Scene::Roll | Scene::Hang(_)) => "more left",
        (Class::Fine, _) => "error below 1 %",
        (Class::Rough, _) => "error 1 % to 10 %",
        (Class::Wrong, _) => "error above 10 %",
        (Class::Creates, _) => "energy created, LIGGGHTS warns",
        (Class::CreatesSilently, _) => "energy created, LIGGGHTS silent",
        (Class::BlowsUp, _) => "blows up (× 100, or NaN)",
    }
}

fn asked(study: &Study) -> Section {
    let columns = ["map", "parameter", "dt over the unit", "here", "in LIGGGHTS", "within 10 % of a border"];
    let rows = study.mapped.iter().flat_map(|m| {
        m.asked.iter().map(move |a| {
            let scene = m.field.rows[0].scene;
            vec![
                m.field.name.into(),
                m.field.rows[a.place.row].param.into(),
                a.place.step.into(),
                word(a.ours, scene).into(),
                word(a.theirs, scene).into(),
                if a.near { "yes" } else { "no" }.into(),
            ]
        })
    });
    let table = Table {
        name: "asked".into(),
        caption: "What LIGGGHTS was asked, on both sides of the borders that our simulation finds".into(),
        columns: columns.map(String::from).to_vec(),
        rows: rows.collect(),
    };
    Section { title: "LIGGGHTS asked".into(), text: Vec::new(), items: vec![Item::Table(table)] }
}

fn checks(n: Agreement, whole: bool) -> Vec<Check> {
    let check = |name: &str, got: usize, of: usize, limit: f64, reason: &str| {
        let share = if of == 0 { 0.0 } else { got as f64 / of as f64 };
        let outcome = match () {
            _ if of == 0 => Outcome::Skipped("LIGGGHTS was asked at no such place".into()),
            _ if share >= limit => Outcome::Agreed,
            _ => Outcome::Disagreed(format!("{got} of {of}")),
        };
        let worst = Worst {
            step: 0,
            what: format!("{got} of {of} places"),
            got: share,
            expected: limit,
            error: 1.0 - share,
            norm: "share that differs".into(),
        };
        let tolerance = Some(Tolerance { limit: 1.0 - limit, reason: reason.into() });
        Check { name: name.into(), shows: Shows::Integrator, outcome, tolerance, worst: Some(worst) }
    };
    let far = "a pair moves bit for bit as in LIGGGHTS, but for the round-off of its place in a larger box";
    let near = "on a border that round-off may turn";
    let mut all = vec![
        check("outcome away from borders", n.far_agree, n.far, 1.0, far),
        check("outcome anywhere", n.agree, n.all, SHARE, near),
    ];
    if whole {
        all.push(check("places away from borders", n.far, PLACES.max(n.far), 1.0, "fewer would show little"));
    }
    all
}
