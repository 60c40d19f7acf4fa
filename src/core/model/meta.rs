//! What a law says of itself; the plugin, the command line, the reports and the universal tests read only this.
use super::{Range, Unit};

/// The four kinds of law, in the order in which LIGGGHTS runs them over a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Normal force; also hands on the stiffnesses and dampings.
    Normal,
    /// Cohesion and bonds.
    Cohesion,
    /// Tangential force (friction).
    Tangential,
    /// Rolling resistance.
    Rolling,
}

impl Kind {
    /// All kinds in LIGGGHTS's order.
    pub const ALL: [Kind; 4] = [Kind::Normal, Kind::Cohesion, Kind::Tangential, Kind::Rolling];

    /// The word that selects a law of this kind in a deck.
    pub fn keyword(self) -> &'static str {
        match self {
            Kind::Normal => "model",
            Kind::Cohesion => "cohesion",
            Kind::Tangential => "tangential",
            Kind::Rolling => "rolling_friction",
        }
    }

    /// The word for people.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Normal => "normal",
            Kind::Cohesion => "cohesion",
            Kind::Tangential => "tangential",
            Kind::Rolling => "rolling",
        }
    }
}

/// For how many types a property is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// One number per atom type.
    PerType,
    /// One number per pair of atom types.
    PerPair,
}

impl Shape {
    /// The word in `fix property/global`.
    pub fn keyword(self) -> &'static str {
        match self {
            Shape::Scalar => "scalar",
            Shape::PerType => "peratomtype",
            Shape::PerPair => "peratomtypepair",
        }
    }
    /// How many numbers that is for `n` types.
    pub fn len(self, n: usize) -> usize {
        match self {
            Shape::Scalar => 1,
            Shape::PerType => n,
            Shape::PerPair => n * n,
        }
    }
}

/// When a property must be given, or a slot of history is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// Always.
    Always,
    /// Only when this setting is at this option.
    When(&'static str, &'static str),
    /// Unless this setting is at this option.
    Unless(&'static str, &'static str),
    /// Only when all these settings are at these options.
    All(&'static [(&'static str, &'static str)]),
    /// Unless all these settings are at these options.
    NotAll(&'static [(&'static str, &'static str)]),
}

/// A material property.
#[derive(Clone, Copy, Debug)]
pub struct Prop {
    /// The name in `fix property/global`.
    pub name: &'static str,
    /// The usual symbol.
    pub symbol: &'static str,
    /// For how many types it is given.
    pub shape: Shape,
    /// Its unit.
    pub unit: Unit,
    /// The values that are allowed.
    pub range: Range,
    /// The values that people use; for tables and for tests, never a reason to refuse.
    pub usual: (f64, f64),
    /// When it must be given.
    pub need: Need,
    /// What it is.
    pub doc: &'static str,
}

impl Prop {
    /// A property that must always be given; `usual` and `need` may be written out behind it.
    pub const fn new(
        name: &'static str,
        symbol: &'static str,
        shape: Shape,
        unit: Unit,
        range: Range,
        doc: &'static str,
    ) -> Prop {
        Prop { name, symbol, shape, unit, range, usual: (0.0, 1.0), need: Need::Always, doc }
    }
    /// The same, asked for only then.
    pub const fn needed(self, need: Need) -> Prop {
        Prop { need, ..self }
    }
    /// The same with the values that people use.
    pub const fn usually(self, lo: f64, hi: f64) -> Prop {
        Prop { usual: (lo, hi), ..self }
    }
}

/// A setting: a word in the deck followed by one of its options.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The word.
    pub name: &'static str,
    /// The options; the first is what `off` would be.
    pub options: &'static [&'static str],
    /// The option that holds when the deck says nothing; `None` where the deck must choose.
    pub default: Option<&'static str>,
    /// What it does, or why it is refused.
    pub doc: &'static str,
}

impl Setting {
    /// A switch that is off unless the deck says otherwise.
    pub const fn off(name: &'static str, doc: &'static str) -> Setting {
        Setting { name, options: &["off", "on"], default: Some("off"), doc }
    }
    /// A switch that is on unless the deck says otherwise.
    pub const fn on(name: &'static str, doc: &'static str) -> Setting {
        Setting { name, options: &["off", "on"], default: Some("on"), doc }
    }
    /// The index of an option.
    pub fn index(&self, option: &str) -> Option<usize> {
        self.options.iter().position(|o| *o == option)
    }
}

/// What happens to a history slot when i and j change places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Newton {
    /// It stays (LIGGGHTS's newton flag 0).
    Even,
    /// It changes sign (newton flag 1).
    Odd,
}

/// One number of contact history.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// The name under which LIGGGHTS keeps it.
    pub name: &'static str,
    /// What a swap of i and j does to it.
    pub newton: Newton,
    /// Its unit.
    pub unit: Unit,
    /// When there is room for it in a row of history.
    pub need: Need,
}

