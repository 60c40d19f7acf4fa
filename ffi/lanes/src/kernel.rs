//! One law over the contacts of a chunk.
use crate::chunk::{At, Block, Chunk};
use crate::unit::Unit;
use granlaw::lane::Lanes;
use granlaw::model::{Call, ForLanes, Law, LawError, Parameters, Response, Setup, Size, Slots};
use nalgebra::Vector3;
use std::marker::PhantomData;

/// A law prepared for lanes of one width.
pub(crate) trait Kernel<L> {
    /// All contacts have this pair of types and this size from now on.
    fn fit_all(&mut self, pair: usize, size: &Size);
    /// Contacts differ from now on, and none has parameters yet.
    fn fit_none(&mut self);
    /// The parameters of one more contact, with this pair of types and this size.
    fn fit(&mut self, pair: usize, size: &Size);
    /// Run the law, `first` of the chain or not.
    fn surfaces_intersect(&self, chunk: &mut Chunk<L>, call: &Call, first: bool);
    /// Bytes in use.
    fn bytes(&self) -> usize;
}

/// Makes kernels of one width of all laws over lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kernels<L>(PhantomData<L>);

/// A kernel from its set-up and the places of its history in a row.
pub(crate) type Prepare<L> = fn(&Setup, &[usize]) -> Result<Box<dyn Kernel<L>>, LawError>;

impl<L: Unit> ForLanes for Kernels<L> {
    type Made = Prepare<L>;
    fn make<W: Law>() -> Prepare<L> {
        |setup, places| {
            let coeffs = setup.mixed(W::Params::coeffs)?;
            let places = Places::new(&setup.placed(places));
            Ok(Box::new(Prepared::<W, L> { coeffs, places, params: Params::Each(Vec::new()) }))
        }
    }
}

/// Where the slots of a law lie in a row.
struct Places {
    /// Where the first one lies.
    begin: usize,
    /// All of them, unless they lie behind each other; `None` where the settings do not call for one.
    apart: Option<Vec<Option<usize>>>,
}

impl Places {
    fn new(places: &[Option<usize>]) -> Places {
        let begin = places.first().copied().flatten().unwrap_or(0);
        let together = places.iter().zip(begin..).all(|(place, at)| *place == Some(at));
        Places { begin, apart: (!together).then(|| places.to_vec()) }
    }
}

/// The parameters of a law.
enum Params<W: Law, L: Unit> {
    /// The same for all contacts.
    Shared(<W::Params as Lanes>::Of<L>),
    /// Those of each contact so far, in the order in which they began.
    Each(Vec<W::Params>),
}

type History<W, L> = <<W as Law>::History as Lanes>::Of<L>;

struct Prepared<W: Law, L: Unit> {
    coeffs: Vec<<W::Params as Parameters>::Coeffs>,
    places: Places,
    params: Params<W, L>,
}

impl<W: Law, L: Unit> Prepared<W, L> {
    const SLOTS: usize = <W::History as Slots>::LEN;
    /// The slots that are read and written three at a time, as vectors are.
    const THREES: usize = Self::SLOTS / 3 * 3;

    /// `APART`: the slots do not lie behind each other. Asked once for all blocks, as a question in each costs two per cent.
    #[inline(always)]
    fn touch_block<const APART: bool>(
        &self,
        p: &<W::Params as Lanes>::Of<L>,
        at: &At<'_>,
        b: &mut Block<L>,
        call: &Call,
        first: bool,
    ) {
        let Block { surface, response } = b;
        let mut h = W::History::zero::<L>();
        self.read::<APART>(at, &mut h);
        if first {
            // What no law of this chain hands on is left as it is: laws that read it are refused at set-up.
            let mut new = Response { kc: response.kc, fo: response.fo, ..Response::default() };
            W::intersect::<L>(p, call, surface, &mut h, &mut new);
            *response = new;
        } else {
            W::intersect::<L>(p, call, surface, &mut h, response);
        }
        self.keep::<APART>(at, &h);
    }

