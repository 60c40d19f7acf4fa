//! Properties that LIGGGHTS itself knows, with its names, and the settings that several of its laws share.
use crate::law::{Need, Prop, Range, Setting, Shape, Support, Unit};

const fn prop(name: &'static str, symbol: &'static str, shape: Shape, unit: Unit, range: Range) -> Prop {
    Prop { name, symbol, shape, unit, range, usual: (0.0, 1.0), need: Need::Always, doc: "" }
}

/// Young's modulus.
pub const YOUNG: Prop = Prop {
    usual: (5e6, 1e9),
    doc: "Young's modulus",
    ..prop("youngsModulus", "E", Shape::PerType, Unit::PA, Range::above(0.0))
};
/// Poisson's ratio.
pub const POISSON: Prop = Prop {
    usual: (0.1, 0.49),
    doc: "Poisson's ratio",
    ..prop("poissonsRatio", "ν", Shape::PerType, Unit::ONE, Range::within(0.0, 0.5))
};
/// Coefficient of restitution of the dashpot; not asked for with `viscous on`.
pub const RESTITUTION: Prop = Prop {
    usual: (0.1, 1.0),
    need: Need::Always,
    doc: "coefficient of restitution that the dashpot alone would give",
    ..prop("coefficientRestitution", "e", Shape::PerPair, Unit::ONE, Range::above_to(0.05, 1.0))
};
/// The velocity for which the linear spring is as deep as a Hertz contact.
pub const CHARACTERISTIC_VELOCITY: Prop = Prop {
    usual: (0.1, 10.0),
    doc: "impact velocity for which the linear spring is fitted to a Hertz contact",
    ..prop("characteristicVelocity", "v_c", Shape::Scalar, Unit::M_PER_S, Range::above(0.0))
};
/// Coulomb friction.
pub const FRICTION: Prop = Prop {
    usual: (0.0, 1.0),
    doc: "coefficient of friction",
    ..prop("coefficientFriction", "μ", Shape::PerPair, Unit::ONE, Range::at_least(0.0))
};
/// Rolling friction.
pub const ROLLING_FRICTION: Prop = Prop {
    usual: (0.0, 0.5),
    doc: "coefficient of rolling friction",
    ..prop("coefficientRollingFriction", "μ_r", Shape::PerPair, Unit::ONE, Range::at_least(0.0))
};
/// Viscosity of the fluid between the surfaces.
pub const FLUID_VISCOSITY: Prop = Prop {
    usual: (1e-5, 1.0),
    need: Need::When("viscous", "on"),
    doc: "dynamic viscosity of the fluid between the particles",
    ..prop("FluidViscosity", "μ_f", Shape::PerPair, Unit::PA_S, Range::above(0.0))
};
/// Restitution at infinite Stokes number.
pub const MAXIMUM_RESTITUTION: Prop = Prop {
    usual: (0.5, 1.0),
    need: Need::When("viscous", "on"),
    doc: "coefficient of restitution without fluid",
    ..prop("MaximumRestitution", "e_max", Shape::PerPair, Unit::ONE, Range::above_to(0.0, 1.0))
};
/// The Stokes number at which restitution falls to e_max/e.
pub const CRITICAL_STOKES: Prop = Prop {
    usual: (0.1, 50.0),
    need: Need::When("viscous", "on"),
    doc: "critical Stokes number of the fit ln e = ln e_max + St_c/St",
    ..prop("CriticalStokes", "St_c", Shape::PerPair, Unit::ONE, Range::above(0.0))
};

/// γt = γn, or 0 when off.
pub const TANGENTIAL_DAMPING: Setting =
    Setting::on("tangential_damping", Support::Full, "damp the tangential motion too");
/// No attraction by the dashpot.
pub const LIMIT_FORCE: Setting =
    Setting::off("limitForce", Support::Full, "never let the normal force attract");
/// Restitution from the Stokes number.
pub const VISCOUS: Setting =
    Setting::off("viscous", Support::Full, "take the restitution from the Stokes number of the impact");
/// As [`VISCOUS`], with |St|.
pub const VISCOUS_ABS: Setting = Setting::off(
    "viscousAbs",
    Support::OwnOnly,
    "with viscous on: use |St|, so that approach and rebound are damped alike (LIGGGHTS uses the signed v_n)",
);

/// See [`super::timing`].
pub const CENTRED_DAMPING: Setting = Setting::off(
    "centredDamping",
    Support::OwnOnly,
    "damp the velocity of the end of the step instead of its middle's; with touchFraction on, second order in the step",
);
/// See [`super::timing`].
pub const TOUCH_FRACTION: Setting = Setting::off(
    "touchFraction",
    Support::OwnOnly,
    "let the first and last steps of a contact count by the part of them that is in contact",
);

/// A switch of LIGGGHTS that is not done here.
pub const fn refused(name: &'static str, why: &'static str) -> Setting {
    Setting::off(name, Support::Refused, why)
}
/// Energy bookkeeping of LIGGGHTS.
pub const ELASTIC_POTENTIAL: Setting =
    refused("computeElasticPotential", "energies are not kept in the contact history");
/// Energy bookkeeping of LIGGGHTS.
pub const DISSIPATED_ENERGY: Setting =
    refused("computeDissipatedEnergy", "dissipated energy is not accumulated");
/// Heat from dissipation.
pub const HEATING_TRACKING: Setting = refused("heating_tracking", "contacts do not produce heat");
/// Switching a contact off while a bond holds.
pub const DISABLE_WHEN_BONDED: Setting =
    refused("disableNormalWhenBonded", "the normal law does not look at bonds");
