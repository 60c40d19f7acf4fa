//! Advice as a document: what to put into the deck, the ladder of models, the classes, the histograms, the proofs.
use super::ladder::Candidate;
use super::lines::{number, percent};
use super::{terminal, Found};
use crate::probe::{Histogram, Probe, Sample, TypePair};
use crate::report::page::{Cell, Chart, Item, Mark, Page, Section, Spread, Table, Trend};
use crate::report::{About, Check, Outcome, Shows, Tolerance, Worst};

/// The document. `probe` is that of the deck.
pub fn page(found: &Found, probe: &Probe, about: About) -> Page {
    let mut sections = vec![advice(found), ladder(found), classes(found), contacts(probe), bulk(probe)];
    sections.extend(found.check.as_ref().map(|_| whole(found)));
    sections.extend(found.fresh.as_ref().map(|_| fresh(found)));
    Page {
        program: "granlaw advise".into(),
        headline: headline(found),
        about,
        checks: checks(found),
        sections,
    }
}

fn headline(found: &Found) -> String {
    let a = &found.advice;
    match a.chosen.map(|k| &a.ladder[k]) {
        None => format!("{}: no model that was tried is within {}", a.deck, percent(a.options.accuracy)),
        Some(_) if a.lines.is_empty() => format!("{}: keep the deck as it is", a.deck),
        Some(r) => format!("{}: {}, {}", a.deck, named(r), terminal::gain(r)),
    }
}

fn named(r: &Candidate) -> String {
    let step = r.step.map_or(String::new(), |s| format!(" with a step of {} s", number(s)));
    format!("{}{step}", if r.changes.is_empty() { "the laws as they are".into() } else { r.name() })
}

fn table(name: &str, caption: &str, columns: &[&str], rows: Vec<Vec<Cell>>) -> Item {
    let columns = columns.iter().map(|c| (*c).into()).collect();
    Item::Table(Table { name: name.into(), caption: caption.into(), columns, rows })
}

fn advice(found: &Found) -> Section {
    let a = &found.advice;
    let lines = a.lines.iter().map(|l| vec![l.text.clone().into(), l.place.clone().into()]).collect();
    let terms = a.terms.iter().map(|t| {
        vec![
            t.who.clone().into(),
            t.term.clone().into(),
            t.dissipated.into(),
            t.impulse.into(),
            t.turn.into(),
        ]
    });
    let rows = terms.collect();
    Section {
        title: "Advice".into(),
        text: a.reasons.clone(),
        items: vec![
            table("lines", "What to put into the deck", &["line", "where"], lines),
            table(
                "terms",
                "What each term contributes: shares of the work dissipated, of the momentum exchanged, of torques",
                &["chain", "term", "dissipates", "momentum", "torque"],
                rows,
            ),
        ],
    }
}

/// Error over cost of the models. The deck's own is ringed, and so are those that no other beats in both.
fn ladder(found: &Found) -> Section {
    let a = &found.advice;
    let error = |r: &Candidate| r.model.worst.map_or(f64::NAN, |w| w.1);
    let beaten = |r: &Candidate| {
        let better = |o: &&Candidate| {
            error(o) <= error(r) && o.cost <= r.cost && (error(o), o.cost) != (error(r), r.cost)
        };
        a.ladder.iter().any(|o| better(&o))
    };
    let trend = |name: &str, of: &dyn Fn(&Candidate) -> bool| Trend {
        name: name.into(),
        joined: false,
        marks: a
            .ladder
            .iter()
            .filter(|r| of(r) && r.cost.is_finite() && error(r).is_finite())
            .map(|r| Mark {
                label: r.name(),
                x: Spread::exact(r.cost),
                // Zero has no place on a logarithmic axis.
                y: Spread::exact(error(r).max(1e-6)),
                front: !beaten(r),
            })
            .collect(),
        ..Trend::default()
    };
    let chart = Chart {
        name: "ladder".into(),
        caption:
            "The ladder of models: worst error of all classes in very small steps, over the cost of the laws"
                .into(),
        x: "evaluating the laws [ns per contact]".into(),
        y: "worst error".into(),
        trends: vec![trend("good enough", &|r| r.holds), trend("not good enough", &|r| !r.holds)],
    };
    let rows = a.ladder.iter().enumerate().map(|(k, r)| {
        let worst = |t: &Option<(&str, f64, usize)>| -> [Cell; 3] {
            match t {
                Some((what, size, class)) => {
                    [(*size).into(), (*what).into(), a.groups[*class].name.clone().into()]
                }
                None => ["-".into(), "".into(), "".into()],
            }
        };
        let sign = if a.chosen == Some(k) {
            "advised"
        } else if r.holds {
            "good enough"
        } else {
            "not good enough"
        };
        let mut row: Vec<Cell> = vec![r.name().into(), sign.into()];
        row.extend(worst(&r.model.worst));
        row.extend([r.step, Some(r.cost).filter(|c| c.is_finite()), r.predicted].map(known));
        row
    });
    let columns = [
        "model",
        "",
        "worst error",
        "of",
        "class",
        "largest step [s]",
        "cost [ns]",
        "time relative to the deck",
    ];
    let text = match a.groups.len() {
        0 => "Nothing could be tried; the deck stays as it is.".into(),
        n => format!(
            "Each model was tried on {n} classes of contacts; it is good enough if no error is above {}.",
            percent(a.options.accuracy)
        ),
    };
    Section {
        title: "Models".into(),
        text: vec![text],
        items: vec![Item::Chart(chart), table("models", "All models on trial", &columns, rows.collect())],
    }
}

