//! The batched pair pass: all contacts of a step in one call, several side by side in vector registers.
//!
//! Nothing is described here a second time. The laws are those of [`granlaw::laws::all`], whose hot functions are written
//! once over [`granlaw::lane::Lane`]; this crate adds the vector units, walks LIGGGHTS's neighbour lists, and adds up
//! forces in LIGGGHTS's order, so that the answers are those of the contact path to the last bit.
#![warn(clippy::undocumented_unsafe_blocks)]

pub mod arrays;
mod chunk;
mod few;
mod kernel;
mod list;
mod near;
mod pass;
mod seen;
mod trouble;
mod unit;

pub use arrays::Arrays;
pub use trouble::{NonFinite, Trouble};
pub use unit::Width;

use granlaw::lane::Pack;
use granlaw::model::{LawError, Setup};
use pass::Pass;

/// A chain that runs over all contacts of a step at once.
pub trait Batch {
    /// One pass: adds to forces and torques, writes history and contact flags.
    ///
    /// # Errors
    /// A contact that is not finite, or arrays that do not fit together.
    ///
    /// # Safety
    /// `a` is what [`Arrays`] says.
    unsafe fn pass(&mut self, a: &Arrays) -> Result<(), Trouble>;
    /// How many contacts were evaluated so far.
    fn contacts(&self) -> u64;
    /// How many neighbours the lists hold.
    fn neighbours(&self) -> usize;
    /// How many of them the last pass looked at: those that can touch before long.
    fn looked_at(&self) -> usize;
    /// Bytes in use beside LIGGGHTS's own.
    fn bytes(&self) -> usize;
}

/// The chain of laws, as wide as asked for; `places[k]` is where the slots of `setups[k]` lie in a row of history. `None` where a law
/// has no lanes.
///
/// # Errors
/// The first thing that a law refuses.
pub fn batch(
    setups: &[Setup],
    places: &[Vec<usize>],
    width: Width,
) -> Result<Option<Box<dyn Batch>>, LawError> {
    // The only place that chooses a unit, after asking the processor for it.
    match width {
        Width::One => Pass::<f64>::boxed(setups, places),
        #[cfg(target_arch = "x86_64")]
        Width::Four if unit::has_avx2() => Pass::<unit::avx2::Avx2>::boxed(setups, places),
        #[cfg(target_arch = "x86_64")]
        Width::Eight if unit::has_avx512() => Pass::<unit::avx512::Avx512>::boxed(setups, places),
        Width::Four => Pass::<Pack<4>>::boxed(setups, places),
        Width::Eight => Pass::<Pack<8>>::boxed(setups, places),
    }
}

/// The same, as wide as suits each neighbour list: one contact at a time among a handful of particles, else
/// [`Width::widest`].
///
/// # Errors
/// As [`batch`].
pub fn fitting(setups: &[Setup], places: &[Vec<usize>]) -> Result<Option<Box<dyn Batch>>, LawError> {
    let [one, wide] = [batch(setups, places, Width::One)?, batch(setups, places, Width::widest())?];
    Ok(one.zip(wide).map(|(one, wide)| Box::new(few::Fitting::new(one, wide)) as Box<dyn Batch>))
}
