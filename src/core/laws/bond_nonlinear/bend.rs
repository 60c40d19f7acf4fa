//! Bending (10): the angle θ is a vector in the tangent plane, the region that it has visited a disc.
//!
//! Extremes per component would depend on where the axes of the plane lie. For bending to and fro in one plane the disc
//! gives what [`super::twist`] gives. The torque is continuous, its tangents lie in \[−kc, ku\], and every cycle from
//! θ = 0 does work.
use super::coeffs::Line;
use nalgebra::Vector3;

/// The region that bending has visited.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Its centre \[rad\].
    pub centre: Vector3<f64>,
    /// Its radius \[rad\].
    pub rho: f64,
}

impl Disc {
    /// Let the disc reach `theta`: the far side stays where it is.
    pub fn visit(&mut self, theta: &Vector3<f64>) {
        let out = theta - self.centre;
        let s = out.norm();
        if s > self.rho {
            let half = 0.5 * (s - self.rho);
            self.centre += out * (half / s);
            self.rho += half;
        }
    }

    /// g(θ), to be multiplied by −I: unloading from the nearest point of the disc that is left of the visited one.
    pub fn stress(&self, line: &Line, theta: &Vector3<f64>) -> Vector3<f64> {
        let (centre, rho) = (self.centre * line.left, self.rho * line.left);
        let out = theta - centre;
        let s = out.norm();
        let nearest = if s > rho { centre + out * (rho / s) } else { *theta };
        theta * line.ku - nearest * (line.ku + line.kc)
    }
}
