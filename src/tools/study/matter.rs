//! Laws with their numbers, written once, from which both a chain for our own integrations and the lines of a deck are made.
use granlaw::chain::Chain;
use granlaw::laws::find;
use granlaw::model::{Entry, Kind, LawError, Settings, Setup, Shape, Support, Values};

/// Laws with the property values and settings that a deck would give them, for one material.
#[derive(Clone, Debug, Default)]
pub struct Matter {
    /// Kinds and names, in the order in which they run.
    pub laws: Vec<(Kind, &'static str)>,
    /// Property values by name.
    pub values: Vec<(&'static str, f64)>,
    /// Settings with their options.
    pub settings: Vec<(&'static str, &'static str)>,
}

/// The names under which a deck asks for laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// LIGGGHTS's own names.
    Stock,
    /// Ours, ending in `/rs`.
    Own,
}

impl Matter {
    /// The same with another value of a property.
    pub fn with(mut self, name: &'static str, value: f64) -> Matter {
        self.values.retain(|(n, _)| *n != name);
        self.values.push((name, value));
        self
    }

    /// The same with another option of a setting.
    pub fn set(mut self, name: &'static str, option: &'static str) -> Matter {
        self.settings.retain(|(n, _)| *n != name);
        self.settings.push((name, option));
        self
    }

    /// The same with `centredDamping` and `touchFraction` on.
    pub fn timed(self) -> Matter {
        self.set("centredDamping", "on").set("touchFraction", "on")
    }

    /// The value of a property, if it is given.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|(n, _)| *n == name).map(|(_, v)| *v)
    }

    fn entries(&self) -> impl Iterator<Item = &'static Entry> + '_ {
        self.laws.iter().map(|(kind, name)| find(*kind, name).expect("a law of LAWS"))
    }

    /// The set-ups from which the laws are made.
    ///
    /// # Errors
    /// A setting or option that a law does not have.
    pub fn setups(&self) -> Result<Vec<Setup>, LawError> {
        let one = |law: &'static Entry| {
            let meta = law.meta;
            let mut settings = Settings::new(law, false);
            for (name, option) in &self.settings {
                if law.settings().any(|s| s.name == *name) {
                    settings.set(name, option)?;
                }
            }
            let of = meta.props.iter().map(|p| self.value(p.name).into_iter().collect()).collect();
            Ok(Setup { law, settings, values: Values { types: 1, of }, nktv2p: 1.0 })
        };
        self.entries().map(one).collect()
    }

    /// The laws, prepared.
    ///
    /// # Errors
    /// A law refuses a value.
    pub fn chain(&self) -> Result<Chain, LawError> {
        Chain::packed(&self.setups()?)
    }

    /// The lines of a deck that give the properties.
    pub fn properties(&self) -> String {
        let mut seen: Vec<&str> = Vec::new();
        let mut out = String::new();
        for p in self.entries().flat_map(|e| e.meta.props) {
            let Some(value) = self.value(p.name).filter(|_| !seen.contains(&p.name)) else { continue };
            seen.push(p.name);
            let count = if p.shape == Shape::PerPair { "1 " } else { "" };
            let (name, shape, k) = (p.name, p.shape.keyword(), seen.len());
            out += &format!("fix p{k} all property/global {name} {shape} {count}{value:?}\n");
        }
        out
    }

    /// Whether LIGGGHTS alone cannot run this, because it lacks a law or a setting.
    pub fn needs_ours(&self) -> bool {
        let ours = |name: &str| self.entries().any(|e| e.support(name) == Support::OwnOnly);
        self.entries().any(|e| e.liggghts.stock_id.is_none())
            || self.settings.iter().any(|(name, _)| ours(name))
    }

    /// The words of `pair_style gran` or `fix wall/gran` that choose the laws.
    pub fn models(&self, names: Names) -> String {
        let one = |(kind, name): &(Kind, &str)| {
            let own = names == Names::Own || find(*kind, name).is_some_and(|e| e.liggghts.stock_id.is_none());
            format!("{} {name}{}", kind.keyword(), if own { "/rs" } else { "" })
        };
        self.laws.iter().map(one).collect::<Vec<_>>().join(" ")
    }

    /// The settings as words of a deck, which come after all models. Settings that only our laws have need our names.
    pub fn switches(&self, names: Names) -> String {
        let known = |name: &str| {
            let has = |e: &Entry| e.settings().any(|s| s.name == name);
            self.entries().any(|e| has(e) && (names == Names::Own || e.support(name) != Support::OwnOnly))
        };
        let given = self.settings.iter().filter(|(name, _)| known(name));
        given.map(|(name, option)| format!(" {name} {option}")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deck_says_what_the_chain_is_made_of() {
        let matter = Matter {
            laws: vec![(Kind::Normal, "hooke"), (Kind::Tangential, "history")],
            values: vec![("youngsModulus", 5e6), ("coefficientFriction", 0.5)],
            settings: vec![("tangential_damping", "off")],
        };
        let lines = "fix p1 all property/global youngsModulus peratomtype 5000000.0\n\
                     fix p2 all property/global coefficientFriction peratomtypepair 1 0.5\n";
        assert_eq!(matter.properties(), lines);
        assert_eq!(matter.models(Names::Stock), "model hooke tangential history");
        assert_eq!(matter.switches(Names::Stock), " tangential_damping off");
        let timed = matter.clone().timed();
        assert_eq!(timed.models(Names::Own), "model hooke/rs tangential history/rs");
        assert_eq!(timed.switches(Names::Own), " tangential_damping off centredDamping on touchFraction on");
        assert_eq!(timed.switches(Names::Stock), " tangential_damping off");
        assert!(timed.needs_ours() && !matter.needs_ours());
        assert!(timed.chain().is_err(), "values are missing");
    }
}
