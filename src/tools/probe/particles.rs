//! The particles of a rank, as the plugin shows them.

/// The particles of a rank.
#[derive(Clone, Copy, Debug)]
pub struct Particles<'a> {
    /// Atom types, from 1.
    pub kind: &'a [i32],
    /// Masses \[kg\].
    pub mass: &'a [f64],
    /// Radii \[m\].
    pub radius: &'a [f64],
    /// Positions \[m\], three numbers each.
    pub x: &'a [f64],
    /// Velocities \[m/s\].
    pub v: &'a [f64],
    /// Spins \[rad/s\].
    pub omega: &'a [f64],
}
