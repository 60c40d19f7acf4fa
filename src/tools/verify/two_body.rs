//! Our own integration of two particles from the recorded first state, compared with every recorded evaluation.
use super::checks::{self, Limit};
use crate::report::{Check, Curve, Shows, Worst};
use crate::trace::{Header, Reader, Row, TraceError};
use granlaw::model::Body;
use granlaw::pair::{self, Opened, Partner, Start, State};
use nalgebra::Vector3;
use std::fs::File;
use std::path::{Path, PathBuf};

const NAME: &str = "two-body";

/// The check, and the history for the plots.
pub(super) fn check(traces: &[PathBuf], limit: Limit<'_>) -> (Check, Option<Curve>) {
    match compare(traces) {
        Ok((worst, curve)) if worst.error == 0.0 => {
            (checks::equal(NAME, Shows::Integrator, limit), Some(curve))
        }
        Ok((worst, curve)) => (checks::within(NAME, Shows::Integrator, limit, worst), Some(curve)),
        Err(why) => (checks::could_not(NAME, Shows::Integrator, why), None),
    }
}

fn compare(traces: &[PathBuf]) -> Result<(Worst, Curve), String> {
    let [path] = traces else {
        return Err(format!(
            "needs two free particles and nothing else, but the run has {} traces (walls or ranks); take the check out of the deck",
            traces.len()
        ));
    };
    let seen = Seen::of(path)?;
    let start = seen.start()?;
    let (every, scale) = (seen.header.every as i64, &seen.scale);
    let mut chain = seen.header.chain().map_err(|e| e.to_string())?;
    let mut rows = Rows::open(path)?;
    let mut worst = Worst { norm: "relative to the peaks of speed, overlap and force".into(), ..nothing() };
    let mut curve = Curve { answer: NAME.into(), ..Curve::default() };
    pair::run(&mut chain, &start, |state| {
        if state.step % every != 0 {
            return;
        }
        let row = rows.at(state.step);
        if row.is_none() && !state.touching {
            return;
        }
        let error = scale.compare(state, row, &mut worst);
        let gap = &state.contact.close;
        curve.time.push(state.step as f64 * start.dt);
        curve.overlap.push(gap.i.radius + gap.j.radius - gap.rsq.sqrt());
        curve.force.push(state.response.force.dot(&gap.delta) / gap.rsq.sqrt());
        curve.error.push(error);
    });
    rows.failed.map_or(Ok((worst, curve)), |e| Err(e.to_string()))
}

fn nothing() -> Worst {
    Worst { step: 0, what: String::new(), got: 0.0, expected: 0.0, error: 0.0, norm: String::new() }
}

/// What is learnt from a first reading of a trace.
struct Seen {
    header: Header,
    first: Row,
    last: i64,
    /// Whether the laws were also called while surfaces did not touch.
    told: bool,
    scale: Scale,
}

impl Seen {
    fn of(path: &Path) -> Result<Seen, String> {
        let mut reader = Reader::open(path).map_err(|e| e.to_string())?;
        let (header, mut row) = (reader.header().clone(), Row::default());
        if !reader.read(&mut row).map_err(|e| e.to_string())? {
            return Err("no contact was recorded".into());
        }
        let mut seen = Seen { header, first: row.clone(), last: 0, told: false, scale: Scale::default() };
        loop {
            (seen.last, seen.told) = (row.close.call.step, seen.told || !row.touch);
            seen.scale.raise(&row);
            if !reader.read(&mut row).map_err(|e| e.to_string())? {
                break;
            }
        }
        if reader.headers() > 1 {
            return Err(
                "the deck has several runs, each with a set-up of its own; ask for two-body in a deck with one"
                    .into(),
            );
        }
        Ok(seen)
    }