    #[allow(
        clippy::needless_range_loop,
        reason = "adaptors of iterators are not inlined into code for a vector unit"
    )]
    #[inline(always)]
    fn read<const APART: bool>(&self, at: &At<'_>, h: &mut History<W, L>) {
        let columns = W::History::lanes_mut(h);
        if APART {
            return read_apart(self.places.apart.as_deref().unwrap_or_default(), at, columns);
        }
        let place = |k: usize, c: usize| at.history[k].wrapping_add(self.places.begin + c).cast_const();
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
    }

    #[allow(
        clippy::needless_range_loop,
        reason = "adaptors of iterators are not inlined into code for a vector unit"
    )]
    #[inline(always)]
    fn keep<const APART: bool>(&self, at: &At<'_>, h: &History<W, L>) {
        let columns = W::History::lanes(h);
        if APART {
            return keep_apart(self.places.apart.as_deref().unwrap_or_default(), at, columns);
        }
        let place = |k: usize, c: usize| at.history[k].wrapping_add(self.places.begin + c);
        for c in (0..Self::THREES).step_by(3) {
            let three = Vector3::new(columns[c], columns[c + 1], columns[c + 2]);
            // SAFETY: as in `read`; rows of different contacts do not overlap.
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

    fn every_block<const APART: bool>(&self, chunk: &mut Chunk<L>, call: &Call, first: bool) {
        L::run(
            #[inline(always)]
            || match &self.params {
                Params::Shared(p) => {
                    chunk.each_block(
                        #[inline(always)]
                        |at, b| self.touch_block::<APART>(p, at, b, call, first),
                    );
                }
                Params::Each(params) => chunk.each_block(
                    #[inline(always)]
                    |at, b| {
                        let p = W::Params::side_by_side::<L>(
                            #[inline(always)]
                            |k| params[at.fit[k] as usize],
                        );
                        self.touch_block::<APART>(&p, at, b, call, first);
                    },
                ),
            },
        );
    }
}

/// Slots that lie anywhere in a row; those that are not there stay zero.
#[inline(never)]
fn read_apart<L: Unit>(places: &[Option<usize>], at: &At<'_>, columns: &mut [L]) {
    for (column, place) in columns.iter_mut().zip(places) {
        if let Some(place) = place {
            // SAFETY: every contact of a block has a row that holds the slots of all laws of the chain.
            *column = L::from_fn(|k| unsafe { *at.history[k].wrapping_add(*place) });
        }
    }
}

/// See [`read_apart`].
#[inline(never)]
fn keep_apart<L: Unit>(places: &[Option<usize>], at: &At<'_>, columns: &[L]) {
    for (column, place) in columns.iter().zip(places) {
        for (k, row) in at.history.iter().enumerate().take(L::WIDTH) {
            if let Some(place) = place {
                // SAFETY: as in `read_apart`; rows of different contacts do not overlap.
                unsafe { *row.wrapping_add(*place) = column.lane(k) };
            }
        }
    }
}

impl<W: Law, L: Unit> Kernel<L> for Prepared<W, L> {
    fn fit_all(&mut self, pair: usize, size: &Size) {
        let params = W::Params::new(&self.coeffs[pair], size);
        self.params = L::run(|| Params::Shared(W::Params::side_by_side::<L>(|_| params)));
    }

    fn fit_none(&mut self) {
        match &mut self.params {
            Params::Each(params) => params.clear(),
            shared => *shared = Params::Each(Vec::new()),
        }
    }

    fn fit(&mut self, pair: usize, size: &Size) {
        if let Params::Each(params) = &mut self.params {
            params.push(W::Params::new(&self.coeffs[pair], size));
        }
    }

    fn surfaces_intersect(&self, chunk: &mut Chunk<L>, call: &Call, first: bool) {
        if Self::SLOTS > 0 && self.places.apart.is_some() {
            self.every_block::<true>(chunk, call, first);
        } else {
            self.every_block::<false>(chunk, call, first);
        }
    }

    fn bytes(&self) -> usize {
        match &self.params {
            Params::Shared(_) => 0,
            Params::Each(params) => params.capacity() * size_of::<W::Params>(),
        }
    }
}