/// A cell with a number, or an empty one.
fn known(x: Option<f64>) -> Cell {
    x.map_or("-".into(), Cell::from)
}

fn classes(found: &Found) -> Section {
    let a = &found.advice;
    let at_step = a.chosen.and_then(|k| a.ladder[k].at_step.as_ref());
    let rows = a.groups.iter().enumerate().map(|(k, g)| {
        let (what, size) = at_step.map_or(("", f64::NAN), |t| t.errors[k].worst(a.options.time));
        let shares = [g.count, g.impulse, g.dissipated, size].map(Cell::from);
        [Cell::from(g.name.clone())].into_iter().chain(shares).chain([what.into()]).collect()
    });
    let columns = ["class", "of impacts", "of momentum", "of dissipation", "worst error of the advice", "of"];
    Section {
        title: "Classes of contacts".into(),
        text: Vec::new(),
        items: vec![table(
            "classes",
            "The classes that count, and the advised model in the advised step",
            &columns,
            rows.collect(),
        )],
    }
}

/// One histogram, summed over the pairs of types of a chain.
type Of = fn(&TypePair) -> &Histogram;

fn contacts(probe: &Probe) -> Section {
    let all: [(&str, &str, Of); 7] = [
        ("impact speed", "normal speed at first touch [m/s]", |p| &p.impact_speed),
        ("restitution", "normal speed after over before", |p| &p.restitution),
        ("overlap", "largest overlap of a contact, over R*", |p| &p.overlap),
        ("duration", "steps that a contact lasted", |p| &p.steps),
        ("limit", "largest use of a law's own limit, such as δmax/δlim", |p| &p.load),
        ("bonds", "use of its limit by a bond across a gap, in each step", |p| &p.gaps.load),
        ("friction", "tangential over normal force", |p| &p.friction),
    ];
    let chains = probe.principal();
    let chart = |(name, x, of): (&str, &str, Of)| {
        let trends = chains.iter().flat_map(|c| c.pairs.iter().map(move |p| (c, p))).filter_map(|(c, p)| {
            let marks: Vec<_> = of(p)
                .bins()
                .map(|b| Mark {
                    label: format!("{} to {}", number(b.from), number(b.to)),
                    x: Spread { at: (b.from * b.to).sqrt(), low: b.from, high: b.to },
                    y: Spread::exact(b.count as f64),
                    front: false,
                })
                .collect();
            let note = of(p).mean().map_or(String::new(), |m| format!("mean {}", terminal::digits(m)));
            let name = format!("{} {}-{}", c.header.who, p.types[0], p.types[1]);
            (!marks.is_empty()).then_some(Trend { name, note, joined: true, marks, ..Trend::default() })
        });
        let chart = Chart {
            name: name.into(),
            caption: format!("How often: {x}"),
            x: x.into(),
            y: "contacts".into(),
            trends: trends.collect(),
        };
        (!chart.trends.is_empty()).then_some(Item::Chart(chart))
    };
    let items = all.into_iter().filter_map(chart).collect();
    Section { title: "What the contacts do".into(), text: Vec::new(), items }
}

