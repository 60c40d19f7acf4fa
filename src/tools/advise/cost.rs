//! What a run takes, and what evaluating a chain costs, measured on the scene's own contacts.
use super::scene::{Contacts, Scene};
use crate::probe::Probe;
use crate::trace::{Header, HeaderError};
use granlaw::law::{Call, Contact, Gap, Stage, Surface};
use nalgebra::Vector3;
use std::time::Instant;

/// Contacts per round, and rounds; the fastest counts, as nothing makes a round faster than it is.
const CONTACTS: usize = 512;
const ROUNDS: usize = 25;

/// The time that the probed run took.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    /// Processor time per contact call, of all that is done step by step \[ns\].
    per_call: f64,
    /// Time that does not grow with the number of steps, over that which does: the start, and neighbour lists, which are made by
    /// distance travelled.
    fixed: f64,
}

impl Pace {
    /// That of a probe, without what following contacts took; the rest of the probe's own cost is in it.
    pub(super) fn of(probe: &Probe) -> Pace {
        let calls: u64 = probe.chains.iter().map(|c| c.calls).sum();
        let (t, ranks) = (&probe.times, probe.ranks.max(1) as f64);
        // Where others were at work on the machine, the processor's time tells what the run took.
        let whole = if t.processor > 0.0 { t.processor / ranks } else { probe.seconds };
        let lists = if probe.seconds > 0.0 { t.lists * whole / probe.seconds } else { 0.0 };
        let steps = (whole - lists - t.probe / ranks).max(0.0);
        let fixed = if steps > 0.0 { (t.start + lists) / steps } else { 0.0 };
        Pace { per_call: 1e9 * steps * ranks / calls.max(1) as f64, fixed }
    }

    /// Time of a run with laws of another cost \[ns per contact\] and another step, relative to the one that was probed.
    pub(super) fn relative(&self, (was, is): (f64, f64), steps: f64) -> f64 {
        let each = 1.0 + (is - was) / self.per_call.max(was);
        (self.fixed + each * steps) / (self.fixed + 1.0)
    }
}

/// Time to evaluate the laws on a contact \[ns\], over the chains by their calls. It is measured, and varies by a few
/// hundredths from time to time.
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
                let mut s = Stage::default();
                chain.touch(*types, x, h, &mut s);
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

/// Contacts of a chain as they might be met: half way into the impacts that were kept.
fn contacts(scene: &Scene, chain: usize) -> Vec<((usize, usize), Contact)> {
    let impacts = scene.groups.iter().filter(|g| g.chain == chain).flat_map(|g| match &g.contacts {
        Contacts::Impacts(all) => all.iter().map(|(i, _)| (i.partners, i.v, i.slip, i.end.overlap)).collect(),
        Contacts::Loads(all) => all
            .iter()
            .map(|(l, _)| (l.partners, [-1e-3, 0.0, 0.0], 1e-3, l.normal / l.kn))
            .collect::<Vec<_>>(),
    });
    let one = |(p, v, slip, overlap): (crate::probe::Partners, [f64; 3], f64, f64)| {
        let mut gap = Gap { meff: p.meff, ..Gap::default() };
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
        ((p.types[0] - 1, p.types[1] - 1), Contact { gap, surface })
    };
    impacts.map(one).collect::<Vec<_>>().into_iter().cycle().take(CONTACTS).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::{self, Times};

    #[test]
    fn what_does_not_grow_with_the_steps_is_not_saved() {
        let chains = vec![probe::Contacts { calls: 4_000_000, ..probe::Contacts::default() }];
        let times = Times { start: 0.5, lists: 0.5, processor: 3.0, probe: 0.5 };
        let mut probe = Probe { ranks: 1, seconds: 6.0, times, chains, ..Probe::default() };
        // The machine was busy: of 6 s only half were ours, half a second of that the probe's. So 2.25 s of steps, 0.25 s of
        // lists and half a second to start.
        let pace = Pace::of(&probe);
        assert!((pace.per_call - 562.5).abs() < 1e-9 && (pace.fixed - 0.75 / 2.25).abs() < 1e-12, "{pace:?}");
        assert!((pace.relative((50.0, 50.0), 0.1) - (0.75 + 0.225) / 3.0).abs() < 1e-12);
        assert_eq!(pace.relative((50.0, 50.0), 1.0), 1.0);
        // Laws that cost 56 ns more make each step a tenth longer.
        assert!((pace.relative((50.0, 106.25), 1.0) - (0.75 + 2.475) / 3.0).abs() < 1e-12);
        // A probe that does not know its times: everything goes by steps.
        probe.times = Times::default();
        assert!((Pace::of(&probe).relative((50.0, 50.0), 0.1) - 0.1).abs() < 1e-12);
    }
}
