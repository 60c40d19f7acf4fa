//! Failure (14), (15).
use super::coeffs::Breaks;
use super::loads::Loads;
use super::Params;

/// Whether a distance, as [`super::apart`] compares it, tears the bond \[m\].
pub fn torn(p: &Params, distance: f64) -> bool {
    matches!(p.c.breaks, Breaks::Distance(max) if distance > max)
}

/// Whether the undamped loads exceed the strength.
pub fn fails(p: &Params, delta: f64, l: &Loads) -> bool {
    let Breaks::Stress { sigma, tau, ratio } = p.c.breaks else { return false };
    let [along, across] = stresses(p, l);
    along >= limit(delta, sigma, ratio) || across >= tau
}

/// How much of the strength is used: of the stresses, or of the way from where the bond began to where it tears; the
/// distances as [`super::apart`] compares them \[m\].
pub fn used(p: &Params, [began, now]: [f64; 2], l: &Loads) -> f64 {
    match p.c.breaks {
        Breaks::Stress { sigma, tau, ratio } => {
            let [along, across] = stresses(p, l);
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
fn stresses(p: &Params, l: &Loads) -> [f64; 2] {
    [
        l.normal.abs() / p.area + l.bend.norm() * p.radius / p.bending,
        l.shear.norm() / p.area + l.twist.abs() * p.radius / p.polar,
    ]
}
