//! The one abstraction: what a contact law is.
//!
//! A law describes itself in its [`Meta`], refuses impossible set-ups in [`Law::coeffs`], and is from there on a pure
//! function of coefficients, contact and history. Read `laws/hooke.rs` next.
mod contact;
mod kernel;
mod meta;
mod setup;

pub use contact::{Body, Call, Contact, Gap, Life, Mark, Size, Stage, Surface, Swing, Terms, ATOM_PROPS};
pub use kernel::{Alone, Entry, ForLanes, Kernel, Memory};
pub use meta::{
    AtomProp, Exception, Kind, Meta, Need, Newton, Prop, Range, Reach, Rule, Setting, Shape, Slot, Support,
    Unit,
};
pub use setup::{LawError, Pair, Settings, Setup, Values};

use crate::lane::Lane;

/// A contact law. Its file holds all of it; a line in `laws::LAWS` makes it known everywhere.
pub trait Law: 'static {
    /// What the law says of itself.
    const META: Meta;
    /// Contact history: as many `f64` as `META.slots`, in that order. `[f64]` where settings decide which are kept.
    type History: Memory + ?Sized;
    /// What a pair of atom types decides.
    type Coeffs: Copy + Send;
    /// What remains once radii and masses are known; reused as long as they stay the same.
    type Fit: Copy + Send;

    /// Mix the properties of a type pair, once per run. Ranges and missing values are already checked.
    ///
    /// # Errors
    /// Combinations that make no sense.
    fn coeffs(pair: &Pair<'_>) -> Result<Self::Coeffs, LawError>;
    /// How far the law acts \[m\], from centre to centre or from a centre to a wall; 0 only while surfaces overlap.
    fn reach(_: &Self::Coeffs, _is_wall: bool) -> f64 {
        0.0
    }
    /// What the user should know about a type pair that is allowed but asks for trouble.
    fn remarks(_: &Pair<'_>) -> Vec<String> {
        Vec::new()
    }
    /// Fit the coefficients to two sizes.
    fn fit(c: &Self::Coeffs, size: &Size) -> Self::Fit;
    /// The surfaces overlap.
    fn touch(f: &Self::Fit, x: &Contact, h: &mut Self::History, s: &mut Stage);
    /// They do not: the contact is forgotten.
    fn apart(h: &mut Self::History, s: &mut Stage) {
        h.clear();
        s.mark = Mark::Clear;
    }
    /// In place of [`Law::apart`] for a law with [`Reach::Beyond`], which may still answer with a force.
    fn across(_: &Self::Fit, _: &Gap, h: &mut Self::History, s: &mut Stage) {
        Self::apart(h, s);
    }
    /// The ways in which two bodies swing under a law that acts whether or not surfaces overlap, each as stiff as it gets;
    /// they limit the time step. `speed` is how fast the bodies move against each other \[m/s\]. A law that answers to an
    /// overlap tells its stiffness in [`Law::observe`] instead.
    fn swings(_: &Self::Fit, _size: &Size, _speed: f64) -> Vec<Swing> {
        Vec::new()
    }
    /// What a study wants to know of the contact, before `touch` is called on it.
    fn observe(f: &Self::Fit, x: &Contact, h: &Self::History) -> Terms;
}

/// A law whose hot function runs on several contacts at once. Its [`Law::touch`] is the one-lane instance.
pub trait LaneLaw: Law {
    /// [`Law::Fit`], one per lane.
    type FitOf<L: Lane>: Copy;
    /// [`Law::History`], one per lane: `[L; slots]`.
    type HistoryOf<L: Lane>: Copy + AsRef<[L]> + for<'a> TryFrom<&'a [L]>;

    /// Whether the fit changes with the normal velocity, so that it cannot be kept.
    fn follows_speed(_: &Self::Fit) -> bool {
        false
    }
    /// The fit that holds at a normal velocity \[m/s\].
    fn fit_at(f: &Self::Fit, vn: f64) -> Self::FitOf<f64>;
    /// The fits of all lanes side by side. They come from one chain, so their switches are the same.
    fn side_by_side<L: Lane>(fit: impl Fn(usize) -> Self::FitOf<f64>) -> Self::FitOf<L>;

    /// The hot function: `call` is the same for all lanes.
    fn touch_lanes<L: Lane>(
        f: &Self::FitOf<L>,
        call: &Call,
        x: &Surface<L>,
        h: &mut Self::HistoryOf<L>,
        s: &mut Stage<L>,
    );
}
