//! A probe: what the contacts of a scene really do, in bounded memory however many there are and however long they run.
//!
//! The plugin hands every contact call to a [`Session`] while a deck runs. Of many contacts only a sample is followed, at most
//! [`FOLLOWED`] of a chain at a time, each counting for those that it stands for. A probe keeps counts, sums, histograms, and a few
//! examples of every class of impact and of load, for each pair of atom types and each wall fix. The probes of all ranks are merged
//! into one JSON file, a [`Probe`].
mod alarm;
mod bulk;
mod call;
mod contacts;
mod examples;
mod follow;
mod followed;
mod histogram;
mod particle_types;
mod particles;
mod session;
mod tally;
mod times;
mod work;

pub use bulk::{Bulk, Sample, SAMPLES};
pub use call::Call;
pub use contacts::Contacts;
pub use examples::{Class, Drawn, End, Impact, Partners, Pressed, KEPT};
pub use follow::{Follower, FOLLOWED};
pub use histogram::{Bin, Histogram};
pub use particle_types::ParticleType;
pub use particles::Particles;
pub use session::Session;
pub use tally::{Branches, Counts, Directions, Fastest, Gaps, Impulse, LawShare, TypePair};
pub use times::Times;

use crate::trace::Header;
use serde::{Deserialize, Serialize};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The value of `format` in a file of this version.
pub const FORMAT: &str = "granlaw probe 2";

/// What a run's contacts did.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// [`FORMAT`].
    pub format: String,
    /// MPI ranks of the run.
    pub ranks: usize,
    /// Wall-clock time from the first step to the last, with the probe at work \[s\].
    pub seconds: f64,
    /// Other times of the run.
    #[serde(default)]
    pub times: Times,
    /// The pair style and each wall fix; once more where a deck changes laws, coefficients or time step.
    pub chains: Vec<Contacts>,
    /// `pair` or `wall ID` of chains whose contacts were not counted, because none of their laws has a Rust twin.
    #[serde(default)]
    pub unseen: Vec<String>,
    /// The particles by type.
    #[serde(default)]
    pub grains: Vec<ParticleType>,
    /// The scene as a whole.
    pub bulk: Bulk,
}

/// Why there is no probe.
#[derive(Debug, Error)]
pub enum ProbeError {
    /// The file cannot be read or written.
    #[error("cannot {doing} the probe {}: {source}", path.display())]
    Io {
        /// What was tried.
        doing: &'static str,
        /// On what.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// It is not a probe.
    #[error("{}: not a probe of this granlaw ({why}); make one with granlaw run --probe {0} -- -in DECK", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        why: String,
    },
}

impl Probe {
    /// Adds what another rank of the same run saw.
    pub fn merge(&mut self, other: Probe) {
        for chain in other.chains {
            match self.chains.iter_mut().find(|c| c.header == chain.header) {
                Some(mine) => mine.merge(chain),
                None => self.chains.push(chain),
            }
        }
        self.unseen.extend(other.unseen);
        self.unseen.sort();
        self.unseen.dedup();
        particle_types::merge(&mut self.grains, &other.grains);
        self.bulk.merge(other.bulk);
        self.seconds = self.seconds.max(other.seconds);
        self.times.merge(other.times);
    }

    /// One chain for the pair style, and one for all walls with the same laws, coefficients and time step, which is then called
    /// `walls A, B`. If a deck changes a chain on the way, the version with the most calls. Chains without calls are left out.
    pub fn principal(&self) -> Vec<Contacts> {
        let mut busiest: Vec<&Contacts> = Vec::new();
        for c in self.chains.iter().filter(|c| c.calls > 0) {
            match busiest.iter_mut().find(|b| b.header.who == c.header.who) {
                Some(b) if b.calls < c.calls => *b = c,
                Some(_) => {}
                None => busiest.push(c),
            }
        }
        let mut all: Vec<Contacts> = Vec::new();
        for c in busiest {
            let wall = |h: &Header| h.who != "pair";
            let same = |a: &Header| *a == Header { who: a.who.clone(), ..c.header.clone() };
            match all.iter_mut().find(|a| wall(&a.header) && wall(&c.header) && same(&a.header)) {
                Some(a) => {
                    let id = c.header.who.trim_start_matches("wall ");
                    a.header.who = format!(
                        "walls {}, {id}",
                        a.header.who.trim_start_matches("walls ").trim_start_matches("wall ")
                    );
                    a.merge(c.clone());
                }
                None => all.push(c.clone()),
            }
        }
        all
    }

    /// Reads a file.
    ///
    /// # Errors
    /// It cannot be read or is no probe of this version.
    pub fn read(path: &Path) -> Result<Probe, ProbeError> {
        let io = |source| ProbeError::Io { doing: "read", path: path.into(), source };
        let foreign = |why: String| ProbeError::Foreign { path: path.into(), why };
        let text = std::fs::read_to_string(path).map_err(io)?;
        let any: serde_json::Value =
            serde_json::from_str(&text).map_err(|_| foreign("it is no JSON".into()))?;
        match any.get("format").and_then(|f| f.as_str()) {
            Some(FORMAT) => serde_json::from_value(any).map_err(|e| foreign(e.to_string())),
            Some(other) => Err(foreign(format!("its format is {other:?}, not {FORMAT:?}"))),
            None => Err(foreign("it has no format".into())),
        }
    }

    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), ProbeError> {
        let io = |source| ProbeError::Io { doing: "write", path: path.into(), source };
        let mut part = path.as_os_str().to_owned();
        part.push(".part");
        let file = std::fs::File::create(&part).map_err(io)?;
        let mut out = io::BufWriter::new(file);
        serde_json::to_writer(&mut out, self).map_err(|e| io(e.into()))?;
        out.flush().and_then(|()| std::fs::rename(&part, path)).map_err(io)
    }
}
