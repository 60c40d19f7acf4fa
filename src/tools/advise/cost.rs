//! What evaluating a chain costs, measured on the scene's own contacts.
use super::group::Contacts;
use super::scene::Scene;
use crate::trace::{Header, HeaderError};
use granlaw::model::{Call, ClosePair, Contact, Response, Surface};
use nalgebra::Vector3;
use std::time::Instant;

/// Contacts per round, and number of rounds. The fastest round counts: other programs can only slow a round down.
const CONTACTS: usize = 512;
const ROUNDS: usize = 25;

/// Time to evaluate the laws on one contact \[ns\]: the mean over the chains, weighted by their calls. It is measured, and varies
/// by a few per cent from one measurement to the next.
///
/// # Errors
/// A law refuses.
pub(super) fn per_contact(scene: &Scene, chains: &[Header]) -> Result<f64, HeaderError> {
    let (mut sum, mut calls) = (0.0, 0.0);
    for (k, header) in chains.iter().enumerate() {
        let mut chain = header.chain()?;
        let contacts = contacts(scene, k);
        let mut rows = vec![vec![0.0; chain.row()]; contacts.len()];
        let round = |rows: &mut Vec<Vec<f64>>, chain: &mut granlaw::chain::Chain| {
            let begun = Instant::now();
            for ((types, x), h) in contacts.iter().zip(rows) {
                let mut s = Response::default();
                chain.surfaces_intersect(*types, x, h, &mut s);
                std::hint::black_box(&s);
            }
            begun.elapsed().as_secs_f64()
        };
        let best = (0..ROUNDS).map(|_| round(&mut rows, &mut chain)).fold(f64::INFINITY, f64::min);
        let weight = scene.calls[k] as f64;
        sum += weight * best / contacts.len().max(1) as f64 * 1e9;
        calls += weight;
    }
    Ok(sum / calls)
}

/// Contacts of a chain to time the laws on: the impacts and loads that the probe kept, at half of their largest overlap.
fn contacts(scene: &Scene, chain: usize) -> Vec<((usize, usize), Contact)> {
    let impacts = scene.groups.iter().filter(|g| g.chain == chain).flat_map(|g| match &g.contacts {
        Contacts::Impacts(all) => all.iter().map(|(i, _)| (i.partners, i.v, i.slip, i.end.overlap)).collect(),
        Contacts::Loads(all) => all
            .iter()
            .map(|(l, _)| (l.partners, [-1e-3, 0.0, 0.0], 1e-3, l.normal / l.kn))
            .collect::<Vec<_>>(),
    });
    let one = |(p, v, slip, overlap): (crate::probe::Partners, [f64; 3], f64, f64)| {
        let mut gap = ClosePair { meff: p.meff, ..ClosePair::default() };
        gap.call = Call { dt: scene.dt(), step: 1, update: true, counts: false, is_wall: p.wall };
        (gap.i.radius, gap.j.radius, gap.i.mass, gap.j.mass) =
            (p.radius[0], p.radius[1], p.mass[0], p.mass[1]);
        (gap.i.v, gap.delta) = (v.into(), Vector3::x() * (p.radius[0] + p.radius[1] - overlap));
        gap.rsq = gap.delta.norm_squared();
        let surface = Surface {
            r: gap.delta.x,
            deltan: 0.5 * overlap,
            vn: 0.5 * v[0],
            en: Vector3::x(),
            vtr: Vector3::y() * slip,
            roll: Vector3::new(0.1, 1.0, 1.0) * slip / p.radius[0],
            cri: p.radius[0],
            crj: p.radius[1],
        };
        ((p.types[0] - 1, p.types[1] - 1), Contact { close: gap, surface })
    };
    impacts.map(one).collect::<Vec<_>>().into_iter().cycle().take(CONTACTS).collect()
}
