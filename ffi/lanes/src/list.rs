//! LIGGGHTS's neighbour list, all rows in one.
use crate::arrays::Arrays;
use std::ptr::null_mut;

/// The bits of a neighbour that are its index; LIGGGHTS keeps others above.
const NEIGHBOUR: u32 = 0x1FFF_FFFF;

/// All neighbours in LIGGGHTS's order. Good until LIGGGHTS builds its lists anew.
#[derive(Default)]
pub(crate) struct List {
    /// Particles i and j of each neighbour; checked, so every index is that of a particle.
    pub pairs: Vec<[u32; 2]>,
    /// Where each particle's neighbours keep their flags and histories.
    rows: Vec<Row>,
    /// Numbers per neighbour in a history.
    row: usize,
}

/// Where neighbour 0 of the whole list would keep its flag and its history, if it were in this row.
#[derive(Clone, Copy)]
struct Row {
    flags: *mut i32,
    history: *mut f64,
}

impl List {
    /// Take up the list of `a`; `None` where an index is not that of a particle, or a particle has two rows.
    ///
    /// # Safety
    /// `ilist` holds `rows` indices; each of the arrays by particle reaches as far as those, and each row of
    /// neighbours as far as `numneigh` says.
    pub unsafe fn renew(&mut self, a: &Arrays) -> Option<()> {
        // SAFETY: as the caller promises.
        let taken = unsafe { self.take_all(a) };
        if taken.is_none() {
            self.pairs.clear();
        }
        taken
    }

    /// # Safety
    /// As [`List::renew`].
    unsafe fn take_all(&mut self, a: &Arrays) -> Option<()> {
        self.pairs.clear();
        self.rows.clear();
        self.rows.resize(a.all, Row { flags: null_mut(), history: null_mut() });
        self.row = a.row;
        let mut seen = vec![false; a.all];
        for k in 0..a.rows {
            // SAFETY: as the caller promises.
            let i = unsafe { *a.ilist.add(k) };
            let i = usize::try_from(i).ok().filter(|i| *i < a.all)?;
            if std::mem::replace(&mut seen[i], true) {
                return None;
            }
            // SAFETY: as the caller promises.
            unsafe { self.take_up(a, i) }?;
        }
        Some(())
    }

    /// # Safety
    /// As [`List::renew`], and `i` is the index of a particle.
    unsafe fn take_up(&mut self, a: &Arrays, i: usize) -> Option<()> {
        // SAFETY: as the caller promises.
        let n = unsafe { *a.numneigh.add(i) } as usize;
        if n == 0 {
            return Some(());
        }
        let slot = self.pairs.len();
        u32::try_from(slot + n).ok()?;
        // SAFETY: as the caller promises, in this block.
        let (neighbours, flags, history) = unsafe {
            (
                std::slice::from_raw_parts((*a.neighbours.add(i)).cast::<u32>(), n),
                if a.flags.is_null() { null_mut() } else { *a.flags.add(i) },
                if a.history.is_null() { null_mut() } else { *a.history.add(i) },
            )
        };
        self.rows[i] = Row { flags: flags.wrapping_sub(slot), history: history.wrapping_sub(a.row * slot) };
        self.pairs.extend(neighbours.iter().map(|j| [i as u32, j & NEIGHBOUR]));
        neighbours.iter().all(|j| ((j & NEIGHBOUR) as usize) < a.all).then_some(())
    }

    /// Whether all particles that the list names are among those of `a`.
    pub fn is_of(&self, a: &Arrays) -> bool {
        self.rows.len() <= a.all
    }

    /// Whether each row of `a` has a history.
    ///
    /// # Safety
    /// As [`List::renew`], which has gone well with `a`.
    pub unsafe fn has_history(&self, a: &Arrays) -> bool {
        // SAFETY: as the caller promises.
        let lacks = |i: usize| unsafe { *a.numneigh.add(i) > 0 && (*a.history.add(i)).is_null() };
        // SAFETY: as above.
        !a.history.is_null() && !(0..a.rows).any(|k| lacks(unsafe { *a.ilist.add(k) } as usize))
    }

    /// Where neighbour `slot` of particle i keeps its history and its flag, if it has any.
    ///
    /// # Safety
    /// `i` is that of `pairs[slot]`.
    #[inline(always)]
    pub unsafe fn places(&self, i: u32, slot: u32) -> (*mut f64, *mut i32) {
        // SAFETY: every i is the index of a particle, and each has a row.
        let row = unsafe { self.rows.get_unchecked(i as usize) };
        (row.history.wrapping_add(self.row * slot as usize), row.flags.wrapping_add(slot as usize))
    }

    /// Bytes in use.
    pub fn bytes(&self) -> usize {
        self.pairs.capacity() * size_of::<[u32; 2]>() + self.rows.capacity() * size_of::<Row>()
    }
}
