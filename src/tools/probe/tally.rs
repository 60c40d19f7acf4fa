//! What the contacts of one pair of atom types do.
use super::examples::{self, Class, Impact, Pressed};
use super::Histogram;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The contacts of one pair of atom types, or of a type with the walls of one fix. Where contacts are drawn (see
/// [`super::Contacts::share`]), each counts for those that it stands for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TypePair {
    /// Atom types from 1, the lower first; of a wall, the type of its material behind that of the particle.
    pub types: [usize; 2],
    /// How contacts began and ended.
    pub counts: Counts,
    /// Contact time of all contacts together \[s\].
    pub time: f64,
    /// The part of it in which friction was at its Coulomb limit \[s\]; 0 without a `coefficientFriction`.
    pub slip: f64,
    /// Momentum exchanged \[N s\].
    pub impulse: Impulse,
    /// Work done on the bodies by the whole chain, by direction \[J\]; what was dissipated is negative.
    pub work: Directions,
    /// Shares of the laws, in the order of the chain; empty if the chain has a law that granlaw lacks.
    pub laws: Vec<LawShare>,
    /// The fastest contact.
    pub fastest: Fastest,
    /// Normal speed at first touch \[m/s\].
    pub impact_speed: Histogram,
    /// Slip speed at first touch \[m/s\].
    pub impact_slip: Histogram,
    /// Normal speed after over before, of impacts that were seen whole.
    pub restitution: Histogram,
    /// Largest overlap of a contact over R*.
    pub overlap: Histogram,
    /// Steps that a contact lasted, of those seen whole.
    pub steps: Histogram,
    /// Largest use of a law's own limit in a contact, such as δmax/δlim.
    pub load: Histogram,
    /// Largest attraction in a contact over its largest repulsion.
    pub tension: Histogram,
    /// Tangential over normal force, once per contact and step.
    pub friction: Histogram,
    /// Bonds across gaps.
    #[serde(default)]
    pub gaps: Gaps,
    /// Contacts seen whole that ended within a few contact times, by impact speed and slip.
    pub impacts: Vec<Class<Impact>>,
    /// Contacts that lasted, by mean load.
    pub pressed: Vec<Class<Pressed>>,
}

/// The loads of laws that act across gaps, while surfaces do not overlap.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gaps {
    /// Time of all bonds together \[s\].
    pub time: f64,
    /// Use of the law's limit, such as the stress of a bond over its strength, once per bond and step; it
    /// reaches 1 when a bond breaks.
    pub load: Histogram,
}

/// How contacts began and ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// The surfaces met.
    pub began: u64,
    /// They overlapped when first seen: at the start of a run, or on another rank than before.
    pub found: u64,
    /// The surfaces parted.
    pub parted: u64,
    /// They overlapped when last seen: particles that left, or went to another rank.
    pub lost: u64,
    /// They still touch at the end.
    pub open: u64,
}

/// Momentum exchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Impulse {
    /// Along the normal \[N s\].
    pub normal: f64,
    /// Across it \[N s\].
    pub tangential: f64,
}

/// Work by direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Directions {
    /// Along the normal \[J\].
    pub normal: f64,
    /// Along the slip of the surfaces, spin included \[J\].
    pub tangential: f64,
    /// By torques that are not the lever of a force, against spin about tangents \[J\].
    pub rolling: f64,
    /// Likewise, against spin about the normal \[J\].
    pub torsion: f64,
}

/// What one law of the chain did.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawShare {
    /// Its kind and keyword, for instance `normal hooke/hysteresis`.
    pub law: String,
    /// Work that it did on the bodies \[J\]; what it dissipated, or still stores, is negative.
    pub work: f64,
    /// What its dashpot took out of the motion \[J\].
    pub damped: f64,
    /// Momentum exchanged by its forces \[N s\].
    pub impulse: f64,
    /// Angular momentum exchanged by its torques \[N m s\].
    pub turn: f64,
    /// Contact time on each of its branches \[s\].
    pub branches: Branches,
}

