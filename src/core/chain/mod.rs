//! The chosen laws over one contact, in LIGGGHTS's order, with their histories side by side in one row.
use crate::model::{
    BondEvent, Call, ClosePair, Contact, ContactFlag, Effects, Kernel, LawError, Meta, NamedMode,
    Observation, Reach, Response, Setup, Size, ATOM_OUTPUTS,
};

mod host;

pub use host::Wall;

struct Link {
    meta: &'static Meta,
    kernel: Box<dyn Kernel>,
}

/// What a chain does besides forces and history.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChainEffects {
    /// Bits of LIGGGHTS's contact flags to set; `1 << kind`.
    pub set: i32,
    /// Bits to clear.
    pub clear: i32,
    /// Whether there is a force although surfaces do not overlap.
    pub acts: bool,
    /// Whether force and torques stand in place of those that LIGGGHTS's laws before this chain gave.
    pub replaces: bool,
    /// What becomes of the bond of the law that keeps bonds.
    pub bond_event: BondEvent,
    /// What is added to i and to j, by [`AtomProp::place`](crate::model::AtomProp::place).
    pub outputs: [[f64; ATOM_OUTPUTS]; 2],
}

/// Where the slots of laws lie whose histories follow each other from slot 0.
pub fn packed(setups: &[Setup]) -> Vec<Vec<usize>> {
    let mut at = 0;
    let mut place = |s: &Setup| {
        let begin = at;
        at += s.slots().count();
        (begin..at).collect()
    };
    setups.iter().map(&mut place).collect()
}

/// The bonds that a chain has seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bonds {
    /// How many began.
    pub begun: u64,
    /// How many ended.
    pub ended: u64,
    /// How many there were in the step that was counted last.
    pub there: u64,
    /// That step.
    pub step: i64,
}

impl Bonds {
    fn count(&mut self, call: &Call, event: BondEvent) {
        if self.step != call.step {
            (self.step, self.there) = (call.step, 0);
        }
        match event {
            BondEvent::None => {}
            BondEvent::Begins => (self.begun, self.there) = (self.begun + 1, self.there + 1),
            BondEvent::Lasts => self.there += 1,
            BondEvent::Ends => self.ended += 1,
        }
    }
}

/// Laws of different kinds, prepared.
pub struct Chain {
    links: Vec<Link>,
    types: usize,
    row: usize,
    /// Whether a law acts across gaps; no other is fitted to surfaces that are apart.
    across: bool,
    /// What the laws are fitted to. Neighbouring contacts mostly have the same sizes, so the last fit mostly holds.
    fitted: Option<(usize, Size)>,
    bonds: Bonds,
}

impl Chain {
    /// Prepare laws; `places[k]` says where the slots that `setups[k]` calls for lie in a contact's row of history.
    /// The laws run in the order given, which should be that of [`crate::model::Kind::ALL`].
    ///
    /// # Errors
    /// The first thing that a law refuses, or a law that reads what none before it hands on.
    pub fn new(setups: &[Setup], places: &[Vec<usize>]) -> Result<Chain, LawError> {
        let mut links: Vec<Link> = Vec::with_capacity(setups.len());
        for (setup, places) in setups.iter().zip(places) {
            let meta = setup.law.meta;
            let missing = meta.reads.iter().find(|c| !links.iter().any(|l| l.meta.publishes.contains(c)));
            if let Some(missing) = missing {
                let what = format!(
                    "reads {}, which no law before it in the chain hands on; take a normal law that does",
                    missing.name()
                );
                return Err(LawError::Senseless { law: meta.called(setup.settings.taken_over()), what });
            }
            links.push(Link { meta, kernel: setup.law.prepare(setup, places)? });
        }
        let row = places.iter().flatten().map(|at| at + 1).max().unwrap_or(0);
        let (types, bonds) = (setups.first().map_or(0, |s| s.values.types), Bonds::default());
        let across = links.iter().any(|l: &Link| l.meta.reach == Reach::Beyond);
        Ok(Chain { links, types, row, across, fitted: None, bonds })
    }

