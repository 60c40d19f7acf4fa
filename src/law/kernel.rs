//! A law with its types erased, ready to run for every pair of atom types.
use super::{Contact, Gap, LaneLaw, Law, LawError, Meta, Setup, Size, Stage, Terms};
use bytemuck::Pod;
use std::fmt::Debug;

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

/// What is made of every law that has lanes: kernels of a certain width, tests.
pub trait ForLanes: Copy + Debug + 'static {
    /// What comes out.
    type Made: 'static;
    /// Make it for one law.
    fn make<W: LaneLaw>() -> Self::Made;
}

/// Where nothing is made of lanes: a law as it stands.
#[derive(Clone, Copy, Debug)]
pub struct Alone;

impl ForLanes for Alone {
    type Made = ();
    fn make<W: LaneLaw>() {}
}

/// A row of the registry.
#[derive(Clone, Copy, Debug)]
pub struct Entry<U: ForLanes = Alone> {
    /// What the law says of itself.
    pub meta: &'static Meta,
    prepare: fn(&Setup) -> Result<Box<dyn Kernel>, LawError>,
    lanes: Option<fn() -> U::Made>,
}

impl<U: ForLanes> Entry<U> {
    /// The row of a law whose hot function takes one contact at a time.
    pub const fn scalar<L: Law>() -> Entry<U> {
        assert!(size_of::<L::History>() == 8 * L::META.slots.len(), "History and slots differ in length");
        assert!(L::META.id >= 48 && L::META.id < 64, "own numbers are 48 to 63");
        Entry { meta: &L::META, prepare: prepare::<L>, lanes: None }
    }

    /// The row of a law whose hot function takes several.
    pub const fn lanes<W: LaneLaw>() -> Entry<U> {
        Entry { lanes: Some(U::make::<W>), ..Entry::scalar::<W>() }
    }

    /// Check the set-up and prepare the law for all pairs of atom types.
    ///
    /// # Errors
    /// The first thing that the law refuses.
    pub fn prepare(&self, setup: &Setup) -> Result<Box<dyn Kernel>, LawError> {
        (self.prepare)(setup)
    }

    /// What `U` makes of the law; nothing of one without lanes.
    pub fn make(&self) -> Option<U::Made> {
        self.lanes.map(|make| make())
    }
}

fn prepare<L: Law>(setup: &Setup) -> Result<Box<dyn Kernel>, LawError> {
    Ok(Box::new(Prepared::<L> { coeffs: setup.coeffs::<L>()?, fit: None }))
}
