//! As wide as the processor is, and one contact at a time where there are hardly any.
use crate::{Arrays, Batch, Trouble};

/// So many particles, ghosts included, have too few contacts to fill lanes.
const FEW: usize = 8;

/// The same chain twice.
pub(crate) struct Fitting {
    one: Box<dyn Batch>,
    wide: Box<dyn Batch>,
    few: bool,
}

impl Fitting {
    pub fn new(one: Box<dyn Batch>, wide: Box<dyn Batch>) -> Fitting {
        Fitting { one, wide, few: false }
    }

    fn used(&self) -> &dyn Batch {
        if self.few {
            &*self.one
        } else {
            &*self.wide
        }
    }
}

impl Batch for Fitting {
    unsafe fn pass(&mut self, a: &Arrays) -> Result<(), Trouble> {
        // A new list is taken up whole, so neither needs to know what the other has done.
        if a.rebuilt {
            self.few = a.all <= FEW;
        }
        let used = if self.few { &mut self.one } else { &mut self.wide };
        // SAFETY: as the caller promises.
        unsafe { used.pass(a) }
    }

    fn contacts(&self) -> u64 {
        self.one.contacts() + self.wide.contacts()
    }

    fn neighbours(&self) -> usize {
        self.used().neighbours()
    }

    fn looked_at(&self) -> usize {
        self.used().looked_at()
    }

    fn bytes(&self) -> usize {
        self.one.bytes() + self.wide.bytes()
    }
}
