//! The head of a trace: where it comes from, and the laws with their coefficients.
use granlaw::chain::Chain;
use granlaw::laws::{find, LAWS};
use granlaw::model::{Body, Kind, LawError, Need, Settings, Setup, Slot, Values};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use thiserror::Error;

/// The head of a trace.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// Version of granlaw.
    pub granlaw: String,
    /// The version of LIGGGHTS, in its own words.
    pub liggghts: String,
    /// File name of the deck.
    pub deck: String,
    /// Fingerprint of the deck, with the name of the method, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deck_hash: Option<String>,
    /// The deck's `units`.
    pub units: String,
    /// `pair`, or `wall <fix id>`.
    pub who: String,
    /// Rank that wrote the trace.
    pub rank: usize,
    /// Number of ranks of the run.
    pub ranks: usize,
    /// One in this many steps was recorded.
    pub every: u64,
    /// Number of atom types.
    pub types: usize,
    /// LIGGGHTS's conversion from pressure to force per area; 1 in SI.
    pub nktv2p: f64,
    /// Time step \[s\].
    pub dt: f64,
    /// Remarks for people, for instance on columns that were not recorded but computed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The per-atom properties of the deck that a law reads, by their names in `fix property/atom`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub atoms: Vec<String>,
    /// All slots of a row of history, including those of laws that granlaw lacks.
    pub slots: Vec<String>,
    /// The laws of the chain, in the order in which they run.
    #[serde(default)]
    pub laws: Vec<LawSpec>,
    /// The particles at the start of the trace, if they are few.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub particles: Vec<Particle>,
}

/// A law of the chain as LIGGGHTS resolved it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawSpec {
    /// `normal`, `cohesion`, `tangential` or `rolling`.
    pub kind: String,
    /// The name in the deck, without `/rs`.
    pub keyword: String,
    /// Whether the deck uses LIGGGHTS's own name for it, without `/rs`.
    pub taken_over: bool,
    /// Whether granlaw has the law, so that settings and properties are complete.
    pub known: bool,
    /// Where its slots begin in a row of history.
    pub offset: usize,
    /// Every setting of the law with its option.
    #[serde(default)]
    pub settings: BTreeMap<String, String>,
    /// The properties that the law asked for.
    #[serde(default)]
    pub properties: Vec<Property>,
}

/// A property as it was given to LIGGGHTS.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Property {
    /// The name in `fix property/global`.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// `scalar`, `peratomtype` or `peratomtypepair`.
    pub shape: String,
    /// The values, row by row for a type pair.
    pub values: Vec<f64>,
}

/// A particle at the start of the trace.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Particle {
    /// Its number.
    pub tag: i64,
    /// Its atom type, from 0; in the file from 1.
    #[serde(rename = "type", with = "from_one")]
    pub kind: usize,
    /// Radius \[m\].
    pub radius: f64,
    /// Mass \[kg\].
    pub mass: f64,
    /// Position \[m\].
    #[serde(with = "triple")]
    pub x: Vector3<f64>,
    /// Velocity \[m/s\].
    #[serde(with = "triple")]
    pub v: Vector3<f64>,
    /// Spin \[rad/s\].
    #[serde(with = "triple")]
    pub omega: Vector3<f64>,
}

impl Particle {
    /// The particle without its type.
    pub fn body(&self) -> Body {
        let Particle { tag, radius, mass, x, v, omega, .. } = *self;
        Body { tag, radius, mass, x, v, omega, ..Body::default() }
    }
}

/// Why the Rust chain cannot be built from a header.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum HeaderError {
    /// Laws that granlaw does not have.
    #[error(
        "the trace has {missing}, which granlaw does not have; it has {known}. Replay is possible only for chains made of these"
    )]
    Lacks {
        /// The laws.
        missing: String,
        /// The laws that there are.
        known: String,
    },
    /// A law refuses its settings or properties.
    #[error(transparent)]
    Law(#[from] LawError),
    /// The header contradicts itself.
    #[error("{law}: {what}; record the trace again")]
    Wrong {
        /// The law.
        law: String,
        /// What is wrong.
        what: String,
    },
}

impl LawSpec {
    /// The kind, if the word is one.
    pub fn kind(&self) -> Option<Kind> {
        Kind::ALL.into_iter().find(|k| k.name() == self.kind)
    }

    fn wrong(&self, what: String) -> HeaderError {
        HeaderError::Wrong { law: format!("{} {}", self.kind, self.keyword), what }
    }

