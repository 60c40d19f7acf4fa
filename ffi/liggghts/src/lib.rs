//! The plugin `libgranlaw_liggghts.so`: the Rust half of what `cpp/` does inside LIGGGHTS.
#![warn(clippy::undocumented_unsafe_blocks)]

// The C interface must be part of this library: the C++ half calls it.
pub use granlaw_capi::*;

mod batch;
#[allow(non_camel_case_types, missing_docs)]
#[rustfmt::skip]
mod boundary;
mod parting_words;
mod probe;
mod recorder;
mod shadow;

#[cfg(liggghts)]
#[used]
static MARKER: &[u8] = b"granlaw-plugin abi=3 liggghts=3.8.0 end";
#[cfg(not(liggghts))]
#[used]
static MARKER: &[u8] = b"granlaw-plugin abi=3 liggghts=none end";
