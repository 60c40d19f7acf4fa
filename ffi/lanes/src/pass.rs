//! One pass over all contacts of a step: find those that touch, run the laws, add up.
use crate::arrays::{Arrays, Particles};
use crate::chunk::Chunk;
use crate::kernel::{Kernel, Kernels};
use crate::list::List;
use crate::near::Near;
use crate::seen::{size, Seen};
use crate::trouble::Trouble;
use crate::unit::Unit;
use crate::Batch;
use granlaw::laws::made;
use granlaw::model::{Call, ContactFlag, LawError, Setup};

/// A neighbour without a fit.
const NONE: u32 = u32::MAX;

/// A chain over lanes of one width.
pub(crate) struct Pass<L: Unit> {
    laws: Vec<Box<dyn Kernel<L>>>,
    /// The contact flags of all laws, to set and to clear.
    flags: [i32; 2],
    types: usize,
    /// The length that a row of history must have at least.
    row: usize,
    list: List,
    near: Near,
    seen: Seen,
    /// The number of each neighbour's fit, [`NONE`] where it has none yet; empty where all contacts are alike.
    fitted: Vec<u32>,
    /// How many fits there are.
    fits: u32,
    /// The radius of all particles, where they are alike.
    radius: Option<f64>,
    chunk: Chunk<L>,
    contacts: u64,
}

