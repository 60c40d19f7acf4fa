//! Says when the time step is too long for a contact at hand.
use super::{Fastest, Follower};
use crate::critical::{Mode, SAFE};
use crate::law::Kind;

impl Follower {
    /// A sentence for the first contact of a pair of types for which the time step is too long; once for each. Chains with
    /// bonds are left out: a bond is infinitely stiff where its compression begins, which says nothing.
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

fn acts(kind: &str) -> bool {
    [Kind::Normal, Kind::Cohesion].iter().any(|k| k.name() == kind)
}

/// The fastest contact as an oscillator; `None` if there was none.
fn mode(f: &Fastest) -> Option<Mode> {
    (f.stiffness > 0.0).then_some(Mode { stiffness: f.stiffness, damping: f.damping, mass: f.meff })
}