fn bulk(probe: &Probe) -> Section {
    let trend = |name: &str, of: &dyn Fn(&Sample) -> f64| Trend {
        name: name.into(),
        joined: true,
        marks: probe
            .bulk
            .samples
            .iter()
            .map(|s| Mark { x: Spread::exact(s.time), y: Spread::exact(of(s)), ..Mark::default() })
            .collect(),
        ..Trend::default()
    };
    let chart = Chart {
        name: "energy".into(),
        caption: "Kinetic energy of the scene over time".into(),
        x: "time [s]".into(),
        y: "energy [J]".into(),
        trends: vec![trend("translation", &|s| s.kinetic), trend("spin", &|s| s.rotational)],
    };
    Section { title: "The scene".into(), text: Vec::new(), items: vec![Item::Chart(chart)] }
}

fn whole(found: &Found) -> Section {
    let Some(c) = &found.check else { return Section::default() };
    let rows = c.observables.iter().map(|o| {
        let scatter = o.scatter.map_or("not run".into(), Cell::from);
        vec![o.name.into(), o.difference.into(), c.bound.into(), scatter, o.meaning.into()]
    });
    let times = vec![
        vec!["deck [s]".into(), c.seconds[0].into()],
        vec!["advised [s]".into(), c.seconds[1].into()],
        vec!["measured, relative".into(), c.measured().into()],
        vec!["predicted, relative".into(), known(c.predicted)],
    ];
    let columns = ["observable", "difference", "bound", "by chance", "how it is meant"];
    let deck = c.advised.lines().map(|l| vec![Cell::from(l)]).collect();
    Section {
        title: "The whole scene, deck against advised deck".into(),
        text: vec![format!(
            "Each deck ran {} time{}, with other seeds; \"by chance\" is what as many runs of the deck differ from as many others.",
            c.runs,
            if c.runs == 1 { "" } else { "s" },
        )],
        items: vec![
            table("observables", "Bulk observables", &columns, rows.collect()),
            table("times", "Wall-clock time of plain runs", &["", "time"], times),
            table("advised deck", "The advised deck", &["line"], deck),
        ],
    }
}

fn fresh(found: &Found) -> Section {
    let Some(f) = &found.fresh else { return Section::default() };
    let time = found.advice.options.time;
    let rows = f.classes.iter().map(|c| {
        let (what, size) = c.errors.worst(time);
        vec![
            c.name.clone().into(),
            size.into(),
            what.into(),
            if c.within { "within" } else { "outside" }.into(),
        ]
    });
    Section {
        title: format!("Fresh contacts of a run with {}", f.run),
        text: vec![terminal::tallied(f)],
        items: vec![table(
            "fresh",
            "The advised model on them",
            &["class", "worst error", "of", ""],
            rows.collect(),
        )],
    }
}

fn checks(found: &Found) -> Vec<Check> {
    let outcome = |good: bool, why: String| if good { Outcome::Agreed } else { Outcome::Disagreed(why) };
    let mut all = Vec::new();
    for (o, c) in found.check.iter().flat_map(|c| c.observables.iter().map(move |o| (o, c))) {
        let why = format!("{} apart, {} allowed", percent(o.difference), percent(c.bound));
        let worst = Worst {
            step: 0,
            what: o.name.into(),
            got: o.difference,
            expected: 0.0,
            error: o.difference,
            norm: o.meaning.into(),
        };
        all.push(Check {
            name: o.name.into(),
            shows: Shows::Physics,
            outcome: outcome(o.within(c.bound), why),
            tolerance: Some(Tolerance { limit: c.bound, reason: "the bound that was asked for".into() }),
            worst: Some(worst),
        });
    }
    all.extend(found.fresh.as_ref().map(|f| Check {
        name: "fresh contacts".into(),
        shows: Shows::Physics,
        outcome: outcome(f.holds(), terminal::tallied(f)),
        tolerance: None,
        worst: None,
    }));
    all
}
