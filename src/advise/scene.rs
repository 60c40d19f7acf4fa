//! What of a probe is lived through again: its important classes of contacts, and what the present chain makes of them.
use super::held::{hold, Held};
use super::lived::{self, Rebound};
use super::rules::{COVERED, FINE, IMPORTANT, PHASES, STUCK};
use crate::chain::Chain;
use crate::law::Reach;
use crate::probe::{Class, Drawn, Impact, Pressed, Probe, TypePair};
use crate::trace::{Header, HeaderError};
use rayon::prelude::*;
use serde::Serialize;

/// Contacts of each class that a fit is made on; it is judged on all.
const FEW: usize = 3;

/// A class of contacts that is lived through again.
#[derive(Clone, Debug, Serialize)]
pub struct Group {
    /// Which contacts, in words.
    pub name: String,
    /// The chain that they belong to.
    pub chain: usize,
    /// Atom types from 1, the lower first.
    pub types: [usize; 2],
    /// Share of all impacts; 0 for loads.
    pub count: f64,
    /// Share of the momentum exchanged along normals by all contacts.
    pub impulse: f64,
    /// Share of the work that all contacts took out of the motion.
    pub dissipated: f64,
    /// The contacts, with what the present chain makes of them in very small steps.
    #[serde(skip)]
    pub contacts: Contacts,
}

/// The contacts of a class.
#[derive(Clone, Debug)]
pub enum Contacts {
    /// Impacts.
    Impacts(Vec<(Impact, Rebound)>),
    /// Loads.
    Loads(Vec<(Pressed, Held)>),
}

/// What a chain gets wrong of a class: the mean over its contacts, and the standard error of that mean on top, so that
/// other contacts of the class may be expected to come out no worse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Normal speed afterwards over that before, absolute.
    pub restitution: f64,
    /// Contact time, relative.
    pub time: f64,
    /// Surface speed by spin afterwards, over the speed of the impact.
    pub spin: f64,
    /// Square root of overlap over R* under a load: the coordination number of a packing goes with it.
    pub overlap: f64,
    /// Tangential force that is borne at rest, over the normal load.
    pub shear: f64,
    /// Torque against rolling or torsion, over the normal load times R*.
    pub torque: f64,
    /// Attraction that is borne, over the normal load.
    pub tension: f64,
}

/// What is lived through again, and how.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The pair style and the wall fixes.
    pub chains: Vec<Header>,
    /// Contact calls of each.
    pub calls: Vec<u64>,
    /// Laws that act across gaps, with their chain: what they do is not lived through again, so that chain stays as it is.
    pub untried: Vec<(usize, String)>,
    /// Important classes.
    pub groups: Vec<Group>,
    /// Share of impacts and of momentum that the groups stand for.
    pub covered: (f64, f64),
    /// Circular frequency of the stiffest contact \[rad/s\].
    pub omega: f64,
    /// Processor time of the probed run per contact call \[ns\].
    pub per_call: f64,
}

impl Errors {
    fn all(&mut self) -> [&mut f64; 7] {
        let Errors { restitution, time, spin, overlap, shear, torque, tension } = self;
        [restitution, time, spin, overlap, shear, torque, tension]
    }

    /// Of one contact that began at two moments of a step.
    fn halfway([mut a, mut b]: [Errors; 2]) -> Errors {
        a.all().into_iter().zip(b.all()).for_each(|(a, b)| *a = 0.5 * (*a + *b));
        a
    }

    /// Of many contacts.
    fn mean(mut of: Vec<Errors>) -> Errors {
        let n = of.len() as f64;
        let mut mean = Errors::default();
        for (k, out) in mean.all().into_iter().enumerate() {
            let values: Vec<f64> = of.iter_mut().map(|e| *e.all()[k]).collect();
            let m = values.iter().sum::<f64>() / n;
            let square = values.iter().map(|x| (x - m) * (x - m)).sum::<f64>();
            *out = if n > 1.0 { m + (square / (n - 1.0) / n).sqrt() } else { m };
        }
        mean
    }

    /// The largest with its name; contact time counts as far as it is asked for less closely.
    pub fn worst(&self, time: f64) -> (&'static str, f64) {
        let all = [
            ("restitution", self.restitution),
            ("contact time", self.time / time),
            ("spin", self.spin),
            ("overlap under load", self.overlap),
            ("shear held at rest", self.shear),
            ("torque against rolling", self.torque),
            ("attraction borne", self.tension),
        ];
        let worst =
            |a: (&'static str, f64), b: (&'static str, f64)| if worse(a.1, b.1) > a.1 { b } else { a };
        let found = all.into_iter().fold(("", 0.0), worst);
        if found.0 == "contact time" {
            (found.0, self.time)
        } else {
            found
        }
    }

    /// Whether all are within what is asked for: the accuracy, and for contact times a multiple of it.
    pub fn within(&self, accuracy: f64, time: f64) -> bool {
        let rest = [self.restitution, self.spin, self.overlap, self.shear, self.torque, self.tension];
        rest.iter().all(|e| *e <= accuracy) && self.time <= accuracy * time
    }
}

