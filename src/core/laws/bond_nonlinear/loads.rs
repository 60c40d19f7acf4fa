//! What a bond carries.
use nalgebra::Vector3;

/// What the bond carries, undamped.
pub struct Loads {
    /// F_n \[N\], positive when it pushes apart.
    pub normal: f64,
    /// F_t \[N\] on i.
    pub shear: Vector3<f64>,
    /// T_n \[N m\] on i, along n.
    pub twist: f64,
    /// T_t \[N m\] on i.
    pub bend: Vector3<f64>,
}
