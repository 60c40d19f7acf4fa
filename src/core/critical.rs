//! The longest stable time steps, by theory, and what LIGGGHTS's own check says.
use crate::model::Mode;
use std::f64::consts::PI;

/// Up to this times π/ω no contact of `granlaw stability`'s maps creates energy, but for those without any damping, whose
/// restitution may come out above 1.005: the least of the maps is 0.14, of `hooke/hysteresis` over its adhesion.
pub const SAFE: f64 = 0.13;

/// The same for bonds, by their fastest mode, unless they neither take damage nor are damped. The least of the maps is 0.098,
/// of twist in some thousand steps, and it was seen to fall to 0.092 in 40,000.
pub const SAFE_BOND: f64 = 0.06;

impl Mode {
    /// Angular frequency without damping \[rad/s\].
    pub fn frequency(&self) -> f64 {
        (self.stiffness / self.mass).sqrt()
    }

    /// Damping ratio.
    pub fn ratio(&self) -> f64 {
        self.damping / (2.0 * (self.stiffness * self.mass).sqrt())
    }

    /// Longest stable step \[s\] of LIGGGHTS's scheme, whose dashpot sees the velocity of the middle of the step:
    /// `2/ω (√(1+ζ²) − ζ)`. Infinite without stiffness and damping.
    pub fn step(&self) -> f64 {
        if self.stiffness <= 0.0 {
            // A dashpot alone turns round what moves beyond 2m/γ.
            return 2.0 * self.mass / self.damping;
        }
        let z = self.ratio();
        2.0 / self.frequency() * ((1.0 + z * z).sqrt() - z)
    }

    /// The same with `centredDamping on`, where damping no longer counts: `2/ω`.
    pub fn step_centred(&self) -> f64 {
        if self.stiffness <= 0.0 {
            return f64::INFINITY;
        }
        2.0 / self.frequency()
    }

    /// A step \[s\] below which the contacts of the maps create no energy: [`SAFE`] π/ω, or half the critical one where
    /// damping makes that shorter.
    pub fn safe(&self) -> f64 {
        (SAFE * PI / self.frequency()).min(0.5 * self.step())
    }

    /// A step \[s\] below which a bond with this mode as its fastest creates no energy on the maps.
    pub fn safe_bond(&self) -> f64 {
        SAFE_BOND * PI / self.frequency()
    }
}

/// Rayleigh time of a sphere \[s\], as LIGGGHTS's `fix check/timestep/gran` has it:
/// `π R √(ρ/G)/(0.1631 ν + 0.8766)`, G = E/(2(1+ν)).
pub fn rayleigh(radius: f64, density: f64, young: f64, poisson: f64) -> f64 {
    let shear = young / (2.0 * (1.0 + poisson));
    PI * radius * (density / shear).sqrt() / (0.1631 * poisson + 0.8766)
}

/// Hertz time \[s\] of a sphere at the speed of the fastest particle, as that fix has it:
/// `2.87 (m²/(R E*² v))^(1/5)`; infinite at rest.
pub fn hertz(mass: f64, radius: f64, e_star: f64, speed: f64) -> f64 {
    2.87 * (mass * mass / (radius * e_star * e_star * speed)).powf(0.2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the scheme does to a linear oscillator after many steps.
    fn grows(mode: &Mode, dt: f64) -> bool {
        let (mut x, mut v, mut a) = (1.0, 0.0, -mode.frequency().powi(2));
        for _ in 0..4000 {
            v += 0.5 * dt * a;
            x += dt * v;
            a = -(mode.stiffness * x + mode.damping * v) / mode.mass;
            v += 0.5 * dt * a;
        }
        f64::abs(x) >= 10.0 || x.is_nan()
    }

    /// A formula for the critical step, held against the scheme on both sides of it.
    fn holds(formula: fn(&Mode) -> f64) -> bool {
        [0.0, 0.05, 0.1, 0.2, 0.5, 1.0].into_iter().all(|z| {
            let mode = Mode { stiffness: 3.0, damping: 2.0 * z * (3.0f64 * 0.5).sqrt(), mass: 0.5 };
            let dt = formula(&mode);
            !grows(&mode, 0.99 * dt) && grows(&mode, 1.01 * dt)
        })
    }

    #[test]
    fn beyond_the_critical_step_the_scheme_blows_up_and_below_it_does_not() {
        assert!(holds(Mode::step));
    }

    #[test]
    fn a_wrong_critical_step_is_seen() {
        assert!(!holds(|m| 1.03 * m.step()));
        assert!(!holds(|m| 0.97 * m.step()));
        assert!(!holds(Mode::step_centred), "damping must count");
    }

    #[test]
    fn times_of_the_check_are_those_that_liggghts_prints() {
        // f_ID[1] and f_ID[2] of fix check/timestep/gran in LIGGGHTS 3.8.0 for three spheres, with a step of 1e-5 s.
        let smallest = rayleigh(0.003, 8000.0, 2e7, 0.3);
        approx::assert_relative_eq!(1e-5 / smallest, 0.0304510802223129, max_relative = 1e-13);
        let mass = 8000.0 * 4.0 / 3.0 * PI * 0.003f64.powi(3);
        let time = hertz(mass, 0.003, 1.0 / (2.0 * (1.0 - 0.09) / 2e7), 0.3);
        approx::assert_relative_eq!(1e-5 / time, 0.00926260414492674, max_relative = 1e-13);
    }
}
