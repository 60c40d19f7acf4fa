//! Follows the contacts of one chain on one rank.
use super::call::Call;
use super::contacts::Contacts;
use super::followed::{Live, Over};
use super::tally::{Fastest, LawShare, TypePair};
use super::work::Motion;
use crate::trace::Header;
use granlaw::chain::Chain;
use granlaw::laws::prop;
use granlaw::model::{ClosePair, Contact, Kind, Reach, Response};
use nalgebra::Vector3;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;
use std::time::Instant;

/// At most so many contacts are followed at a time. When there are more, every second pair of particles is let go,
/// chosen by a hash of their numbers, and those that stay count twice.
pub const FOLLOWED: usize = 512;
/// Up to this many contacts are all followed. Of more, at most a quarter are, and mostly an eighth, as following a contact costs
/// more than evaluating it.
const FEW: usize = 4;
/// Up to this many are all followed where the cost does not matter.
const MANY: usize = 4096;

/// One in this many calls is timed. It is a prime number, so that it keeps no step with the order of the calls.
const TIMED: u64 = 61;
/// A call that seems to take longer than this was interrupted, and counts with this time \[s\].
const LONGEST: f64 = 5e-6;

/// Numbers of the partners, and a number that tells meshes apart, which may number their triangles alike.
type Key = (i64, i64, usize);

/// Follows the contacts of one chain.
pub struct Follower {
    contacts: Contacts,
    /// The laws, if granlaw has all of them, and their kinds.
    chain: Option<Chain>,
    kinds: Vec<Kind>,
    /// Which of them act across gaps.
    beyond: Vec<bool>,
    /// Coefficient of friction of each pair of types; infinite where there is none.
    mu: Vec<f64>,
    /// Where the types of a call are in `contacts.pairs`.
    places: Vec<Option<usize>>,
    live: FxHashMap<Key, Live>,
    /// Up to `few` contacts are all followed, and never more than `most`.
    few: usize,
    most: usize,
    /// Time that following took \[s\].
    seconds: f64,
    /// The present step, the number of calls before it, and that of the calls in the step before.
    step: i64,
    before: u64,
    touching: usize,
    history: Vec<f64>,
    /// The pairs of types for which it was warned that the time step is too long.
    told: Vec<bool>,
    /// The same for their bonds.
    told_bonds: Vec<bool>,
    /// Momentum that a wall handed to particles \[N s\]; zero for the pair style.
    pub(super) impulse: Vector3<f64>,
}

impl Follower {
    /// For the chain of a header, with at most `most` contacts followed at a time.
    pub fn new(header: Header, most: usize) -> Follower {
        let chain = header.chain().ok();
        let laws = || chain.iter().flat_map(Chain::laws);
        let kinds = laws().map(|m| m.kind).collect();
        let beyond = laws().map(|m| m.reach == Reach::Beyond).collect();
        let friction = header.laws.iter().flat_map(|l| &l.properties).find(|p| p.name == prop::FRICTION.name);
        let none = vec![f64::INFINITY; header.types * header.types];
        // Without friction there is no Coulomb limit, so nothing counts as slip.
        let mu = friction.map_or(none, |p| {
            p.values.iter().map(|mu| if *mu > 0.0 { *mu } else { f64::INFINITY }).collect()
        });
        let places = vec![None; header.types * header.types];
        let contacts = Contacts { header, share: 1, calls: 0, followed: 0, residual: 0.0, pairs: Vec::new() };
        let (live, history, told) = (FxHashMap::default(), Vec::new(), Vec::new());
        let told_bonds = vec![false; places.len()];
        Follower {
            contacts,
            chain,
            kinds,
            beyond,
            mu,
            places,
            live,
            few: FEW,
            most,
            seconds: 0.0,
            step: i64::MIN,
            before: 0,
            touching: 0,
            history,
            told,
            told_bonds,
            impulse: Vector3::zeros(),
        }
    }

    /// Follows up to [`MANY`] contacts, at any cost.
    pub fn closely(mut self) -> Follower {
        (self.few, self.most) = (MANY, MANY);
        self
    }

    /// Time that following took, estimated from a sample of the calls \[s\].
    pub(super) fn seconds(&self) -> f64 {
        self.seconds
    }

    pub(super) fn header(&self) -> &Header {
        &self.contacts.header
    }

    /// The pairs of types so far, and those for which there was a warning.
    pub(super) fn told(&mut self) -> (&[TypePair], &mut Vec<bool>) {
        (&self.contacts.pairs, &mut self.told)
    }

    /// The laws, if granlaw has all of them, and the pairs of types for which there was a warning about bonds.
    pub(super) fn bonds(&mut self) -> Option<(&mut Chain, &mut Vec<bool>)> {
        self.chain.as_mut().map(|chain| (chain, &mut self.told_bonds))
    }

