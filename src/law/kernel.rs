//! A law with its types erased, ready to run for every pair of atom types.
use super::{Contact, Gap, Law, LawError, Meta, Setup, Size, Stage, Terms};
use bytemuck::Pod;

/// What the chain holds of a law: prepared for all pairs of atom types, histories as plain numbers.
pub trait Kernel: Send {
    /// The surfaces overlap. `pair` is `type_i * types + type_j`, counted from 0.
    fn touch(&mut self, pair: usize, x: &Contact, h: &mut [f64], s: &mut Stage);
    /// They do not.
    fn apart(&mut self, pair: usize, x: &Gap, h: &mut [f64], s: &mut Stage);
    /// See [`Law::observe`].
    fn observe(&mut self, pair: usize, x: &Contact, h: &[f64]) -> Terms;
}

struct Prepared<L: Law> {
    coeffs: Vec<L::Coeffs>,
    last: Option<(usize, Size, L::Fit)>,
}

impl<L: Law> Prepared<L> {
    /// Neighbouring contacts mostly have the same sizes, so the last fit mostly holds.
    #[inline]
    fn fit(&mut self, pair: usize, x: &Gap) -> &L::Fit {
        let size = Size { radi: x.i.radius, radj: x.j.radius, meff: x.meff, is_wall: x.call.is_wall };
        let (p, s, fit) = self.last.get_or_insert_with(|| (pair, size, L::fit(&self.coeffs[pair], &size)));
        if *p != pair || *s != size {
            (*p, *s, *fit) = (pair, size, L::fit(&self.coeffs[pair], &size));
        }
        fit
    }
}

fn view<H: Pod>(h: &mut [f64]) -> &mut H {
    bytemuck::from_bytes_mut(bytemuck::cast_slice_mut(h))
}

impl<L: Law> Kernel for Prepared<L> {
    fn touch(&mut self, pair: usize, x: &Contact, h: &mut [f64], s: &mut Stage) {
        let fit = self.fit(pair, &x.gap);
        L::touch(fit, x, view(h), s);
    }
    fn apart(&mut self, pair: usize, x: &Gap, h: &mut [f64], s: &mut Stage) {
        let fit = self.fit(pair, x);
        L::apart(fit, x, view(h), s);
    }
    fn observe(&mut self, pair: usize, x: &Contact, h: &[f64]) -> Terms {
        let fit = self.fit(pair, &x.gap);
        L::observe(fit, x, bytemuck::from_bytes(bytemuck::cast_slice(h)))
    }
}

/// A row of the registry.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What the law says of itself.
    pub meta: &'static Meta,
    prepare: fn(&Setup) -> Result<Box<dyn Kernel>, LawError>,
}

/// The row of a law.
pub const fn entry<L: Law>() -> Entry {
    assert!(size_of::<L::History>() == 8 * L::META.slots.len(), "History and slots differ in length");
    assert!(L::META.id >= 48 && L::META.id < 64, "own numbers are 48 to 63");
    Entry { meta: &L::META, prepare: prepare::<L> }
}

fn prepare<L: Law>(setup: &Setup) -> Result<Box<dyn Kernel>, LawError> {
    setup.check()?;
    let n = setup.values.types;
    let coeffs = (0..n * n).map(|p| L::coeffs(&setup.pair(p / n, p % n))).collect::<Result<_, _>>()?;
    Ok(Box::new(Prepared::<L> { coeffs, last: None }))
}

impl Entry {
    /// Check the set-up and prepare the law for all pairs of atom types.
    ///
    /// # Errors
    /// The first thing that the law refuses.
    pub fn prepare(&self, setup: &Setup) -> Result<Box<dyn Kernel>, LawError> {
        (self.prepare)(setup)
    }
}
