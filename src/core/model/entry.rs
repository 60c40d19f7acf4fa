//! A row of the registry, and what a law is made from: property values and settings in, coefficients or a refusal out.
//! Nothing is refused later.
use super::kernel::{across, single};
use super::{
    Binding, Declaration, GapLaw, Kernel, Law, LawError, Memory, Meta, Parameters, Range, Reach, Setting,
    Settings, Shape, Slot, Slots, Support,
};
use std::fmt::Debug;

/// What is made of every law over lanes: kernels of a certain width, tests.
pub trait ForLanes: Copy + Debug + 'static {
    /// What comes out.
    type Made: Copy + Debug + 'static;
    /// Make it for one law.
    fn make<W: Law>() -> Self::Made;
}

/// Where nothing is made of lanes: a law as it stands.
#[derive(Clone, Copy, Debug)]
pub struct Alone;

impl ForLanes for Alone {
    type Made = ();
    fn make<W: Law>() {}
}

type Prepare = fn(&Setup, &[usize]) -> Result<Box<dyn Kernel>, LawError>;

/// One form of a law.
#[derive(Clone, Copy, Debug)]
struct Form<U: ForLanes> {
    prepare: Prepare,
    lanes: Option<fn() -> U::Made>,
}

/// A form that stands in for the law at an option of a setting, where its parameters are others.
#[derive(Clone, Copy, Debug)]
struct Variant<U: ForLanes> {
    setting: &'static str,
    option: &'static str,
    form: Form<U>,
}

/// A row of the registry.
#[derive(Clone, Copy, Debug)]
pub struct Entry<U: ForLanes = Alone> {
    /// What the law says of itself.
    pub meta: &'static Meta,
    /// How it stands in LIGGGHTS.
    pub liggghts: &'static Binding,
    form: Form<U>,
    variant: Option<Variant<U>>,
}

impl<U: ForLanes> From<&Entry<U>> for Declaration {
    fn from(e: &Entry<U>) -> Declaration {
        e.declaration()
    }
}

impl<U: ForLanes> Entry<U> {
    /// The row of a law over lanes.
    pub const fn law<W: Law>() -> Entry<U> {
        assert!(<W::History as Slots>::LEN == W::META.slots.len(), "History and slots differ in length");
        assert!(matches!(W::META.reach, Reach::Overlap), "a law that acts across a gap is a GapLaw");
        Entry { meta: &W::META, liggghts: &W::LIGGGHTS, form: Form::<U>::law::<W>(), variant: None }
    }

    /// The same law with parameters of another type at an option of one of its settings.
    pub const fn or_with<W: Law>(self, setting: &'static str, option: &'static str) -> Entry<U> {
        Entry { variant: Some(Variant { setting, option, form: Form::<U>::law::<W>() }), ..self }
    }

    /// The row of a law that acts across a gap.
    pub const fn gap_law<W: GapLaw>() -> Entry<U> {
        match <W::History as Memory>::SLOTS {
            Some(n) => assert!(n == W::META.slots.len(), "History and slots differ in length"),
            None => assert!(
                W::LIGGGHTS.stock_id.is_none(),
                "a stock law's history is the same under all settings"
            ),
        }
        assert!(matches!(W::META.reach, Reach::Beyond), "a law that acts while surfaces overlap is a Law");
        let form = Form { prepare: prepare_across::<W>, lanes: None };
        Entry { meta: &W::META, liggghts: &W::LIGGGHTS, form, variant: None }
    }

    /// Check the set-up and prepare the law for all pairs of atom types; `places` says where each slot that the settings
    /// call for lies in a row of history.
    ///
    /// # Errors
    /// The first thing that the law refuses.
    pub fn prepare(&self, setup: &Setup, places: &[usize]) -> Result<Box<dyn Kernel>, LawError> {
        (self.form_for(setup).prepare)(setup, places)
    }