    pub(super) fn calls(&self) -> u64 {
        self.contacts.calls
    }

    /// Counts a call of this chain with overlapping surfaces. Returns whether the contact is followed: then [`Follower::touched`] is
    /// to be called too. This function is cheap.
    #[inline]
    pub fn sees(&mut self, tags: (i64, i64)) -> bool {
        self.contacts.calls += 1;
        drawn(tags, self.contacts.share)
    }

    /// Adds the force of a wall on a particle in a step.
    #[inline]
    pub fn pushed(&mut self, force: &Vector3<f64>, dt: f64) {
        self.impulse += force * dt;
    }

    /// A call of a followed contact that may write history.
    pub fn touched(&mut self, call: &Call<'_>) {
        if !self.contacts.calls.is_multiple_of(TIMED) {
            return self.follow(call);
        }
        let begun = Instant::now();
        self.follow(call);
        self.seconds += begun.elapsed().as_secs_f64().min(LONGEST) * TIMED as f64;
    }

    /// A call of this chain without overlap that may write history, with the history before it. For pairs that are followed, the
    /// load of laws that act across gaps is counted.
    pub fn across(&mut self, types: (usize, usize), gap: &ClosePair, before: &[f64]) {
        let share = self.contacts.share;
        let Some(chain) = self.chain.as_mut().filter(|_| drawn((gap.i.tag, gap.j.tag), share)) else {
            return;
        };
        let mut load = 0.0f64;
        let beyond = &self.beyond;
        let x = Contact { close: *gap, ..Contact::default() };
        chain.observe_each(types, &x, &before[..chain.row()], |k, t| {
            if beyond[k] {
                load = load.max(t.load);
            }
        });
        // Without a bond, or with one that carries nothing, there is nothing to count.
        if load > 0.0 {
            let at = self.place(types, gap.call.is_wall);
            let gaps = &mut self.contacts.pairs[at].gaps;
            gaps.time += gap.call.dt * share as f64;
            gaps.load.add(load, share);
        }
    }

    fn follow(&mut self, call: &Call<'_>) {
        let g = &call.contact.close;
        let (i, j, place) = (g.i.tag, g.j.tag, call.place);
        let key = if g.call.is_wall { (i, j, place) } else { (i.min(j), i.max(j), place) };
        self.tick(g.call.step);
        if self.live.len() >= self.room() && !self.live.contains_key(&key) {
            self.make_room(g.call.step);
            if !drawn((key.0, key.1), self.contacts.share) {
                return;
            }
        }
        let at = self.place(call.types, g.call.is_wall);
        let mu = self.mu[call.types.0 * self.contacts.header.types + call.types.1];
        let pair = &mut self.contacts.pairs[at];
        let (step, share) = (g.call.step, self.contacts.share);
        let new = |pair: &mut TypePair| Live::new(at, call, lot(key, step), share, pair);
        let live = match self.live.entry(key) {
            Entry::Vacant(v) => v.insert(new(pair)),
            Entry::Occupied(o) if o.get().last == step => return,
            Entry::Occupied(mut o) => {
                if o.get().last < step - 1 {
                    o.insert(new(pair)).end(Over::Gone, pair);
                }
                o.into_mut()
            }
        };
        self.contacts.followed += 1;
        let motion = Motion::of(call);
        let (load, residual) = match (&mut self.chain, live.turn()) {
            (Some(chain), turn) if turn > 0 => {
                let weight = (live.weight() * turn) as f64;
                laws((chain, &self.kinds), &mut self.history, call, &motion, weight, pair)
            }
            _ => (0.0, 0.0),
        };
        if self.chain.is_none() {
            let (stiffness, damping) = (call.handed.kn, call.handed.gamman);
            pair.fastest.meet(Fastest { stiffness, meff: g.meff, damping });
        }
        self.contacts.residual = self.contacts.residual.max(residual);
        live.step(call, &motion, load, mu, pair);
    }

    /// The result, once the run is over.
    pub fn finish(mut self) -> Contacts {
        for (_, live) in std::mem::take(&mut self.live) {
            let at = live.at;
            live.end(Over::End, &mut self.contacts.pairs[at]);
        }
        self.contacts.pairs.sort_by_key(|p| p.types);
        self.contacts
    }

    fn tick(&mut self, step: i64) {
        if step != self.step {
            // The present call belongs to the new step.
            let calls = self.contacts.calls.saturating_sub(1);
            (self.touching, self.before, self.step) =
                ((calls.saturating_sub(self.before)) as usize, calls, step);
        }
    }

    fn room(&self) -> usize {
        (self.touching / 4).clamp(self.few, self.most.max(self.few))
    }

