//! A finished run.
use crate::codes::{Folder, Ran};

/// A finished run and its folder.
pub(super) struct Attempt {
    pub folder: Folder,
    pub ran: Ran,
}
