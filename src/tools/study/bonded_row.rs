//! How spheres stand in a row, each bonded to the next, and what sets them going.

/// How many spheres a row has, and what sets them going.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondedRow {
    /// At least two; of unlike sizes in turn.
    pub beads: usize,
    /// Gap between the surfaces when the bonds begin \[m\]: they act across it.
    pub gap: f64,
    /// How they move.
    pub way: Way,
}

/// How a row is set going. Unless it is at random, `speed` or `slide` of the collision is the velocity of one end relative to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// In the slowest mode along the row: pressed together if `speed` is above 0, stretched if below.
    Along,
    /// Across the row, in shear.
    Shear,
    /// The ends turn against each other about an axis across the row; surfaces move with `slide`.
    Bend,
    /// The ends turn against each other about the row, in twist.
    Twist,
    /// Every sphere moves along the row with a random velocity, from a seed, up to `speed`.
    AlongAtRandom(u64),
    /// Every sphere turns about the row with a random velocity, up to `slide`.
    TwistAtRandom(u64),
}

/// A random number within [−1, 1], from a seed and the number of a sphere (the finaliser of SplitMix64).
pub(super) fn random(seed: u64, k: usize) -> f64 {
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (k as u64 + 1).rotate_left(32);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}
