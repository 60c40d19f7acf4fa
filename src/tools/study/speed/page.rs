//! The study as a document: charts, tables, checks.
use super::claims::{claims, Claim, WITHIN};
use super::curves::{Curve, Reach, ERRORS};
use super::found::{Found, Study};
use super::methods::Method;
use super::Options;
use crate::report::page::{Cell, Chart, Item, Mark, Page, Section, Table, Trend};
use crate::report::{Check, Outcome, Shows, Tolerance, Worst};
use crate::study::about;

/// The errors for which tables and checks are made.
const TARGETS: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-6];

pub(super) fn page(study: &Study, options: &Options) -> Page {
    let about = about::about(&options.command, options.bench.as_ref());
    let mut sections = vec![summary(study)];
    sections.extend(study.found.iter().map(case));
    sections.push(costs(study));
    sections.push(errors(study));
    let mut checks = checks(study);
    checks.push(about::ran(options.bench.as_ref(), &study.trouble));
    let headline = headline(study);
    Page { program: "granlaw speed".into(), headline, about, checks, sections }
}

fn curve(found: &Found, method: Method) -> Option<&Curve> {
    found.curves.iter().find(|c| c.method == method)
}

/// How many times fewer steps the settings need for an error, in LIGGGHTS if it was there.
fn saving(found: &Found, target: f64) -> Option<f64> {
    let reach = |m: Method| Some(curve(found, m)?.reach(target)?.n);
    let live = || Some(reach(Method::Stock)? / reach(Method::PluginTimed)?);
    live().or_else(|| Some(reach(Method::Verlet)? / reach(Method::VerletTimed)?))
}

fn headline(study: &Study) -> String {
    let damped = study.found.iter().filter(|f| f.case.name.starts_with("damped"));
    let least = damped.filter_map(|f| saving(f, 1e-4)).fold(f64::INFINITY, f64::min);
    if least.is_infinite() {
        return format!("speed against accuracy of {} kinds of contact", study.found.len());
    }
    format!("with centredDamping and touchFraction, a restitution to 1e-4 takes {least:.0} times fewer steps, or better")
}

fn summary(study: &Study) -> Section {
    Section {
        title: "What to use".into(),
        text: vec![
            "For an error, the cheapest method and its steps per contact, and how much longer a time step the settings \
             centredDamping and touchFraction of our laws allow inside LIGGGHTS."
                .into(),
            "Costs are those of one contact from first touch to last: in LIGGGHTS its Pair time per contact and step in a bed of \
             2048 spheres, elsewhere the time of our own integration of that contact alone. Errors are means over the phases of \
             first touch within a step, relative to the truth; bars span a tenth to nine tenths of the phases, and the quartiles \
             of the repeated timings."
                .into(),
            "Bonds are in no LIGGGHTS but by our plugin, and have no such settings; their steps are per swing, out and back, and their costs those \
             of all bonds of a chain."
                .into(),
        ],
        items: TARGETS.into_iter().map(|t| Item::Table(reaching(study, t))).collect(),
    }
}

/// For one error: the cheapest method and its step, and what the settings save in LIGGGHTS.
fn reaching(study: &Study, target: f64) -> Table {
    let columns = [
        "case",
        "measured",
        "cheapest",
        "its steps per contact",
        "its cost [µs]",
        "LIGGGHTS: steps per contact",
        "with both settings",
        "times as long a step",
    ];
    let row = |f: &Found| -> Vec<Cell> {
        let mut row: Vec<Cell> = vec![f.case.title.into(), f.case.measure.name().into()];
        let cheapest = f.curves.iter().filter_map(|c| Some((c.method, c.reach(target)?)));
        match cheapest.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost)) {
            Some((method, r)) => row.extend([method.name().into(), steps(method, r), (1e6 * r.cost).into()]),
            None => row.extend(["not reached".into(), "".into(), "".into()]),
        }
        let here = |ways: &[Method]| ways.iter().find_map(|m| curve(f, *m));
        let reach = |c: Option<&Curve>| c.and_then(|c| c.reach(target));
        // Laws that lack the settings have no such column.
        let cell = |c: Option<&Curve>| match (c, reach(c)) {
            (None, _) => "–".into(),
            (Some(_), None) => "not reached".into(),
            (Some(c), Some(r)) => steps(c.method, r),
        };
        let plain = here(&[Method::Stock, Method::Plugin, Method::Verlet]);
        let timed = here(&[Method::PluginTimed, Method::VerletTimed]);
        let times = match (reach(plain), reach(timed)) {
            (Some(p), Some(t)) => longer(p, t),
            _ => "".into(),
        };
        row.extend([cell(plain), cell(timed), times]);
        row
    };
    Table {
        name: format!("for-{target:e}"),
        caption: format!("For an error of {target:e}"),
        columns: columns.map(String::from).to_vec(),
        rows: study.found.iter().map(row).collect(),
    }
}

