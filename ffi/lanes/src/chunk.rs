//! A few dozen contacts on their way through the laws, few enough to stay in the nearest cache.
use crate::arrays::{Particles, Row, NEIGHBOUR};
use crate::pass::NonFinite;
use crate::unit::Unit;
use granlaw::chain::Marks;
use granlaw::lane::{dot, Lane};
use granlaw::law::{Stage, Surface};
use nalgebra::Vector3;
use std::ptr::null_mut;

/// Contacts in a chunk at most.
pub(crate) const CHUNK: usize = 64;
/// The widest lanes.
const WIDEST: usize = 8;

/// As many contacts as lanes are wide.
#[derive(Clone)]
pub(crate) struct Block<L> {
    pub surface: Surface<L>,
    pub stage: Stage<L>,
    /// Numbers of the neighbours, all rows of the list counted through.
    pub slot: [u32; WIDEST],
    /// Rows of history.
    pub history: [*mut f64; WIDEST],
}

/// Contacts that were found, and what becomes of them. All indices in it are those of particles of the pass:
/// [`crate::arrays::Arrays::rows`] has checked them.
pub(crate) struct Chunk<L> {
    n: usize,
    i: [u32; CHUNK],
    j: [u32; CHUNK],
    slot: [u32; CHUNK],
    history: [*mut f64; CHUNK],
    flags: [*mut i32; CHUNK],
    blocks: Vec<Block<L>>,
    /// Takes the history of lanes without a contact.
    nowhere: Vec<f64>,
}

