//! Our own integration of two particles from the recorded first state, held against every recorded evaluation.
use super::checks::{self, Limit};
use crate::law::Body;
use crate::pair::{self, Opened, Partner, Start, State};
use crate::report::{Check, Curve, Shows, Worst};
use crate::trace::{Header, Reader, Row};
use nalgebra::Vector3;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

const NAME: &str = "two-body";

/// The check, and the history for the plots.
pub(super) fn check(traces: &[PathBuf], limit: Limit<'_>) -> (Check, Option<Curve>) {
    match compare(traces) {
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
    let (header, rows) = load(path)?;
    let start = start(&header, &rows)?;
    let mut chain = header.chain().map_err(|e| e.to_string())?;
    let scale = Scale::of(&rows);
    let by_step: HashMap<i64, &Row> = rows.iter().map(|r| (r.gap.call.step, r)).collect();
    let mut worst = Worst { norm: "relative to the peaks of speed, overlap and force".into(), ..nothing() };
    let mut curve = Curve { answer: NAME.into(), ..Curve::default() };
    pair::run(&mut chain, &start, |state| {
        if state.step % header.every as i64 != 0 {
            return;
        }
        let row = by_step.get(&state.step).copied();
        if row.is_none() && !state.touching {
            return;
        }
        let error = scale.compare(state, row, &mut worst);
        let gap = &state.contact.gap;
        curve.time.push(state.step as f64 * start.dt);
        curve.overlap.push(gap.i.radius + gap.j.radius - gap.rsq.sqrt());
        curve.force.push(state.stage.force.dot(&gap.delta) / gap.rsq.sqrt());
        curve.error.push(error);
    });
    Ok((worst, curve))
}

fn nothing() -> Worst {
    Worst { step: 0, what: String::new(), got: 0.0, expected: 0.0, error: 0.0, norm: String::new() }
}

fn load(path: &Path) -> Result<(Header, Vec<Row>), String> {
    let mut reader = Reader::open(path).map_err(|e| e.to_string())?;
    let header = reader.header().clone();
    let rows = reader.by_ref().collect::<Result<Vec<_>, _>>().map_err(|e| e.to_string())?;
    if reader.headers() > 1 {
        return Err(
            "the deck has several runs, each with a set-up of its own; ask for two-body in a deck with one"
                .into(),
        );
    }
    Ok((header, rows))
}

/// The state in which the recording began, with i and j as LIGGGHTS's list has them.
fn start(header: &Header, rows: &[Row]) -> Result<Start, String> {
    let [a, b] = &header.particles[..] else {
        return Err(format!("needs two particles, the trace has {}", header.particles.len()));
    };
    let (Some(row), Some(last)) = (rows.first(), rows.last()) else {
        return Err("no contact was recorded".into());
    };
    let (gap, reduced) = (&row.gap, a.mass * b.mass / (a.mass + b.mass));
    let near = |x: f64| (gap.meff - x).abs() < 1e-12 * x;
    let partner = match () {
        _ if gap.call.is_wall => return Err("needs two free particles, the trace is of a wall".into()),
        _ if near(reduced) => Partner::Free,
        _ if near(gap.i.mass) => Partner::Frozen,
        _ => return Err(format!("the effective mass {} fits neither a free nor a frozen partner", gap.meff)),
    };
    let (i, j) = if a.tag == gap.i.tag { (a, b) } else { (b, a) };
    let opened = if rows.iter().any(|r| !r.touch) { Opened::Closes } else { Opened::Keeps };
    Ok(Start {
        bodies: [i.body(), j.body()],
        types: (i.kind, j.kind),
        partner,
        dt: header.dt,
        steps: last.gap.call.step.unsigned_abs(),
        first: 0,
        gravity: Vector3::zeros(),
        opened,
    })
}

/// What errors are measured by. Spin and torque are measured by what they do at the surface, so that a spin that ought
/// to be zero is not held against its own rounding.
struct Scale {
    overlap: f64,
    speed: f64,
    force: f64,
}

impl Scale {
    fn of(rows: &[Row]) -> Scale {
        let peak = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).fold(0.0, f64::max);
        let speed = |b: &Body| b.v.norm().max(b.omega.norm() * b.radius);
        Scale {
            // Of bodies that never touch, the gap.
            overlap: peak(&|r| (r.gap.i.radius + r.gap.j.radius - r.gap.rsq.sqrt()).abs()),
            speed: peak(&|r| speed(&r.gap.i).max(speed(&r.gap.j))),
            force: peak(&|r| r.force_i.norm()),
        }
    }

    /// Enter the worst difference of a step; the result is that of the force. A step that only one side has is held
    /// against no contact.
    fn compare(&self, state: &State, row: Option<&Row>, worst: &mut Worst) -> f64 {
        let none = Row::default();
        let (ours, stage) = (&state.contact.gap, &state.stage);
        let (gap, row) = row.map_or((ours, &none), |r| (&r.gap, r));
        let lever = ours.i.radius.max(ours.j.radius);
        let pairs = [
            ("delta", ours.delta, gap.delta, self.overlap),
            ("v_i", ours.i.v, gap.i.v, self.speed),
            ("v_j", ours.j.v, gap.j.v, self.speed),
            ("omega_i", ours.i.omega, gap.i.omega, self.speed / lever),
            ("omega_j", ours.j.omega, gap.j.omega, self.speed / lever),
            ("torque_i", stage.torque_i, row.torque_i, self.force * lever),
            ("torque_j", stage.torque_j, row.torque_j, self.force * lever),
            ("force_i", stage.force, row.force_i, self.force),
        ];
        let mut last = 0.0;
        for (what, got, expected, scale) in pairs {
            let error = if got == expected { 0.0 } else { (got - expected).norm() / scale };
            // A NaN must not slip through, nor give way to a later number.
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
