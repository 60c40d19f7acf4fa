//! One law over the contacts of a chunk.
use crate::chunk::{At, Block, Chunk};
use crate::unit::Unit;
use granlaw::law::{Call, ForLanes, LaneLaw, LawError, Mark, Setup, Size, Stage};
use nalgebra::Vector3;
use std::marker::PhantomData;

/// A law prepared for lanes of one width.
pub(crate) trait Kernel<L> {
    /// All contacts have this pair of types and this size from now on.
    fn fit_all(&mut self, pair: usize, size: &Size);
    /// Contacts differ from now on, and none has a fit yet.
    fn fit_none(&mut self);
    /// One more fit, for a contact with this pair of types and this size.
    fn fit(&mut self, pair: usize, size: &Size);
    /// Run the law, `first` of the chain or not; the answer is what it does to the contact flags.
    fn touch(&self, chunk: &mut Chunk<L>, call: &Call, first: bool) -> Mark;
    /// Bytes in use.
    fn bytes(&self) -> usize;
}

/// Makes kernels of one width of all laws that have lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kernels<L>(PhantomData<L>);

/// A kernel from its set-up and the place of its history in a row.
pub(crate) type Prepare<L> = fn(&Setup, usize) -> Result<Box<dyn Kernel<L>>, LawError>;

impl<L: Unit> ForLanes for Kernels<L> {
    type Made = Prepare<L>;
    fn make<W: LaneLaw>() -> Prepare<L> {
        |setup, at| {
            let coeffs = setup.coeffs::<W>()?;
            Ok(Box::new(Prepared::<W, L> { coeffs, at, fits: Fits::Each(Vec::new()) }))
        }
    }
}

/// The fits of a law.
enum Fits<W: LaneLaw, L: Unit> {
    /// One for all contacts.
    Shared(W::FitOf<L>),
    /// One per contact so far, in the order in which they began.
    Each(Vec<W::FitOf<f64>>),
    /// As `Each` or for all, still without the speed that it follows.
    Following(Vec<W::Fit>),
}

struct Prepared<W: LaneLaw, L: Unit> {
    coeffs: Vec<W::Coeffs>,
    at: usize,
    fits: Fits<W, L>,
}

impl<W: LaneLaw, L: Unit> Prepared<W, L> {
    const SLOTS: usize = W::META.slots.len();
    /// The slots that are read and written three at a time, as vectors are.
    const THREES: usize = Self::SLOTS / 3 * 3;

    #[inline(always)]
    fn touch_block(&self, f: &W::FitOf<L>, at: &At<'_>, b: &mut Block<L>, call: &Call, first: bool) -> Mark {
        let Block { surface, stage } = b;
        let mut h = self.history(at);
        if first {
            let mut new = Stage::default();
            W::touch_lanes::<L>(f, call, surface, &mut h, &mut new);
            *stage = new;
        } else {
            stage.mark = Mark::Leave;
            W::touch_lanes::<L>(f, call, surface, &mut h, stage);
        }
        self.keep(at, h.as_ref());
        stage.mark
    }

    #[allow(
        clippy::needless_range_loop,
        reason = "adaptors of iterators are not inlined into code for a vector unit"
    )]
    #[inline(always)]
    fn history(&self, at: &At<'_>) -> W::HistoryOf<L> {
        let mut columns = [L::splat(0.0); MOST_SLOTS];
        let place = |k: usize, c: usize| at.history[k].wrapping_add(self.at + c).cast_const();
        for c in (0..Self::THREES).step_by(3) {
            // SAFETY: every contact of a block has a row that holds the slots of all laws of the chain.
            let three = unsafe {
                L::gather(
                    #[inline(always)]
                    |k| place(k, c).cast(),
                )
            };
            columns[c..c + 3].copy_from_slice(three.as_slice());
        }
        for c in Self::THREES..Self::SLOTS {
            // SAFETY: as above.
            columns[c] = L::from_fn(|k| unsafe { *place(k, c) });
        }
        let Ok(h) = W::HistoryOf::<L>::try_from(&columns[..Self::SLOTS]) else {
            unreachable!("the history of a law has as many numbers as it has slots")
        };
        h
    }

    #[allow(
        clippy::needless_range_loop,
        reason = "adaptors of iterators are not inlined into code for a vector unit"
    )]
    #[inline(always)]
    fn keep(&self, at: &At<'_>, columns: &[L]) {
        let place = |k: usize, c: usize| at.history[k].wrapping_add(self.at + c);
        for c in (0..Self::THREES).step_by(3) {
            let three = Vector3::new(columns[c], columns[c + 1], columns[c + 2]);
            // SAFETY: as in `history`; rows of different contacts do not overlap.
            unsafe {
                L::scatter(
                    &three,
                    #[inline(always)]
                    |k| place(k, c).cast(),
                );
            }
        }
        for c in Self::THREES..Self::SLOTS {
            for k in 0..L::WIDTH {
                // SAFETY: as above.
                unsafe { *place(k, c) = columns[c].lane(k) };
            }
        }
    }
}

