//! Where two answers differ, and by how much: traces, LIGGGHTS dumps, and single numbers of a dump.
mod curves;
mod dump;
mod error;
mod quantity;
mod traces;

pub use curves::Follow;
pub(crate) use curves::{across, gap, shown};
pub use dump::{dumps, is_dump, Difference, Dumps, Frame};
pub use error::CompareError;
pub use quantity::{Quantity, Spot, Worst};
pub use traces::{traces, Stray, Traces};