    /// What `U` makes of the law as it is set up; nothing of one without lanes.
    pub fn make(&self, setup: &Setup) -> Option<U::Made> {
        self.form_for(setup).lanes.map(|make| make())
    }

    /// What the law declares.
    pub fn declaration(&self) -> Declaration {
        Declaration { meta: self.meta, liggghts: self.liggghts }
    }

    /// See [`Declaration::settings`].
    pub fn settings(&self) -> impl Iterator<Item = &'static Setting> + Clone {
        self.declaration().settings()
    }

    /// See [`Declaration::support`].
    pub fn support(&self, setting: &str) -> Support {
        self.declaration().support(setting)
    }

    fn form_for(&self, setup: &Setup) -> &Form<U> {
        match &self.variant {
            Some(v) if setup.settings.option(v.setting) == v.option => &v.form,
            _ => &self.form,
        }
    }
}

impl<U: ForLanes> Form<U> {
    const fn law<W: Law>() -> Form<U> {
        Form { prepare: prepare_single::<W>, lanes: Some(U::make::<W>) }
    }
}

fn prepare_single<W: Law>(setup: &Setup, places: &[usize]) -> Result<Box<dyn Kernel>, LawError> {
    let coeffs = setup.mixed(W::Params::coeffs)?;
    Ok(single::<W>(coeffs, setup.remarks(W::remarks), setup.placed(places)))
}

fn prepare_across<W: GapLaw>(setup: &Setup, places: &[usize]) -> Result<Box<dyn Kernel>, LawError> {
    let coeffs = setup.mixed(W::coeffs)?;
    let begin = places.first().copied().unwrap_or(0);
    let slots = begin..begin + places.len();
    if !places.iter().copied().eq(slots.clone()) {
        let what = "the slots of its history must lie behind each other in a row".into();
        return Err(LawError::Senseless { law: W::META.called(false), what });
    }
    Ok(across::<W>(coeffs, setup.remarks(W::remarks), slots))
}

/// The property values of one law: `of[k]` belongs to `META.props[k]`, row by row for a type pair, empty where the
/// settings do not call for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Number of atom types.
    pub types: usize,
    /// The values.
    pub of: Vec<Vec<f64>>,
}

/// What one law is made from.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The law.
    pub law: &'static Entry,
    /// The options chosen.
    pub settings: Settings,
    /// The property values.
    pub values: Values,
    /// LIGGGHTS's conversion from pressure to force per area in the deck's units; 1 in SI.
    pub nktv2p: f64,
}

impl Setup {
    /// Check settings and values against the law's own description.
    pub fn check(&self) -> Result<(), LawError> {
        self.settings.check()?;
        for (k, prop) in self.law.meta.props.iter().enumerate().filter(|(_, p)| self.settings.need(p.need)) {
            let law = self.settings.called();
            let (name, shape) = (prop.name, prop.shape.keyword());
            let values = self.values.of.get(k).map_or(&[][..], |v| v);
            let expected = prop.shape.len(self.values.types);
            if values.is_empty() {
                return Err(LawError::Missing { law, name, shape });
            }
            if values.len() != expected {
                let (got, types) = (values.len(), self.values.types);
                return Err(LawError::Count { law, name, shape, got, expected, types });
            }
            if let Some(at) = values.iter().position(|v| !prop.range.contains(*v)) {
                let types = types_of(prop.shape, at, self.values.types);
                return Err(LawError::OutOfRange { law, name, value: values[at], types, range: prop.range });
            }
        }
        Ok(())
    }

    /// The slots of history that the settings call for, in the order in which they lie in memory.
    pub fn slots(&self) -> impl Iterator<Item = &'static Slot> + '_ {
        self.law.meta.slots.iter().filter(|s| self.settings.need(s.need))
    }

