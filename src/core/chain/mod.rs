//! The chosen laws over one contact, in LIGGGHTS's order, with their histories side by side in one row.
use crate::law::{
    Call, Contact, Gap, Kernel, LawError, Life, Mark, Meta, Reach, Setup, Size, Stage, Swing, Terms,
};
use crate::laws::find;

mod host;

pub use host::Wall;

struct Link {
    meta: &'static Meta,
    kernel: Box<dyn Kernel>,
    slots: std::ops::Range<usize>,
}

/// What the chain does to LIGGGHTS's contact flags; bit `1 << kind`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Bits to set.
    pub set: i32,
    /// Bits to clear.
    pub clear: i32,
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
    fn count(&mut self, call: &Call, life: Life) {
        if self.step != call.step {
            (self.step, self.there) = (call.step, 0);
        }
        match life {
            Life::None => {}
            Life::Begins => (self.begun, self.there) = (self.begun + 1, self.there + 1),
            Life::Lasts => self.there += 1,
            Life::Ends => self.ended += 1,
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
    /// Prepare laws; `offsets[k]` is where the history of `setups[k]` begins in a contact's row of history.
    /// The laws run in the order given, which should be that of [`crate::law::Kind::ALL`].
    ///
    /// # Errors
    /// The first thing that a law refuses.
    pub fn new(setups: &[Setup], offsets: &[usize]) -> Result<Chain, LawError> {
        let mut links = Vec::with_capacity(setups.len());
        for (setup, at) in setups.iter().zip(offsets) {
            let meta = setup.meta;
            let kernel = find(meta.kind, meta.keyword).expect("a law of LAWS").prepare(setup)?;
            links.push(Link { meta, kernel, slots: *at..at + setup.slots().count() });
        }
        let row = links.iter().map(|l| l.slots.end).max().unwrap_or(0);
        let (types, bonds) = (setups.first().map_or(0, |s| s.values.types), Bonds::default());
        let across = links.iter().any(|l: &Link| l.meta.reach == Reach::Beyond);
        Ok(Chain { links, types, row, across, fitted: None, bonds })
    }

    /// Laws whose histories lie one behind the other from slot 0.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn packed(setups: &[Setup]) -> Result<Chain, LawError> {
        let mut at = 0;
        let mut place = |s: &Setup| {
            let begin = at;
            at += s.slots().count();
            begin
        };
        let offsets: Vec<_> = setups.iter().map(&mut place).collect();
        Chain::new(setups, &offsets)
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
    pub fn touch(&mut self, types: (usize, usize), x: &Contact, h: &mut [f64], s: &mut Stage) -> Marks {
        self.fit(types, &x.gap);
        self.run(&x.gap.call, h, s, |kernel, h, s| kernel.touch(x, h, s))
    }

    /// As [`Chain::touch`]; `each` sees what is handed along after every law, told by its place in the chain.
    pub fn touch_each(
        &mut self,
        types: (usize, usize),
        x: &Contact,
        h: &mut [f64],
        s: &mut Stage,
        mut each: impl FnMut(usize, &Stage),
    ) {
        self.fit(types, &x.gap);
        for (k, link) in self.links.iter().enumerate() {
            link.kernel.touch(x, &mut h[link.slots.clone()], s);
            each(k, s);
        }
    }

    /// They do not.
    pub fn apart(&mut self, types: (usize, usize), x: &Gap, h: &mut [f64], s: &mut Stage) -> Marks {
        if self.across {
            self.fit(types, x);
        }
        self.run(&x.call, h, s, |kernel, h, s| kernel.apart(x, h, s))
    }

    #[inline]
    fn fit(&mut self, types: (usize, usize), x: &Gap) {
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
        s: &mut Stage,
        each: impl Fn(&dyn Kernel, &mut [f64], &mut Stage),
    ) -> Marks {
        let mut marks = Marks::default();
        for link in &self.links {
            (s.mark, s.life) = (Mark::Leave, Life::None);
            each(link.kernel.as_ref(), &mut h[link.slots.clone()], s);
            let bit = 1 << link.meta.kind as i32;
            match s.mark {
                Mark::Set => marks.set |= bit,
                Mark::Clear => marks.clear |= bit,
                Mark::Leave => {}
            }
            if call.counts && link.meta.bonds.is_some() {
                self.bonds.count(call, s.life);
            }
        }
        marks
    }

    /// The bonds that began, ended and lasted in the evaluations that count.
    pub fn bonds(&self) -> Bonds {
        self.bonds
    }

    /// The ways in which two bodies swing under laws that act whether or not surfaces overlap; see [`crate::law::Law::swings`].
    pub fn swings(&mut self, types: (usize, usize), size: &Size, speed: f64) -> Vec<Swing> {
        self.fit_to(types, *size);
        self.links.iter().flat_map(|l| l.kernel.swings(size, speed)).collect()
    }

    /// What each law can tell of the contact before it is evaluated.
    pub fn observe(&mut self, types: (usize, usize), x: &Contact, h: &[f64]) -> Vec<Terms> {
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
        mut each: impl FnMut(usize, Terms),
    ) {
        self.fit(types, &x.gap);
        for (k, link) in self.links.iter().enumerate() {
            each(k, link.kernel.observe(x, &h[link.slots.clone()]));
        }
    }
}