const ANY: Size = Size { radi: 1.0, radj: 1.0, massi: 1.0, massj: 1.0, meff: 0.5, is_wall: false };

/// No law on lanes has more slots.
const MOST_SLOTS: usize = 8;

impl<W: LaneLaw, L: Unit> Kernel<L> for Prepared<W, L> {
    fn fit_all(&mut self, pair: usize, size: &Size) {
        const { assert!(Self::SLOTS <= MOST_SLOTS) };
        let fit = W::fit(&self.coeffs[pair], size);
        self.fits = if W::follows_speed(&fit) {
            Fits::Following(vec![fit])
        } else {
            L::run(|| {
                let fit = W::fit_at(&fit, 0.0);
                Fits::Shared(W::side_by_side::<L>(|_| fit))
            })
        };
    }

    fn fit_none(&mut self) {
        self.fits = match std::mem::replace(&mut self.fits, Fits::Each(Vec::new())) {
            // Any fit tells whether it follows the speed.
            _ if W::follows_speed(&W::fit(&self.coeffs[0], &ANY)) => Fits::Following(Vec::new()),
            Fits::Each(mut fits) => {
                fits.clear();
                Fits::Each(fits)
            }
            _ => Fits::Each(Vec::new()),
        };
    }

    fn fit(&mut self, pair: usize, size: &Size) {
        let fit = W::fit(&self.coeffs[pair], size);
        match &mut self.fits {
            Fits::Shared(_) => {}
            Fits::Each(fits) => fits.push(W::fit_at(&fit, 0.0)),
            Fits::Following(fits) => fits.push(fit),
        }
    }

    fn touch(&self, chunk: &mut Chunk<L>, call: &Call, first: bool) -> Mark {
        let mut mark = Mark::Leave;
        L::run(
            #[inline(always)]
            || match &self.fits {
                Fits::Shared(f) => {
                    chunk.each_block(
                        #[inline(always)]
                        |at, b| mark = self.touch_block(f, at, b, call, first),
                    );
                }
                Fits::Each(fits) => chunk.each_block(
                    #[inline(always)]
                    |at, b| {
                        let f = W::side_by_side::<L>(
                            #[inline(always)]
                            |k| fits[at.fit[k] as usize],
                        );
                        mark = self.touch_block(&f, at, b, call, first);
                    },
                ),
                Fits::Following(fits) => chunk.each_block(
                    #[inline(always)]
                    |at, b| {
                        let number = |k: usize| if fits.len() == 1 { 0 } else { at.fit[k] as usize };
                        let fit = |k: usize| W::fit_at(&fits[number(k)], b.surface.vn.lane(k));
                        let now: [_; 8] = std::array::from_fn(|k| fit(k % L::WIDTH));
                        let f = W::side_by_side::<L>(
                            #[inline(always)]
                            |k| now[k],
                        );
                        mark = self.touch_block(&f, at, b, call, first);
                    },
                ),
            },
        );
        mark
    }

    fn bytes(&self) -> usize {
        match &self.fits {
            Fits::Shared(_) => 0,
            Fits::Each(fits) => fits.capacity() * size_of::<W::FitOf<f64>>(),
            Fits::Following(fits) => fits.capacity() * size_of::<W::Fit>(),
        }
    }
}
