//! Bonds described by a few numbers, and the laws and properties of a deck that has them.
use super::matter::Matter;
use granlaw::model::Kind;

/// The properties of bonds.
#[derive(Clone, Copy, Debug)]
pub struct Bond<'a> {
    /// Radius of the spheres \[m\], and the gap between them when they begin \[m\].
    pub radius: f64,
    /// See `radius`.
    pub gap: f64,
    /// Stiffness of first loading per area, in the order of [`MODES`].
    pub k: [f64; 5],
    /// Stiffness of unloading, and of the line through zero, over that of first loading.
    pub over: [f64; 2],
    /// Damping ratio of all modes.
    pub eta: f64,
    /// The modes that are switched on, of [`MODES`].
    pub modes: &'a [&'static str],
}

/// The settings that switch modes on.
pub const MODES: [&str; 5] =
    ["compressionStress", "tensionStress", "shearStress", "normalTorqueStress", "shearTorqueStress"];

/// The properties of each mode: loading, unloading and the line through zero; shear has one stiffness.
const LINES: [&[&str]; 5] = [
    &["stiffnessPerUnitAreaK_fn1", "stiffnessPerUnitAreaKu_fn1", "stiffnessPerUnitAreaKc_fn1"],
    &["stiffnessPerUnitAreaK_fn2", "stiffnessPerUnitAreaKu_fn2", "stiffnessPerUnitAreaKc_fn2"],
    &["stiffnessPerUnitAreaK_ft"],
    &["stiffnessPerUnitAreaK_tn", "stiffnessPerUnitAreaKu_tn", "stiffnessPerUnitAreaKc_tn"],
    &["stiffnessPerUnitAreaK_tt", "stiffnessPerUnitAreaKu_tt", "stiffnessPerUnitAreaKc_tt"],
];

const ETA: [&str; 4] = [
    "dampingNormalForceBondnonlinear",
    "dampingTangentialForceBondnonlinear",
    "dampingNormalTorqueBondnonlinear",
    "dampingTangentialTorqueBondnonlinear",
];

/// Bond radius over that of the spheres.
pub const LAMBDA: f64 = 0.8;

impl Bond<'_> {
    /// The laws with values and settings. LIGGGHTS needs a normal law too, so there is `hooke`, which never acts.
    pub fn matter(&self) -> Matter {
        let apart = 2.0 * self.radius + self.gap;
        let mut m = Matter {
            laws: vec![(Kind::Normal, "hooke"), (Kind::Cohesion, "bond/nonlinear")],
            values: vec![
                ("youngsModulus", 1e7),
                ("poissonsRatio", 0.3),
                ("characteristicVelocity", 2.0),
                ("coefficientRestitution", 0.9),
                ("radiusMultiplierBondnonlinear", LAMBDA),
                ("createDistanceBondnonlinear", apart + 0.01 * self.radius),
                ("maxDistanceBondnonlinear", apart + 2.0 * self.gap),
                ("tsCreateBondnonlinear", 1.0),
            ],
            settings: vec![("bondConvention", "documented")],
        };
        let over = [1.0, self.over[0], self.over[1]];
        for (names, k) in LINES.into_iter().zip(self.k) {
            m.values.extend(names.iter().zip(over).map(|(name, over)| (*name, over * k)));
        }
        m.values.extend(ETA.map(|name| (name, self.eta)));
        let off = MODES.into_iter().filter(|mode| !self.modes.contains(mode));
        m.settings.extend(off.map(|mode| (mode, "off")));
        m.set("dampingBond", if self.eta > 0.0 { "on" } else { "off" })
    }
}
