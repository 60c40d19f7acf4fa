//! One contact call, as the plugin hands it to the probe.
use crate::trace::Handed;
use granlaw::model::Contact;
use nalgebra::Vector3;

/// One contact call with overlapping surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// Atom types from 0.
    pub types: (usize, usize),
    /// The input of the laws.
    pub contact: &'a Contact,
    /// Tells meshes apart, which may number their triangles alike.
    pub place: usize,
    /// The part of a wall contact that counts (LIGGGHTS's `area_ratio`); 1 for a pair.
    pub share: f64,
    /// History before the call.
    pub before: &'a [f64],
    /// What the laws handed along.
    pub handed: Handed,
    /// Force on i \[N\].
    pub force: Vector3<f64>,
    /// Torque on i \[N m\].
    pub torque_i: Vector3<f64>,
    /// Torque on j \[N m\]; of a wall, whatever LIGGGHTS's laws give it.
    pub torque_j: Vector3<f64>,
}

impl Call<'_> {
    /// The torque that turns j: none on a wall.
    pub(super) fn on_j(&self) -> Vector3<f64> {
        if self.contact.close.call.is_wall {
            Vector3::zeros()
        } else {
            self.torque_j
        }
    }
}
