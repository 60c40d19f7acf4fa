//! Says when the time step is too long for a contact at hand.
use super::{Fastest, Follower, ParticleType};
use granlaw::critical::{SAFE, SAFE_BOND};
use granlaw::model::Kind;
use granlaw::model::Mode;

impl Follower {
    /// A warning in words, when the time step is first found too long for a pair of types; one warning for each pair of types. Chains
    /// with bonds are left out, as a bond is infinitely stiff where its compression begins; see [`Follower::bonds_alarm`].
    pub fn alarm(&mut self) -> Option<String> {
        let header = self.header();
        if header.bonds().is_some() {
            return None;
        }
        let dt = header.dt;
        let laws: Vec<&str> =
            header.laws.iter().filter(|l| acts(&l.kind)).map(|l| l.keyword.as_str()).collect();
        let (who, laws) = (header.who.clone(), laws.join(" + "));
        let (pairs, told) = self.told();
        told.resize(pairs.len(), false);
        let (pair, told) = pairs
            .iter()
            .zip(told)
            .find(|(p, told)| !**told && mode(&p.fastest).is_some_and(|m| dt > m.safe()))?;
        *told = true;
        let (m, [i, j]) = (mode(&pair.fastest)?, pair.types);
        Some(format!(
            "the time step of {dt:.3e} is too long for {laws}, {who}, types {i}-{j}: a contact with k = {:.3e}, damping {:.3e} and \
             m* = {:.3e} can create energy beyond {:.3e} ({SAFE} pi/omega) and is unstable beyond {:.3e}; said once. \
             granlaw timestep DECK says more",
            m.stiffness,
            m.damping,
            m.mass,
            m.safe(),
            m.step()
        ))
    }
}

impl Follower {
    /// The same for the bonds that two particles like these can have, before any bond has begun.
    pub(super) fn bonds_alarm(&mut self, grains: &[ParticleType]) -> Option<String> {
        let keyword = self.header().bonds()?.keyword.clone();
        let (dt, types, who) = (self.header().dt, self.header().types, self.header().who.clone());
        let wall = who != "pair";
        let (chain, told) = self.bonds()?;
        let pairs = (0..types * types).map(|p| (p / types, p % types)).filter(|(i, j)| wall || i <= j);
        for (i, j) in pairs {
            let of = |kind: usize| grains.iter().find(|g| g.kind as usize == kind + 1);
            let at = i * types + j;
            let (Some(gi), gj) = (of(i).filter(|_| !told[at]), of(j)) else { continue };
            if !wall && gj.is_none() {
                continue;
            }
            let gj = gj.filter(|_| !wall);
            let speed = gi.fastest + gj.map_or(0.0, |g| g.fastest);
            let modes = gi.sizes(gj).into_iter().flat_map(|size| chain.modes((i, j), &size, speed));
            let worst = modes.min_by(|a, b| a.mode.step().total_cmp(&b.mode.step()));
            let Some(s) = worst.filter(|s| dt > s.mode.safe_bond()) else { continue };
            told[at] = true;
            let m = s.mode;
            return Some(format!(
                "the time step of {dt:.3e} is too long for {keyword}, {who}, types {}-{}: {} of one bond alone can create energy beyond \
                 {:.3e} ({SAFE_BOND} pi/omega) and is unstable beyond {:.3e}, and several on a particle sooner; said once. \
                 granlaw timestep DECK says more",
                i + 1,
                j + 1,
                s.name,
                m.safe_bond(),
                m.step()
            ));
        }
        None
    }
}

fn acts(kind: &str) -> bool {
    [Kind::Normal, Kind::Cohesion].iter().any(|k| k.name() == kind)
}

/// The fastest contact as an oscillator; `None` if there was none.
fn mode(f: &Fastest) -> Option<Mode> {
    (f.stiffness > 0.0).then_some(Mode { stiffness: f.stiffness, damping: f.damping, mass: f.meff })
}