impl<L: Unit + 'static> Pass<L> {
    /// See [`crate::batch`].
    pub fn boxed(setups: &[Setup], places: &[Vec<usize>]) -> Result<Option<Box<dyn Batch>>, LawError> {
        let (mut laws, mut flags) = (Vec::with_capacity(setups.len()), [0, 0]);
        for (setup, places) in setups.iter().zip(places) {
            let meta = setup.law.meta;
            let Some(prepare) = made::<Kernels<L>>(setup) else { return Ok(None) };
            laws.push(prepare(setup, places)?);
            match setup.law.liggghts.contact_flags[0] {
                ContactFlag::Set => flags[0] |= 1 << meta.kind as i32,
                ContactFlag::Clear => flags[1] |= 1 << meta.kind as i32,
                ContactFlag::Leave => {}
            }
        }
        let row = places.iter().flatten().map(|at| at + 1).max().unwrap_or(0);
        Ok(Some(Box::new(Pass {
            laws,
            flags,
            types: setups.first().map_or(0, |s| s.values.types),
            row,
            list: List::default(),
            near: Near::new(),
            seen: Seen::default(),
            fitted: Vec::new(),
            fits: 0,
            radius: None,
            chunk: Chunk::new(row),
            contacts: 0,
        })))
    }

    /// Take up neighbour lists and particles, and drop the fits that no longer hold. The answer is whether anything is
    /// new.
    ///
    /// # Safety
    /// As [`Batch::pass`].
    unsafe fn prepare(&mut self, a: &Arrays, p: &Particles<'_>) -> Result<bool, Trouble> {
        if a.rebuilt {
            self.near.forget();
            // SAFETY: as the caller promises, here and below.
            unsafe { self.list.renew(a) }
                .ok_or(Trouble::Arrays("the neighbour list names a particle that is not there, or twice"))?;
            // SAFETY: as above.
            if self.row > 0 && (a.row < self.row || unsafe { !self.list.has_history(a) }) {
                return Err(Trouble::Arrays("the neighbour list has no room for the laws' history"));
            }
        }
        if !self.list.is_of(a) {
            return Err(Trouble::Arrays("the neighbour list is of other particles"));
        }
        let news = self.seen.look::<L>(p, self.types);
        if news.strange {
            // They are to be looked at again.
            self.seen = Seen::default();
            return Err(Trouble::Arrays("a particle has an atom type that the laws were not prepared for"));
        }
        let new = a.rebuilt || news.changed;
        if new {
            self.forget();
        }
        Ok(new)
    }

    /// Select the neighbours that can touch in the next steps.
    #[inline(always)]
    fn select(&mut self, p: &Particles<'_>, skin: f64) {
        let Some(apart) = self.near.begin(&self.list, p, skin) else { return };
        let mut from = 0;
        while from < self.list.pairs.len() {
            self.chunk.clear();
            from = self.chunk.take(p, &self.list.pairs, from, self.radius, apart);
            for slot in self.chunk.numbers() {
                self.near.add(&self.list, *slot as u32);
            }
        }
        self.near.end(&self.list);
    }

    fn forget(&mut self) {
        self.fitted.clear();
        let alike = self.seen.alike();
        self.radius = alike.map(|(size, _)| size.radi);
        match alike {
            Some((size, kind)) => {
                let pair = kind * self.types + kind;
                self.laws.iter_mut().for_each(|l| l.fit_all(pair, &size));
            }
            None => {
                self.fitted.resize(self.list.pairs.len(), NONE);
                self.fits = 0;
                self.laws.iter_mut().for_each(|l| l.fit_none());
            }
        }
    }

    #[inline(always)]
    fn walk(&mut self, a: &Arrays, p: &mut Particles<'_>) -> Result<(), Trouble> {
        self.chunk.clear();
        let mut from = 0;
        while from < self.near.pairs.len() {
            from = self.chunk.take(p, &self.near.pairs, from, self.radius, 0.0);
            if self.chunk.len() > 0 {
                self.chunk.locate(&self.near, &self.list);
                self.evaluate(a, p)?;
            }
        }
        Ok(())
    }

    /// The laws over the contacts of the chunk.
    #[inline(always)]
    fn evaluate(&mut self, a: &Arrays, p: &mut Particles<'_>) -> Result<(), Trouble> {
        if !self.chunk.look(p, self.radius) {
            return Err(Trouble::NonFinite(self.chunk.non_finite()));
        }
        if !self.fitted.is_empty() {
            self.fit(p)?;
        }
        let call = Call { dt: a.dt, step: a.step, update: a.update, ..Call::default() };
        for (k, law) in self.laws.iter().enumerate() {
            law.surfaces_intersect(&mut self.chunk, &call, k == 0);
        }
        self.chunk.hand_out(p, a.forced);
        if !a.flags.is_null() {
            self.chunk.mark(self.flags);
        }
        self.contacts += self.chunk.len() as u64;
        self.chunk.clear();
        Ok(())
    }

    /// Find the fits of the chunk's contacts, and make those that are not there yet.
    fn fit(&mut self, p: &Particles<'_>) -> Result<(), Trouble> {
        for k in 0..self.chunk.len() {
            let (i, j, slot) = self.chunk.contact(k);
            if self.fitted[slot] == NONE {
                let pair = (p.kind[i] as usize - 1) * self.types + p.kind[j] as usize - 1;
                let size = size(p, i, j);
                if !size.meff.is_finite() {
                    return Err(Trouble::NonFinite(self.chunk.kinematics(k)));
                }
                self.laws.iter_mut().for_each(|l| l.fit(pair, &size));
                self.fitted[slot] = self.fits;
                self.fits += 1;
            }
            self.chunk.set_fit(k, self.fitted[slot]);
        }
        Ok(())
    }
}

impl<L: Unit + 'static> Batch for Pass<L> {
    unsafe fn pass(&mut self, a: &Arrays) -> Result<(), Trouble> {
        // SAFETY: as the caller promises.
        let particles = unsafe { a.particles() };
        let mut p = particles.ok_or(Trouble::Arrays("an array of particles is missing"))?;
        // SAFETY: as the caller promises.
        let new = unsafe { self.prepare(a, &p) }?;
        let outrun = L::run(
            #[inline(always)]
            || self.near.outrun::<L>(p.x),
        );
        if new || outrun {
            L::run(
                #[inline(always)]
                || self.select(&p, a.skin),
            );
        }
        L::run(
            #[inline(always)]
            || self.walk(a, &mut p),
        )
    }

    fn contacts(&self) -> u64 {
        self.contacts
    }

    fn neighbours(&self) -> usize {
        self.list.pairs.len()
    }

    fn looked_at(&self) -> usize {
        self.near.pairs.len()
    }

    fn bytes(&self) -> usize {
        let kernels: usize = self.laws.iter().map(|l| l.bytes()).sum();
        kernels + 4 * self.fitted.capacity() + self.list.bytes() + self.near.bytes() + self.seen.bytes()
    }
}
