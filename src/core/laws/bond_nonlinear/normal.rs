//! Normal force in six branches, (4) to (6): compression grows as √δ, tension linearly; both remember their extremes.
use super::coeffs::Coeffs;

/// The branches of (6), in the order of the sheet, from tension to compression.
const BRANCHES: [&str; 6] = [
    "tension",
    "reloading tension",
    "healing tension",
    "healing compression",
    "reloading compression",
    "compression",
];

/// The branch that holds at an overlap \[m\] with extremes that include it, from 1.
fn branch(c: &Coeffs, delta: f64, max: f64, min: f64) -> usize {
    match () {
        _ if delta < 0.0 && delta <= min => 1,
        _ if delta < c.tension.left * min => 2, // (5)
        _ if delta < 0.0 => 3,
        _ if delta < c.compression.left.powi(2) * max => 4, // (5)
        _ if delta < max => 5,
        _ => 6,
    }
}

/// Its name.
pub fn branch_name(c: &Coeffs, delta: f64, max: f64, min: f64) -> &'static str {
    BRANCHES[branch(c, delta, max, min) - 1]
}

/// F_n/A \[Pa\], positive when it pushes apart (6).
pub fn stress(c: &Coeffs, delta: f64, max: f64, min: f64) -> f64 {
    if !(if delta < 0.0 { c.on_tension } else { c.on.normal }) {
        return 0.0;
    }
    let (press, pull) = (&c.compression, &c.tension);
    match branch(c, delta, max, min) {
        1 => pull.k * delta,
        2 => pull.ku * delta + (pull.k - pull.ku) * min,
        3 => -pull.kc * delta,
        4 => -press.kc * delta.sqrt(),
        5 => press.ku * delta.sqrt() + (press.k - press.ku) * max.sqrt(),
        _ => press.k * delta.sqrt(),
    }
}

/// d(F_n/A)/dδ \[N/m³\]; infinite at δ = 0 from above.
pub fn tangent(c: &Coeffs, delta: f64, max: f64, min: f64) -> f64 {
    let (press, pull) = (&c.compression, &c.tension);
    match branch(c, delta, max, min) {
        1 => pull.k,
        2 => pull.ku,
        3 => -pull.kc,
        4 => -0.5 * press.kc / delta.sqrt(),
        5 => 0.5 * press.ku / delta.sqrt(),
        _ => 0.5 * press.k / delta.sqrt(),
    }
}