impl Slot {
    /// A number that is always kept and stays when i and j change places.
    pub const fn even(name: &'static str, unit: Unit) -> Slot {
        Slot { name, newton: Newton::Even, unit, need: Need::Always }
    }
    /// A number that is always kept and changes sign when i and j change places.
    pub const fn odd(name: &'static str, unit: Unit) -> Slot {
        Slot { name, newton: Newton::Odd, unit, need: Need::Always }
    }
}

/// A number per atom, kept by a `fix property/atom` of the deck.
#[derive(Clone, Copy, Debug)]
pub struct AtomProp {
    /// The name in `fix property/atom`.
    pub name: &'static str,
    /// Where it stands in [`Body::given`](super::Body::given), or in [`Effects::outputs`](super::Effects::outputs).
    pub place: usize,
    /// What it is.
    pub doc: &'static str,
}

/// A number that a normal law hands to the laws behind it, beyond the stiffnesses and dampings that all of them hand on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Adhesion stiffness kc \[N/m\], in [`Response::kc`](super::Response::kc).
    Kc,
    /// Normal force without adhesion and damping f0 \[N\], in [`Response::fo`](super::Response::fo).
    Fo,
}

impl Channel {
    /// The name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Kc => "kc",
            Channel::Fo => "fo",
        }
    }
}

/// How far a law acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// Only while surfaces overlap.
    Overlap,
    /// Also across a gap.
    Beyond,
}

/// The universal rules that a law may break if it says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// History is written only when LIGGGHTS says so.
    QueryLeavesHistory,
    /// i and j change places, and the answer with them.
    PartnersSwap,
    /// Forces and torques of a pair leave its angular momentum as it is.
    AngularMomentum,
    /// Turning the whole picture turns the answer.
    FrameTurns,
    /// Another metre, kilogram or second changes the numbers by the powers of their units.
    UnitsScale,
    /// Separation clears the history.
    ApartClearsHistory,
    /// No force jumps while the inputs change continuously.
    Continuous,
    /// A closed cycle returns no more energy than it took.
    CycleDissipates,
    /// Reversing the approach speed changes the sign of the damping force only.
    DampingOdd,
}

/// A rule that the law breaks, and why.
#[derive(Clone, Copy, Debug)]
pub struct Exception {
    /// The rule.
    pub rule: Rule,
    /// Where, and why it stays so.
    pub why: &'static str,
}

/// Everything that a law says of itself. How it stands in LIGGGHTS is said apart, in its [`Binding`](super::Binding).
#[derive(Clone, Copy, Debug)]
pub struct Meta {
    /// Its kind.
    pub kind: Kind,
    /// Its name; in a LIGGGHTS deck our law is `<keyword>/rs`.
    pub keyword: &'static str,
    /// One line for people.
    pub summary: &'static str,
    /// The properties, in the order in which values are handed over.
    pub props: &'static [Prop],
    /// The settings, in the order in which options are handed over.
    pub settings: &'static [Setting],
    /// What it reads of each atom where the deck gives it.
    pub atoms: &'static [AtomProp],
    /// What it adds to each atom in every evaluation.
    pub outputs: &'static [AtomProp],
    /// The history, in the order in which the law has it; slots that the settings do not call for take no room.
    pub slots: &'static [Slot],
    /// What it hands to the laws behind it.
    pub publishes: &'static [Channel],
    /// What a law before it must hand on.
    pub reads: &'static [Channel],
    /// Exponent n of F ∝ δⁿ of a normal law; 0 for the others.
    pub stress_strain_exponent: f64,
    /// How far it acts.
    pub reach: Reach,
    /// Whether it holds particles to a point of a wall, which may then move but not turn.
    pub anchors: bool,
    /// What it calls the bonds that it keeps, in the plural, if it keeps any that users may count.
    pub bonds: Option<&'static str>,
    /// Whether it gives the same answer for coarse-grained particles.
    pub coarse_graining: bool,
    /// Where it comes from.
    pub references: &'static [&'static str],
    /// The universal rules that it breaks.
    pub exceptions: &'static [Exception],
}

impl Meta {
    /// A law that asks for nothing and keeps nothing; what is different is written out behind it.
    pub const fn new(kind: Kind, keyword: &'static str, summary: &'static str) -> Meta {
        Meta {
            kind,
            keyword,
            summary,
            props: &[],
            settings: &[],
            atoms: &[],
            outputs: &[],
            slots: &[],
            publishes: &[],
            reads: &[],
            stress_strain_exponent: 0.0,
            reach: Reach::Overlap,
            anchors: false,
            bonds: None,
            coarse_graining: false,
            references: &[],
            exceptions: &[],
        }
    }
    /// The exception to a rule, if there is one.
    pub fn exception(&self, rule: Rule) -> Option<&'static Exception> {
        self.exceptions.iter().find(|e| e.rule == rule)
    }
    /// The name in messages: with `/rs` unless it stands in for the stock law.
    pub fn called(&self, taken_over: bool) -> String {
        if taken_over {
            self.keyword.to_string()
        } else {
            format!("{}/rs", self.keyword)
        }
    }
}
