//! All chains of a run on one rank.
use super::bulk::{Bulk, Clock, Sample};
use super::follow::{Follower, FOLLOWED};
use super::particle_types::{self, ParticleType};
use super::particles::Particles;
use super::times::Stopwatch;
use super::{Probe, FORMAT};
use crate::trace::Header;

/// Collects what a rank sees of a run.
#[derive(Default)]
pub struct Session {
    followers: Vec<Follower>,
    /// Whether as many contacts are followed as there is room for.
    all: bool,
    ranks: usize,
    grains: Vec<ParticleType>,
    unseen: Vec<String>,
    bulk: Bulk,
    clock: Clock,
    /// From the first step on.
    watch: Option<Stopwatch>,
}

impl Session {
    /// One that follows as many contacts as it has room for, at any cost.
    pub fn closely() -> Session {
        Session { all: true, ..Session::default() }
    }

    /// The place of the chain with this header, which is begun if there was none like it.
    pub fn chain(&mut self, mut header: Header) -> usize {
        self.ranks = header.ranks;
        // What differs between ranks, or is of traces only, does not make another chain.
        (header.rank, header.every) = (0, 1);
        header.particles.clear();
        let known = self.followers.iter().position(|f| *f.header() == header);
        known.unwrap_or_else(|| {
            if header.who != "pair" {
                self.bulk.wall(&header.who);
            }
            let follower = Follower::new(header, FOLLOWED);
            self.followers.push(if self.all { follower.closely() } else { follower });
            self.followers.len() - 1
        })
    }

    /// The contacts of this pair style or wall fix cannot be counted.
    pub fn unseen(&mut self, who: &str) {
        self.unseen.push(who.into());
    }

    /// The follower of a chain.
    ///
    /// # Panics
    /// If `at` is no place that [`Session::chain`] gave.
    pub fn follower(&mut self, at: usize) -> &mut Follower {
        &mut self.followers[at]
    }

    /// A step of dt \[s\] begins, for which the neighbour list was made anew or not. The result is whether [`Session::sample`]
    /// is to be called.
    pub fn tick(&mut self, step: i64, dt: f64, listed: bool) -> bool {
        match &mut self.watch {
            Some(watch) => watch.tick(listed),
            none => *none = Some(Stopwatch::new()),
        }
        self.clock.tick(step, dt)
    }

    /// The particles in a step for which [`Session::tick`] asked.
    pub fn sample(&mut self, step: i64, p: &Particles<'_>) {
        let mut s = Sample { step, time: self.clock.time, ..Sample::default() };
        particle_types::sample(&mut self.grains, p);
        for (k, size) in p.mass.iter().zip(p.radius).enumerate() {
            let at = 3 * k..3 * k + 3;
            s.particle((*size.0, *size.1), &p.x[at.clone()], &p.v[at.clone()], &p.omega[at]);
        }
        let pairs = self.followers.iter().filter(|f| f.header().who == "pair");
        s.contacts = pairs.map(Follower::calls).sum();
        s.walls = vec![[0.0; 3]; self.bulk.walls.len()];
        for f in &self.followers {
            if let Some(at) = self.bulk.walls.iter().position(|w| *w == f.header().who) {
                (0..3).for_each(|d| s.walls[at][d] += f.impulse[d]);
            }
        }
        self.bulk.add(s, &mut self.clock);
    }

    /// A sentence for the next pair of types whose bonds the time step is too long for; once for each.
    pub fn bonds_alarm(&mut self) -> Option<String> {
        let grains = &self.grains;
        self.followers.iter_mut().find_map(|f| f.bonds_alarm(grains))
    }

    /// The run is over.
    pub fn finish(self) -> Probe {
        let Session { followers, ranks, grains, unseen, bulk, watch, .. } = self;
        let (seconds, mut times) = watch.map_or_else(Default::default, |w| w.read());
        times.probe = followers.iter().map(Follower::seconds).sum();
        let chains = followers.into_iter().map(Follower::finish).collect();
        let (format, ranks) = (FORMAT.into(), ranks.max(1));
        Probe { format, ranks, seconds, times, chains, unseen, grains, bulk }
    }
}
