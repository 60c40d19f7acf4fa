//! Keeps a few contacts of every class as examples, with all that is needed to repeat them.
use super::call::Call;
use granlaw::model::Contact;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// How many examples a class keeps.
pub const KEPT: usize = 24;

/// Sizes and masses of the two partners.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Partners {
    /// Atom types of i and j, from 1; of a wall, the type of its material.
    pub types: [usize; 2],
    /// Whether j is a wall.
    pub wall: bool,
    /// Radii \[m\]; 0 for a wall.
    pub radius: [f64; 2],
    /// Masses \[kg\]; 0 for a wall and for a partner that is held in place.
    pub mass: [f64; 2],
    /// Effective mass \[kg\]; that of one partner where the other is held in place.
    pub meff: f64,
}

/// Two bodies at their first touch, seen from j, with x along the normal from j to i and y along the slip.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Impact {
    /// The two bodies.
    pub partners: Partners,
    /// Relative velocity \[m/s\]; x is negative.
    pub v: [f64; 3],
    /// Spin of i \[rad/s\].
    pub omega_i: [f64; 3],
    /// Spin of j \[rad/s\].
    pub omega_j: [f64; 3],
    /// Speed of the surfaces along each other \[m/s\].
    pub slip: f64,
    /// How it ended in the run; zeros until it has.
    pub end: End,
}

/// How a contact ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// Steps in contact.
    pub steps: u64,
    /// Largest overlap \[m\].
    pub overlap: f64,
    /// Normal speed after over before.
    pub restitution: f64,
    /// Work that the contact took out of the motion \[J\].
    pub dissipated: f64,
}

/// The load of a contact that lasted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pressed {
    /// The two bodies.
    pub partners: Partners,
    /// Mean normal force \[N\].
    pub normal: f64,
    /// Mean tangential force \[N\].
    pub tangential: f64,
    /// Largest repulsion \[N\].
    pub push: f64,
    /// Largest attraction \[N\].
    pub pull: f64,
    /// Time for which it was seen \[s\].
    pub time: f64,
    /// Largest normal stiffness that the normal law gave to the laws after it \[N/m\].
    pub kn: f64,
}

/// A class of similar contacts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Class<T> {
    /// Octave of the impact speed \[m/s\] or of the normal force \[N\]: from 2ⁿ to 2ⁿ⁺¹.
    pub octave: i32,
    /// Slip speed over impact speed, or tangential over normal force: below 1/4, 1, 4, or above for an impact; below
    /// 1/20, 1/5, 1/2, or above for a pressed contact.
    pub slant: u8,
    /// How many there were.
    pub count: u64,
    /// Momentum that they exchanged along the normal \[N s\].
    pub impulse: f64,
    /// Work that they took out of the motion \[J\].
    pub dissipated: f64,
    /// Some of them, drawn at random.
    pub examples: Vec<Drawn<T>>,
}

/// An example with its lot, a random number. The examples with the lowest lots are kept, so that the choice is fair over any number of
/// ranks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drawn<T> {
    /// Its lot.
    pub lot: u32,
    /// The example.
    #[serde(flatten)]
    pub what: T,
}

impl Partners {
    pub(super) fn of(call: &Call<'_>) -> Partners {
        let g = &call.contact.close;
        Partners {
            types: [call.types.0 + 1, call.types.1 + 1],
            wall: g.call.is_wall,
            radius: [g.i.radius, g.j.radius],
            mass: [g.i, g.j].map(|b| b.felt_mass()).map(|m| if m.is_finite() { m } else { 0.0 }),
            meff: g.meff,
        }
    }

    /// Effective radius R* \[m\]; a wall is flat.
    pub fn reff(&self) -> f64 {
        let [i, j] = self.radius;
        if self.wall {
            i
        } else {
            i * j / (i + j)
        }
    }
}

