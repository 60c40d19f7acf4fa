//! Replay: every recorded call is evaluated again by the Rust laws, on the recorded inputs.
//!
//! Each call is independent: it begins with the recorded history, so errors do not add up, and a trace may be thinned.
//! The error of a quantity is its largest difference over the trace relative to its peak; see [`Quantity`].
use crate::compare::{across, gap, Follow, Quantity, Spot};
use crate::report::Curve;
use crate::trace::{Header, HeaderError, Reader, Row, TraceError};
use granlaw::chain::Chain;
use granlaw::model::{Contact, Response, Surface};
use nalgebra::Vector3;
use std::io::Read;
use std::path::Path;
use thiserror::Error;

/// Why a trace cannot be replayed.
#[derive(Debug, Error)]
pub enum ReplayError {
    /// It cannot be read.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// Its chain cannot be built from the Rust laws.
    #[error("{file}: {source}")]
    Header {
        /// The trace.
        file: String,
        /// What is wrong.
        source: HeaderError,
    },
}

/// The result of a replay.
#[derive(Clone, Debug)]
pub struct Replay {
    /// The header at the top of the trace.
    pub header: Header,
    /// Number of calls replayed.
    pub calls: u64,
    /// Those of them in which the surfaces overlap or a law acts across the gap.
    pub touches: u64,
    /// Forces, torques, what the laws handed along, every slot of history, and the surfaces.
    pub quantities: Vec<Quantity>,
    /// The first contact as recorded (`stock`) and as replayed (`replay`).
    pub curves: [Curve; 2],
}

impl Replay {
    /// The quantity with the largest error; `None` if the trace has no rows.
    pub fn worst(&self) -> Option<&Quantity> {
        Quantity::worst_of(&self.quantities).filter(|_| self.calls > 0)
    }

    /// The largest error of all quantities, each relative to its own peak.
    pub fn error(&self) -> f64 {
        self.worst().map_or(0.0, Quantity::error)
    }

    /// Whether every number came out the same to the last bit (zeros of either sign are equal).
    pub fn bit_equal(&self) -> bool {
        self.quantities.iter().all(Quantity::identical)
    }
}

/// Replay a file.
///
/// # Errors
/// If the trace cannot be read, or has laws that granlaw lacks or refuses.
pub fn replay(path: &Path) -> Result<Replay, ReplayError> {
    replay_from(Reader::open(path)?, &path.display().to_string())
}

/// Replay a trace that is already open; `file` is what it is called in errors.
///
/// # Errors
/// As [`replay`].
pub fn replay_from<R: Read>(mut trace: Reader<R>, file: &str) -> Result<Replay, ReplayError> {
    let build = |header: &Header| {
        header.chain().map_err(|source| ReplayError::Header { file: file.to_string(), source })
    };
    let header = trace.header().clone();
    let (mut chain, mut headers) = (build(&header)?, trace.headers());
    let (mut sums, mut follow) = (Sums::new(&header.slots), Follow::default());
    let (mut calls, mut touches) = (0, 0);
    let (mut row, mut again) = (Row::default(), Again::default());
    while trace.read(&mut row)? {
        if trace.headers() != headers {
            (chain, headers) = (build(trace.header())?, trace.headers());
        }
        calls += 1;
        touches += u64::from(row.touch || row.has_force);
        again.run(&mut chain, &row);
        sums.add(trace.line(), &row, &again);
        let (overlap, force) = again.shown(&row);
        follow.row(&row, overlap, force);
    }
    let quantities = sums.quantities();
    Ok(Replay { header, calls, touches, quantities, curves: follow.curves(["stock", "replay"]) })
}

impl Again {
    /// Overlap and normal force for the plots.
    fn shown(&self, row: &Row) -> (f64, f64) {
        match row.touch {
            true => (self.surface.deltan, self.response.fn_),
            false => (gap(row), across(row, &self.response.force)),
        }
    }
}

/// The Rust answer to one call.
#[derive(Default)]
struct Again {
    response: Response,
    history: Vec<f64>,
    surface: Surface,
}

impl Again {
    fn run(&mut self, chain: &mut Chain, row: &Row) {
        self.response = Response::default();
        self.history.clone_from(&row.before);
        if row.touch {
            chain.surfaces_intersect(row.types, &row.contact(), &mut self.history, &mut self.response);
            let own = if row.close.call.is_wall {
                Contact::wall(row.close, row.surface.deltan)
            } else {
                Contact::pair(row.close)
            };
            self.surface = own.surface;
        } else {
            chain.surfaces_close(row.types, &row.close, &mut self.history, &mut self.response);
            self.surface = Surface::default();
        }
    }
}

struct Sums {
    force: Quantity,
    torque: Quantity,
    handed: [Quantity; 5],
    history: Vec<Quantity>,
    overlap: Quantity,
    normal: Quantity,
    velocity: Quantity,
    roll: Quantity,
    lever: Quantity,
}

impl Sums {
    fn new(slots: &[String]) -> Sums {
        Sums {
            force: Quantity::new("force"),
            torque: Quantity::new("torque"),
            handed: ["fn", "kn", "kt", "gamman", "gammat"].map(Quantity::new),
            history: slots.iter().map(|s| Quantity::new(format!("after.{s}"))).collect(),
            overlap: Quantity::new("surface overlap"),
            normal: Quantity::new("surface normal"),
            velocity: Quantity::new("surface velocity"),
            roll: Quantity::new("surface roll"),
            lever: Quantity::new("surface lever"),
        }
    }

    fn add(&mut self, line: u64, row: &Row, again: &Again) {
        let at = Spot { step: row.close.call.step, tags: (row.close.i.tag, row.close.j.tag), line };
        let s = &again.response;
        // LIGGGHTS applies no force to a wall.
        let on_j = if row.close.call.is_wall { Vector3::zeros() } else { -s.force };
        self.force.vector(at, &s.force, &row.force_i);
        self.force.vector(at, &on_j, &row.force_j);
        self.torque.vector(at, &s.torque_i, &row.torque_i);
        self.torque.vector(at, &s.torque_j, &row.torque_j);
        let h = &row.handed;
        let pairs = [(s.fn_, h.fn_), (s.kn, h.kn), (s.kt, h.kt), (s.gamman, h.gamman), (s.gammat, h.gammat)];
        for (q, (got, expected)) in self.handed.iter_mut().zip(pairs) {
            q.number(at, got, expected);
        }
        for (q, (got, expected)) in self.history.iter_mut().zip(again.history.iter().zip(&row.after)) {
            q.number(at, *got, *expected);
        }
        self.surface(at, &again.surface, &row.surface);
    }

    fn surface(&mut self, at: Spot, got: &Surface, expected: &Surface) {
        self.overlap.number(at, got.deltan, expected.deltan);
        self.normal.vector(at, &got.en, &expected.en);
        self.velocity.number(at, got.vn, expected.vn);
        self.velocity.vector(at, &got.vtr, &expected.vtr);
        self.roll.vector(at, &got.roll, &expected.roll);
        self.lever.number(at, got.cri, expected.cri);
        self.lever.number(at, got.crj, expected.crj);
    }

    fn quantities(self) -> Vec<Quantity> {
        let surface = [self.overlap, self.normal, self.velocity, self.roll, self.lever];
        [self.force, self.torque].into_iter().chain(self.handed).chain(self.history).chain(surface).collect()
    }
}