    fn place(&mut self, (i, j): (usize, usize), wall: bool) -> usize {
        let n = self.contacts.header.types;
        if let Some(at) = self.places[i * n + j] {
            return at;
        }
        let (low, high) = if wall { (i, j) } else { (i.min(j), i.max(j)) };
        let at = self.contacts.pairs.len();
        let name = |l: &crate::trace::LawSpec| format!("{} {}", l.kind, l.keyword);
        let share = |l| LawShare { law: name(l), ..LawShare::default() };
        let laws = match self.chain {
            Some(_) => self.contacts.header.laws.iter().map(share).collect(),
            None => Vec::new(),
        };
        self.contacts.pairs.push(TypePair { types: [low + 1, high + 1], laws, ..TypePair::default() });
        self.places[low * n + high] = Some(at);
        if !wall {
            self.places[high * n + low] = Some(at);
        }
        at
    }

    /// Contacts that were not called in the last step are over; if that is not enough, every second pair is let go.
    fn make_room(&mut self, step: i64) {
        let pairs = &mut self.contacts.pairs;
        let gone = self.live.extract_if(|_, l| l.last < step - 1);
        gone.for_each(|(_, l)| {
            let at = l.at;
            l.end(Over::Gone, &mut pairs[at]);
        });
        // A quarter of the room is left free, or this would happen at every call.
        while self.live.len() > self.room() * 3 / 4 {
            self.contacts.share *= 2;
            let share = self.contacts.share;
            // Contacts that are let go count as far as they were seen, as at the end of a run.
            for (_, l) in self.live.extract_if(|key, _| !drawn((key.0, key.1), share)) {
                let at = l.at;
                l.end(Over::End, &mut self.contacts.pairs[at]);
            }
        }
    }
}

/// Adds up what each law does. Returns the largest use of a limit, and the relative difference between the force of the laws and that
/// of the run.
fn laws(
    (chain, kinds): (&mut Chain, &[Kind]),
    history: &mut Vec<f64>,
    call: &Call<'_>,
    motion: &Motion,
    weight: f64,
    pair: &mut TypePair,
) -> (f64, f64) {
    let (x, dt) = (call.contact, call.contact.close.call.dt);
    history.clear();
    history.extend_from_slice(&call.before[..chain.row()]);
    let faster = motion.faster(&x.surface);
    let mut load = 0.0f64;
    let mut fastest = Fastest { meff: x.close.meff, ..Fastest::default() };
    let shares = &mut pair.laws;
    chain.observe_each(call.types, x, history, |k, t| {
        load = load.max(t.load);
        if matches!(kinds[k], Kind::Normal | Kind::Cohesion) {
            fastest.stiffness += t.stiffness;
            fastest.damping += t.damping;
        }
        // All work is taken along the mean velocity of the step, so that of a normal dashpot is too.
        let damped = if kinds[k] == Kind::Normal { t.dissipated * faster } else { t.dissipated };
        shares[k].observed(t.branch, damped, dt * weight);
    });
    pair.fastest.meet(fastest);
    let mut before = Response::default();
    let mut all = Response::default();
    chain.surfaces_intersect_each(call.types, x, history, &mut all, |k, s| {
        let force = (s.force - before.force) * call.share;
        let torque = |now: Vector3<f64>, then: Vector3<f64>| (now - then) * call.share;
        let torque_i = torque(s.torque_i, before.torque_i);
        let torque_j =
            if x.close.call.is_wall { Vector3::zeros() } else { torque(s.torque_j, before.torque_j) };
        add(&mut shares[k].work, motion.power(&force, &torque_i, &torque_j) * dt * weight);
        add(&mut shares[k].impulse, force.norm() * dt * weight);
        add(&mut shares[k].turn, torque_i.norm() * dt * weight);
        before = *s;
    });
    let (ours, theirs) = (all.force * call.share, call.force);
    let residual = if ours == theirs { 0.0 } else { (ours - theirs).norm() / ours.norm().max(theirs.norm()) };
    (load, residual)
}

/// Adds `x` if it is finite. Where surfaces just touch, rounding may make the overlap negative, and some springs then give NaN; that
/// force is not used where a bond takes its place.
fn add(sum: &mut f64, x: f64) {
    if x.is_finite() {
        *sum += x;
    }
}

/// Whether a pair of particles is followed, as one in `share` pairs is; `share` is a power of two.
#[inline]
fn drawn((i, j): (i64, i64), share: u64) -> bool {
    share == 1 || mix(i.min(j), i.max(j)) & (share - 1) == 0
}

/// The lot of a contact that began in a step, made of other bits than [`drawn`] looks at.
fn lot(key: Key, step: i64) -> u32 {
    (mix((mix(key.0, key.1) >> 1) as i64, step) >> 32) as u32
}

/// A hash whose every bit depends on every bit of both numbers (the finaliser of SplitMix64).
#[inline]
fn mix(a: i64, b: i64) -> u64 {
    let mut z = (a as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (b as u64).rotate_left(32);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