/// How many times as long a step the settings allow.
fn longer(plain: Reach, timed: Reach) -> Cell {
    match (plain.at_most, timed.at_most) {
        (true, _) => "".into(),
        (false, true) => format!("at least {:.1}", plain.n / timed.n).into(),
        (false, false) => format!("{:.1}", plain.n / timed.n).into(),
    }
}

fn steps(method: Method, reach: Reach) -> Cell {
    let most = if reach.at_most { "at most " } else { "" };
    match method {
        Method::Adaptive => Cell::Text(format!("{most}tolerance {:.0e}", 1.0 / reach.n)),
        _ => Cell::Text(format!("{most}{:.0}", reach.n)),
    }
}

fn case(found: &Found) -> Section {
    let truth = &found.truth;
    let text = format!(
        "Truth: {}, {} = {:.10}; relative error of the truth {:.0e}.",
        truth.source,
        found.case.measure.name(),
        truth.value,
        truth.error
    );
    let mut trends: Vec<Trend> = found.curves.iter().map(|c| trend(found, c)).collect();
    front(&mut trends);
    let chart = Chart {
        name: format!("speed-{}", found.case.name),
        caption: format!("Error of the {} over the cost of a contact", found.case.measure.name()),
        x: "cost of a contact [µs]".into(),
        y: format!("relative error of the {} [1]", found.case.measure.name()),
        trends,
    };
    Section { title: found.case.title.into(), text: vec![text], items: vec![Item::Chart(chart)] }
}

fn trend(found: &Found, curve: &Curve) -> Trend {
    let mark = |p: &super::Point| Mark {
        label: match curve.method {
            Method::Adaptive => format!("tolerance {:.0e}, error {:.2e}", 1.0 / p.n, p.error.at),
            _ => format!("{:.0} steps per contact, error {:.2e}", p.n, p.error.at),
        },
        x: scaled(p.cost, 1e6),
        y: p.error,
        front: false,
    };
    let claim = Claim::of(&found.case, curve.method);
    let order = curve.order(claim.map_or(100.0, |c| c.from), floor(found));
    let claimed = claim.map(|c| format!(", claimed {}", c.order));
    let note = match order {
        Some(o) => format!("order {o:.2}{}", claimed.unwrap_or_default()),
        None if curve.method == Method::Adaptive => "by its tolerance".into(),
        None => "no clean order".into(),
    };
    let marks = curve.points.iter().filter(|p| p.cost.at.is_finite()).map(mark).collect();
    let look = Some(curve.method as usize);
    Trend { name: curve.method.name().into(), note, joined: curve.points.len() > 1, look, marks }
}

/// Below this an error does not depend on the method.
fn floor(found: &Found) -> f64 {
    found.truth.error.max(1e-13)
}

fn scaled(s: crate::report::page::Spread, by: f64) -> crate::report::page::Spread {
    crate::report::page::Spread { at: s.at * by, low: s.low * by, high: s.high * by }
}

