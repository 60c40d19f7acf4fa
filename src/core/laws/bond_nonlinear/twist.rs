//! Twist about the bond (9): a scalar angle under a linear law with damage, the same in both senses.
use super::coeffs::Line;

/// f(θ), to be multiplied by −J; the extremes include θ.
pub fn stress(line: &Line, theta: f64, max: f64, min: f64) -> f64 {
    let Line { k, ku, kc, left } = *line;
    match () {
        _ if theta >= max || theta <= min => k * theta,
        _ if theta > left * max => ku * theta + (k - ku) * max,
        _ if theta < left * min => ku * theta + (k - ku) * min,
        _ => -kc * theta,
    }
}
