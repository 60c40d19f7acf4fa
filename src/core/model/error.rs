//! Why a law refuses its set-up.
use super::Range;
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