    /// Check the set-up and mix the coefficients of all pairs of atom types; `i * types + j` is the place of i and j.
    ///
    /// # Errors
    /// The first thing that the law refuses.
    pub fn mixed<C>(&self, mix: fn(&Pair<'_>) -> Result<C, LawError>) -> Result<Vec<C>, LawError> {
        self.check()?;
        self.pairs().map(|p| mix(&p)).collect()
    }

    /// The remarks on all pairs of atom types.
    fn remarks(&self, of: fn(&Pair<'_>) -> Vec<String>) -> Vec<String> {
        self.pairs().flat_map(|p| of(&p)).collect()
    }

    /// Where each slot of the law lies in a row, from the places of those that the settings call for.
    pub fn placed(&self, places: &[usize]) -> Vec<Option<usize>> {
        let mut next = places.iter().copied();
        let of = |s: &Slot| self.settings.need(s.need).then(|| next.next().expect("a place for every slot"));
        self.law.meta.slots.iter().map(of).collect()
    }

    fn pairs(&self) -> impl Iterator<Item = Pair<'_>> {
        let n = self.values.types;
        (0..n * n).map(move |p| self.pair(p / n, p % n))
    }

    /// The view of one pair of atom types, counted from 0.
    pub fn pair(&self, i: usize, j: usize) -> Pair<'_> {
        Pair { setup: self, i, j }
    }
}

fn types_of(shape: Shape, at: usize, types: usize) -> String {
    match shape {
        Shape::Scalar => String::new(),
        Shape::PerType => format!(" (type {})", at + 1),
        Shape::PerPair => format!(" (types {}-{})", at / types + 1, at % types + 1),
    }
}

/// The property values of one pair of atom types.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    setup: &'a Setup,
    i: usize,
    j: usize,
}

impl Pair<'_> {
    /// A scalar or per-type-pair property.
    ///
    /// # Panics
    /// If the law does not declare it or the settings do not call for it; a bug of the law.
    pub fn get(&self, name: &str) -> f64 {
        self.both(name).0
    }

    /// A per-type property of i and of j; both the same for the other shapes.
    ///
    /// # Panics
    /// As [`Pair::get`].
    pub fn both(&self, name: &str) -> (f64, f64) {
        let k =
            self.setup.law.meta.props.iter().position(|p| p.name == name).expect("a property of this law");
        let (v, n) = (&self.setup.values.of[k], self.setup.values.types);
        match self.setup.law.meta.props[k].shape {
            Shape::Scalar => (v[0], v[0]),
            Shape::PerType => (v[self.i], v[self.j]),
            Shape::PerPair => (v[self.i * n + self.j], v[self.i * n + self.j]),
        }
    }

    /// Whether a switch is on.
    pub fn on(&self, name: &str) -> bool {
        self.setup.settings.on(name)
    }

    /// The option of a setting.
    pub fn option(&self, name: &str) -> &'static str {
        self.setup.settings.option(name)
    }

    /// LIGGGHTS's conversion from pressure to force per area; 1 in SI.
    pub fn nktv2p(&self) -> f64 {
        self.setup.nktv2p
    }

    /// A refusal of an option that makes no sense with the rest.
    pub fn refuse_option(&self, setting: &'static str, option: &'static str, why: &'static str) -> LawError {
        LawError::Refused { law: self.law(), setting, option, why }
    }

    /// A refusal of a value that the ranges alone cannot rule out.
    pub fn refuse(&self, name: &'static str, value: f64, range: Range) -> LawError {
        LawError::OutOfRange { law: self.law(), name, value, types: self.types(), range }
    }

    /// A refusal of things that make no sense together; `what` says what, why, and what to do.
    pub fn senseless(&self, what: impl Into<String>) -> LawError {
        LawError::Senseless { law: self.law(), what: what.into() }
    }

    /// The types, ready for a message.
    pub fn types(&self) -> String {
        format!(" (types {}-{})", self.i + 1, self.j + 1)
    }

    /// The name of the law in messages.
    pub fn law(&self) -> String {
        self.setup.settings.called()
    }
}
