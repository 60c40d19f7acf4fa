//! What is repeated of a probe: its important classes of contacts, and what the present chain does with them.
use super::classes::{counting, Sums};
use super::errors::{astray, wrong, Errors, Sure};
use super::group::{Contacts, Group};
use super::loaded::{hold, Held};
use super::rules::{FINE, PHASES, STUCK};
use super::run_time::RunTime;
use super::simulated::{self, Rebound};
use crate::probe::{Impact, Pressed, Probe};
use crate::trace::{Header, HeaderError};
use granlaw::chain::Chain;
use granlaw::model::Reach;
use rayon::prelude::*;

/// Number of contacts of each class on which a fit is made. The result is judged on all of them.
const FEW: usize = 3;

/// The contacts that are repeated, with their chains.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The pair style and the wall fixes.
    pub chains: Vec<Header>,
    /// Contact calls of each.
    pub calls: Vec<u64>,
    /// Laws that act across gaps, each with the index of its chain. What they do is not repeated, so that chain stays as it is.
    pub untried: Vec<(usize, String)>,
    /// The important classes.
    pub groups: Vec<Group>,
    /// Share of impacts and of momentum that the groups stand for.
    pub covered: (f64, f64),
    /// Circular frequency of the stiffest contact \[rad/s\].
    pub omega: f64,
    /// How long the probed run took.
    pub run_time: RunTime,
}

impl Scene {
    /// The important classes of a probe. The truth is the present chain in very small steps.
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
                groups.extend(p.impacts.iter().map(|i| sums.group((k, c), p, i, true)));
                groups.extend(p.pressed.iter().map(|l| sums.group((k, c), p, l, false)));
            }
        }
        counting(&mut groups);
        let (mut count, mut impulse) =
            groups.iter().fold((0.0, 0.0), |(c, i), g| (c + g.count, i + g.impulse));
        // Without any impact, or any momentum, everything is covered.
        count = if sums.count > 0.0 { count } else { 1.0 };
        impulse = if sums.impulse > 0.0 { impulse } else { 1.0 };
        let covered = (count, impulse);
        let headers = chains.iter().map(|c| c.header.clone()).collect();
        let calls = chains.iter().map(|c| c.calls).collect();
        let mut scene =
            Scene { chains: headers, calls, untried, groups, covered, omega, run_time: RunTime::of(probe) };
        scene.live();
        Ok(scene)
    }

    /// The same scene with some of its groups only, and a few contacts of each.
    pub(super) fn only(&self, of: impl Fn(&Group) -> bool) -> Scene {
        let mut groups: Vec<_> = self.groups.iter().filter(|g| of(g)).cloned().collect();
        groups.iter_mut().for_each(|g| match &mut g.contacts {
            Contacts::Impacts(all) => all.truncate(FEW),
            Contacts::Loads(all) => all.truncate(FEW),
        });
        Scene { chains: self.chains.clone(), calls: self.calls.clone(), untried: Vec::new(), groups, ..*self }
    }

    /// Whether a chain stays as it is, because nothing that it does was tried.
    pub(super) fn stays(&self, chain: usize) -> bool {
        self.groups.iter().all(|g| g.chain != chain)
    }

    /// The step that counts as infinitely small \[s\].
    pub fn fine(&self) -> f64 {
        simulated::half_period(self.omega) / FINE
    }

    /// The time step of the run \[s\].
    pub fn dt(&self) -> f64 {
        self.chains.first().map_or(0.0, |h| h.dt)
    }

    /// Computes the truth of every group.
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

    /// The errors of chains on every group in steps of `dt` \[s\], and the highest circular frequency met \[rad/s\].
    /// Loads are measured at rest, where the step does not matter: if their errors are `known`, they are not computed again.
    ///
    /// # Errors
    /// A law refuses.
    pub fn try_out(
        &self,
        chains: &[Header],
        dt: f64,
        known: Option<&[Errors]>,
        sure: Sure,
    ) -> Result<(Vec<Errors>, f64), HeaderError> {
        let tried = self.groups.par_iter().enumerate().map(|(k, g)| {
            if let (Some(known), Contacts::Loads(_)) = (known, &g.contacts) {
                return Ok((known[k], 0.0));
            }
            let mut bench = Bench::new(&chains[g.chain])?;
            Ok(bench.errors(g, dt, sure))
        });
        let all: Vec<_> = tried.collect::<Result<_, HeaderError>>()?;
        Ok((all.iter().map(|(e, _)| *e).collect(), all.iter().map(|(_, w)| *w).fold(0.0, f64::max)))
    }
}

/// A chain that moves the bodies, and a second one that is asked for stiffnesses.
struct Bench {
    chain: Chain,
    laws: Chain,
    /// Time step of the run, the unit of the contacts' durations \[s\].
    dt: f64,
}

impl Bench {
    fn new(header: &Header) -> Result<Bench, HeaderError> {
        Ok(Bench { chain: header.chain()?, laws: header.chain()?, dt: header.dt })
    }

    fn impact(&mut self, i: &Impact, dt: f64, phase: f64) -> Rebound {
        let longest = STUCK * i.end.steps as f64 * self.dt;
        simulated::impact(&mut self.chain, Some(&mut self.laws), i, (dt, phase, longest))
    }

    fn errors(&mut self, g: &Group, dt: f64, sure: Sure) -> (Errors, f64) {
        let mut most = 0.0f64;
        let mut seen = |errors, omega| {
            most = most.max(omega);
            errors
        };
        let errors = match &g.contacts {
            Contacts::Impacts(all) => {
                let one = |(k, (i, truth)): (usize, &(Impact, Rebound))| {
                    let turns = PHASES.map(|turn| {
                        // Contacts begin anywhere within a step; multiples of the golden section spread evenly.
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
        (Errors::mean(errors, sure), most)
    }
}
