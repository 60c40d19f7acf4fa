//! Traces: every call of a contact chain, with all its inputs and results.
//!
//! A file holds one chain (the pair style, or one wall fix) on one rank:
//!
//! 1. `# granlaw trace 1`, then the [`Header`] as TOML behind `# `: programs, deck, laws, settings and coefficients;
//! 2. a line of column names ([`COLUMNS`], then `before.<slot>` and `after.<slot>` for every slot of history);
//! 3. a line of numbers per call, with as few digits as read back the same `f64`;
//! 4. where LIGGGHTS prepared the chain again, another header, which holds from there on; the columns stay;
//! 5. `# end <number of rows>`. A file without it was cut short.
//!
//! Reading and writing hold one row at a time in memory. Numbers are in the units of the deck; the documented ones are SI.
mod columns;
mod error;
mod header;
mod read;
#[cfg(test)]
mod tests;
mod write;

pub(crate) use columns::Cell;
pub use columns::{column_names, columns_markdown, Column, COLUMNS};
pub use error::TraceError;
pub use header::{Header, HeaderError, LawSpec, Particle, Property};
pub use read::Reader;
pub use write::Writer;

use granlaw::model::{ClosePair, Contact, Response, Surface};
use nalgebra::Vector3;

/// The format that this version writes and reads.
pub const VERSION: u32 = 1;

const MARK: &str = "# granlaw trace ";
const END: &str = "# end ";

/// The quantities that the laws of a chain pass on to each other, after the last law; units as in [`Response`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Handed {
    /// Normal force \[N\], positive when it pushes apart.
    pub fn_: f64,
    /// Normal stiffness \[N/m\].
    pub kn: f64,
    /// Tangential stiffness \[N/m\].
    pub kt: f64,
    /// Normal damping \[N s/m\].
    pub gamman: f64,
    /// Tangential damping \[N s/m\].
    pub gammat: f64,
}

impl From<&Response> for Handed {
    fn from(s: &Response) -> Handed {
        Handed { fn_: s.fn_, kn: s.kn, kt: s.kt, gamman: s.gamman, gammat: s.gammat }
    }
}

/// One call of the chain.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// LIGGGHTS's `computeflag`.
    pub computeflag: i32,
    /// LIGGGHTS's `shearupdate`. When a row is read, `gap.call.update` is set from these two.
    pub shearupdate: i32,
    /// Whether the surfaces overlap (`surfacesIntersect`) or not (`surfacesClose`).
    pub touch: bool,
    /// Atom types of i and j, from 0; of a wall, the type of its material. In the file they count from 1.
    pub types: (usize, usize),
    /// The call and the bodies.
    pub close: ClosePair,
    /// The result of the surface model; zeros unless they touch.
    pub surface: Surface,
    /// History before the call, all slots of the chain.
    pub before: Vec<f64>,
    /// History after it.
    pub after: Vec<f64>,
    /// What the laws passed on; zeros unless they touch.
    pub handed: Handed,
    /// Force on i \[N\].
    pub force_i: Vector3<f64>,
    /// Torque on i \[N m\].
    pub torque_i: Vector3<f64>,
    /// Force on j \[N\]; zero for a wall.
    pub force_j: Vector3<f64>,
    /// Torque on j \[N m\].
    pub torque_j: Vector3<f64>,
    /// Whether a law said that there is a force.
    pub has_force: bool,
}

impl Row {
    /// Bodies and surfaces together.
    pub fn contact(&self) -> Contact {
        Contact { close: self.close, surface: self.surface }
    }

    /// Fill in what follows from the columns of a file.
    fn complete(&mut self) {
        let ClosePair { call, i, j, rsq, .. } = &mut self.close;
        call.update = self.computeflag != 0 && self.shearupdate != 0;
        (i.frozen, j.frozen) = (i.mass.is_infinite(), j.mass.is_infinite());
        self.surface.r = match (self.touch, call.is_wall) {
            (true, true) => i.radius - self.surface.deltan,
            (true, false) => rsq.sqrt(),
            (false, _) => 0.0,
        };
    }
}
