//! The differences between two answers to one call.
use crate::trace::Row;
use granlaw::chain::Chain;
use granlaw::model::Response;
use nalgebra::Vector3;

/// The answer of the Rust laws to a call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Force on i \[N\].
    pub force_i: Vector3<f64>,
    /// Torque on i \[N m\].
    pub torque_i: Vector3<f64>,
    /// Force on j \[N\]; zero for a wall.
    pub force_j: Vector3<f64>,
    /// Torque on j \[N m\].
    pub torque_j: Vector3<f64>,
    /// The contact's row of history after the call.
    pub history: Vec<f64>,
}

impl Answer {
    /// The answer of a chain, one contact at a time; `share` is the part of a wall contact that counts, 1 for a pair.
    pub(super) fn of(&mut self, chain: &mut Chain, row: &Row, share: f64) {
        let mut s = Response::default();
        self.history.clone_from(&row.before);
        if row.touch {
            chain.surfaces_intersect(row.types, &row.contact(), &mut self.history, &mut s);
        } else {
            chain.surfaces_close(row.types, &row.close, &mut self.history, &mut s);
        }
        (self.force_i, self.torque_i) = (s.force * share, s.torque_i * share);
        // LIGGGHTS applies no force to a wall.
        self.force_j = if row.close.call.is_wall { Vector3::zeros() } else { -s.force };
        self.torque_j = s.torque_j;
    }
}

/// A number in both answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair {
    /// Its place: one of the three components, or a slot.
    pub at: usize,
    /// Which of the two partners it belongs to; 0 for a slot.
    pub of: usize,
    pub rust: f64,
    pub stock: f64,
    pub error: f64,
}

/// Compares the calls of a chain, one after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Measure {
    /// The largest value of each history slot so far.
    peaks: Vec<f64>,
}

impl Measure {
    /// The worst of force, torque and history; `None` where all numbers are equal.
    pub fn differences(&mut self, row: &Row, rust: &Answer) -> [Option<Pair>; 3] {
        self.peaks.resize(row.after.len(), 0.0);
        for (peak, x) in self.peaks.iter_mut().zip(&row.after) {
            if x.abs() > *peak && x.is_finite() {
                *peak = x.abs();
            }
        }
        if same(row, rust) {
            return [None; 3];
        }
        let force = scale(row);
        let lever = row.close.i.radius.max(row.close.j.radius);
        let forces = [(&rust.force_i, &row.force_i), (&rust.force_j, &row.force_j)];
        let torques = [(&rust.torque_i, &row.torque_i), (&rust.torque_j, &row.torque_j)];
        let slots = rust.history.iter().zip(&row.after).zip(&self.peaks);
        [
            worst(vectors(forces, force)),
            worst(vectors(torques, force * lever)),
            worst(slots.enumerate().map(|(at, ((r, s), peak))| pair((at, 0), *r, *s, *peak))),
        ]
    }
}

/// Whether all numbers are finite and equal; zeros of either sign count as equal.
fn same(row: &Row, rust: &Answer) -> bool {
    let equal = |a: &f64, b: &f64| a == b && a.is_finite();
    let vectors = [
        (&rust.force_i, &row.force_i),
        (&rust.force_j, &row.force_j),
        (&rust.torque_i, &row.torque_i),
        (&rust.torque_j, &row.torque_j),
    ];
    rust.history.iter().zip(&row.after).all(|(a, b)| equal(a, b))
        && vectors.into_iter().all(|(a, b)| (0..3).all(|k| equal(&a[k], &b[k])))
}

/// The size of the forces that the laws add up in a call \[N\]; their sum may be smaller.
fn scale(row: &Row) -> f64 {
    let (h, s) = (&row.handed, &row.surface);
    let parts = [row.force_i.norm(), (h.kn * s.deltan).abs(), (h.gamman * s.vn).abs()];
    parts.into_iter().filter(|x| x.is_finite()).fold(0.0, f64::max)
}

fn vectors<'a>(of: [(&'a Vector3<f64>, &'a Vector3<f64>); 2], scale: f64) -> impl Iterator<Item = Pair> + 'a {
    of.into_iter().enumerate().flat_map(move |(k, (rust, stock))| {
        let scale = scale.max(stock.norm());
        (0..3).map(move |at| pair((at, k), rust[at], stock[at], scale))
    })
}

fn pair((at, of): (usize, usize), rust: f64, stock: f64, scale: f64) -> Pair {
    let error = match () {
        // Two equal answers that are not finite differ too, as neither is right.
        _ if !rust.is_finite() || !stock.is_finite() => f64::INFINITY,
        _ if rust == stock => 0.0,
        _ if !scale.is_finite() => f64::INFINITY,
        // A difference is never zero, even where the division underflows.
        _ => ((rust - stock).abs() / scale).max(f64::MIN_POSITIVE),
    };
    Pair { at, of, rust, stock, error }
}

fn worst(pairs: impl Iterator<Item = Pair>) -> Option<Pair> {
    pairs.filter(|p| p.error > 0.0).reduce(|worst, p| if p.error > worst.error { p } else { worst })
}
