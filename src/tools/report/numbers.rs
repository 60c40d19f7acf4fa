//! Numbers in JSON, which has no infinities: what is not finite is written as the strings `NaN`, `inf` and `-inf`.
use super::escape;
use serde::{Serialize, Serializer};

#[derive(Serialize)]
#[serde(untagged)]
enum Number {
    Finite(f64),
    Not(String),
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        if value.is_finite() {
            Number::Finite(value)
        } else {
            Number::Not(escape::exact(value))
        }
    }
}

pub(super) fn number<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    Number::from(*value).serialize(to)
}

pub(super) fn numbers<S: Serializer>(values: &[f64], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(values.iter().map(|&value| Number::from(value)))
}
