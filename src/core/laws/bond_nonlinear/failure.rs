//! Failure (14), (15).
use super::coeffs::Breaks;
use super::loads::Loads;
use super::Fit;

/// Whether a distance, as [`super::apart`] compares it, tears the bond \[m\].
pub fn torn(f: &Fit, distance: f64) -> bool {
    matches!(f.c.breaks, Breaks::Distance(max) if distance > max)
}

/// Whether the undamped loads exceed the strength.
pub fn fails(f: &Fit, delta: f64, l: &Loads) -> bool {
    let Breaks::Stress { sigma, tau, ratio } = f.c.breaks else { return false };
    let [along, across] = stresses(f, l);
    along >= limit(delta, sigma, ratio) || across >= tau
}

/// How much of the strength is used: of the stresses, or of the way from where the bond began to where it tears; the
/// distances as [`super::apart`] compares them \[m\].
pub fn used(f: &Fit, [began, now]: [f64; 2], l: &Loads) -> f64 {
    match f.c.breaks {
        Breaks::Stress { sigma, tau, ratio } => {
            let [along, across] = stresses(f, l);
            let delta = if now > began { -1.0 } else { 0.0 };
            (along / limit(delta, sigma, ratio)).max(across / tau)
        }
        Breaks::Distance(max) => ((now - began) / (max - began)).max(0.0),
    }
}

/// The strength against tension (δ < 0) and compression \[Pa\].
fn limit(delta: f64, sigma: f64, ratio: f64) -> f64 {
    if delta < 0.0 {
        ratio * sigma
    } else {
        sigma
    }
}

/// The largest stresses along and across the bond \[Pa\].
fn stresses(f: &Fit, l: &Loads) -> [f64; 2] {
    [
        l.normal.abs() / f.area + l.bend.norm() * f.radius / f.bending,
        l.shear.norm() / f.area + l.twist.abs() * f.radius / f.polar,
    ]
}
