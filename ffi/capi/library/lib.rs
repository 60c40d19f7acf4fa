//! `libgranlaw.so` and `libgranlaw.a`: the C interface and nothing else. A package of its own, because cargo hands the
//! soname on to every library that is built from this one.
pub use granlaw_capi::*;
