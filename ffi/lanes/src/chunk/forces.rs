//! What the laws of a chunk's contacts gave, added to the particles.
use super::Chunk;
use crate::arrays::Particles;
use crate::unit::Unit;
use nalgebra::Vector3;
use std::mem::MaybeUninit;

/// Contacts per particle below which they are few.
const FEW: usize = 4;

impl<L: Unit> Chunk<L> {
    /// Add forces and torques in the order of the contacts. Particles from `forced` on belong to other ranks and get none.
    #[inline(always)]
    pub fn hand_out(&self, p: &mut Particles<'_>, forced: usize) {
        let [first, last] = [0, self.n - 1].map(|k| self.pairs[k][0] as usize);
        // With few contacts per particle nobody can tell whether the next one is of the same, so it is not asked; one lane
        // alone does not wait for the answer either.
        if L::WIDTH == 1 || FEW * last.abs_diff(first) > self.n {
            self.add_up::<true>(p, forced);
        } else {
            self.add_up::<false>(p, forced);
        }
    }

    /// See [`Chunk::hand_out`]; `SINGLY`: what particle i has goes through memory at each contact.
    /// A function of its own, as two copies of it would take registers from what is around them.
    #[inline(never)]
    fn add_up<const SINGLY: bool>(&self, p: &mut Particles<'_>, forced: usize) {
        L::run(
            #[inline(always)]
            || self.add_all::<SINGLY>(p, forced),
        );
    }

    #[inline(always)]
    fn add_all<const SINGLY: bool>(&self, p: &mut Particles<'_>, forced: usize) {
        // SAFETY: indices of particles, see [`Chunk`]; none is its own neighbour; rows are read as far as there are lanes.
        unsafe {
            let (f, torque) = (p.f.as_mut_ptr(), p.torque.as_mut_ptr());
            let mut i = self.pairs[0][0] as usize;
            let (mut fi, mut torque_i) = (*f.add(i), *torque.add(i));
            for b in 0..self.n.div_ceil(L::WIDTH) {
                let s = &self.blocks.get_unchecked(b).response;
                let (force, on_i, on_j) = (rows(&s.force), rows(&s.torque_i), rows(&s.torque_j));
                for k in 0..L::WIDTH {
                    if b * L::WIDTH + k >= self.n {
                        break;
                    }
                    let [next, j] = self.pairs.get_unchecked(b * L::WIDTH + k).map(|p| p as usize);
                    if SINGLY || next != i {
                        (*f.add(i), *torque.add(i)) = (fi, torque_i);
                        i = next;
                        (fi, torque_i) = (*f.add(i), *torque.add(i));
                    }
                    let force = force.get_unchecked(k).assume_init();
                    add(&mut fi, force);
                    add(&mut torque_i, on_i.get_unchecked(k).assume_init());
                    if j < forced {
                        // Zero less the force, as a contact alone has it: the sign of a zero may differ.
                        add(&mut *f.add(j), force.map(|f| 0.0 - f));
                        add(&mut *torque.add(j), on_j.get_unchecked(k).assume_init());
                    }
                }
            }
            (*f.add(i), *torque.add(i)) = (fi, torque_i);
        }
    }
}

/// A vector per lane; what lies beyond the last lane is not set.
#[inline(always)]
fn rows<L: Unit>(v: &Vector3<L>) -> [MaybeUninit<[f64; 3]>; 8] {
    let mut rows = [MaybeUninit::uninit(); 8];
    let first = rows.as_mut_ptr();
    // SAFETY: no unit is wider than the array.
    unsafe {
        L::scatter(
            v,
            #[inline(always)]
            |k| first.add(k).cast(),
        );
    }
    rows
}

#[inline(always)]
fn add(to: &mut [f64; 3], what: [f64; 3]) {
    for (t, w) in to.iter_mut().zip(what) {
        *t += w;
    }
}