/// The larger; NaN is worse than anything.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

impl Scene {
    /// The important classes of a probe, with the present chain in very small steps as the truth.
    ///
    /// # Errors
    /// A chain has a law that granlaw lacks.
    pub fn of(probe: &Probe) -> Result<Scene, HeaderError> {
        let chains = probe.principal();
        let mut untried = Vec::new();
        for (k, c) in chains.iter().enumerate() {
            let laws = c.header.chain()?;
            untried
                .extend(laws.laws().filter(|m| m.reach == Reach::Beyond).map(|m| (k, m.keyword.to_string())));
        }
        let tried = |k: &usize| untried.iter().all(|(chain, _)| chain != k);
        let sums = Sums::of(chains.iter().enumerate().filter(|(k, _)| tried(k)).flat_map(|(_, c)| &c.pairs));
        let mut groups = Vec::new();
        let mut omega = 0.0f64;
        for (k, c) in chains.iter().enumerate().filter(|(k, _)| tried(k)) {
            for p in &c.pairs {
                omega = omega.max(p.fastest.omega());
                groups.extend(p.impacts.iter().map(|i| sums.group((k, &c.header.who), p, i, true)));
                groups.extend(p.pressed.iter().map(|l| sums.group((k, &c.header.who), p, l, false)));
            }
        }
        counting(&mut groups);
        let (mut count, mut impulse) =
            groups.iter().fold((0.0, 0.0), |(c, i), g| (c + g.count, i + g.impulse));
        // Of none they are all.
        count = if sums.count > 0.0 { count } else { 1.0 };
        impulse = if sums.impulse > 0.0 { impulse } else { 1.0 };
        let covered = (count, impulse);
        let every: u64 = probe.chains.iter().map(|c| c.calls).sum();
        let per_call = 1e9 * probe.seconds * probe.ranks as f64 / every.max(1) as f64;
        let headers = chains.iter().map(|c| c.header.clone()).collect();
        let calls = chains.iter().map(|c| c.calls).collect();
        let mut scene = Scene { chains: headers, calls, untried, groups, covered, omega, per_call };
        scene.live();
        Ok(scene)
    }

    /// The same with some of its groups, and a few contacts of each.
    pub(super) fn only(&self, of: impl Fn(&Group) -> bool) -> Scene {
        let mut groups: Vec<_> = self.groups.iter().filter(|g| of(g)).cloned().collect();
        groups.iter_mut().for_each(|g| match &mut g.contacts {
            Contacts::Impacts(all) => all.truncate(FEW),
            Contacts::Loads(all) => all.truncate(FEW),
        });
        Scene { chains: self.chains.clone(), calls: self.calls.clone(), untried: Vec::new(), groups, ..*self }
    }

    /// Whether a chain stays as it is: nothing that it does was tried.
    pub(super) fn stays(&self, chain: usize) -> bool {
        self.groups.iter().all(|g| g.chain != chain)
    }

    /// The step that counts as infinitely small \[s\].
    pub fn fine(&self) -> f64 {
        lived::half_period(self.omega) / FINE
    }

    /// The time step of the run \[s\].
    pub fn dt(&self) -> f64 {
        self.chains.first().map_or(0.0, |h| h.dt)
    }

    /// The truth of every group.
    fn live(&mut self) {
        let fine = self.fine();
        let chains = &self.chains;
        self.groups.par_iter_mut().for_each(|g| {
            let mut bench = Bench::new(&chains[g.chain]).expect("its laws are known");
            match &mut g.contacts {
                Contacts::Impacts(all) => {
                    all.iter_mut().for_each(|(i, r)| *r = bench.impact(i, fine, 0.5));
                }
                Contacts::Loads(all) => {
                    all.iter_mut().for_each(|(l, r)| *r = hold(&mut bench.chain, l, bench.dt))
                }
            }
        });
    }

    /// What chains get wrong of every group in steps of `dt` \[s\], and the highest circular frequency met \[rad/s\].
    /// Loads are held at rest, so that `known` errors of theirs in another step need not be found again.
    ///
    /// # Errors
    /// A law refuses.
    pub fn try_out(
        &self,
        chains: &[Header],
        dt: f64,
        known: Option<&[Errors]>,
    ) -> Result<(Vec<Errors>, f64), HeaderError> {
        let tried = self.groups.par_iter().enumerate().map(|(k, g)| {
            if let (Some(known), Contacts::Loads(_)) = (known, &g.contacts) {
                return Ok((known[k], 0.0));
            }
            let mut bench = Bench::new(&chains[g.chain])?;
            Ok(bench.errors(g, dt))
        });
        let all: Vec<_> = tried.collect::<Result<_, HeaderError>>()?;
        Ok((all.iter().map(|(e, _)| *e).collect(), all.iter().map(|(_, w)| *w).fold(0.0, f64::max)))
    }
}