    fn setup(&self, types: usize, nktv2p: f64, slots: &[String]) -> Result<Setup, HeaderError> {
        let law = self.kind().and_then(|k| find(k, &self.keyword)).expect("laws are looked up first");
        let meta = law.meta;
        let mut settings = Settings::new(law, self.taken_over);
        for (name, option) in &self.settings {
            settings.set(name, option)?;
        }
        let mut of = vec![Vec::new(); meta.props.len()];
        for p in &self.properties {
            let Some(k) = meta.props.iter().position(|known| known.name == p.name) else {
                return Err(self.wrong(format!("the law has no property {}", p.name)));
            };
            if meta.props[k].shape.keyword() != p.shape {
                let shape = meta.props[k].shape.keyword();
                return Err(self.wrong(format!("property {} is {} and should be {shape}", p.name, p.shape)));
            }
            of[k].clone_from(&p.values);
        }
        let setup = Setup { law, settings, values: Values { types, of }, nktv2p };
        if self.places(&setup, slots).is_none() {
            let (at, names) = (self.offset, setup.slots().map(|s| s.name).collect::<Vec<_>>());
            return Err(
                self.wrong(format!("its history ({}) is not at slot {at} of {slots:?}", names.join(", ")))
            );
        }
        setup.check()?;
        Ok(setup)
    }

    /// Where the slots of the law lie in a row: one behind the other from `offset`; one that a setting adds to a stock law
    /// lies behind those of all laws.
    fn places(&self, setup: &Setup, slots: &[String]) -> Option<Vec<usize>> {
        let mut next = self.offset;
        let mut place = |s: &Slot| {
            if slots.get(next).is_some_and(|name| name == s.name) {
                next += 1;
                return Some(next - 1);
            }
            (s.need != Need::Always).then(|| slots.iter().position(|name| name == s.name)).flatten()
        };
        setup.slots().map(&mut place).collect()
    }
}

impl Header {
    /// The place of each of [`Header::atoms`] in [`Body::given`]; `None` for one that no law here reads.
    pub fn places(&self) -> impl Iterator<Item = Option<usize>> + '_ {
        let known = || LAWS.iter().flat_map(|e| e.meta.atoms);
        self.atoms.iter().map(move |name| known().find(|a| a.name == name).map(|a| a.place))
    }

    /// The set-up of each law, ready for [`Chain::new`].
    ///
    /// # Errors
    /// Laws that granlaw lacks, all of them named; otherwise the first thing that is wrong or refused.
    pub fn setups(&self) -> Result<Vec<Setup>, HeaderError> {
        let lacks = |l: &&LawSpec| !l.known || l.kind().and_then(|k| find(k, &l.keyword)).is_none();
        let missing: Vec<_> =
            self.laws.iter().filter(lacks).map(|l| format!("{} {}", l.kind, l.keyword)).collect();
        if !missing.is_empty() {
            let known: Vec<_> =
                LAWS.iter().map(|e| format!("{} {}", e.meta.kind.name(), e.meta.keyword)).collect();
            return Err(HeaderError::Lacks { missing: missing.join(", "), known: known.join(", ") });
        }
        self.laws.iter().map(|l| l.setup(self.types, self.nktv2p, &self.slots)).collect()
    }

    /// The places in a row of the slots of each law; `setups` are those of [`Header::setups`].
    ///
    /// # Panics
    /// If `setups` are those of another header.
    pub fn history_places(&self, setups: &[Setup]) -> Vec<Vec<usize>> {
        let of = |(l, s): (&LawSpec, &Setup)| l.places(s, &self.slots).expect("checked with the set-up");
        self.laws.iter().zip(setups).map(of).collect()
    }

    /// The Rust laws, prepared.
    ///
    /// # Errors
    /// As [`Header::setups`].
    pub fn chain(&self) -> Result<Chain, HeaderError> {
        let setups = self.setups()?;
        Ok(Chain::new(&setups, &self.history_places(&setups))?)
    }

    /// The law that makes bonds, if there is one.
    pub fn bonds(&self) -> Option<&LawSpec> {
        let keeps =
            |l: &&LawSpec| l.kind().and_then(|k| find(k, &l.keyword)).is_some_and(|e| e.meta.bonds.is_some());
        self.laws.iter().find(keeps)
    }

    /// The law of a kind.
    pub fn law(&self, kind: Kind) -> Option<&LawSpec> {
        self.laws.iter().find(|l| l.kind() == Some(kind))
    }
}

mod triple {
    use nalgebra::Vector3;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(v: &Vector3<f64>, s: S) -> Result<S::Ok, S::Error> {
        [v.x, v.y, v.z].serialize(s)
    }
    pub fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<Vector3<f64>, D::Error> {
        <[f64; 3]>::deserialize(d).map(Vector3::from)
    }
}

mod from_one {
    use serde::{de::Error, Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(kind: &usize, s: S) -> Result<S::Ok, S::Error> {
        (kind + 1).serialize(s)
    }
    pub fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<usize, D::Error> {
        usize::deserialize(d)?.checked_sub(1).ok_or_else(|| D::Error::custom("atom types count from 1"))
    }
}