impl<L: Unit> Chunk<L> {
    pub fn new(row: usize) -> Chunk<L> {
        let history = [null_mut(); WIDEST];
        let block =
            Block { surface: Surface::default(), stage: Stage::default(), slot: [0; WIDEST], history };
        Chunk {
            n: 0,
            i: [0; CHUNK],
            j: [0; CHUNK],
            slot: [0; CHUNK],
            history: [null_mut(); CHUNK],
            flags: [null_mut(); CHUNK],
            blocks: vec![block; CHUNK / L::WIDTH],
            nowhere: vec![0.0; row],
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

    /// Take up the neighbours of a row that touch, from number `from` on, as many as there is room for; the answer is the number of
    /// the first one that was not looked at. `dnum` is the length of a row of history.
    #[inline(always)]
    pub fn take(&mut self, p: &Particles<'_>, row: &Row, from: usize, dnum: usize) -> usize {
        let to = row.neighbours.len().min(from + CHUNK - self.n);
        let (begin, i) = (self.n, row.i as usize);
        let mut at = [0u32; CHUNK];
        let mut n = begin;
        // SAFETY: i and all j are indices of particles, see [`Chunk`]; n stays below CHUNK, as at most one contact
        // comes of each neighbour.
        unsafe {
            let (xi, ri) = (p.x.get_unchecked(i), *p.radius.get_unchecked(i));
            for k in from..to {
                let j = row.neighbours.get_unchecked(k) & NEIGHBOUR;
                let (xj, rj) = (p.x.get_unchecked(j as usize), *p.radius.get_unchecked(j as usize));
                let (dx, dy, dz) = (xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]);
                let reach = ri + rj;
                *self.j.get_unchecked_mut(n) = j;
                *at.get_unchecked_mut(n) = k as u32;
                n += usize::from(dx * dx + dy * dy + dz * dz < reach * reach);
            }
        }
        for (k, at) in at.iter().enumerate().take(n).skip(begin) {
            let neighbour = *at as usize;
            self.i[k] = row.i;
            self.slot[k] = row.slot + at;
            self.history[k] = offset(row.history, dnum * neighbour);
            self.flags[k] = offset(row.flags, neighbour);
        }
        self.n = n;
        to
    }

    /// Work out the surfaces; false where one is not finite.
    #[inline(always)]
    pub fn look(&mut self, p: &Particles<'_>) -> bool {
        let mut finite = true;
        for b in 0..self.n.div_ceil(L::WIDTH) {
            // Lanes beyond the last contact repeat it, and write its history nowhere.
            let at = |k: usize| (b * L::WIDTH + k).min(self.n - 1);
            let block = &mut self.blocks[b];
            for k in 0..L::WIDTH {
                let beyond = b * L::WIDTH + k >= self.n;
                block.slot[k] = self.slot[at(k)];
                block.history[k] = if beyond || self.history[at(k)].is_null() {
                    self.nowhere.as_mut_ptr()
                } else {
                    self.history[at(k)]
                };
            }
            let (i, j) = (|k: usize| self.i[at(k)] as usize, |k: usize| self.j[at(k)] as usize);
            let delta = gather::<L>(p.x, i) - gather::<L>(p.x, j);
            let v = gather::<L>(p.v, i) - gather::<L>(p.v, j);
            let (wi, wj) = (gather(p.omega, i), gather(p.omega, j));
            // SAFETY: indices of particles, see [`Chunk`].
            let radius = |of: usize| unsafe { *p.radius.get_unchecked(of) };
            let (ri, rj) = (L::from_fn(|k| radius(i(k))), L::from_fn(|k| radius(j(k))));
            block.surface = Surface::between(&delta, dot(&delta, &delta), (ri, rj), &v, (&wi, &wj));
            block.stage = Stage::default();
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

    /// The contacts for the laws.
    pub fn blocks(&mut self) -> &mut [Block<L>] {
        let n = self.n.div_ceil(L::WIDTH);
        &mut self.blocks[..n]
    }

    /// Add forces and torques in the order of the contacts, and set the contact flags. Particles from `forced` on
    /// belong to other ranks and get none.
    #[inline(always)]
    pub fn hand_out(&self, p: &mut Particles<'_>, forced: usize, marks: Marks) {
        for k in 0..self.n {
            let (s, lane) = (&self.blocks[k / L::WIDTH].stage, k % L::WIDTH);
            let (i, j) = (self.i[k] as usize, self.j[k] as usize);
            let force = s.force.map(|f| f.lane(lane));
            // SAFETY: indices of particles, see [`Chunk`].
            unsafe {
                add(p.f.get_unchecked_mut(i), force);
                add(p.torque.get_unchecked_mut(i), s.torque_i.map(|t| t.lane(lane)));
                if j < forced {
                    // Zero less the force, as a contact alone has it: the sign of a zero may differ.
                    add(p.f.get_unchecked_mut(j), force.map(|f| 0.0 - f));
                    add(p.torque.get_unchecked_mut(j), s.torque_j.map(|t| t.lane(lane)));
                }
            }
            if !self.flags[k].is_null() {
                // SAFETY: LIGGGHTS keeps a flag for each neighbour of a row that has flags.
                let flags = unsafe { &mut *self.flags[k] };
                let new = (*flags | marks.set) & !marks.clear;
                if new != *flags {
                    *flags = new;
                }
            }
        }
    }
}

/// NULL stays NULL.
#[inline(always)]
fn offset<T>(p: *mut T, n: usize) -> *mut T {
    if p.is_null() {
        p
    } else {
        p.wrapping_add(n)
    }
}

#[inline(always)]
fn add(to: &mut [f64; 3], what: Vector3<f64>) {
    for (t, w) in to.iter_mut().zip(what.iter()) {
        *t += w;
    }
}

/// Vectors of the particles that `of` names, side by side.
#[inline(always)]
fn gather<L: Lane>(from: &[[f64; 3]], of: impl Fn(usize) -> usize) -> Vector3<L> {
    // SAFETY: indices of particles, see [`Chunk`].
    let number = |k: usize, c: usize| unsafe { from.get_unchecked(of(k))[c] };
    Vector3::new(L::from_fn(|k| number(k, 0)), L::from_fn(|k| number(k, 1)), L::from_fn(|k| number(k, 2)))
}

/// Any NaN or infinity survives the sum; finite numbers of a simulation do not overflow it.
#[inline(always)]
fn sum<L: Lane>(s: &Surface<L>) -> L {
    let of = |v: &Vector3<L>| v.x + v.y + v.z;
    s.deltan + s.vn + of(&s.en) + of(&s.vtr) + of(&s.roll) + s.cri + s.crj
}
