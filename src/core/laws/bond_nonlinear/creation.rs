//! When a bond begins: always, in one time step, or where two atoms carry the same number.
use super::Params;
use crate::model::ClosePair;

/// Whether two bodies bond now; `distance` is what [`super::apart`] makes of r. A distance of 0 has no direction.
pub fn wanted(p: &Params, x: &ClosePair, distance: f64) -> bool {
    let near = distance > 0.0 && distance < p.c.near;
    near && x.call.update && (p.c.at.is_none_or(|at| at == x.call.step) || same_number(x))
}

/// −∞ where the deck gives no numbers, and then never true.
fn same_number(x: &ClosePair) -> bool {
    let (i, j) = (x.i.given[0], x.j.given[0]);
    !x.call.is_wall && (x.call.step as f64) < i && i == j
}
