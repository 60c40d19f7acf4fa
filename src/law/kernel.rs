//! A law with its types erased, ready to run for every pair of atom types.
use super::{Contact, Gap, Law, LawError, Meta, Setup, Size, Stage, Terms};
use bytemuck::Pod;

/// What the chain holds of a law: prepared for all pairs of atom types, histories as plain numbers.
pub trait Kernel: Send {
    /// Fit to two sizes of a pair of atom types (`type_i * types + type_j`, counted from 0), for all calls until the next fit.
    fn fit(&mut self, pair: usize, size: &Size);
    /// The surfaces overlap.
    fn touch(&self, x: &Contact, h: &mut [f64], s: &mut Stage);
    /// They do not.
    fn apart(&self, x: &Gap, h: &mut [f64], s: &mut Stage);
    /// See [`Law::observe`].
    fn observe(&self, x: &Contact, h: &[f64]) -> Terms;
}

struct Prepared<L: Law> {
    coeffs: Vec<L::Coeffs>,
    fit: Option<L::Fit>,
}

impl<L: Law> Prepared<L> {
    #[inline]
    fn fitted(&self) -> &L::Fit {
        self.fit.as_ref().expect("the chain fits before it calls")
    }
}

fn view<H: Pod>(h: &mut [f64]) -> &mut H {
    bytemuck::from_bytes_mut(bytemuck::cast_slice_mut(h))
}

impl<L: Law> Kernel for Prepared<L> {
    fn fit(&mut self, pair: usize, size: &Size) {
        self.fit = Some(L::fit(&self.coeffs[pair], size));
    }
    fn touch(&self, x: &Contact, h: &mut [f64], s: &mut Stage) {
        L::touch(self.fitted(), x, view(h), s);
    }
    fn apart(&self, x: &Gap, h: &mut [f64], s: &mut Stage) {
        L::apart(self.fitted(), x, view(h), s);
    }
    fn observe(&self, x: &Contact, h: &[f64]) -> Terms {
        L::observe(self.fitted(), x, bytemuck::from_bytes(bytemuck::cast_slice(h)))
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
    Ok(Box::new(Prepared::<L> { coeffs, fit: None }))
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
