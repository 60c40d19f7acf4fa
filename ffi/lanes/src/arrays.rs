//! LIGGGHTS's arrays, as the C++ half hands them over and as the pass sees them.
use std::slice::{from_raw_parts, from_raw_parts_mut};

/// LIGGGHTS's own arrays, none copied. Indices are LIGGGHTS's: particles that this rank owns come first, its ghosts behind
/// them.
#[derive(Clone, Copy, Debug)]
pub struct Arrays {
    /// Positions \[m\], velocities \[m/s\] and spins \[rad/s\] of `all` particles.
    pub x: *const [f64; 3],
    pub v: *const [f64; 3],
    pub omega: *const [f64; 3],
    /// Forces \[N\] and torques \[N m\], added to.
    pub f: *mut [f64; 3],
    pub torque: *mut [f64; 3],
    /// Radii \[m\] and masses \[kg\].
    pub radius: *const f64,
    pub mass: *const f64,
    /// Masses of the rigid bodies that particles belong to, 0 for none; NULL without rigid bodies.
    pub rigid: *const f64,
    /// Atom types from 1, group masks, numbers.
    pub kind: *const i32,
    pub mask: *const i32,
    pub tag: *const i32,
    /// The neighbour list: `rows` particles, and for each particle its neighbours, their flags and histories.
    pub ilist: *const i32,
    pub numneigh: *const i32,
    pub neighbours: *const *const i32,
    /// NULL where the chain has no history.
    pub flags: *const *mut i32,
    pub history: *const *mut f64,
    /// Length of `ilist`.
    pub rows: usize,
    /// Number of particles, ghosts included.
    pub all: usize,
    /// Particles below this index get forces.
    pub forced: usize,
    /// Numbers per neighbour in `history`.
    pub row: usize,
    /// How far apart the surfaces of neighbours may be when the list is built \[m\].
    pub skin: f64,
    /// Time step \[s\] and its number.
    pub dt: f64,
    pub step: i64,
    /// Bits of `mask` that freeze a particle.
    pub frozen: i32,
    /// Whether history may be written.
    pub update: bool,
    /// Whether the neighbour list is another one than at the last pass.
    pub rebuilt: bool,
}

/// The particles of a pass.
pub(crate) struct Particles<'a> {
    pub x: &'a [[f64; 3]],
    pub v: &'a [[f64; 3]],
    pub omega: &'a [[f64; 3]],
    pub f: &'a mut [[f64; 3]],
    pub torque: &'a mut [[f64; 3]],
    pub radius: &'a [f64],
    pub mass: &'a [f64],
    pub rigid: &'a [f64],
    pub kind: &'a [i32],
    pub mask: &'a [i32],
    pub frozen: i32,
}

/// # Safety
/// `p` leads to `n` values for as long as `'a`, or is NULL.
unsafe fn slice<'a, T>(p: *const T, n: usize) -> &'a [T] {
    if p.is_null() {
        return &[];
    }
    // SAFETY: as the caller promises.
    unsafe { from_raw_parts(p, n) }
}

/// # Safety
/// As [`slice`], and nothing else uses the values.
unsafe fn slice_mut<'a, T>(p: *mut T, n: usize) -> &'a mut [T] {
    if p.is_null() {
        return &mut [];
    }
    // SAFETY: as the caller promises.
    unsafe { from_raw_parts_mut(p, n) }
}

impl Arrays {
    /// The particles; `None` where an array is missing.
    ///
    /// # Safety
    /// The arrays hold `all` particles and are left alone as long as the answer lives.
    pub(crate) unsafe fn particles(&self) -> Option<Particles<'_>> {
        let n = self.all;
        // SAFETY: as the caller promises, in this block.
        let p = unsafe {
            Particles {
                x: slice(self.x, n),
                v: slice(self.v, n),
                omega: slice(self.omega, n),
                f: slice_mut(self.f, n),
                torque: slice_mut(self.torque, n),
                radius: slice(self.radius, n),
                mass: slice(self.mass, n),
                rigid: slice(self.rigid, n),
                kind: slice(self.kind, n),
                mask: slice(self.mask, n),
                frozen: self.frozen,
            }
        };
        let motion = [p.x.len(), p.v.len(), p.omega.len(), p.f.len(), p.torque.len()];
        let rest = [p.radius.len(), p.mass.len(), p.kind.len(), p.mask.len()];
        (motion == [n; 5] && rest == [n; 4]).then_some(p)
    }
}
