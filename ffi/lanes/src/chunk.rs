//! A few dozen contacts on their way through the laws, few enough to stay in the nearest cache.
use crate::arrays::{Particles, Row, NEIGHBOUR};
use crate::pass::NonFinite;
use crate::unit::Unit;
use granlaw::chain::Marks;
use granlaw::lane::{dot, Lane};
use granlaw::law::{Stage, Surface};
use nalgebra::Vector3;
use std::ops::Range;
use std::ptr::null_mut;

/// Contacts in a chunk at most; whole blocks of any width.
pub(crate) const CHUNK: usize = 64;

/// As many contacts as lanes are wide.
#[derive(Clone)]
pub(crate) struct Block<L> {
    pub surface: Surface<L>,
    pub stage: Stage<L>,
}

/// Where the contacts of a block keep their fits and histories.
pub(crate) struct At<'a> {
    pub slot: &'a [u32],
    pub history: &'a [*mut f64],
}

/// Contacts that were found, and what becomes of them. All indices in it are those of particles of the pass:
/// [`crate::arrays::Arrays::rows`] has checked them. Lanes beyond the last contact repeat it.
pub(crate) struct Chunk<L> {
    n: usize,
    i: [u32; CHUNK],
    j: [u32; CHUNK],
    /// Numbers of the neighbours, all rows of the list counted through.
    slot: [u32; CHUNK],
    /// Rows of history.
    history: [*mut f64; CHUNK],
    flags: [*mut i32; CHUNK],
    blocks: Vec<Block<L>>,
    /// Takes the history of lanes without a contact, and the flags of contacts without one.
    nowhere: Vec<f64>,
    no_flags: Box<i32>,
}

impl<L: Unit> Chunk<L> {
    pub fn new(row: usize) -> Chunk<L> {
        let block = Block { surface: Surface::default(), stage: Stage::default() };
        Chunk {
            n: 0,
            i: [0; CHUNK],
            j: [0; CHUNK],
            slot: [0; CHUNK],
            history: [null_mut(); CHUNK],
            flags: [null_mut(); CHUNK],
            blocks: vec![block; CHUNK / L::WIDTH],
            nowhere: vec![0.0; row],
            no_flags: Box::default(),
        }
    }

    pub fn len(&self) -> usize {
        self.n
    }

    pub fn is_full(&self) -> bool {
        self.n == CHUNK
    }

    pub fn clear(&mut self) {
        self.n = 0;
    }

    /// Contact `k`: particles i and j, and its neighbour number.
    pub fn contact(&self, k: usize) -> (usize, usize, usize) {
        (self.i[k] as usize, self.j[k] as usize, self.slot[k] as usize)
    }

    /// Take up the neighbours of a row that touch, from number `from` on, as many as there is room for; the answer is the
    /// number of the first one that was not looked at. `dnum` is the length of a row of history, `radius` that of all
    /// particles where they are alike.
    #[inline(always)]
    pub fn take(
        &mut self,
        p: &Particles<'_>,
        row: &Row,
        from: usize,
        dnum: usize,
        radius: Option<f64>,
    ) -> usize {
        let to = row.neighbours.len().min(from + CHUNK - self.n);
        let begin = self.n;
        match radius {
            Some(r) => self.sift(
                p,
                row,
                from..to,
                #[inline(always)]
                |_| r,
            ),
            // SAFETY: see `sift`.
            None => self.sift(
                p,
                row,
                from..to,
                #[inline(always)]
                |k| unsafe { *p.radius.get_unchecked(k) },
            ),
        }
        let (history, dnum) =
            if row.history.is_null() { (self.nowhere.as_mut_ptr(), 0) } else { (row.history, dnum) };
        let (flags, each) = if row.flags.is_null() { (&raw mut *self.no_flags, 0) } else { (row.flags, 1) };
        for k in begin..self.n {
            let at = self.slot[k] as usize;
            self.i[k] = row.i;
            self.slot[k] += row.slot;
            self.history[k] = history.wrapping_add(dnum * at);
            self.flags[k] = flags.wrapping_add(each * at);
            prefetch(self.history[k]);
        }
        to
    }

