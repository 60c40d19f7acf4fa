//! Failure (14), (15).
use super::coeffs::Breaks;
use super::documented::Loads;
use super::Fit;

/// Whether a distance, as [`super::apart`] compares it, tears the bond \[m\].
pub fn torn(f: &Fit, distance: f64) -> bool {
    matches!(f.c.breaks, Breaks::Distance(max) if distance > max)
}

/// Whether the undamped loads exceed the strength.
pub fn fails(f: &Fit, delta: f64, l: &Loads) -> bool {
    let Breaks::Stress { sigma, tau, ratio } = f.c.breaks else { return false };
    let limit = if delta < 0.0 { ratio * sigma } else { sigma };
    l.normal.abs() / f.area + l.bend.norm() * f.radius / f.bending >= limit
        || l.shear.norm() / f.area + l.twist.abs() * f.radius / f.polar >= tau
}
