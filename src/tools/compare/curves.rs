//! Histories to plot, collected while the rows of a trace are read.
use crate::report::Curve;
use crate::trace::Row;
use nalgebra::Vector3;

/// Overlap \[m\] and normal force \[N\] of a recorded call; across a gap, minus the gap and the force of what acts there.
pub(crate) fn shown(row: &Row) -> (f64, f64) {
    match row.touch {
        true => (row.surface.deltan, row.handed.fn_),
        false => (gap(row), across(row, &row.force_i)),
    }
}

/// Minus the gap \[m\].
pub(crate) fn gap(row: &Row) -> f64 {
    row.close.i.radius + row.close.j.radius - row.close.rsq.sqrt()
}

/// The normal part of a force on i \[N\].
pub(crate) fn across(row: &Row, force: &Vector3<f64>) -> f64 {
    force.dot(&row.close.delta) / row.close.rsq.sqrt()
}

/// Follows the first contact that has a force, in two answers, with at most [`Follow::POINTS`] points.
#[derive(Debug, Default)]
pub struct Follow {
    contact: Option<(i64, i64)>,
    points: Vec<Point>,
    seen: usize,
    stride: usize,
}

#[derive(Clone, Copy, Debug)]
struct Point {
    time: f64,
    overlap: [f64; 2],
    force: [f64; 2],
}

impl Follow {
    /// When there are so many points, every other one is dropped, and from then on only every other row is taken.
    pub const POINTS: usize = 20_000;

    /// Adds a row of the first answer, with overlap and normal force of the second.
    pub fn row(&mut self, row: &Row, overlap: f64, force: f64) {
        let (i, j) = (row.close.i.tag, row.close.j.tag);
        let tags = (i.min(j), i.max(j));
        if (row.touch || row.has_force) && self.contact.is_none() {
            self.contact = Some(tags);
            self.stride = 1;
        }
        if self.contact != Some(tags) {
            return;
        }
        self.seen += 1;
        if !(self.seen - 1).is_multiple_of(self.stride) {
            return;
        }
        if self.points.len() == Follow::POINTS {
            let mut k = 0;
            self.points.retain(|_| {
                k += 1;
                k % 2 == 1
            });
            self.stride *= 2;
        }
        let (call, first) = (&row.close.call, shown(row));
        self.points.push(Point {
            time: call.step as f64 * call.dt,
            overlap: [first.0, overlap],
            force: [first.1, force],
        });
    }

    /// The two histories; the second with its difference from the first relative to the peak force.
    pub fn curves(&self, answers: [&str; 2]) -> [Curve; 2] {
        let peak = self.points.iter().map(|p| p.force[0].abs()).fold(0.0, f64::max);
        [0, 1].map(|k| Curve {
            answer: answers[k].to_string(),
            time: self.points.iter().map(|p| p.time).collect(),
            overlap: self.points.iter().map(|p| p.overlap[k]).collect(),
            force: self.points.iter().map(|p| p.force[k]).collect(),
            error: match k {
                0 => Vec::new(),
                _ => self.points.iter().map(|p| relative(p.force[1] - p.force[0], peak)).collect(),
            },
        })
    }
}

fn relative(difference: f64, peak: f64) -> f64 {
    if difference == 0.0 {
        0.0
    } else {
        difference.abs() / peak
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_contact_is_followed_and_long_histories_are_thinned_evenly() {
        let mut follow = Follow::default();
        let n = 3 * Follow::POINTS;
        for step in 0..n {
            for partner in [2, 3] {
                let mut row = Row { touch: true, ..Row::default() };
                (row.close.call.step, row.close.call.dt) = (step as i64, 0.5);
                (row.close.i.tag, row.close.j.tag) = if step % 2 == 0 { (1, partner) } else { (partner, 1) };
                (row.surface.deltan, row.handed.fn_) = (partner as f64, step as f64);
                follow.row(&row, partner as f64, step as f64 * 1.5);
            }
        }
        let [stock, replay] = follow.curves(["stock", "replay"]);
        assert!(stock.time.len() > Follow::POINTS / 2 && stock.time.len() <= Follow::POINTS);
        let gaps: Vec<_> = stock.time.windows(2).map(|w| w[1] - w[0]).collect();
        assert!(gaps.iter().all(|g| *g == gaps[0]), "uneven: {:?}", &gaps[..4]);
        assert!(stock.overlap.iter().all(|d| *d == 2.0), "another contact got in");
        assert!(stock.error.is_empty());
        let last = stock.force.len() - 1;
        assert_eq!(replay.force[last], 1.5 * stock.force[last]);
        assert_eq!(replay.error[last], 0.5);
    }
}