/// Contact time on each branch of a law \[s\]. Laws have few branches, so a list is searched faster than a map.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "BTreeMap<String, f64>", into = "BTreeMap<String, f64>")]
pub struct Branches(Vec<(Cow<'static, str>, f64)>);

impl Branches {
    fn add(&mut self, branch: &str, time: f64, own: impl FnOnce() -> Cow<'static, str>) {
        match self.0.iter_mut().find(|(b, _)| b == branch) {
            Some((_, sum)) => *sum += time,
            None => self.0.push((own(), time)),
        }
    }

    /// The branches with their times.
    pub fn iter(&self) -> impl Iterator<Item = (&str, f64)> {
        self.0.iter().map(|(b, t)| (b.as_ref(), *t))
    }
}

impl From<BTreeMap<String, f64>> for Branches {
    fn from(map: BTreeMap<String, f64>) -> Branches {
        Branches(map.into_iter().map(|(b, t)| (b.into(), t)).collect())
    }
}

impl From<Branches> for BTreeMap<String, f64> {
    fn from(b: Branches) -> BTreeMap<String, f64> {
        b.0.into_iter().map(|(b, t)| (b.into_owned(), t)).collect()
    }
}

/// The contact with the stiffest tangent for its mass, which limits the time step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fastest {
    /// Its tangent stiffness \[N/m\].
    pub stiffness: f64,
    /// Its effective mass \[kg\].
    pub meff: f64,
    /// Its damping \[N s/m\].
    pub damping: f64,
}

impl Fastest {
    /// Undamped circular frequency \[rad/s\]; 0 if there was no contact.
    pub fn omega(&self) -> f64 {
        if self.meff > 0.0 {
            (self.stiffness / self.meff).sqrt()
        } else {
            0.0
        }
    }

    pub(super) fn meet(&mut self, other: Fastest) {
        // At the kink between two branches the tangent of a law may be infinite.
        if other.omega().is_finite() && other.omega() > self.omega() {
            *self = other;
        }
    }
}

impl Counts {
    pub(super) fn merge(&mut self, o: &Counts) {
        let Counts { began, found, parted, lost, open } = self;
        let pairs = [(began, o.began), (found, o.found), (parted, o.parted), (lost, o.lost), (open, o.open)];
        pairs.into_iter().for_each(|(a, b)| *a += b);
    }
}

impl Directions {
    /// The sum of all directions \[J\].
    pub fn sum(&self) -> f64 {
        self.normal + self.tangential + self.rolling + self.torsion
    }

    pub(super) fn add(&mut self, o: &Directions, weight: f64) {
        self.normal += o.normal * weight;
        self.tangential += o.tangential * weight;
        self.rolling += o.rolling * weight;
        self.torsion += o.torsion * weight;
    }
}

impl LawShare {
    /// The law was on a branch for a time \[s\], with this power going into its dashpot \[W\].
    pub(super) fn observed(&mut self, branch: &'static str, damped: f64, time: f64) {
        // See `add` of the follower.
        self.damped += if damped.is_finite() { damped * time } else { 0.0 };
        self.branches.add(branch, time, || branch.into());
    }

    fn merge(&mut self, o: &LawShare) {
        self.work += o.work;
        self.damped += o.damped;
        self.impulse += o.impulse;
        self.turn += o.turn;
        o.branches.iter().for_each(|(b, t)| self.branches.add(b, t, || b.to_string().into()));
    }
}

impl TypePair {
    /// Adds what another rank saw of the same types.
    pub(super) fn merge(&mut self, o: TypePair) {
        self.counts.merge(&o.counts);
        self.time += o.time;
        self.slip += o.slip;
        self.impulse.normal += o.impulse.normal;
        self.impulse.tangential += o.impulse.tangential;
        self.work.add(&o.work, 1.0);
        self.laws.iter_mut().zip(&o.laws).for_each(|(a, b)| a.merge(b));
        self.fastest.meet(o.fastest);
        let (mine, others) = (self.histograms_mut(), o.histograms());
        mine.into_iter().zip(others).for_each(|(a, b)| a.merge(b));
        self.gaps.time += o.gaps.time;
        self.gaps.load.merge(&o.gaps.load);
        o.impacts.into_iter().for_each(|c| examples::merge(&mut self.impacts, c));
        o.pressed.into_iter().for_each(|c| examples::merge(&mut self.pressed, c));
    }

    fn histograms(&self) -> [&Histogram; 8] {
        [
            &self.impact_speed,
            &self.impact_slip,
            &self.restitution,
            &self.overlap,
            &self.steps,
            &self.load,
            &self.tension,
            &self.friction,
        ]
    }

    fn histograms_mut(&mut self) -> [&mut Histogram; 8] {
        [
            &mut self.impact_speed,
            &mut self.impact_slip,
            &mut self.restitution,
            &mut self.overlap,
            &mut self.steps,
            &mut self.load,
            &mut self.tension,
            &mut self.friction,
        ]
    }
}
