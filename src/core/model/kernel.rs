//! A law with its types erased, prepared for all pairs of atom types.
use super::{ClosePair, Contact, Effects, GapLaw, Law, NamedMode, Observation, Parameters, Response, Size};
use crate::lane::{Lane, Lanes};
use bytemuck::Pod;
use std::ops::Range;

/// What the chain holds of a law. `row` is a contact's whole row of history; the kernel knows its places in it.
pub trait Kernel: Send {
    /// Fit to two sizes of a pair of atom types (`type_i * types + type_j`, counted from 0), for all calls until the next fit.
    fn fit(&mut self, pair: usize, size: &Size);
    /// The surfaces overlap.
    fn surfaces_intersect(&self, x: &Contact, row: &mut [f64], s: &mut Response, e: &mut Effects);
    /// They do not. Only a law with [`Reach::Beyond`] needs a fit for this.
    fn surfaces_close(&self, x: &ClosePair, row: &mut [f64], s: &mut Response, e: &mut Effects);
    /// See [`Law::observe`].
    fn observe(&self, x: &Contact, row: &[f64]) -> Observation;
    /// See [`GapLaw::modes`]; `size` is that of the fit.
    fn modes(&self, size: &Size, speed: f64) -> Vec<NamedMode>;
    /// The largest [`GapLaw::reach`] of all type pairs \[m\].
    fn reach(&self, is_wall: bool) -> f64;
    /// See [`Law::remarks`]; each once.
    fn remarks(&self) -> &[String];
}

/// The history of a law over lanes: `[f64; N]`.
pub trait Slots: Lanes<Of<f64> = Self> + Send {
    /// N.
    const LEN: usize;
    /// All zero.
    fn zero<L: Lane>() -> Self::Of<L>;
    /// The lanes, slot by slot.
    fn lanes<L: Lane>(h: &Self::Of<L>) -> &[L];
    /// The same for writing.
    fn lanes_mut<L: Lane>(h: &mut Self::Of<L>) -> &mut [L];
}

impl<const N: usize> Slots for [f64; N] {
    const LEN: usize = N;
    #[inline(always)]
    fn zero<L: Lane>() -> [L; N] {
        [L::splat(0.0); N]
    }
    #[inline(always)]
    fn lanes<L: Lane>(h: &[L; N]) -> &[L] {
        h
    }
    #[inline(always)]
    fn lanes_mut<L: Lane>(h: &mut [L; N]) -> &mut [L] {
        h
    }
}

/// How a law that acts across a gap sees its part of a row of history.
pub trait Memory {
    /// How many numbers it holds, if that is the same under all settings.
    const SLOTS: Option<usize>;
    /// The numbers as the law has them.
    fn view(h: &mut [f64]) -> &mut Self;
    /// The same without writing.
    fn see(h: &[f64]) -> &Self;
}

impl<H: Pod> Memory for H {
    const SLOTS: Option<usize> = Some(size_of::<H>() / 8);
    fn view(h: &mut [f64]) -> &mut H {
        bytemuck::from_bytes_mut(bytemuck::cast_slice_mut(h))
    }
    fn see(h: &[f64]) -> &H {
        bytemuck::from_bytes(bytemuck::cast_slice(h))
    }
}

impl Memory for [f64] {
    const SLOTS: Option<usize> = None;
    fn view(h: &mut [f64]) -> &mut [f64] {
        h
    }
    fn see(h: &[f64]) -> &[f64] {
        h
    }
}

/// What is the same for every prepared law.
struct Prepared<C, P> {
    coeffs: Vec<C>,
    remarks: Vec<String>,
    params: Option<P>,
}

impl<C, P> Prepared<C, P> {
    fn new(coeffs: Vec<C>, mut remarks: Vec<String>) -> Prepared<C, P> {
        remarks.sort();
        remarks.dedup();
        Prepared { coeffs, remarks, params: None }
    }

    #[inline]
    fn params(&self) -> &P {
        self.params.as_ref().expect("the chain fits before it calls")
    }
}

/// A [`Law`], one contact at a time.
struct Single<W: Law> {
    of: Prepared<<W::Params as Parameters>::Coeffs, W::Params>,
    /// Where each slot lies in a row.
    places: Vec<Option<usize>>,
    /// Where the first one lies, if all are there and lie behind each other.
    begin: Option<usize>,
}