    /// Note which of these neighbours of a row touch, by index and by number within the row.
    #[inline(always)]
    fn sift(&mut self, p: &Particles<'_>, row: &Row, these: Range<usize>, radius: impl Fn(usize) -> f64) {
        let (mut n, i) = (self.n, row.i as usize);
        // SAFETY: i and all j are indices of particles, see [`Chunk`]; n stays below CHUNK, as at most one contact
        // comes of each neighbour.
        unsafe {
            let (xi, ri) = (*p.x.get_unchecked(i), radius(i));
            for k in these {
                let j = row.neighbours.get_unchecked(k) & NEIGHBOUR;
                let (xj, rj) = (p.x.get_unchecked(j as usize), radius(j as usize));
                let (dx, dy, dz) = (xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]);
                let reach = ri + rj;
                *self.j.get_unchecked_mut(n) = j;
                *self.slot.get_unchecked_mut(n) = k as u32;
                n += usize::from(dx * dx + dy * dy + dz * dz < reach * reach);
            }
        }
        self.n = n;
    }

    /// Fill the lanes beyond the last contact.
    #[inline(always)]
    fn pad(&mut self) {
        for k in self.n..self.n.next_multiple_of(L::WIDTH) {
            (self.i[k], self.j[k], self.slot[k]) =
                (self.i[self.n - 1], self.j[self.n - 1], self.slot[self.n - 1]);
            self.history[k] = self.nowhere.as_mut_ptr();
        }
    }

    /// Work out the surfaces; false where one is not finite.
    #[inline(always)]
    pub fn look(&mut self, p: &Particles<'_>) -> bool {
        self.pad();
        let mut finite = true;
        for (b, block) in self.blocks[..self.n.div_ceil(L::WIDTH)].iter_mut().enumerate() {
            let (i, j) = (&self.i[b * L::WIDTH..][..L::WIDTH], &self.j[b * L::WIDTH..][..L::WIDTH]);
            let delta = gather::<L>(p.x, i) - gather::<L>(p.x, j);
            let v = gather::<L>(p.v, i) - gather::<L>(p.v, j);
            let (wi, wj) = (gather(p.omega, i), gather(p.omega, j));
            // SAFETY: indices of particles, see [`Chunk`].
            let radius = |of: &[u32], k: usize| unsafe { *p.radius.get_unchecked(of[k] as usize) };
            let (ri, rj) = (L::from_fn(|k| radius(i, k)), L::from_fn(|k| radius(j, k)));
            block.surface = Surface::between(&delta, dot(&delta, &delta), (ri, rj), &v, (&wi, &wj));
            finite &= !L::any(!L::splat(f64::MAX).ge(sum(&block.surface).abs()));
        }
        finite
    }

    /// The first contact whose surfaces are not finite; the last one if all are.
    pub fn non_finite(&self) -> NonFinite {
        let wrong = |k: &usize| {
            let (s, lane) = (&self.blocks[*k / L::WIDTH].surface, *k % L::WIDTH);
            !sum(s).lane(lane).is_finite()
        };
        self.kinematics((0..self.n).find(wrong).unwrap_or(self.n - 1))
    }

    /// What is to be said of contact `k`.
    pub fn kinematics(&self, k: usize) -> NonFinite {
        let (s, lane) = (&self.blocks[k / L::WIDTH].surface, k % L::WIDTH);
        let (i, j, _) = self.contact(k);
        NonFinite { i, j, deltan: s.deltan.lane(lane), vn: s.vn.lane(lane) }
    }

    /// Let a law work on all contacts. `work` gets the place of a block's first contact in the lists, and the block.
    #[inline(always)]
    pub fn each_block(&mut self, mut work: impl FnMut(&At<'_>, &mut Block<L>)) {
        let n = self.n.div_ceil(L::WIDTH);
        for (b, block) in self.blocks[..n].iter_mut().enumerate() {
            let of = b * L::WIDTH..(b + 1) * L::WIDTH;
            work(&At { slot: &self.slot[of.clone()], history: &self.history[of] }, block);
        }
    }

    /// Add forces and torques in the order of the contacts, and set the contact flags. Particles from `forced` on
    /// belong to other ranks and get none.
    #[inline(always)]
    pub fn hand_out(&self, p: &mut Particles<'_>, forced: usize, marks: Marks) {
        let mut begin = 0;
        while begin < self.n {
            let i = self.i[begin];
            let end = begin + self.i[begin..self.n].iter().take_while(|k| **k == i).count();
            // SAFETY: indices of particles, see [`Chunk`]; none is its own neighbour.
            let (mut f, mut torque) =
                unsafe { (*p.f.get_unchecked(i as usize), *p.torque.get_unchecked(i as usize)) };
            for k in begin..end {
                let (s, lane) = (&self.blocks[k / L::WIDTH].stage, k % L::WIDTH);
                let force = one(&s.force, lane);
                add(&mut f, force);
                add(&mut torque, one(&s.torque_i, lane));
                let j = self.j[k] as usize;
                if j < forced {
                    // SAFETY: as above.
                    unsafe {
                        // Zero less the force, as a contact alone has it: the sign of a zero may differ.
                        add(p.f.get_unchecked_mut(j), force.map(|f| 0.0 - f));
                        add(p.torque.get_unchecked_mut(j), one(&s.torque_j, lane));
                    }
                }
            }
            // SAFETY: as above.
            unsafe {
                *p.f.get_unchecked_mut(i as usize) = f;
                *p.torque.get_unchecked_mut(i as usize) = torque;
            }
            begin = end;
        }
        self.mark(marks);
    }

    #[inline(always)]
    fn mark(&self, marks: Marks) {
        for flags in &self.flags[..self.n] {
            // SAFETY: LIGGGHTS keeps a flag for each neighbour of a row that has flags; else they lead to `no_flags`.
            let flags = unsafe { &mut **flags };
            let new = (*flags | marks.set) & !marks.clear;
            if new != *flags {
                *flags = new;
            }
        }
    }
}

