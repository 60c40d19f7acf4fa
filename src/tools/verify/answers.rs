//! Compares two answers; the results are checks of the report.
use super::attempt::Attempt;
use super::checks::{self, Limit};
use crate::compare::{self, CompareError, Difference, Frame, Quantity, Spot};
use crate::deck::Final;
use crate::replay::{replay_from, Replay, ReplayError};
use crate::report::{Case, Check, Curve, Parameter, Shows, Worst};
use crate::trace::{Header, LawSpec, Property, Reader, Row, TraceError};
use granlaw::laws::find;
use granlaw::model::Shape;
use std::path::{Path, PathBuf};

/// Adds laws and coefficients to the case. Returns the number of calls, and of those with overlapping surfaces or a force.
pub(super) fn describe(traces: &[PathBuf], case: &mut Case) -> Result<(u64, u64), String> {
    if traces.is_empty() {
        return Err("nothing was recorded: the deck has no pair style or wall made of contact models (pair_style gran, fix wall/gran)".into());
    }
    let count = |path: &PathBuf, case: &mut Case| -> Result<(u64, u64), TraceError> {
        let mut reader = Reader::open(path)?;
        enter(reader.header(), case);
        let (mut row, mut calls, mut touches) = (Row::default(), 0, 0);
        while reader.read(&mut row)? {
            calls += 1;
            touches += u64::from(row.touch || row.has_force);
        }
        Ok((calls, touches))
    };
    traces.iter().try_fold((0, 0), |(calls, touches), path| {
        let (more, touching) = count(path, case).map_err(|e| e.to_string())?;
        Ok((calls + more, touches + touching))
    })
}

fn enter(header: &Header, case: &mut Case) {
    for law in &header.laws {
        let name = format!("{} {}", law.kind, law.keyword);
        if !case.laws.contains(&name) {
            case.laws.push(name);
        }
        for p in &law.properties {
            if !case.parameters.iter().any(|known| known.name == p.name) {
                case.parameters.push(parameter(law, p));
            }
        }
    }
}

fn parameter(law: &LawSpec, p: &Property) -> Parameter {
    let entry = law.kind().and_then(|k| find(k, &law.keyword));
    let known = entry.and_then(|e| e.meta.props.iter().find(|known| known.name == p.name));
    let shape = match known.map(|k| k.shape) {
        Some(Shape::Scalar) => "scalar",
        Some(Shape::PerType) => "per type",
        Some(Shape::PerPair) => "per type pair",
        None => &p.shape,
    };
    let symbol = known.map_or(String::new(), |k| k.symbol.into());
    Parameter {
        name: p.name.clone(),
        symbol,
        unit: p.unit.clone(),
        shape: shape.into(),
        values: p.values.clone(),
    }
}

/// Replays every call of the traces through the Rust laws. Also returns the curves of the contact that was followed longest.
pub(super) fn replay(traces: &[PathBuf], shows: Shows, limit: Limit<'_>) -> (Check, Vec<Curve>) {
    let name = "replay";
    // Only the file name is given in messages, as the folder is gone by the time that they are read.
    let one = |p: &PathBuf| replay_from(Reader::open(p)?, &file(p));
    let done: Result<Vec<Replay>, ReplayError> = traces.iter().map(one).collect();
    let done = match done {
        Ok(done) => done,
        Err(e) => return (checks::could_not(name, shows, e.to_string()), Vec::new()),
    };
    let worst = done.iter().filter_map(Replay::worst).max_by(|a, b| a.error().total_cmp(&b.error()));
    let Some(worst) = worst else {
        return (checks::could_not(name, shows, "no contact call was recorded"), Vec::new());
    };
    let check = match worst.report() {
        Some(worst) => checks::within(name, shows, limit, worst),
        None => checks::equal(name, shows, limit),
    };
    let longest = done.into_iter().max_by_key(|r| r.curves[0].time.len());
    (check, longest.map(|r| r.curves.to_vec()).unwrap_or_default())
}

/// Where two answers differ, if they do.
pub(super) type Found = Option<(String, Option<Worst>)>;

/// Compares the traces of the run on the Rust laws with those of LIGGGHTS's own. Also returns the curves of the contact that was
/// followed longest.
pub(super) fn traces(got: &[PathBuf], expected: &[PathBuf]) -> (Found, Vec<Curve>) {
    let names = |all: &[PathBuf]| all.iter().map(|p| file(p)).collect::<Vec<_>>();
    if names(got) != names(expected) {
        let text = format!("traces {:?} were written where {:?} were expected", names(got), names(expected));
        return (Some((text, None)), Vec::new());
    }
    let mut found: Found = None;
    let mut curves: [Curve; 2] = Default::default();
    for (a, b) in got.iter().zip(expected) {
        match compare::traces(a, b, ["plugin", "stock"]) {
            Ok(t) => {
                found = found.or_else(|| first_difference(&file(b), &t));
                if curves[0].time.len() < t.curves[0].time.len() {
                    curves = t.curves;
                }
            }
            Err(e) => found = found.or(Some((e.to_string(), None))),
        }
    }
    let [plugin, stock] = curves;
    let any = |c: &Curve| !c.time.is_empty();
    (found, [stock, plugin].into_iter().filter(any).collect())
}