    /// Laws whose histories lie one behind the other from slot 0.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn packed(setups: &[Setup]) -> Result<Chain, LawError> {
        Chain::new(setups, &packed(setups))
    }

    /// The laws, in order.
    pub fn laws(&self) -> impl Iterator<Item = &'static Meta> + '_ {
        self.links.iter().map(|l| l.meta)
    }

    /// Number of atom types.
    pub fn types(&self) -> usize {
        self.types
    }

    /// The length that a row of history must have at least.
    pub fn row(&self) -> usize {
        self.row
    }

    /// The surfaces overlap. `types` are the atom types counted from 0, `h` is the contact's row of history; what
    /// `s` holds already is kept and added to.
    #[inline]
    pub fn surfaces_intersect(
        &mut self,
        types: (usize, usize),
        x: &Contact,
        h: &mut [f64],
        s: &mut Response,
    ) -> ChainEffects {
        self.fit(types, &x.close);
        self.run(&x.close.call, h, s, |kernel, h, s, e| kernel.surfaces_intersect(x, h, s, e))
    }

    /// As [`Chain::surfaces_intersect`]; `each` sees what is handed along after every law, told by its place in the chain.
    pub fn surfaces_intersect_each(
        &mut self,
        types: (usize, usize),
        x: &Contact,
        h: &mut [f64],
        s: &mut Response,
        mut each: impl FnMut(usize, &Response),
    ) {
        self.fit(types, &x.close);
        for (k, link) in self.links.iter().enumerate() {
            link.kernel.surfaces_intersect(x, h, s, &mut Effects::default());
            each(k, s);
        }
    }

    /// They do not.
    pub fn surfaces_close(
        &mut self,
        types: (usize, usize),
        x: &ClosePair,
        h: &mut [f64],
        s: &mut Response,
    ) -> ChainEffects {
        if self.across {
            self.fit(types, x);
        }
        self.run(&x.call, h, s, |kernel, h, s, e| kernel.surfaces_close(x, h, s, e))
    }

    #[inline]
    fn fit(&mut self, types: (usize, usize), x: &ClosePair) {
        self.fit_to(types, x.size());
    }

    #[inline]
    fn fit_to(&mut self, types: (usize, usize), size: Size) {
        let pair = types.0 * self.types + types.1;
        if self.fitted != Some((pair, size)) {
            self.links.iter_mut().for_each(|l| l.kernel.fit(pair, &size));
            self.fitted = Some((pair, size));
        }
    }

    #[inline]
    fn run(
        &mut self,
        call: &Call,
        h: &mut [f64],
        s: &mut Response,
        each: impl Fn(&dyn Kernel, &mut [f64], &mut Response, &mut Effects),
    ) -> ChainEffects {
        let (mut e, mut done) = (Effects::default(), ChainEffects::default());
        for link in &self.links {
            (e.contact_flag, e.bond_event) = (ContactFlag::Leave, BondEvent::None);
            each(link.kernel.as_ref(), h, s, &mut e);
            let bit = 1 << link.meta.kind as i32;
            match e.contact_flag {
                ContactFlag::Set => done.set |= bit,
                ContactFlag::Clear => done.clear |= bit,
                ContactFlag::Leave => {}
            }
            if link.meta.bonds.is_some() {
                done.bond_event = e.bond_event;
                if call.counts {
                    self.bonds.count(call, e.bond_event);
                }
            }
        }
        (done.acts, done.replaces, done.outputs) = (e.acts, e.replaces, e.outputs);
        done
    }

    /// The bonds that began, ended and lasted in the evaluations that count.
    pub fn bonds(&self) -> Bonds {
        self.bonds
    }

    /// The modes of two bodies under laws that act whether or not surfaces overlap; see [`crate::model::GapLaw::modes`].
    pub fn modes(&mut self, types: (usize, usize), size: &Size, speed: f64) -> Vec<NamedMode> {
        self.fit_to(types, *size);
        self.links.iter().flat_map(|l| l.kernel.modes(size, speed)).collect()
    }

    /// What each law can tell of the contact before it is evaluated.
    pub fn observe(&mut self, types: (usize, usize), x: &Contact, h: &[f64]) -> Vec<Observation> {
        let mut terms = Vec::with_capacity(self.links.len());
        self.observe_each(types, x, h, |_, t| terms.push(t));
        terms
    }

    /// As [`Chain::observe`], without a list: `each` gets what every law tells, with its place in the chain.
    pub fn observe_each(
        &mut self,
        types: (usize, usize),
        x: &Contact,
        h: &[f64],
        mut each: impl FnMut(usize, Observation),
    ) {
        self.fit(types, &x.close);
        for (k, link) in self.links.iter().enumerate() {
            each(k, link.kernel.observe(x, h));
        }
    }
}