/// Marks the points that no other point beats in cost and error.
fn front(trends: &mut [Trend]) {
    let all: Vec<(f64, f64)> = trends.iter().flat_map(|t| &t.marks).map(|m| (m.x.at, m.y.at)).collect();
    let beaten =
        |m: &Mark| all.iter().any(|(x, y)| *x <= m.x.at && *y <= m.y.at && (*x < m.x.at || *y < m.y.at));
    trends.iter_mut().flat_map(|t| &mut t.marks).for_each(|m| m.front = !beaten(m));
}

fn costs(study: &Study) -> Section {
    let rows = study.per_step.iter().map(|p| {
        let ns = |x: f64| Cell::Number(1e9 * x);
        vec![p.law.into(), p.method.name().into(), ns(p.cost.at), ns(p.cost.low), ns(p.cost.high)]
    });
    let table = Table {
        name: "per-step".into(),
        caption: "Pair time of LIGGGHTS per contact and step, with tangential history".into(),
        columns: ["normal law", "who", "median [ns]", "lower quartile [ns]", "upper quartile [ns]"]
            .map(String::from)
            .to_vec(),
        rows: rows.collect(),
    };
    Section {
        title: "Cost per contact in LIGGGHTS".into(),
        text: vec![
            "2048 spheres on a lattice with 12 neighbours each, sheared; nine blocks of 40 steps, one rank."
                .into(),
        ],
        items: vec![Item::Table(table)],
    }
}

fn errors(study: &Study) -> Section {
    let mut columns: Vec<String> =
        ["case", "method", "steps per contact", "cost [µs]"].map(String::from).to_vec();
    columns.extend(ERRORS.map(String::from));
    let rows = study.found.iter().flat_map(|f| {
        f.curves.iter().flat_map(move |c| {
            c.points.iter().map(move |p| {
                let head = [
                    f.case.name.into(),
                    c.method.name().into(),
                    steps(c.method, Reach { n: p.n, cost: p.cost.at, at_most: false }),
                    (1e6 * p.cost.at).into(),
                ];
                let number = |x: &f64| if x.is_nan() { "".into() } else { Cell::Number(*x) };
                head.into_iter().chain(p.errors.iter().map(number)).collect()
            })
        })
    });
    let table = Table {
        name: "errors".into(),
        caption: "Every error of every point, relative to the truth".into(),
        columns,
        rows: rows.collect(),
    };
    Section { title: "All errors".into(), text: Vec::new(), items: vec![Item::Table(table)] }
}

fn checks(study: &Study) -> Vec<Check> {
    let mut checks = vec![orders(study)];
    for name in ["damped-0.9", "damped-0.5"] {
        checks.extend(study.found.iter().find(|f| f.case.name == name).map(best));
        checks.extend(
            study.found.iter().find(|f| f.case.name == name && curve(f, Method::Stock).is_some()).map(inside),
        );
    }
    checks.extend(study.apart.map(same));
    let stock = study.found.iter().any(|f| curve(f, Method::Stock).is_some());
    checks.extend(study.apart.filter(|_| stock).map(|_| bits(study)));
    checks
}

fn check(name: &str, outcome: Outcome, limit: f64, reason: &str, worst: Worst) -> Check {
    let tolerance = Some(Tolerance { limit, reason: reason.into() });
    Check { name: name.into(), shows: Shows::Integrator, outcome, tolerance, worst: Some(worst) }
}

fn worst(what: &str, got: f64, expected: f64, error: f64, norm: &str) -> Worst {
    Worst { step: 0, what: what.into(), got, expected, error, norm: norm.into() }
}

