//! A shadow: LIGGGHTS's laws and the Rust ones on the same inputs, in every contact call of a whole run.
//!
//! The run itself uses LIGGGHTS's laws. The plugin hands every call with LIGGGHTS's answer to a [`Session`], which computes the Rust
//! answer from the same inputs and the same history and compares. Each call is independent, so errors do not add up. Only counts
//! and the worst differences are kept, however long the run. The parts of all ranks are merged into one [`Shadow`].
//!
//! Differences are relative to what the laws add up in that very call, not to a peak of the run, so that a violent
//! contact does not hide an error in a gentle one; and not to the sum alone, which may come to nothing:
//!
//! | of | scale |
//! |---|---|
//! | force | the largest of LIGGGHTS's force, k_n times overlap and γ_n times normal velocity |
//! | torque | the larger of LIGGGHTS's torque and the scale of the force times the larger radius |
//! | history | the largest that LIGGGHTS had in this slot of the chain so far |
mod measure;
mod session;
mod terminal;

pub use measure::Answer;
pub use session::Session;

use serde::{Deserialize, Serialize};

/// The result of a shadowed run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Shadow {
    /// MPI ranks of the run.
    pub ranks: usize,
    /// The pair style and each wall fix; once more where a deck gives it other laws.
    pub chains: Vec<Compared>,
}

/// The result for one chain.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Compared {
    /// `pair`, or `wall <fix id>`.
    pub who: String,
    /// The laws, for instance `normal hooke/hysteresis, tangential history`.
    pub laws: String,
    /// How the batched pass went through contacts, such as its width; empty if it was not used.
    pub way: String,
    /// Number of calls compared through the batched pass; the others were compared one by one.
    pub batched: u64,
    /// Why the chain is not compared; `None` if it is.
    pub left_out: Option<String>,
    /// Number of calls seen.
    pub calls: u64,
    /// Number of calls in which a number differs or is not finite.
    pub differing: u64,
    /// The worst force, torque and number of history; `None` while all are equal to the last bit.
    pub worst: [Option<Worst>; 3],
}

/// The quantities of [`Compared::worst`].
pub const MEASURES: [&str; 3] = ["force", "torque", "history"];

/// A difference between the two answers to a call.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Worst {
    /// The difference over its scale; infinite where a number is not finite, or where the scale is 0.
    #[serde(with = "exact")]
    pub error: f64,
    /// Number of the step.
    pub step: i64,
    /// Numbers of the particles; a wall's is negative.
    pub tags: (i64, i64),
    /// Which number, for instance `force_i.x`.
    pub what: String,
    /// The Rust answer.
    #[serde(with = "exact")]
    pub rust: f64,
    /// LIGGGHTS's answer.
    #[serde(with = "exact")]
    pub stock: f64,
    /// The inputs of the call, by the columns of a trace.
    pub inputs: Vec<(String, String)>,
}

/// The verdict of a shadowed run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// No difference is above the tolerance.
    Agreed,
    /// At least one difference is above the tolerance.
    Differs,
    /// No call was compared.
    Nothing,
}

impl Verdict {
    /// The exit status of a run that LIGGGHTS itself ended well.
    pub fn exit_code(self) -> u8 {
        match self {
            Verdict::Agreed => 0,
            Verdict::Nothing => 2,
            Verdict::Differs => 3,
        }
    }
}

impl Shadow {
    /// Adds what another rank of the same run saw.
    pub fn merge(&mut self, other: Shadow) {
        for chain in other.chains {
            match self.chains.iter_mut().find(|c| c.is(&chain)) {
                Some(mine) => mine.merge(chain),
                None => self.chains.push(chain),
            }
        }
    }

    /// Number of calls compared.
    pub fn calls(&self) -> u64 {
        self.chains.iter().filter(|c| c.left_out.is_none()).map(|c| c.calls).sum()
    }

    /// Number of calls of chains that cannot be compared.
    pub fn left_out(&self) -> u64 {
        self.chains.iter().filter(|c| c.left_out.is_some()).map(|c| c.calls).sum()
    }

    /// The worst difference of all chains; 0 where everything is equal to the last bit.
    pub fn error(&self) -> f64 {
        let all = self.chains.iter().flat_map(|c| c.worst.iter().flatten());
        all.map(|w| w.error).fold(0.0, f64::max)
    }

    /// The verdict, with the largest difference that is allowed.
    pub fn verdict(&self, tolerance: f64) -> Verdict {
        match self.calls() {
            _ if self.error() > tolerance => Verdict::Differs,
            0 => Verdict::Nothing,
            _ => Verdict::Agreed,
        }
    }
}

impl Compared {
    fn is(&self, other: &Compared) -> bool {
        (&self.who, &self.laws, &self.left_out) == (&other.who, &other.laws, &other.left_out)
    }

    fn merge(&mut self, other: Compared) {
        self.calls += other.calls;
        self.batched += other.batched;
        self.differing += other.differing;
        for (mine, theirs) in self.worst.iter_mut().zip(other.worst) {
            let worse = |w: &Worst| mine.as_ref().is_none_or(|m| w.error > m.error);
            if theirs.as_ref().is_some_and(worse) {
                *mine = theirs;
            }
        }
    }
}

/// Writes infinities as text, as JSON has none.
mod exact {
    use serde::{de::Error, Deserialize, Deserializer, Serializer};

    pub fn serialize<S: Serializer>(x: &f64, s: S) -> Result<S::Ok, S::Error> {
        s.serialize_str(&format!("{x:e}"))
    }
    pub fn deserialize<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
        String::deserialize(d)?.parse().map_err(D::Error::custom)
    }
}
