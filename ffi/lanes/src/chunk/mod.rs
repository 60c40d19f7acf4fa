//! A few dozen contacts on their way through the laws, few enough to stay in the nearest cache.
mod forces;

use crate::arrays::Particles;
use crate::list::List;
use crate::near::Near;
use crate::trouble::NonFinite;
use crate::unit::Unit;
use granlaw::lane::dot;
use granlaw::model::{Response, Surface};
use nalgebra::Vector3;
use std::ptr::null_mut;

/// Contacts in a chunk at most; whole blocks of any width.
pub(crate) const CHUNK: usize = 64;

/// As many contacts as lanes are wide.
#[derive(Clone)]
pub(crate) struct Block<L> {
    pub surface: Surface<L>,
    pub response: Response<L>,
}

/// Where the contacts of a block keep their fits and histories.
pub(crate) struct At<'a> {
    pub fit: &'a [u32],
    pub history: &'a [*mut f64],
}

/// Contacts that were found, and what becomes of them. All indices in it are those of particles of the pass: [`List`] has
/// checked them. Lanes beyond the last contact repeat it.
pub(crate) struct Chunk<L> {
    n: usize,
    /// Particles i and j.
    pairs: [[u32; 2]; CHUNK],
    /// From j to i \[m\].
    delta: [[f64; CHUNK]; 3],
    /// Numbers of the pairs among those that were searched, as wide as lanes, and in the list.
    number: [u64; CHUNK],
    slot: [u32; CHUNK],
    /// Numbers of their fits, where contacts differ.
    fit: [u32; CHUNK],
    /// Rows of history, and flags.
    history: [*mut f64; CHUNK],
    flags: [*mut i32; CHUNK],
    blocks: Vec<Block<L>>,
    /// Takes the history of lanes without a contact.
    nowhere: Vec<f64>,
}

impl<L: Unit> Chunk<L> {
    /// Whether the vectors between particles are kept from the search; one lane works them out again sooner.
    const KEEPS_DELTA: bool = L::WIDTH > 1;

    pub fn new(row: usize) -> Chunk<L> {
        let block = Block { surface: Surface::default(), response: Response::default() };
        Chunk {
            n: 0,
            pairs: [[0; 2]; CHUNK],
            delta: [[0.0; CHUNK]; 3],
            slot: [0; CHUNK],
            fit: [0; CHUNK],
            number: [0; CHUNK],
            history: [null_mut(); CHUNK],
            flags: [null_mut(); CHUNK],
            blocks: vec![block; CHUNK / L::WIDTH],
            nowhere: vec![0.0; row],
        }
    }

    pub fn len(&self) -> usize {
        self.n
    }

    pub fn clear(&mut self) {
        self.n = 0;
    }

    /// Contact `k`: particles i and j, and its neighbour number.
    pub fn contact(&self, k: usize) -> (usize, usize, usize) {
        let [i, j] = self.pairs[k];
        (i as usize, j as usize, self.slot[k] as usize)
    }

    /// Contact `k` has this fit, and so have the lanes behind it until another is set.
    #[inline(always)]
    pub fn set_fit(&mut self, k: usize, fit: u32) {
        for k in k..(k + 1).next_multiple_of(L::WIDTH) {
            self.fit[k] = fit;
        }
    }

    /// Take up the pairs whose surfaces are less than `apart` apart, from number `from` on, until there is no room; the
    /// answer is the number of the first one that was not looked at. Pairs begin with particles i and j; `radius` is that
    /// of all particles where they are alike.
    #[inline(always)]
    pub fn take<const N: usize>(
        &mut self,
        p: &Particles<'_>,
        pairs: &[[u32; N]],
        from: usize,
        radius: Option<f64>,
        apart: f64,
    ) -> usize {
        let x = p.x.as_ptr();
        match radius {
            Some(r) => self.find(
                x,
                pairs,
                from,
                #[inline(always)]
                |_| r,
                apart,
            ),
            // SAFETY: all indices are those of particles.
            None => self.find(
                x,
                pairs,
                from,
                #[inline(always)]
                |k| unsafe { *p.radius.get_unchecked(k) },
                apart,
            ),
        }
    }

    #[inline(always)]
    fn find<const N: usize>(
        &mut self,
        x: *const [f64; 3],
        pairs: &[[u32; N]],
        from: usize,
        radius: impl Fn(usize) -> f64,
        apart: f64,
    ) -> usize {
        let (mut k, end, mut n) = (from, pairs.len(), self.n);
        // SAFETY: all indices are those of particles, and there is room for what is found in a group.
        unsafe {
            while k + L::WIDTH <= end && n + L::WIDTH <= CHUNK {
                n += self.sift::<L, N>(x, &pairs[k..k + L::WIDTH], [k, n], &radius, apart);
                k += L::WIDTH;
            }
            while k + L::WIDTH > end && k < end && n < CHUNK {
                n += self.sift::<f64, N>(x, &pairs[k..k + 1], [k, n], &radius, apart);
                k += 1;
            }
        }
        self.n = n;
        k
    }

