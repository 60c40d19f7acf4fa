//! The batched path inside LIGGGHTS: what it does not do and says so, the options that choose it, and scenes that need
//! all of it.
mod emulated;
mod fallback;
mod options;
mod scenes;

use crate::built::{alone, must};
use crate::common::Scratch;
use std::path::Path;

/// The dump of a deck by LIGGGHTS alone.
fn stock(s: &Scratch) -> String {
    must(alone(Path::new("liggghts"), &s.path("")).args(["-in", "deck.in"]));
    dump(s)
}

/// The dump of the run before, which goes away, so that no run can be taken for the next.
fn dump(s: &Scratch) -> String {
    let text = s.read("dump.txt");
    assert!(text.lines().count() > 100, "nothing was dumped");
    std::fs::remove_file(s.path("dump.txt")).unwrap();
    text
}
