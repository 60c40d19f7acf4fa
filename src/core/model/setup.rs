//! Set-up: property values and settings in, coefficients or a refusal out. Nothing is refused later.
use super::meta::{Need, Range, Setting, Shape, Slot};
use super::{Entry, Support};
use thiserror::Error;

/// Why a law refused its set-up. Each message says what, which, allowed and what to do.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum LawError {
    /// A property that the law needs was not given.
    #[error(
        "{law}: property {name} was not given; set it with fix ID all property/global {name} {shape} ..."
    )]
    Missing {
        /// The law.
        law: String,
        /// The property.
        name: &'static str,
        /// Its shape in `fix property/global`.
        shape: &'static str,
    },
    /// The wrong number of values.
    #[error("{law}: property {name} has {got} values where {expected} are needed for {types} atom types; set it with fix ID all property/global {name} {shape} ...")]
    Count {
        /// The law.
        law: String,
        /// The property.
        name: &'static str,
        /// Its shape in `fix property/global`.
        shape: &'static str,
        /// How many came.
        got: usize,
        /// How many should have.
        expected: usize,
        /// Number of atom types.
        types: usize,
    },
    /// A value that makes no sense.
    #[error("{law}: {name} = {value}{types} must be {range}; change it in fix property/global {name}")]
    OutOfRange {
        /// The law.
        law: String,
        /// The property.
        name: &'static str,
        /// The value.
        value: f64,
        /// The types it was given for, ready for the message.
        types: String,
        /// What is allowed.
        range: Range,
    },
    /// A setting that LIGGGHTS knows and this law does not do.
    #[error(
        "{law}: setting {setting} {option} is not supported ({why}); switch it off or use a law that does it"
    )]
    Refused {
        /// The law.
        law: String,
        /// The setting.
        setting: &'static str,
        /// The option that was chosen.
        option: &'static str,
        /// Why.
        why: &'static str,
    },
    /// A setting without a default that the deck does not give.
    #[error("{law}: setting {setting} must be given, one of {options}: {doc}")]
    NotChosen {
        /// The law.
        law: String,
        /// The setting.
        setting: &'static str,
        /// Its options.
        options: String,
        /// What they mean.
        doc: &'static str,
    },
    /// A setting or option that does not exist.
    #[error("{law}: {what}")]
    Unknown {
        /// The law.
        law: String,
        /// What is unknown, and what is known.
        what: String,
    },
    /// Things that are allowed each by itself and make no sense together.
    #[error("{law}: {what}")]
    Senseless {
        /// The law.
        law: String,
        /// What, why, and what to do.
        what: String,
    },
}

/// The options chosen for one law.
#[derive(Clone, Debug)]
pub struct Settings {
    law: &'static Entry,
    /// By the order of [`Entry::settings`].
    picked: Vec<Option<usize>>,
    taken_over: bool,
}

impl Settings {
    /// Every setting at its default. `taken_over`: the law stands in for LIGGGHTS's own of the same name.
    pub fn new(law: &'static Entry, taken_over: bool) -> Settings {
        let picked = law.settings().map(|s| s.default.and_then(|d| s.index(d))).collect();
        Settings { law, picked, taken_over }
    }

    /// The name of the law in messages.
    fn called(&self) -> String {
        self.law.meta.called(self.taken_over)
    }

    fn find(&self, name: &str) -> Option<(usize, &'static Setting)> {
        self.law.settings().enumerate().find(|(_, s)| s.name == name)
    }

    /// Choose an option by name.
    ///
    /// # Errors
    /// There is no such setting or option.
    pub fn set(&mut self, name: &str, option: &str) -> Result<(), LawError> {
        let unknown = |what| LawError::Unknown { law: self.called(), what };
        let Some((k, setting)) = self.find(name) else {
            let known: Vec<_> = self.law.settings().map(|s| s.name).collect();
            return Err(unknown(format!("no setting {name}; known: {}", known.join(", "))));
        };
        let Some(index) = setting.index(option) else {
            return Err(unknown(format!(
                "setting {name} {option}: must be one of {}",
                setting.options.join(", ")
            )));
        };
        self.picked[k] = Some(index);
        Ok(())
    }

    /// The option in force: what the deck chose, except where the stock law would ignore it.
    ///
    /// # Panics
    /// If the law has no setting of that name or its option was never chosen; both are bugs that set-up rules out.
    pub fn option(&self, name: &str) -> &'static str {
        let (k, s) = self.find(name).expect("a setting of this law");
        let ignored = self.taken_over && self.law.support(name) == Support::StockIgnores;
        s.options[if ignored { 0 } else { self.picked[k].expect("checked at set-up") }]
    }

    /// Whether a switch is on.
    pub fn on(&self, name: &str) -> bool {
        self.option(name) == "on"
    }

    /// Whether the law stands in for LIGGGHTS's own of the same name.
    pub fn taken_over(&self) -> bool {
        self.taken_over
    }

    /// The settings with the options that the deck chose, in the order of [`Entry::settings`].
    pub fn chosen(&self) -> impl Iterator<Item = (&'static str, &'static str)> + '_ {
        self.law.settings().zip(&self.picked).filter_map(|(s, p)| p.map(|k| (s.name, s.options[k])))
    }

    /// Whether every setting has an option, and one that the law does.
    ///
    /// # Errors
    /// The first setting that is refused or was not chosen.
    pub fn check(&self) -> Result<(), LawError> {
        for (s, p) in self.law.settings().zip(&self.picked) {
            match p {
                None => {
                    return Err(LawError::NotChosen {
                        law: self.called(),
                        setting: s.name,
                        options: s.options.join(", "),
                        doc: s.doc,
                    })
                }
                Some(k) if self.law.support(s.name) == Support::Refused && *k != 0 => {
                    return Err(LawError::Refused {
                        law: self.called(),
                        setting: s.name,
                        option: s.options[*k],
                        why: s.doc,
                    })
                }
                Some(_) => {}
            }
        }
        Ok(())
    }

    /// Whether these settings call for a property or a slot. A setting without a default that the deck has not chosen counts
    /// as being at none of its options.
    pub fn need(&self, need: Need) -> bool {
        let is = |name: &str, option: &str| {
            let (k, _) = self.find(name).expect("a setting of this law");
            self.picked[k].is_some() && self.option(name) == option
        };
        match need {
            Need::Always => true,
            Need::When(name, option) => is(name, option),
            Need::Unless(name, option) => !is(name, option),
            Need::All(these) => these.iter().all(|(name, option)| is(name, option)),
            Need::NotAll(these) => !these.iter().all(|(name, option)| is(name, option)),
        }
    }
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
    pub(super) fn all_remarks(&self, of: fn(&Pair<'_>) -> Vec<String>) -> Vec<String> {
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
