//! Damping (11), (12): each mode gives up a share η of its load against its own velocity.
//!
//! sgn(x) of a number or a vector is x/|x|, and 0 at rest. `dampingBondSmooth` divides by max(|x|, x0), where
//! x0 = 10 |load| Δt/m is the velocity that the load gives the mode's mass m in ten steps.
use nalgebra::Vector3;

/// The damped load along one direction. `inertia` is the mode's mass over 10 Δt; infinite for sgn.
pub fn along(load: f64, eta: f64, speed: f64, inertia: f64) -> f64 {
    if speed == 0.0 || eta == 0.0 {
        return load;
    }
    let (size, least) = (speed.abs(), least(load.abs(), inertia));
    load - eta * load.abs() * if size >= least { speed.signum() } else { speed / least }
}

/// The damped load in a plane.
pub fn in_plane(load: Vector3<f64>, eta: f64, velocity: &Vector3<f64>, inertia: f64) -> Vector3<f64> {
    let speed = velocity.norm();
    if speed == 0.0 || eta == 0.0 {
        return load;
    }
    let size = load.norm();
    load - velocity * (eta * size / speed.max(least(size, inertia)))
}

/// x0, without a division where there is none.
fn least(size: f64, inertia: f64) -> f64 {
    if inertia == f64::INFINITY {
        0.0
    } else {
        size / inertia
    }
}
