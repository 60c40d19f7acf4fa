//! The settings of a law: what it declares, and what a deck chose.
use super::{Binding, LawError, Meta, Need, Setting, Support};

/// What a law declares: of itself, and of how it stands in LIGGGHTS.
#[derive(Clone, Copy, Debug)]
pub struct Declaration {
    /// What the law says of itself.
    pub meta: &'static Meta,
    /// How it stands in LIGGGHTS.
    pub liggghts: &'static Binding,
}

impl Declaration {
    /// Every setting that LIGGGHTS may hand over: the law's own, then those that are refused.
    pub fn settings(&self) -> impl Iterator<Item = &'static Setting> + Clone {
        self.meta.settings.iter().chain(self.liggghts.refused)
    }

    /// How far LIGGGHTS's name and ours share a setting of [`Declaration::settings`].
    pub fn support(&self, setting: &str) -> Support {
        let Binding { own_settings, ignored, refused, .. } = self.liggghts;
        match () {
            _ if own_settings.contains(&setting) => Support::OwnOnly,
            _ if ignored.contains(&setting) => Support::StockIgnores,
            _ if refused.iter().any(|s| s.name == setting) => Support::Refused,
            _ => Support::Full,
        }
    }
}

/// The options chosen for one law.
#[derive(Clone, Debug)]
pub struct Settings {
    law: Declaration,
    /// By the order of [`Declaration::settings`].
    picked: Vec<Option<usize>>,
    taken_over: bool,
}

impl Settings {
    /// Every setting at its default. `taken_over`: the law stands in for LIGGGHTS's own of the same name.
    pub fn new(law: impl Into<Declaration>, taken_over: bool) -> Settings {
        let law = law.into();
        let picked = law.settings().map(|s| s.default.and_then(|d| s.index(d))).collect();
        Settings { law, picked, taken_over }
    }

    /// The name of the law in messages.
    pub(super) fn called(&self) -> String {
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

    /// The settings with the options that the deck chose, in the order of [`Declaration::settings`].
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