    /// The first recorded state, with i and j in the order of LIGGGHTS's list.
    fn start(&self) -> Result<Start, String> {
        let Seen { header, first: row, .. } = self;
        let [a, b] = &header.particles[..] else {
            return Err(format!("needs two particles, the trace has {}", header.particles.len()));
        };
        let (gap, reduced) = (&row.close, a.mass * b.mass / (a.mass + b.mass));
        let near = |x: f64| (gap.meff - x).abs() < 1e-12 * x;
        let partner = match () {
            _ if gap.call.is_wall => return Err("needs two free particles, the trace is of a wall".into()),
            _ if near(reduced) => Partner::Free,
            _ if near(gap.i.mass) => Partner::Frozen,
            _ => {
                return Err(format!(
                    "the effective mass {} fits neither a free nor a frozen partner",
                    gap.meff
                ))
            }
        };
        let (i, j) = if a.tag == gap.i.tag { (a, b) } else { (b, a) };
        let opened = if self.told { Opened::Closes } else { Opened::Keeps };
        Ok(Start {
            bodies: [i.body(), j.body()],
            types: (i.kind, j.kind),
            partner,
            dt: header.dt,
            steps: self.last.unsigned_abs(),
            first: 0,
            gravity: Vector3::zeros(),
            opened,
        })
    }
}

/// The rows of a trace, step by step.
struct Rows {
    reader: Reader<File>,
    row: Row,
    more: bool,
    failed: Option<TraceError>,
}

impl Rows {
    fn open(path: &Path) -> Result<Rows, String> {
        let reader = Reader::open(path).map_err(|e| e.to_string())?;
        let mut rows = Rows { reader, row: Row::default(), more: true, failed: None };
        rows.next();
        Ok(rows)
    }

    fn next(&mut self) {
        self.more = self.reader.read(&mut self.row).unwrap_or_else(|e| {
            self.failed = Some(e);
            false
        });
    }

    /// The row of a step, if there is one; steps are asked for in order.
    fn at(&mut self, step: i64) -> Option<&Row> {
        while self.more && self.row.close.call.step < step {
            self.next();
        }
        (self.more && self.row.close.call.step == step).then_some(&self.row)
    }
}

/// The scales of errors. Spin and torque are compared by what they do at the surface, so that the error of a spin that should be zero is
/// not relative to its own rounding.
#[derive(Default)]
struct Scale {
    overlap: f64,
    speed: f64,
    force: f64,
}

impl Scale {
    fn raise(&mut self, r: &Row) {
        let speed = |b: &Body| b.v.norm().max(b.omega.norm() * b.radius);
        // If the bodies never touch, the gap is the scale.
        let overlap = r.close.i.radius + r.close.j.radius - r.close.rsq.sqrt();
        self.overlap = self.overlap.max(overlap.abs());
        self.speed = self.speed.max(speed(&r.close.i)).max(speed(&r.close.j));
        self.force = self.force.max(r.force_i.norm());
    }

    /// Adds the worst difference of a step, and returns that of the force. A step that only one side has is compared with no
    /// contact.
    fn compare(&self, state: &State, row: Option<&Row>, worst: &mut Worst) -> f64 {
        let none = Row::default();
        let (ours, response) = (&state.contact.close, &state.response);
        let (gap, row) = row.map_or((ours, &none), |r| (&r.close, r));
        let lever = ours.i.radius.max(ours.j.radius);
        let pairs = [
            ("delta", ours.delta, gap.delta, self.overlap),
            ("v_i", ours.i.v, gap.i.v, self.speed),
            ("v_j", ours.j.v, gap.j.v, self.speed),
            ("omega_i", ours.i.omega, gap.i.omega, self.speed / lever),
            ("omega_j", ours.j.omega, gap.j.omega, self.speed / lever),
            ("torque_i", response.torque_i, row.torque_i, self.force * lever),
            ("torque_j", response.torque_j, row.torque_j, self.force * lever),
            ("force_i", response.force, row.force_i, self.force),
        ];
        let mut last = 0.0;
        for (what, got, expected, scale) in pairs {
            let error = if got == expected { 0.0 } else { (got - expected).norm() / scale };
            // NaN counts as the worst, and stays the worst.
            if worst.what.is_empty() || (!worst.error.is_nan() && (error > worst.error || error.is_nan())) {
                worst.step = state.step;
                worst.what = format!("{what} of {}-{}", ours.i.tag, ours.j.tag);
                (worst.got, worst.expected, worst.error) = (got.norm(), expected.norm(), error);
            }
            last = error;
        }
        last
    }
}
