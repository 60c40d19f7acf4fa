//! The batched path inside LIGGGHTS: what it does not do and says so, the options that choose it, and scenes that need
//! all of it.
#[path = "batched/emulated.rs"]
mod emulated;
#[path = "batched/fallback.rs"]
mod fallback;
#[path = "batched/options.rs"]
mod options;
#[path = "batched/scenes.rs"]
mod scenes;

#[path = "built/mod.rs"]
mod built;
#[path = "live/mod.rs"]
mod live;

use live::Scratch;
use std::path::Path;

/// The dump of a deck by LIGGGHTS alone.
fn stock(s: &Scratch) -> String {
    built::must(built::alone(Path::new("liggghts"), &s.path("")).args(["-in", "deck.in"]));
    dump(s)
}

/// The dump of the run before, which goes away, so that no run can be taken for the next.
fn dump(s: &Scratch) -> String {
    let text = s.read("dump.txt");
    assert!(text.lines().count() > 100, "nothing was dumped");
    std::fs::remove_file(s.path("dump.txt")).unwrap();
    text
}