/// A chain to move bodies with, and a second one to ask.
struct Bench {
    chain: Chain,
    laws: Chain,
    /// Time step of the run, in which the contacts' durations are given \[s\].
    dt: f64,
}

impl Bench {
    fn new(header: &Header) -> Result<Bench, HeaderError> {
        Ok(Bench { chain: header.chain()?, laws: header.chain()?, dt: header.dt })
    }

    fn impact(&mut self, i: &Impact, dt: f64, phase: f64) -> Rebound {
        let longest = STUCK * i.end.steps as f64 * self.dt;
        lived::impact(&mut self.chain, Some(&mut self.laws), i, (dt, phase, longest))
    }

    fn errors(&mut self, g: &Group, dt: f64) -> (Errors, f64) {
        let mut most = 0.0f64;
        let mut seen = |errors, omega| {
            most = most.max(omega);
            errors
        };
        let errors = match &g.contacts {
            Contacts::Impacts(all) => {
                let one = |(k, (i, truth)): (usize, &(Impact, Rebound))| {
                    let turns = PHASES.map(|turn| {
                        // Contacts begin anywhere within a step; the golden section spreads evenly.
                        let got = self.impact(i, dt, (turn + 0.618 * k as f64).fract());
                        seen(wrong(i, truth, &got), got.omega)
                    });
                    Errors::halfway(turns)
                };
                all.iter().enumerate().map(one).collect()
            }
            Contacts::Loads(all) => {
                let one = |(l, truth): &(Pressed, Held)| {
                    let got = hold(&mut self.chain, l, self.dt);
                    seen(astray(l, truth, &got), got.omega)
                };
                all.iter().map(one).collect()
            }
        };
        (Errors::mean(errors), most)
    }
}

fn wrong(i: &Impact, truth: &Rebound, got: &Rebound) -> Errors {
    let speed = i.v[0].hypot(i.slip);
    let spin = |k: usize| (got.spin[k] - truth.spin[k]).norm() * i.partners.radius[k] / speed;
    let time = match (truth.time.is_finite(), got.time.is_finite()) {
        (true, true) => (got.time / truth.time - 1.0).abs(),
        (false, false) => 0.0,
        // One sticks and the other does not.
        _ => 1.0,
    };
    Errors {
        restitution: (got.restitution - truth.restitution).abs(),
        time,
        spin: worse(spin(0), spin(1)),
        ..Errors::default()
    }
}

fn astray(l: &Pressed, truth: &Held, got: &Held) -> Errors {
    let torque = |k: usize| (got.torque[k] - truth.torque[k]).abs();
    let root = |h: &Held| (h.overlap / l.partners.reff()).sqrt();
    Errors {
        overlap: (root(got) - root(truth)).abs(),
        shear: (got.shear - truth.shear).abs(),
        torque: worse(torque(0), torque(1)),
        tension: (got.tension - truth.tension).abs(),
        ..Errors::default()
    }
}

/// Leaves the classes that count: those with a share of their own, and the next larger ones as far as they are needed to
/// cover the scene.
fn counting(groups: &mut Vec<Group>) {
    let mut counts: Vec<bool> =
        groups.iter().map(|g| g.count.max(g.impulse).max(g.dissipated) >= IMPORTANT).collect();
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

/// What shares are of.
struct Sums {
    count: f64,
    impulse: f64,
    dissipated: f64,
}

impl Sums {
    fn of<'a>(pairs: impl Iterator<Item = &'a TypePair>) -> Sums {
        let mut s = Sums { count: 0.0, impulse: 0.0, dissipated: 0.0 };
        for p in pairs {
            s.count += p.impacts.iter().map(|c| c.count as f64).sum::<f64>();
            s.impulse += p.impulse.normal;
            s.dissipated += -p.work.sum();
        }
        s
    }

    fn group<T: Kept>(&self, (chain, who): (usize, &str), p: &TypePair, c: &Class<T>, impact: bool) -> Group {
        let share = |x: f64, of: f64| if of > 0.0 { x / of } else { 0.0 };
        let [a, b] = p.types;
        Group {
            name: format!("{who} {a}-{b}: {}", T::words(c.octave, c.slant)),
            chain,
            types: [a.min(b), a.max(b)],
            count: if impact { share(c.count as f64, self.count) } else { 0.0 },
            impulse: share(c.impulse, self.impulse),
            dissipated: share(c.dissipated, self.dissipated),
            contacts: T::contacts(&c.examples),
        }
    }
}

/// What a class keeps examples of.
trait Kept: Sized {
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

/// A power of two with two digits.
fn power(octave: i32) -> String {
    let x = f64::from(octave).exp2();
    let digits = (1 - x.log10().floor() as i32).max(0) as usize;
    if !(1e-3..1e4).contains(&x) {
        format!("{x:.1e}")
    } else {
        format!("{x:.digits$}")
    }
}
