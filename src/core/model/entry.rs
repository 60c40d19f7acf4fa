//! A row of the registry: a law with its types erased.
use super::kernel::{across, single};
use super::{Binding, GapLaw, Kernel, Law, LawError, Memory, Meta, Reach, Setting, Setup, Slots, Support};
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
        let form = Form { prepare: across::<W>, lanes: None };
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

    /// Every setting that LIGGGHTS may hand over: the law's own, then those that are refused.
    pub fn settings(&self) -> impl Iterator<Item = &'static Setting> + Clone {
        self.meta.settings.iter().chain(self.liggghts.refused)
    }

    /// How far LIGGGHTS's name and ours share a setting of [`Entry::settings`].
    pub fn support(&self, setting: &str) -> Support {
        let Binding { own_settings, ignored, refused, .. } = self.liggghts;
        match () {
            _ if own_settings.contains(&setting) => Support::OwnOnly,
            _ if ignored.contains(&setting) => Support::StockIgnores,
            _ if refused.iter().any(|s| s.name == setting) => Support::Refused,
            _ => Support::Full,
        }
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
        Form { prepare: single::<W>, lanes: Some(U::make::<W>) }
    }
}
