//! A probe against what it is meant to say: two bodies counted by hand, samples, ranks.
mod counts;
mod scene;
