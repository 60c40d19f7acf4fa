//! The limits of `fix check/timestep/gran`.
use crate::probe::{ParticleType, Probe};
use granlaw::critical::{hertz, rayleigh};
use granlaw::laws::prop;
use serde::Serialize;
use std::f64::consts::PI;

/// The times of LIGGGHTS's check, which knows neither the unloading stiffness nor friction nor damping.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Stock {
    /// Shortest Rayleigh time \[s\].
    pub rayleigh: f64,
    /// Shortest Hertz time \[s\], at the speed of the fastest particle; infinite at rest.
    pub hertz: f64,
}

impl Stock {
    /// Whether `fix check/timestep/gran` with these fractions of Rayleigh and Hertz time would warn of a step \[s\].
    pub fn warns(&self, dt: f64, (rayleigh, hertz): (f64, f64)) -> bool {
        dt > rayleigh * self.rayleigh || dt > hertz * self.hertz
    }
}

pub(super) fn of(probe: &Probe) -> Option<Stock> {
    let laws = || probe.chains.iter().flat_map(|c| &c.header.laws);
    let values = |name: &str| laws().flat_map(|l| &l.properties).find(|p| p.name == name).map(|p| &p.values);
    let (young, poisson) = (values(prop::YOUNG.name)?, values(prop::POISSON.name)?);
    let fastest = probe.grains.iter().map(|g| g.fastest).fold(0.0, f64::max);
    let one = |g: &ParticleType| -> Option<Stock> {
        let k = usize::try_from(g.kind - 1).ok()?;
        let (e, nu, r, density) = (*young.get(k)?, *poisson.get(k)?, g.radius[0], g.density[0]);
        let mass = 4.0 / 3.0 * PI * r.powi(3) * density;
        let e_star = e / (2.0 * (1.0 - nu * nu));
        Some(Stock { rayleigh: rayleigh(r, density, e, nu), hertz: hertz(mass, r, e_star, fastest) })
    };
    probe
        .grains
        .iter()
        .filter_map(one)
        .reduce(|a, b| Stock { rayleigh: a.rayleigh.min(b.rayleigh), hertz: a.hertz.min(b.hertz) })
}
