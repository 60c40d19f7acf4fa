//! The particles of a scene by type. Their sizes limit the time step, even before any of them has touched.
use super::particles::Particles;
use granlaw::model::Size;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// The particles of one atom type, over all samples.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParticleType {
    /// The type, from 1.
    #[serde(rename = "type")]
    pub kind: i32,
    /// Their number in the last sample.
    pub count: u64,
    /// Smallest and largest radius \[m\].
    pub radius: [f64; 2],
    /// Smallest and largest density \[kg/m³\].
    pub density: [f64; 2],
    /// Largest speed of a centre \[m/s\].
    pub fastest: f64,
}

impl ParticleType {
    fn none(kind: i32) -> ParticleType {
        let (radius, density) = ([f64::INFINITY, 0.0], [f64::INFINITY, 0.0]);
        ParticleType { kind, count: 0, radius, density, fastest: 0.0 }
    }

    /// The pairs of the smallest and the largest of these with the smallest and the largest of `partner`, or each with a wall if there
    /// is none. Masses are those of the lowest density.
    pub fn sizes(&self, partner: Option<&ParticleType>) -> Vec<Size> {
        let ends = |g: &ParticleType| g.radius.map(|r| (r, 4.0 / 3.0 * PI * r.powi(3) * g.density[0]));
        let wall = partner.is_none();
        let others = partner.map_or(vec![(0.0, 0.0)], |g| ends(g).to_vec());
        let pair = |(radi, massi): (f64, f64), (radj, massj): (f64, f64)| {
            let meff = if wall { massi } else { massi * massj / (massi + massj) };
            Size { radi, radj, massi, massj, frozen: [false; 2], meff, is_wall: wall }
        };
        ends(self).into_iter().flat_map(|i| others.iter().map(move |j| pair(i, *j))).collect()
    }

    fn widen(&mut self, radius: [f64; 2], density: [f64; 2], fastest: f64) {
        let wider = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        (self.radius, self.density) = (wider(self.radius, radius), wider(self.density, density));
        self.fastest = self.fastest.max(fastest);
    }
}

fn of(all: &mut Vec<ParticleType>, kind: i32) -> &mut ParticleType {
    let at = all.iter().position(|g| g.kind == kind).unwrap_or(all.len());
    if at == all.len() {
        all.push(ParticleType::none(kind));
    }
    &mut all[at]
}

/// Adds the particles of a sample.
pub(super) fn sample(all: &mut Vec<ParticleType>, p: &Particles<'_>) {
    let mut now: Vec<ParticleType> = Vec::new();
    for (k, kind) in p.kind.iter().enumerate() {
        let (r, v) = (p.radius[k], &p.v[3 * k..3 * k + 3]);
        let density = p.mass[k] / (4.0 / 3.0 * PI * r.powi(3));
        let speed = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let grains = of(&mut now, *kind);
        grains.count += 1;
        grains.widen([r; 2], [density; 2], speed);
    }
    all.iter_mut().for_each(|g| g.count = 0);
    for g in now {
        let known = of(all, g.kind);
        known.count = g.count;
        known.widen(g.radius, g.density, g.fastest);
    }
    all.sort_by_key(|g| g.kind);
}

/// Adds those of another rank.
pub(super) fn merge(all: &mut Vec<ParticleType>, other: &[ParticleType]) {
    for g in other {
        let known = of(all, g.kind);
        known.count += g.count;
        known.widen(g.radius, g.density, g.fastest);
    }
    all.sort_by_key(|g| g.kind);
}