/// The vector of one lane, read where it lies.
#[inline(always)]
fn one<L: Lane>(v: &Vector3<L>, lane: usize) -> [f64; 3] {
    [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane)]
}

#[inline(always)]
fn add(to: &mut [f64; 3], what: [f64; 3]) {
    for (t, w) in to.iter_mut().zip(what) {
        *t += w;
    }
}

/// Ask for memory that is needed soon.
#[inline(always)]
fn prefetch(p: *const f64) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: a prefetch never faults, wherever it points.
    unsafe {
        std::arch::x86_64::_mm_prefetch::<{ std::arch::x86_64::_MM_HINT_T0 }>(p.cast())
    };
    #[cfg(not(target_arch = "x86_64"))]
    let _ = p;
}

/// Vectors of some particles, side by side.
#[inline(always)]
fn gather<L: Lane>(from: &[[f64; 3]], of: &[u32]) -> Vector3<L> {
    // SAFETY: indices of particles, see [`Chunk`].
    let number = |k: usize, c: usize| unsafe { from.get_unchecked(of[k] as usize)[c] };
    Vector3::new(L::from_fn(|k| number(k, 0)), L::from_fn(|k| number(k, 1)), L::from_fn(|k| number(k, 2)))
}

/// Any NaN or infinity survives the sum; finite numbers of a simulation do not overflow it.
#[inline(always)]
fn sum<L: Lane>(s: &Surface<L>) -> L {
    let of = |v: &Vector3<L>| v.x + v.y + v.z;
    s.deltan + s.vn + of(&s.en) + of(&s.vtr) + of(&s.roll) + s.cri + s.crj
}
