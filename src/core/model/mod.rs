//! The one abstraction: what a contact law is.
//!
//! A law describes itself in its [`Meta`], refuses impossible set-ups in `coeffs`, and is from there on a pure function
//! of parameters, contact and history. Most are a [`Law`], written over lanes so that several contacts run at once; one
//! that acts across a gap is a [`GapLaw`]. Read `laws/hooke.rs` next.
mod binding;
mod contact;
mod entry;
mod error;
mod kernel;
mod meta;
mod quantity;
mod settings;

pub use binding::{Binding, ContactFlag, Support};
pub use contact::{
    Body, BondEvent, Call, ClosePair, Contact, Effects, Mode, NamedMode, Observation, Response, Size,
    Surface, ATOM_OUTPUTS, ATOM_PROPS,
};
pub use entry::{Alone, Entry, ForLanes, Pair, Setup, Values};
pub use error::LawError;
pub use kernel::{Kernel, Memory, Slots};
pub use meta::{
    AtomProp, Channel, Exception, Kind, Meta, Need, Newton, Prop, Reach, Rule, Setting, Shape, Slot,
};
pub use quantity::{Range, Unit};
pub use settings::{Declaration, Settings};

use crate::lane::{Lane, Lanes};

/// The parameters of a law between two sizes, and what they are made from. They derive `Lanes`.
pub trait Parameters: Lanes<Of<f64> = Self> + Send {
    /// What a pair of atom types decides.
    type Coeffs: Copy + Send;

    /// Mix the properties of a type pair, once per run. Ranges and missing values are already checked.
    ///
    /// # Errors
    /// Combinations that make no sense.
    fn coeffs(pair: &Pair<'_>) -> Result<Self::Coeffs, LawError>;
    /// What remains once radii and masses are known; kept as long as they stay the same.
    fn new(c: &Self::Coeffs, size: &Size) -> Self;
}

impl Parameters for () {
    type Coeffs = ();
    fn coeffs(_: &Pair<'_>) -> Result<(), LawError> {
        Ok(())
    }
    fn new(_: &(), _: &Size) {}
}

/// A contact law. Its file holds all of it; a line in `laws::all` makes it known everywhere.
///
/// ```
/// use granlaw::lane::{Lane, Lanes};
/// use granlaw::model::*;
///
/// /// F = k δ, with k from the deck.
/// struct Spring;
///
/// #[derive(Clone, Copy, Lanes)]
/// struct Params<L = f64> {
///     k: L,
/// }
///
/// impl Parameters for Params {
///     type Coeffs = f64;
///     fn coeffs(p: &Pair<'_>) -> Result<f64, LawError> {
///         Ok(p.get("kSpring"))
///     }
///     fn new(k: &f64, _: &Size) -> Params {
///         Params { k: *k }
///     }
/// }
///
/// impl Law for Spring {
///     type Params = Params;
///     type History = [f64; 0];
///     const META: Meta = Meta {
///         props: &[Prop::new("kSpring", "k", Shape::PerPair, Unit::N_PER_M, Range::above(0.0), "stiffness")],
///         ..Meta::new(Kind::Normal, "spring", "a spring of given stiffness")
///     };
///     fn intersect<L: Lane>(p: &Params<L>, _: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
///         (s.fn_, s.kn) = (p.k * x.deltan, p.k);
///         s.force += x.en * s.fn_;
///     }
///     fn observe(p: &Params, x: &Contact, _: &[f64; 0]) -> Observation {
///         let delta = x.surface.deltan;
///         let stored = 0.5 * p.k * delta * delta;
///         Observation { branch: "spring", stiffness: p.k, stored, ..Observation::default() }
///     }
/// }
///
/// static SPRING: Entry = Entry::law::<Spring>();
/// let values = Values { types: 1, of: vec![vec![1e4]] };
/// let setup = Setup { law: &SPRING, settings: Settings::new(&SPRING, false), values, nktv2p: 1.0 };
/// let mut chain = granlaw::chain::Chain::packed(&[setup])?;
/// let mut response = Response::default();
/// let surface = Surface { deltan: 1e-4, en: nalgebra::Vector3::x(), ..Surface::default() };
/// chain.surfaces_intersect((0, 0), &Contact { surface, ..Contact::default() }, &mut [], &mut response);
/// assert_eq!(response.force.x, 1.0);
/// # Ok::<(), LawError>(())
/// ```
pub trait Law: 'static {
    /// What remains of the properties once radii and masses are known.
    type Params: Parameters;
    /// Contact history, `[f64; N]`: as many numbers as `META.slots`, in that order. A slot that the settings do not call for
    /// is zero, and what is written to it is lost.
    type History: Slots;
    /// What the law says of itself.
    const META: Meta;
    /// How it stands in LIGGGHTS; a law of another crate needs none.
    const LIGGGHTS: Binding = Binding::NONE;

    /// What the user should know about a type pair that is allowed but asks for trouble.
    fn remarks(_: &Pair<'_>) -> Vec<String> {
        Vec::new()
    }
    /// The surfaces overlap. The hot function, for as many contacts as the lane is wide; `call` is the same for all.
    fn intersect<L: Lane>(
        p: &<Self::Params as Lanes>::Of<L>,
        call: &Call,
        x: &Surface<L>,
        h: &mut <Self::History as Lanes>::Of<L>,
        s: &mut Response<L>,
    );
    /// What a study wants to know of the contact, before `intersect` is called on it.
    fn observe(p: &Self::Params, x: &Contact, h: &Self::History) -> Observation;
}

/// A law that acts across a gap too, one contact at a time.
pub trait GapLaw: 'static {
    /// What the law says of itself.
    const META: Meta;
    /// How it stands in LIGGGHTS; a law of another crate needs none.
    const LIGGGHTS: Binding = Binding::NONE;
    /// What a pair of atom types decides.
    type Coeffs: Copy + Send;
    /// What remains once radii and masses are known; reused as long as they stay the same.
    type Params: Copy + Send;
    /// Contact history: a plain struct of as many `f64` as `META.slots`, or `[f64]` where settings decide which are kept.
    type History: Memory + ?Sized;

    /// As [`Parameters::coeffs`].
    ///
    /// # Errors
    /// Combinations that make no sense.
    fn coeffs(pair: &Pair<'_>) -> Result<Self::Coeffs, LawError>;
    /// As [`Law::remarks`].
    fn remarks(_: &Pair<'_>) -> Vec<String> {
        Vec::new()
    }
    /// How far the law acts \[m\], from centre to centre or from a centre to a wall.
    fn reach(c: &Self::Coeffs, is_wall: bool) -> f64;
    /// As [`Parameters::new`].
    fn params(c: &Self::Coeffs, size: &Size) -> Self::Params;
    /// Two bodies near each other, whether or not surfaces overlap.
    fn interact(p: &Self::Params, x: &ClosePair, h: &mut Self::History, s: &mut Response, e: &mut Effects);
    /// The modes of two bodies under the law, each at its largest stiffness; they limit the time step. `speed` is how fast
    /// the bodies move against each other \[m/s\].
    fn modes(p: &Self::Params, size: &Size, speed: f64) -> Vec<NamedMode>;
    /// What a study wants to know of the contact, before `act` is called on it.
    fn observe(p: &Self::Params, x: &ClosePair, h: &Self::History) -> Observation;
}