fn first_difference(file: &str, t: &compare::Traces) -> Found {
    let at = |s: Option<Spot>| match s {
        Some(s) => format!("step {}, contact {}-{} (line {})", s.step, s.tags.0, s.tags.1, s.line),
        None => "its end".into(),
    };
    // The force says most. By relative error, a column of nothing but round-off would come first.
    let force = t.quantities.iter().find(|q| q.name == "force_i" && !q.identical());
    let worst = force.or_else(|| Quantity::worst_of(&t.quantities)).and_then(Quantity::report);
    if let Some(stray) = t.stray {
        return Some((format!("{file}: {} where {} was expected", at(stray.got), at(stray.expected)), worst));
    }
    let worst = worst?;
    let Worst { what, step, got, expected, .. } = &worst;
    Some((format!("{file}: {what} at step {step} is {got:e} where {expected:e} was expected"), Some(worst)))
}

fn file(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Compares the dump files of two runs, byte for byte.
pub(super) fn dumps(name: &str, shows: Shows, reason: &str, got: &Attempt, expected: &Attempt) -> Check {
    let list =
        |a: &Attempt| a.ran.dumps.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ");
    if got.ran.dumps != expected.ran.dumps {
        let text = format!("the run wrote {} where {} was expected", list(got), list(expected));
        return checks::identical(name, shows, reason, Some((text, None)));
    }
    for dump in &expected.ran.dumps {
        match compare::dumps(&got.folder.path().join(dump), &expected.folder.path().join(dump)) {
            Ok(compare::Dumps { difference: None, .. }) => {}
            Ok(compare::Dumps { difference: Some(d), .. }) => {
                return checks::identical(name, shows, reason, Some(told(&dump.display().to_string(), &d)));
            }
            Err(e) => return checks::could_not(name, shows, e.to_string()),
        }
    }
    checks::identical(name, shows, reason, None)
}

fn told(dump: &str, d: &Difference) -> (String, Option<Worst>) {
    let of = d.id.map(|id| format!(" of {id}")).unwrap_or_default();
    let quoted = |s: &str| if s.is_empty() { "its end".to_string() } else { s.to_string() };
    let what = format!("{}{of}", d.column);
    let (got, expected) = (quoted(&d.got), quoted(&d.expected));
    let text = format!("{dump}:{}: {what} at step {} is {got} where {expected} was expected", d.line, d.step);
    let worst = d.got.parse().ok().zip(d.expected.parse().ok()).map(|(got, expected): (f64, f64)| Worst {
        step: d.step,
        what,
        got,
        expected,
        error: (got - expected).abs() / expected.abs(),
        norm: "relative to the value expected; the first difference, not the largest".into(),
    });
    (text, worst)
}

/// Checks one number of the last frame that a run dumped.
pub(super) fn last(stock: &Attempt, wanted: &Final, limit: Limit<'_>) -> Check {
    let name = format!("final {} of {}", wanted.column, wanted.id);
    let look = |dump: &PathBuf| -> Result<(i64, f64), CompareError> {
        let frame = Frame::last(&stock.folder.path().join(dump))?;
        Ok((frame.step, frame.value(wanted.id, &wanted.column)?))
    };
    // If there are several dumps, any of them may have the column.
    let found = stock.ran.dumps.iter().map(look).reduce(|a, b| if a.is_ok() { a } else { b });
    let (step, got) = match found {
        Some(Ok(found)) => found,
        Some(Err(e)) => return checks::could_not(&name, Shows::Physics, e.to_string()),
        None => {
            let why = "the deck writes no text dump; add a dump custom with this column";
            return checks::could_not(&name, Shows::Physics, why);
        }
    };
    let expected = wanted.value;
    let (scale, norm) =
        if expected == 0.0 { (1.0, "absolute") } else { (expected.abs(), "relative to the value expected") };
    let error = (got - expected).abs() / scale;
    let what = format!("{} of {}", wanted.column, wanted.id);
    checks::within(
        &name,
        Shows::Physics,
        limit,
        Worst { step, what, got, expected, error, norm: norm.into() },
    )
}