/// Checks observed orders against those claimed.
fn orders(study: &Study) -> Check {
    let (mut wrong, mut seen, mut furthest) =
        (Vec::new(), 0, worst("", 0.0, 0.0, 0.0, "difference of orders"));
    for claim in claims() {
        let Some(found) = study.found.iter().find(|f| f.case.name == claim.case) else { continue };
        let Some(curve) = curve(found, claim.method) else { continue };
        seen += 1;
        let order = curve.order(claim.from, floor(found));
        if let Err(e) = claim.check(order) {
            wrong.push(e);
        }
        let off = (order.unwrap_or(f64::NAN) - claim.order).abs();
        if off > furthest.error || off.is_nan() {
            let what = format!("{}, {}", claim.case, claim.method.name());
            furthest =
                Worst { what, got: order.unwrap_or(f64::NAN), expected: claim.order, error: off, ..furthest };
        }
    }
    let outcome = match () {
        _ if seen == 0 => Outcome::Skipped("no order is claimed of these cases".into()),
        _ if wrong.is_empty() => Outcome::Agreed,
        _ => Outcome::Disagreed(wrong.join("; ")),
    };
    let reason =
        format!("{seen} orders, fitted over fine steps; what terms of higher order leave is less than this");
    check("orders", outcome, WITHIN, &reason, furthest)
}

/// Checks that the best method takes at most a tenth of the steps of LIGGGHTS's scheme for an error of 1e-4.
fn best(found: &Found) -> Check {
    let steps = |m: Method| curve(found, m).and_then(|c| c.reach(1e-4)).map_or(f64::INFINITY, |r| r.n);
    let stock = steps(Method::Verlet);
    let (m, n) = [Method::VerletTimed, Method::Located]
        .map(|m| (m, steps(m)))
        .into_iter()
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .expect("two");
    share(&format!("best method, {}", found.case.name), m, n, stock, 0.1)
}

/// Checks that inside LIGGGHTS the settings reduce the steps to at most a fifth.
fn inside(found: &Found) -> Check {
    let steps = |m: Method| curve(found, m).and_then(|c| c.reach(1e-4)).map_or(f64::INFINITY, |r| r.n);
    share(
        &format!("inside LIGGGHTS, {}", found.case.name),
        Method::PluginTimed,
        steps(Method::PluginTimed),
        steps(Method::Stock),
        0.2,
    )
}

fn share(name: &str, method: Method, n: f64, stock: f64, limit: f64) -> Check {
    let share = n / stock;
    let outcome = if share <= limit {
        Outcome::Agreed
    } else {
        Outcome::Disagreed(format!("{n:.0} steps per contact where LIGGGHTS's scheme needs {stock:.0}"))
    };
    let reason = "share of the steps per contact that LIGGGHTS's scheme needs for a relative error of 1e-4";
    check(name, outcome, limit, reason, worst(method.name(), n, stock, share, "share of the steps"))
}

/// Checks that LIGGGHTS on the Rust laws and LIGGGHTS on its own have exactly the same mean errors.
fn bits(study: &Study) -> Check {
    let errors = |f: &Found, m| curve(f, m).map(|c| c.points.iter().map(|p| p.error).collect::<Vec<_>>());
    let has = |f: &&Found| errors(f, Method::Stock).is_some();
    let differ = |f: &&Found| has(f) && errors(f, Method::Stock) != errors(f, Method::Plugin);
    let names: Vec<&str> = study.found.iter().filter(differ).map(|f| f.case.name).collect();
    let outcome = match &names[..] {
        [] => Outcome::Agreed,
        some => Outcome::Disagreed(some.join(", ")),
    };
    let reason = "the same operations in the same order";
    let all = study.found.iter().filter(has).count().max(1) as f64;
    let share = names.len() as f64 / all;
    let seen = worst("cases with another error", names.len() as f64, 0.0, share, "share of the cases");
    Check { shows: Shows::Boundary, ..check("Rust laws in place of LIGGGHTS's", outcome, 0.0, reason, seen) }
}

/// Checks LIGGGHTS against our own integration of the same collisions.
fn same(apart: f64) -> Check {
    let limit = 1e-6;
    let outcome = match apart <= limit {
        true => Outcome::Agreed,
        false => Outcome::Disagreed(format!(
            "a collision in LIGGGHTS and our own integration of it differ by {apart:.1e}"
        )),
    };
    let reason = "places in a large box round off by 1e-17 m, and a stick or slip that sits on its border may turn on that";
    check(
        "LIGGGHTS and our integration",
        outcome,
        limit,
        reason,
        worst("all collisions", apart, 0.0, apart, "relative to the measured quantity"),
    )
}
