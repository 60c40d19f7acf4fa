//! A law with its types erased, ready to run for every pair of atom types.
use super::{Contact, Gap, LaneLaw, Law, LawError, Meta, Reach, Setup, Size, Stage, Swing, Terms};
use bytemuck::Pod;
use std::fmt::Debug;

/// What the chain holds of a law: prepared for all pairs of atom types, histories as plain numbers.
pub trait Kernel: Send {
    /// Fit to two sizes of a pair of atom types (`type_i * types + type_j`, counted from 0), for all calls until the next fit.
    fn fit(&mut self, pair: usize, size: &Size);
    /// The surfaces overlap.
    fn touch(&self, x: &Contact, h: &mut [f64], s: &mut Stage);
    /// They do not. Only a law with [`Reach::Beyond`] needs a fit for this.
    fn apart(&self, x: &Gap, h: &mut [f64], s: &mut Stage);
    /// See [`Law::observe`].
    fn observe(&self, x: &Contact, h: &[f64]) -> Terms;
    /// See [`Law::swings`]; `size` is that of the fit.
    fn swings(&self, size: &Size, speed: f64) -> Vec<Swing>;
    /// The largest [`Law::reach`] of all type pairs \[m\].
    fn reach(&self, is_wall: bool) -> f64;
    /// See [`Law::remarks`]; each once.
    fn remarks(&self) -> &[String];
}

/// How a law sees its part of a row of history.
pub trait Memory {
    /// How many numbers it holds, if that is the same under all settings.
    const SLOTS: Option<usize>;
    /// The numbers as the law has them.
    fn view(h: &mut [f64]) -> &mut Self;
    /// The same without writing.
    fn see(h: &[f64]) -> &Self;
    /// All numbers become 0.
    fn clear(&mut self);
}

impl<H: Pod> Memory for H {
    const SLOTS: Option<usize> = Some(size_of::<H>() / 8);
    fn view(h: &mut [f64]) -> &mut H {
        bytemuck::from_bytes_mut(bytemuck::cast_slice_mut(h))
    }
    fn see(h: &[f64]) -> &H {
        bytemuck::from_bytes(bytemuck::cast_slice(h))
    }
    fn clear(&mut self) {
        *self = H::zeroed();
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
    fn clear(&mut self) {
        self.fill(0.0);
    }
}

struct Prepared<L: Law> {
    coeffs: Vec<L::Coeffs>,
    remarks: Vec<String>,
    fit: Option<L::Fit>,
}

impl<L: Law> Prepared<L> {
    #[inline]
    fn fitted(&self) -> &L::Fit {
        self.fit.as_ref().expect("the chain fits before it calls")
    }
}

impl<L: Law> Kernel for Prepared<L> {
    fn fit(&mut self, pair: usize, size: &Size) {
        self.fit = Some(L::fit(&self.coeffs[pair], size));
    }
    fn touch(&self, x: &Contact, h: &mut [f64], s: &mut Stage) {
        L::touch(self.fitted(), x, L::History::view(h), s);
    }
    fn apart(&self, x: &Gap, h: &mut [f64], s: &mut Stage) {
        let h = L::History::view(h);
        match L::META.reach {
            Reach::Overlap => L::apart(h, s),
            Reach::Beyond => L::across(self.fitted(), x, h, s),
        }
    }
    fn observe(&self, x: &Contact, h: &[f64]) -> Terms {
        L::observe(self.fitted(), x, L::History::see(h))
    }
    fn swings(&self, size: &Size, speed: f64) -> Vec<Swing> {
        L::swings(self.fitted(), size, speed)
    }
    fn reach(&self, is_wall: bool) -> f64 {
        self.coeffs.iter().map(|c| L::reach(c, is_wall)).fold(0.0, f64::max)
    }
    fn remarks(&self) -> &[String] {
        &self.remarks
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
        match <L::History as Memory>::SLOTS {
            Some(n) => assert!(n == L::META.slots.len(), "History and slots differ in length"),
            None => {
                assert!(L::META.stock_id.is_none(), "a stock law's history is the same under all settings");
            }
        }
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
    let coeffs = setup.coeffs::<L>()?;
    let n = setup.values.types;
    let mut remarks: Vec<_> = (0..n * n).flat_map(|p| L::remarks(&setup.pair(p / n, p % n))).collect();
    remarks.sort();
    remarks.dedup();
    Ok(Box::new(Prepared::<L> { coeffs, remarks, fit: None }))
}
