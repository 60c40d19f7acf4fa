//! Two traces of the same chain, row by row.
use super::{shown, CompareError, Follow, Quantity, Spot};
use crate::report::Curve;
use crate::trace::{Cell, Reader, Row, COLUMNS};
use std::path::Path;

/// The result of comparing two traces.
#[derive(Clone, Debug)]
pub struct Traces {
    /// Number of rows compared.
    pub rows: u64,
    /// Every column: inputs, results and history.
    pub quantities: Vec<Quantity>,
    /// The first row that has no counterpart in the other trace; nothing after it was compared.
    pub stray: Option<Stray>,
    /// The history of the first contact, in both.
    pub curves: [Curve; 2],
}

/// A row without a counterpart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stray {
    /// The row of the trace on trial; `None` where that has ended.
    pub got: Option<Spot>,
    /// The row of the other; `None` where that has ended.
    pub expected: Option<Spot>,
}

impl Traces {
    /// Whether both have the same rows with the same numbers.
    pub fn identical(&self) -> bool {
        self.stray.is_none() && self.quantities.iter().all(Quantity::identical)
    }

    /// The largest error of all columns, each relative to its peak; infinite if the rows differ.
    pub fn error(&self) -> f64 {
        match self.stray {
            Some(_) => f64::INFINITY,
            None => Quantity::worst_of(&self.quantities).map_or(0.0, Quantity::error),
        }
    }
}

/// Compare two traces; the second is the reference. `answers` names the two in the curves.
///
/// # Errors
/// If either cannot be read.
pub fn traces(got: &Path, expected: &Path, answers: [&str; 2]) -> Result<Traces, CompareError> {
    let (mut a, mut b) = (Reader::open(got)?, Reader::open(expected)?);
    let slots = &b.header().slots;
    let names = COLUMNS.iter().map(|c| c.name.to_string());
    let history = ["before", "after"].into_iter().flat_map(|w| slots.iter().map(move |s| format!("{w}.{s}")));
    let mut quantities: Vec<_> = names.chain(history).map(Quantity::new).collect();
    let (mut x, mut y) = (Row::default(), Row::default());
    let (mut rows, mut stray, mut follow) = (0, None, Follow::default());
    loop {
        let (more_a, more_b) = (a.read(&mut x)?, b.read(&mut y)?);
        if !more_a && !more_b {
            break;
        }
        let spots = [more_a.then(|| spot(&x, a.line())), more_b.then(|| spot(&y, b.line()))];
        let same = more_a && more_b && key(&x) == key(&y) && x.before.len() == y.before.len();
        if !same {
            stray = Some(Stray { got: spots[0], expected: spots[1] });
            break;
        }
        rows += 1;
        let (overlap, force) = shown(&x);
        follow.row(&y, overlap, force);
        row(&mut quantities, spot(&y, b.line()), &mut x, &mut y);
    }
    let [expected, got] = follow.curves([answers[1], answers[0]]);
    Ok(Traces { rows, quantities, stray, curves: [got, expected] })
}

fn key(r: &Row) -> (i64, i64, i64, bool) {
    (r.close.call.step, r.close.i.tag, r.close.j.tag, r.touch)
}

fn spot(r: &Row, line: u64) -> Spot {
    Spot { step: r.close.call.step, tags: (r.close.i.tag, r.close.j.tag), line }
}

fn row(quantities: &mut [Quantity], spot: Spot, x: &mut Row, y: &mut Row) {
    let (columns, history) = quantities.split_at_mut(COLUMNS.len());
    for (q, c) in columns.iter_mut().zip(COLUMNS) {
        match ((c.cell)(x), (c.cell)(y)) {
            (Cell::Vector(a), Cell::Vector(b)) => q.vector(spot, a, b),
            (a, b) => q.number(spot, scalar(a), scalar(b)),
        }
    }
    let pairs = x.before.iter().chain(&x.after).zip(y.before.iter().chain(&y.after));
    for (q, (a, b)) in history.iter_mut().zip(pairs) {
        q.number(spot, *a, *b);
    }
}

/// The number of a whole-number column. These are far below 2⁵³, so nothing is lost.
fn scalar(cell: Cell<'_>) -> f64 {
    match cell {
        Cell::Flag(x) => f64::from(u8::from(*x)),
        Cell::Small(x) => f64::from(*x),
        Cell::Whole(x) => *x as f64,
        Cell::Type(x) => *x as f64,
        Cell::Number(x) => *x,
        Cell::Vector(v) => v.norm(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{Header, Writer};

    fn file(folder: &Path, name: &str, rows: &[Row]) -> std::path::PathBuf {
        let path = folder.join(name);
        let header = Header { types: 1, slots: vec!["shearx".into()], ..Header::default() };
        let mut w = Writer::create(&path, &header).unwrap();
        rows.iter().for_each(|r| w.row(r).unwrap());
        w.finish().unwrap();
        path
    }

    fn rows() -> Vec<Row> {
        (1..=4)
            .map(|step| {
                let mut r =
                    Row { touch: true, before: vec![0.5], after: vec![step as f64], ..Row::default() };
                r.close.call.step = step;
                (r.close.i.tag, r.close.j.tag) = (1, 2);
                r.close.i.x.y = step as f64;
                r.handed.fn_ = 2.0 * step as f64;
                r
            })
            .collect()
    }

    fn against(change: impl Fn(&mut Vec<Row>)) -> Traces {
        let folder = tempfile::tempdir().unwrap();
        let mut other = rows();
        change(&mut other);
        let (a, b) = (file(folder.path(), "a", &other), file(folder.path(), "b", &rows()));
        traces(&a, &b, ["plugin", "stock"]).unwrap()
    }

    #[test]
    fn equal_traces_are_identical() {
        let t = against(|_| {});
        assert!(t.identical() && t.error() == 0.0);
        assert_eq!((t.rows, t.curves[0].force.as_slice()), (4, &[2.0, 4.0, 6.0, 8.0][..]));
    }

    #[test]
    fn inputs_results_and_history_are_all_compared() {
        let worst = |t: &Traces| Quantity::worst_of(&t.quantities).unwrap().report().unwrap();
        let t = against(|r| r[1].close.i.x.y += 1.0);
        assert_eq!((worst(&t).what.as_str(), worst(&t).step, t.error()), ("x_i.y of 1-2", 2, 0.25));
        let t = against(|r| r[2].after[0] = -3.0);
        assert_eq!((worst(&t).what.as_str(), t.error()), ("after.shearx of 1-2", 1.5));
        let t = against(|r| r[3].handed.fn_ = 4.0);
        assert_eq!((worst(&t).what.as_str(), t.error()), ("fn of 1-2", 0.5));
        assert_eq!(
            (t.curves[0].answer.as_str(), t.curves[0].error.as_slice()),
            ("plugin", &[0.0, 0.0, 0.0, 0.5][..])
        );
        assert!(t.curves[1].error.is_empty());
        let t = against(|r| r[0].has_force = true);
        assert!(!t.identical());
    }

    #[test]
    fn a_row_too_few_or_of_another_contact_is_found() {
        let t = against(|r| {
            r.pop();
        });
        assert_eq!((t.rows, t.error(), t.identical()), (3, f64::INFINITY, false));
        let stray = t.stray.unwrap();
        assert_eq!((stray.got, stray.expected.unwrap().step), (None, 4));
        let t = against(|r| r[1].close.j.tag = 3);
        assert_eq!((t.rows, t.stray.unwrap().got.unwrap().tags), (1, (1, 3)));
    }
}
