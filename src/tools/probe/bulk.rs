//! What a scene does as a whole, sampled at up to [`SAMPLES`] moments, however long the run.
use serde::{Deserialize, Serialize};

/// The most samples. When there are so many, every second one is dropped, and from then on they are taken half as often.
pub const SAMPLES: usize = 512;

/// The scene over time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bulk {
    /// The wall fixes, in the order of [`Sample::walls`].
    pub walls: Vec<String>,
    /// The moments, evenly spaced in steps.
    pub samples: Vec<Sample>,
}

/// A moment, before the contact forces of its step. Contacts and wall forces are summed from the first step on: if samples are
/// dropped, the differences of the sums are still exact means over the time between.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sample {
    /// Number of the step.
    pub step: i64,
    /// Time since the first step \[s\].
    pub time: f64,
    /// Number of particles.
    pub particles: u64,
    /// Their mass \[kg\].
    pub mass: f64,
    /// Their kinetic energy without spin \[J\].
    pub kinetic: f64,
    /// That of their spin \[J\].
    pub rotational: f64,
    /// Sum of mass times position \[kg m\]; divided by the mass it is the centre of mass.
    pub moment: [f64; 3],
    /// The lowest coordinates that any particle reaches \[m\]; 0 where there is none.
    pub low: [f64; 3],
    /// The highest \[m\].
    pub high: [f64; 3],
    /// Contact calls between particles since the first step; divided by the steps it is the number of contacts.
    pub contacts: u64,
    /// Momentum that each wall fix has handed to the particles since the first step \[N s\].
    pub walls: Vec<[f64; 3]>,
}

/// Decides when a sample is taken.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    pub time: f64,
    last: Option<i64>,
    next: i64,
    every: i64,
}

impl Default for Clock {
    fn default() -> Clock {
        Clock { time: 0.0, last: None, next: i64::MIN, every: 1 }
    }
}

impl Clock {
    /// A step begins. Returns whether a sample is due.
    pub fn tick(&mut self, step: i64, dt: f64) -> bool {
        if let Some(last) = self.last {
            self.time += (step - last).max(0) as f64 * dt;
            // The deck may have set the number of the step back.
            if step < last {
                self.next = step;
            }
        }
        let due = step >= self.next && self.last != Some(step);
        self.last = Some(step);
        if due {
            self.next = step + self.every;
        }
        due
    }

    pub fn slower(&mut self) {
        self.every *= 2;
    }
}

impl Sample {
    /// Widens the extent to that of another one.
    fn meet(&mut self, other: &Sample) {
        if other.particles == 0 {
            return;
        }
        let empty = self.particles == 0;
        for d in 0..3 {
            self.low[d] = if empty { other.low[d] } else { self.low[d].min(other.low[d]) };
            self.high[d] = if empty { other.high[d] } else { self.high[d].max(other.high[d]) };
        }
    }

    /// Counts a particle of mass m \[kg\] and radius r \[m\].
    pub(super) fn particle(&mut self, (m, r): (f64, f64), x: &[f64], v: &[f64], omega: &[f64]) {
        let square = |v: &[f64]| v.iter().map(|c| c * c).sum::<f64>();
        for (d, x) in x.iter().enumerate() {
            self.moment[d] += m * x;
            self.low[d] = if self.particles == 0 { x - r } else { self.low[d].min(x - r) };
            self.high[d] = if self.particles == 0 { x + r } else { self.high[d].max(x + r) };
        }
        self.particles += 1;
        self.mass += m;
        self.kinetic += 0.5 * m * square(v);
        self.rotational += 0.5 * 0.4 * m * r * r * square(omega);
    }
}

impl Bulk {
    pub(super) fn add(&mut self, sample: Sample, clock: &mut Clock) {
        self.samples.push(sample);
        if self.samples.len() >= SAMPLES {
            let mut k = 0;
            self.samples.retain(|_| {
                k += 1;
                k % 2 == 1
            });
            clock.slower();
        }
    }

    /// Adds what another rank saw. All ranks take the same steps, and so the same samples.
    pub(super) fn merge(&mut self, other: Bulk) {
        for (k, wall) in other.walls.iter().enumerate() {
            let at = self.wall(wall);
            for (a, b) in self.samples.iter_mut().zip(&other.samples) {
                (0..3).for_each(|d| a.walls[at][d] += b.walls.get(k).map_or(0.0, |w| w[d]));
            }
        }
        for (a, b) in self.samples.iter_mut().zip(other.samples) {
            a.meet(&b);
            a.particles += b.particles;
            a.mass += b.mass;
            a.kinetic += b.kinetic;
            a.rotational += b.rotational;
            (0..3).for_each(|d| a.moment[d] += b.moment[d]);
            a.contacts += b.contacts;
        }
    }

    /// The index of a wall. A new wall is added, with zeros in all samples so far.
    pub(super) fn wall(&mut self, name: &str) -> usize {
        let at = self.walls.iter().position(|w| w == name).unwrap_or(self.walls.len());
        if at == self.walls.len() {
            self.walls.push(name.to_string());
        }
        let n = self.walls.len();
        self.samples.iter_mut().for_each(|s| s.walls.resize(n, [0.0; 3]));
        at
    }
}
