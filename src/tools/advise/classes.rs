//! Which classes of contacts count, and what they are called.
use super::group::{Contacts, Group};
use super::loaded::Held;
use super::rules::{COVERED, IMPORTANT};
use super::simulated::Rebound;
use crate::probe::{self, Class, Drawn, Impact, Pressed, TypePair};

/// Removes the classes that do not count. Those with a large enough share stay, and then the largest of the others until the scene is
/// covered.
pub(super) fn counting(groups: &mut Vec<Group>) {
    let mut counts: Vec<bool> =
        groups.iter().map(|g| g.likely.max(g.impulse).max(g.dissipated) >= IMPORTANT).collect();
    for share in [|g: &Group| g.count, |g: &Group| g.impulse] {
        let mut order: Vec<_> = (0..groups.len()).collect();
        order.sort_by(|a, b| share(&groups[*b]).total_cmp(&share(&groups[*a])));
        let mut covered: f64 = order.iter().filter(|k| counts[**k]).map(|k| share(&groups[*k])).sum();
        for k in order {
            if covered < COVERED && !counts[k] {
                counts[k] = true;
                covered += share(&groups[k]);
            }
        }
    }
    let mut counts = counts.into_iter();
    groups.retain(|_| counts.next() == Some(true));
}

/// The sums over the whole scene, of which each class has a share.
pub(super) struct Sums {
    pub count: f64,
    pub impulse: f64,
    dissipated: f64,
}

impl Sums {
    pub fn of<'a>(pairs: impl Iterator<Item = &'a TypePair>) -> Sums {
        let mut s = Sums { count: 0.0, impulse: 0.0, dissipated: 0.0 };
        for p in pairs {
            s.count += p.impacts.iter().map(|c| c.count as f64).sum::<f64>();
            s.impulse += p.impulse.normal;
            s.dissipated += -p.work.sum();
        }
        s
    }

    pub fn group<T: Kept>(
        &self,
        (chain, from): (usize, &probe::Contacts),
        p: &TypePair,
        c: &Class<T>,
        impact: bool,
    ) -> Group {
        // Only a sample was followed: each contact that was seen stands for this many.
        let (many, each) = (c.count as f64, from.share as f64);
        let share = |x: f64, of: f64| if of > 0.0 { x / of } else { 0.0 };
        let [a, b] = p.types;
        Group {
            name: format!("{} {a}-{b}: {}", from.header.who, T::words(c.octave, c.slant)),
            chain,
            types: [a.min(b), a.max(b)],
            count: if impact { share(many, self.count) } else { 0.0 },
            likely: if impact { share(many + (many * each).sqrt(), self.count) } else { 0.0 },
            impulse: share(c.impulse, self.impulse),
            dissipated: share(c.dissipated, self.dissipated),
            contacts: T::contacts(&c.examples),
        }
    }
}

/// The kinds of example that a class can hold.
pub(super) trait Kept: Sized {
    fn words(octave: i32, slant: u8) -> String;
    fn contacts(of: &[Drawn<Self>]) -> Contacts;
}

impl Kept for Impact {
    fn words(octave: i32, slant: u8) -> String {
        let slip = ["below 1/4", "1/4 to 1", "1 to 4", "above 4"][usize::from(slant.min(3))];
        format!("{} to {} m/s, slip {slip}", power(octave), power(octave + 1))
    }
    fn contacts(of: &[Drawn<Impact>]) -> Contacts {
        Contacts::Impacts(of.iter().map(|d| (d.what, Rebound::default())).collect())
    }
}

impl Kept for Pressed {
    fn words(octave: i32, slant: u8) -> String {
        let pull = ["below 1/20", "1/20 to 1/5", "1/5 to 1/2", "above 1/2"][usize::from(slant.min(3))];
        format!("pressed by {} to {} N, pulled by {pull} of it", power(octave), power(octave + 1))
    }
    fn contacts(of: &[Drawn<Pressed>]) -> Contacts {
        Contacts::Loads(of.iter().map(|d| (d.what, Held::default())).collect())
    }
}

/// Two to the power `octave`, to two digits.
fn power(octave: i32) -> String {
    let x = f64::from(octave).exp2();
    let digits = (1 - x.log10().floor() as i32).max(0) as usize;
    if !(1e-3..1e4).contains(&x) {
        format!("{x:.1e}")
    } else {
        format!("{x:.digits$}")
    }
}
