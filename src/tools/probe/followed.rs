//! A followed contact, while it lasts.
use super::call::Call;
use super::examples::{self, Drawn, Impact, Partners, Pressed};
use super::tally::TypePair;
use super::work::Motion;

/// A contact that lasts longer than this many half periods of its own spring counts as pressed, a shorter one as an impact.
const IMPACT: f64 = 8.0;
/// From then on its laws are evaluated only in one of this many steps, and the result counts for all of them: it changes little from one
/// step to the next, and evaluating laws is most of the cost of a probe.
const SELDOM: u64 = 4;

/// A followed contact.
pub(super) struct Live {
    /// Index of its [`TypePair`].
    pub at: usize,
    pub last: i64,
    lot: u32,
    weight: u64,
    /// The first state, if the contact was seen to begin.
    whole: Option<Box<Impact>>,
    partners: Partners,
    steps: u64,
    time: f64,
    overlap: f64,
    push: f64,
    pull: f64,
    load: f64,
    /// Largest kn that the normal law gave to the laws after it \[N/m\].
    kn: f64,
    impulse: [f64; 2],
    work: f64,
    /// Normal velocity after the last force has acted \[m/s\], and whether the surfaces part in the next step at that velocity.
    out: f64,
    parts: bool,
}

/// Why a contact is over.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Over {
    /// It was not called again.
    Gone,
    /// The run is over.
    End,
}

impl Live {
    pub fn new(at: usize, call: &Call<'_>, lot: u32, weight: u64, pair: &mut TypePair) -> Live {
        let s = &call.contact.surface;
        let whole = began(call).then(|| Box::new(Impact::of(call)));
        if whole.is_some() {
            pair.counts.began += weight;
            pair.impact_speed.add(-s.vn, weight);
            pair.impact_slip.add(s.vtr.norm(), weight);
        } else {
            pair.counts.found += weight;
        }
        Live {
            at,
            last: call.contact.close.call.step,
            lot,
            weight,
            whole,
            partners: Partners::of(call),
            steps: 0,
            time: 0.0,
            overlap: 0.0,
            push: 0.0,
            pull: 0.0,
            load: 0.0,
            kn: 0.0,
            impulse: [0.0; 2],
            work: 0.0,
            out: 0.0,
            parts: false,
        }
    }

    /// A step of the contact. `load` is the largest use of a limit that the laws report, `mu` the coefficient of friction.
    pub fn step(&mut self, call: &Call<'_>, motion: &Motion, load: f64, mu: f64, pair: &mut TypePair) {
        let (s, dt) = (&call.contact.surface, call.contact.close.call.dt);
        let (weight, many) = (self.weight, self.weight as f64);
        let normal = call.force.dot(&s.en);
        let tangential = (call.force - s.en * normal).norm();
        self.last = call.contact.close.call.step;
        self.steps += 1;
        self.time += dt;
        self.overlap = self.overlap.max(s.deltan);
        (self.push, self.pull) = (self.push.max(normal), self.pull.max(-normal));
        self.load = self.load.max(load);
        self.kn = self.kn.max(call.handed.kn);
        self.impulse[0] += normal.abs() * dt;
        self.impulse[1] += tangential * dt;
        self.out = s.vn + normal * dt / call.contact.close.meff;
        // The factor 1.5 leaves room for a normal that turns and a velocity that still changes a little.
        self.parts = s.deltan <= 1.5 * self.out * dt + reach(call);
        let done = motion.directions(call, normal);
        self.work += done.sum();
        pair.time += dt * many;
        pair.impulse.normal += normal.abs() * dt * many;
        pair.impulse.tangential += tangential * dt * many;
        pair.work.add(&done, many);
        let used = tangential / call.handed.fn_.abs();
        pair.friction.add(used, weight);
        // The limit itself is rounded.
        if used >= mu * (1.0 - 1e-9) {
            pair.slip += dt * many;
        }
    }

    /// For how many steps an evaluation of the laws in this step is to count; 0 if they are not to be evaluated.
    pub fn turn(&self) -> u64 {
        match self.lasted() {
            false => 1,
            true if self.steps.is_multiple_of(SELDOM) => SELDOM,
            true => 0,
        }
    }

    /// Whether it has lasted too long to be an impact.
    fn lasted(&self) -> bool {
        let longest = IMPACT * std::f64::consts::PI;
        self.time * self.time * self.kn > longest * longest * self.partners.meff
    }

    /// The contact is over; adds it to its pair of types.
    pub fn end(mut self, over: Over, pair: &mut TypePair) {
        let weight = self.weight;
        let parted = self.parts;
        match (parted, over) {
            (true, _) => pair.counts.parted += weight,
            (false, Over::Gone) => pair.counts.lost += weight,
            (false, Over::End) => pair.counts.open += weight,
        }
        pair.overlap.add(self.overlap / self.partners.reff(), weight);
        pair.load.add(self.load, weight);
        if self.push > 0.0 {
            pair.tension.add(self.pull / self.push, weight);
        }
        let seen_whole = self.whole.take().filter(|_| parted);
        if seen_whole.is_some() {
            pair.steps.add(self.steps as f64, weight);
        }
        let lasted = self.lasted();
        match seen_whole {
            Some(impact) if !lasted => self.impact(*impact, pair),
            _ if lasted => self.pressed(pair),
            _ => {}
        }
    }

    fn impact(&self, mut impact: Impact, pair: &mut TypePair) {
        let restitution = self.out / -impact.v[0];
        let (steps, overlap, dissipated) = (self.steps, self.overlap, -self.work);
        impact.end = examples::End { steps, overlap, restitution, dissipated };
        pair.restitution.add(restitution, self.weight);
        let class = (examples::octave(-impact.v[0]), impact.slant());
        let drawn = Drawn { lot: self.lot, what: impact };
        examples::enter(&mut pair.impacts, class, self.weight, (self.impulse[0], dissipated), drawn);
    }

    fn pressed(&self, pair: &mut TypePair) {
        let [normal, tangential] = self.impulse.map(|i| i / self.time);
        if normal <= 0.0 {
            return;
        }
        let Live { partners, push, pull, time, kn, .. } = *self;
        let pressed = Pressed { partners, normal, tangential, push, pull, time, kn };
        let class = (examples::octave(normal), pressed.slant());
        let drawn = Drawn { lot: self.lot, what: pressed };
        examples::enter(&mut pair.pressed, class, self.weight, (self.impulse[0], -self.work), drawn);
    }

    pub fn weight(&self) -> u64 {
        self.weight
    }
}

/// Whether the surfaces first touched in the last step: then the overlap is not larger than the distance moved in that step.
fn began(call: &Call<'_>) -> bool {
    let s = &call.contact.surface;
    s.vn < 0.0 && s.deltan <= -s.vn * call.contact.close.call.dt + reach(call)
}

/// How much the distance can change in a step apart from the normal velocity \[m\], as the normal turns and numbers are rounded.
fn reach(call: &Call<'_>) -> f64 {
    let g = &call.contact.close;
    let moved = (g.i.v - g.j.v).norm() * g.call.dt;
    moved * moved / (g.i.radius + g.j.radius) + 1e-12 * g.i.radius
}