    /// Put those of a few pairs, from number `k` on, that are close into the chunk, from place `n` on; the answer is how
    /// many they are.
    ///
    /// # Safety
    /// There are as many pairs as `G` is wide, and the chunk has room for them.
    #[inline(always)]
    unsafe fn sift<G: Unit, const N: usize>(
        &mut self,
        x: *const [f64; 3],
        pairs: &[[u32; N]],
        [k, n]: [usize; 2],
        radius: impl Fn(usize) -> f64,
        apart: f64,
    ) -> usize {
        // SAFETY: as the caller promises; every index is that of a particle.
        unsafe {
            let i = |k: usize| pairs.get_unchecked(k)[0] as usize;
            let j = |k: usize| pairs.get_unchecked(k)[1] as usize;
            let delta = G::differences(
                #[inline(always)]
                |k| x.add(i(k)),
                #[inline(always)]
                |k| x.add(j(k)),
            );
            let reach = G::from_fn(|k| radius(i(k))) + G::from_fn(|k| radius(j(k))) + G::splat(apart);
            let near = G::bits((reach * reach).gt(dot(&delta, &delta)));
            let number = G::from_fn(|lane| f64::from_bits((k + lane) as u64));
            number.first(near).store(self.number.as_mut_ptr().add(n).cast());
            if Self::KEEPS_DELTA {
                for (c, d) in delta.iter().enumerate() {
                    d.first(near).store(self.delta[c].as_mut_ptr().add(n));
                }
            }
            near.count_ones() as usize
        }
    }

    /// The numbers of the pairs that were taken up.
    pub fn numbers(&self) -> &[u64] {
        &self.number[..self.n]
    }

    /// Find out what was taken up of `near`, and where that keeps its flags and histories.
    #[inline(always)]
    pub fn locate(&mut self, near: &Near, list: &List) {
        for k in 0..self.n {
            let number = self.number[k] as usize;
            // SAFETY: the number is that of a pair of `near`, and all of those are in the list.
            unsafe {
                let [i, j, slot] = *near.pairs.get_unchecked(number);
                (self.pairs[k], self.slot[k]) = ([i, j], slot);
                (self.history[k], self.flags[k]) = list.places(i, slot);
            }
            if !self.nowhere.is_empty() {
                prefetch(self.history[k]);
            }
        }
    }

    /// Fill the lanes beyond the last contact.
    #[inline(always)]
    fn pad(&mut self) {
        let last = self.n - 1;
        for k in self.n..self.n.next_multiple_of(L::WIDTH) {
            self.pairs[k] = self.pairs[last];
            self.delta.iter_mut().for_each(|d| d[k] = d[last]);
            self.history[k] = self.nowhere.as_mut_ptr();
        }
    }

    /// Work out the surfaces; false where one is not finite.
    #[inline(always)]
    pub fn look(&mut self, p: &Particles<'_>, radius: Option<f64>) -> bool {
        self.pad();
        let mut wrong = L::splat(0.0);
        for (b, block) in self.blocks[..self.n.div_ceil(L::WIDTH)].iter_mut().enumerate() {
            let pairs = &self.pairs[b * L::WIDTH..][..L::WIDTH];
            let (i, j) = (|k: usize| pairs[k][0] as usize, |k: usize| pairs[k][1] as usize);
            // SAFETY: indices of particles, see [`Chunk`].
            unsafe {
                let (x, v, w) = (p.x.as_ptr(), p.v.as_ptr(), p.omega.as_ptr());
                let delta = if Self::KEEPS_DELTA {
                    let of = |c: usize| L::load(self.delta[c].as_ptr().add(b * L::WIDTH));
                    Vector3::new(of(0), of(1), of(2))
                } else {
                    L::differences(
                        #[inline(always)]
                        |k| x.add(i(k)),
                        #[inline(always)]
                        |k| x.add(j(k)),
                    )
                };
                let v = L::differences(
                    #[inline(always)]
                    |k| v.add(i(k)),
                    #[inline(always)]
                    |k| v.add(j(k)),
                );
                let wi = L::gather(
                    #[inline(always)]
                    |k| w.add(i(k)),
                );
                let wj = L::gather(
                    #[inline(always)]
                    |k| w.add(j(k)),
                );
                let of = |k: usize| *p.radius.get_unchecked(k);
                let radii = match radius {
                    Some(r) => (L::splat(r), L::splat(r)),
                    None => (L::from_fn(|k| of(i(k))), L::from_fn(|k| of(j(k)))),
                };
                block.surface = Surface::between(&delta, dot(&delta, &delta), radii, &v, (&wi, &wj));
            }
            // 0, or NaN once a surface is not finite.
            wrong += sum(&block.surface) * L::splat(0.0);
        }
        !L::any(!wrong.ge(L::splat(0.0)))
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
        for b in 0..self.n.div_ceil(L::WIDTH) {
            let of = b * L::WIDTH..(b + 1) * L::WIDTH;
            // SAFETY: there are as many blocks as contacts have room in.
            let (block, fit, history) = unsafe {
                (
                    self.blocks.get_unchecked_mut(b),
                    self.fit.get_unchecked(of.clone()),
                    self.history.get_unchecked(of),
                )
            };
            work(&At { fit, history }, block);
        }
    }

    /// Set and clear the contact flags, which all contacts must have.
    #[inline(always)]
    pub fn mark(&self, [set, clear]: [i32; 2]) {
        for flags in &self.flags[..self.n] {
            // SAFETY: LIGGGHTS keeps a flag for each neighbour of a row that has flags.
            let flags = unsafe { &mut **flags };
            let new = (*flags | set) & !clear;
            if new != *flags {
                *flags = new;
            }
        }
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

/// Not finite if anything of the surface is not, as all of it goes into the tangential velocity; finite numbers of a
/// simulation do not overflow it.
#[inline(always)]
fn sum<L: Unit>(s: &Surface<L>) -> L {
    s.deltan + s.vn + (s.vtr.x + s.vtr.y + s.vtr.z)
}