impl Impact {
    pub(super) fn of(call: &Call<'_>) -> Impact {
        let axes = axes(call.contact);
        let (g, s) = (&call.contact.close, &call.contact.surface);
        let seen = |v: Vector3<f64>| axes.map(|a| a.dot(&v));
        Impact {
            partners: Partners::of(call),
            v: seen(g.i.v - g.j.v),
            omega_i: seen(g.i.omega),
            omega_j: seen(g.j.omega),
            slip: s.vtr.norm(),
            end: End::default(),
        }
    }

    pub(super) fn slant(&self) -> u8 {
        part(self.slip / -self.v[0], [0.25, 1.0, 4.0])
    }
}

impl Pressed {
    pub(super) fn slant(&self) -> u8 {
        part(self.tangential / self.normal, [0.05, 0.2, 0.5])
    }
}

/// The normal, the direction of slip, and what is normal to both.
fn axes(x: &Contact) -> [Vector3<f64>; 3] {
    let n = x.surface.en;
    // A slip of nothing but rounding error has a random direction, which may be that of the normal.
    let least = 1e-12 * (x.close.i.v - x.close.j.v).norm();
    let across = |v: Vector3<f64>| (v - n * n.dot(&v)).try_normalize(least);
    // Any direction will do where nothing slips; the axis furthest from the normal cannot fail.
    let t = across(x.surface.vtr).unwrap_or_else(|| Vector3::ith(n.iamin(), 1.0));
    // Once more, as rounding errors leave a part along the normal where the slip is small.
    let t = (t - n * n.dot(&t)).normalize();
    [n, t, n.cross(&t)]
}

fn part(x: f64, edges: [f64; 3]) -> u8 {
    edges.iter().filter(|e| x >= **e).count() as u8
}

/// The octave of a positive number.
pub(super) fn octave(x: f64) -> i32 {
    x.log2().floor() as i32
}

/// Counts a contact in its class, which is made if there is none yet.
pub(super) fn enter<T: Copy>(
    classes: &mut Vec<Class<T>>,
    (octave, slant): (i32, u8),
    weight: u64,
    (impulse, dissipated): (f64, f64),
    drawn: Drawn<T>,
) {
    let one = Class {
        octave,
        slant,
        count: weight,
        impulse: impulse * weight as f64,
        dissipated: dissipated * weight as f64,
        examples: vec![drawn],
    };
    merge(classes, one);
}

/// Adds the contacts of a class to the class of the same octave and slant, or appends it.
pub(super) fn merge<T: Copy>(classes: &mut Vec<Class<T>>, other: Class<T>) {
    let same = |c: &&mut Class<T>| (c.octave, c.slant) == (other.octave, other.slant);
    let Some(class) = classes.iter_mut().find(same) else {
        classes.push(other);
        return;
    };
    class.count += other.count;
    class.impulse += other.impulse;
    class.dissipated += other.dissipated;
    for drawn in other.examples {
        let at = class.examples.partition_point(|e| e.lot <= drawn.lot);
        if at < KEPT {
            class.examples.insert(at, drawn);
            class.examples.truncate(KEPT);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slip_that_is_rounding_alone_does_not_turn_the_axes() {
        let mut x = Contact::default();
        x.surface.en = Vector3::new(0.6, 0.0, 0.8);
        x.close.i.v = x.surface.en * -0.2;
        for slip in
            [Vector3::zeros(), x.surface.en * 5e-17, Vector3::new(3e-17, 1e-17, 4e-17), Vector3::y() * 1e-9]
        {
            x.surface.vtr = slip;
            let [n, t, s] = axes(&x);
            let most = [n.dot(&t), n.dot(&s), t.dot(&s)].map(f64::abs).into_iter().fold(0.0, f64::max);
            assert!(most < 1e-14 && (t.norm() - 1.0).abs() < 1e-14, "{slip:?} {t:?}");
        }
        // The slip itself is where it was.
        assert!((axes(&x)[1] - Vector3::y()).norm() < 1e-6);
    }
}
