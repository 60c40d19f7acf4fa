//! Finds borders in our simulation, and runs LIGGGHTS on both sides of them.
use super::cell::Class;
use super::plan::Field;
use super::row::Row;
use crate::study::in_liggghts::{Bench, LiveError, Who};

/// A row and a step at which LIGGGHTS is run.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Index of the row.
    pub row: usize,
    /// The step over the row's unit.
    pub step: f64,
}

/// The outcome of LIGGGHTS at a place, and that of our simulation.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// The place.
    pub place: Place,
    /// The class in our simulation.
    pub ours: Class,
    /// The class in LIGGGHTS.
    pub theirs: Class,
    /// Whether our simulation has another class within 10 % of the step.
    pub near: bool,
}

/// How many places agree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Agreement {
    /// Number of places.
    pub all: usize,
    /// Number of places that agree.
    pub agree: usize,
    /// Number of places further than 10 % from a border.
    pub far: usize,
    /// Number of those that agree.
    pub far_agree: usize,
}

/// Steps at which LIGGGHTS is run, over that of the onset.
const ASIDE: [f64; 6] = [0.4, 0.75, 0.95, 1.06, 1.3, 1.8];

/// The first step over the unit of a row at which energy is created, to one part in a thousand.
pub fn onset(field: &Field, row: &Row, phases: usize) -> Option<f64> {
    let creates = |step: f64| row.class(step, &row.at(step, phases)).creates();
    let (low, high) = field.range;
    let n = 90;
    let step = |k: usize| low * (high / low).powf(k as f64 / n as f64);
    let first = (0..=n).find(|k| creates(step(*k)))?;
    let (mut fine, mut wrong) = (step(first.saturating_sub(1)), step(first));
    while wrong / fine > 1.001 && first > 0 {
        let middle = (fine * wrong).sqrt();
        if creates(middle) {
            wrong = middle;
        } else {
            fine = middle;
        }
    }
    Some(wrong)
}

/// Places on both sides of the onset of some rows. For rows without an onset, places where the error passes from one class to the next;
/// there always is one.
pub fn choose(field: &Field, onset: &[Option<f64>], rows: usize, phases: usize) -> Vec<Place> {
    let n = field.rows.len();
    let chosen = (0..rows).map(|k| (2 * k + 1) * n / (2 * rows));
    let at = |row: usize| onset[row].or_else(|| turn(field, &field.rows[row], phases));
    chosen
        .filter_map(|row| Some((row, at(row)?)))
        .flat_map(|(row, border)| ASIDE.into_iter().map(move |f| Place { row, step: f * border }))
        .collect()
}

/// The step at which a row first leaves the class of its shortest step.
fn turn(field: &Field, row: &Row, phases: usize) -> Option<f64> {
    let (low, high) = field.range;
    let class = |step: f64| row.class(step, &row.at(step, phases));
    let first = class(low);
    (1..=60).map(|k| low * (high / low).powf(f64::from(k) / 60.0)).find(|s| class(*s) != first)
}

/// Runs LIGGGHTS at a place.
///
/// # Errors
/// If it fails.
pub fn ask(bench: &Bench, field: &Field, place: Place, phases: usize) -> Result<Asked, LiveError> {
    let row = &field.rows[place.row];
    let (step, dt) = (place.step, place.step * row.unit());
    let who = if row.matter.needs_ours() { Who::Own } else { Who::Stock };
    let outcomes =
        bench.collide(&row.matter, &row.collisions, who, (dt, row.length(dt)), &row.before(phases))?;
    let ours = row.class(step, &row.at(step, phases));
    let theirs = row.class(step, &row.judge(&outcomes, phases));
    let around = (1..=10).flat_map(|k| [1.0 + 0.01 * f64::from(k), 1.0 / (1.0 + 0.01 * f64::from(k))]);
    let near = around.map(|f| f * step).any(|s| row.class(s, &row.at(s, phases)) != ours);
    Ok(Asked { place, ours, theirs, near })
}

/// Counts what agrees.
pub fn agreement<'a>(asked: impl Iterator<Item = &'a Asked>) -> Agreement {
    let mut n = Agreement::default();
    for a in asked {
        let same = usize::from(a.ours == a.theirs);
        n.all += 1;
        n.agree += same;
        if !a.near {
            n.far += 1;
            n.far_agree += same;
        }
    }
    n
}