impl<W: Law> Single<W> {
    #[inline]
    fn history(&self, row: &[f64]) -> W::History {
        let mut h = W::History::zero::<f64>();
        let own = W::History::lanes_mut::<f64>(&mut h);
        match self.begin {
            Some(begin) => own.copy_from_slice(&row[begin..begin + W::History::LEN]),
            None => {
                for (value, at) in own.iter_mut().zip(&self.places) {
                    *value = at.map_or(0.0, |at| row[at]);
                }
            }
        }
        h
    }

    #[inline]
    fn keep(&self, h: &W::History, row: &mut [f64]) {
        let own = W::History::lanes::<f64>(h);
        match self.begin {
            Some(begin) => row[begin..begin + W::History::LEN].copy_from_slice(own),
            None => {
                let kept = own.iter().zip(&self.places).filter_map(|(value, at)| Some((value, (*at)?)));
                kept.for_each(|(value, at)| row[at] = *value);
            }
        }
    }
}

impl<W: Law> Kernel for Single<W> {
    fn fit(&mut self, pair: usize, size: &Size) {
        self.of.params = Some(W::Params::new(&self.of.coeffs[pair], size));
    }
    fn surfaces_intersect(&self, x: &Contact, row: &mut [f64], s: &mut Response, e: &mut Effects) {
        let mut h = self.history(row);
        W::intersect::<f64>(self.of.params(), &x.close.call, &x.surface, &mut h, s);
        self.keep(&h, row);
        e.contact_flag = W::LIGGGHTS.contact_flags[0];
    }
    fn surfaces_close(&self, _: &ClosePair, row: &mut [f64], _: &mut Response, e: &mut Effects) {
        self.keep(&W::History::zero::<f64>(), row);
        e.contact_flag = W::LIGGGHTS.contact_flags[1];
    }
    fn observe(&self, x: &Contact, row: &[f64]) -> Observation {
        W::observe(self.of.params(), x, &self.history(row))
    }
    fn modes(&self, _: &Size, _: f64) -> Vec<NamedMode> {
        Vec::new()
    }
    fn reach(&self, _: bool) -> f64 {
        0.0
    }
    fn remarks(&self) -> &[String] {
        &self.of.remarks
    }
}

/// A [`GapLaw`].
struct Across<W: GapLaw> {
    of: Prepared<W::Coeffs, W::Params>,
    slots: Range<usize>,
}

impl<W: GapLaw> Kernel for Across<W> {
    fn fit(&mut self, pair: usize, size: &Size) {
        self.of.params = Some(W::params(&self.of.coeffs[pair], size));
    }
    fn surfaces_intersect(&self, x: &Contact, row: &mut [f64], s: &mut Response, e: &mut Effects) {
        self.surfaces_close(&x.close, row, s, e);
    }
    fn surfaces_close(&self, x: &ClosePair, row: &mut [f64], s: &mut Response, e: &mut Effects) {
        W::interact(self.of.params(), x, W::History::view(&mut row[self.slots.clone()]), s, e);
    }
    fn observe(&self, x: &Contact, row: &[f64]) -> Observation {
        W::observe(self.of.params(), &x.close, W::History::see(&row[self.slots.clone()]))
    }
    fn modes(&self, size: &Size, speed: f64) -> Vec<NamedMode> {
        W::modes(self.of.params(), size, speed)
    }
    fn reach(&self, is_wall: bool) -> f64 {
        self.of.coeffs.iter().map(|c| W::reach(c, is_wall)).fold(0.0, f64::max)
    }
    fn remarks(&self) -> &[String] {
        &self.of.remarks
    }
}

/// A [`Law`] from its coefficients for all pairs of types, and the place of each of its slots in a row.
pub(super) fn single<W: Law>(
    coeffs: Vec<<W::Params as Parameters>::Coeffs>,
    remarks: Vec<String>,
    places: Vec<Option<usize>>,
) -> Box<dyn Kernel> {
    let begin = places.first().copied().flatten().unwrap_or(0);
    let together = places.iter().zip(begin..).all(|(place, at)| *place == Some(at));
    let begin = together.then_some(begin);
    Box::new(Single::<W> { of: Prepared::new(coeffs, remarks), places, begin })
}

/// A [`GapLaw`] from the same, and where its slots lie.
pub(super) fn across<W: GapLaw>(
    coeffs: Vec<W::Coeffs>,
    remarks: Vec<String>,
    slots: Range<usize>,
) -> Box<dyn Kernel> {
    Box::new(Across::<W> { of: Prepared::new(coeffs, remarks), slots })
}
