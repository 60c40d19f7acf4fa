//! Properties that LIGGGHTS itself knows, with its names, and the settings that several of its laws share.
use crate::model::{Need, Prop, Range, Setting, Shape, Unit};

/// Young's modulus.
pub const YOUNG: Prop =
    Prop::new("youngsModulus", "E", Shape::PerType, Unit::PA, Range::above(0.0), "Young's modulus")
        .usually(5e6, 1e9);
/// Poisson's ratio.
pub const POISSON: Prop =
    Prop::new("poissonsRatio", "ν", Shape::PerType, Unit::ONE, Range::within(0.0, 0.5), "Poisson's ratio")
        .usually(0.1, 0.49);
/// Coefficient of restitution of the dashpot.
pub const RESTITUTION: Prop = Prop::new(
    "coefficientRestitution",
    "e",
    Shape::PerPair,
    Unit::ONE,
    Range::above_to(0.05, 1.0),
    "coefficient of restitution that the dashpot alone would give",
)
.usually(0.1, 1.0);
/// The velocity for which the linear spring is as deep as a Hertz contact.
pub const CHARACTERISTIC_VELOCITY: Prop = Prop::new(
    "characteristicVelocity",
    "v_c",
    Shape::Scalar,
    Unit::M_PER_S,
    Range::above(0.0),
    "impact velocity for which the linear spring is fitted to a Hertz contact",
)
.usually(0.1, 10.0);
/// Coulomb friction.
pub const FRICTION: Prop = Prop::new(
    "coefficientFriction",
    "μ",
    Shape::PerPair,
    Unit::ONE,
    Range::at_least(0.0),
    "coefficient of friction",
);
/// Rolling friction.
pub const ROLLING_FRICTION: Prop = Prop::new(
    "coefficientRollingFriction",
    "μ_r",
    Shape::PerPair,
    Unit::ONE,
    Range::at_least(0.0),
    "coefficient of rolling friction",
)
.usually(0.0, 0.5);
/// Viscosity of the fluid between the surfaces.
pub const FLUID_VISCOSITY: Prop = Prop::new(
    "FluidViscosity",
    "μ_f",
    Shape::PerPair,
    Unit::PA_S,
    Range::above(0.0),
    "dynamic viscosity of the fluid between the particles",
)
.usually(1e-5, 1.0)
.needed(Need::When("viscous", "on"));
/// Restitution at infinite Stokes number.
pub const MAXIMUM_RESTITUTION: Prop = Prop::new(
    "MaximumRestitution",
    "e_max",
    Shape::PerPair,
    Unit::ONE,
    Range::above_to(0.0, 1.0),
    "coefficient of restitution without fluid",
)
.usually(0.5, 1.0)
.needed(Need::When("viscous", "on"));
/// The Stokes number at which restitution falls to e_max/e.
pub const CRITICAL_STOKES: Prop = Prop::new(
    "CriticalStokes",
    "St_c",
    Shape::PerPair,
    Unit::ONE,
    Range::above(0.0),
    "critical Stokes number of the fit ln e = ln e_max + St_c/St",
)
.usually(0.1, 50.0)
.needed(Need::When("viscous", "on"));
/// Stiffest unloading over loading stiffness, k2max/kn.
pub const MAX_STIFFNESS: Prop = Prop::new(
    "coefficientMaxElasticStiffness",
    "k2max/kn",
    Shape::PerPair,
    Unit::ONE,
    Range::at_least(1.0),
    "stiffest unloading over loading stiffness; 1 is a linear spring",
)
.usually(1.5, 20.0);
/// Adhesion over loading stiffness, kc/kn.
pub const ADHESION_STIFFNESS: Prop = Prop::new(
    "coefficientAdhesionStiffness",
    "kc/kn",
    Shape::PerPair,
    Unit::ONE,
    Range::at_least(0.0),
    "adhesion over loading stiffness",
)
.usually(0.0, 2.0);
/// Plasticity depth φF.
pub const PLASTICITY_DEPTH: Prop = Prop::new(
    "coefficientPlasticityDepth",
    "φF",
    Shape::PerPair,
    Unit::ONE,
    Range::at_least(0.0),
    "plastic depth over the diameter 2R*; 0 unloads along k2max from the start",
)
.usually(0.01, 0.5);

/// γt = γn, or 0 when off.
pub const TANGENTIAL_DAMPING: Setting = Setting::on("tangential_damping", "damp the tangential motion too");
/// No attraction by the dashpot.
pub const LIMIT_FORCE: Setting = Setting::off("limitForce", "never let the normal force attract");
/// Restitution from the Stokes number.
pub const VISCOUS: Setting =
    Setting::off("viscous", "take the restitution from the Stokes number of the impact");
/// As [`VISCOUS`], with |St|.
pub const VISCOUS_ABS: Setting = Setting::off(
    "viscousAbs",
    "with viscous on: use |St|, so that approach and rebound are damped alike (LIGGGHTS uses the signed v_n)",
);

/// Of rolling laws.
pub const TORSION_TORQUE: Setting = Setting::off("torsionTorque", "also resist spin about the normal");

/// See [`super::timing`].
pub const CENTRED_DAMPING: Setting = Setting::off(
    "centredDamping",
    "damp the velocity of the end of the step instead of its middle's; with touchFraction on, second order in the step",
);
/// See [`super::timing`].
pub const TOUCH_FRACTION: Setting = Setting::off(
    "touchFraction",
    "let the first and last steps of a contact count by the part of them that is in contact",
);

/// A switch of LIGGGHTS that is not done here, for [`Binding::refused`](crate::model::Binding::refused).
pub const fn refused(name: &'static str, why: &'static str) -> Setting {
    Setting::off(name, why)
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

/// LIGGGHTS's own creators of the properties above (`global_properties.h`), so that its checks and messages hold: the table
/// in the plugin is made from this.
pub const CREATORS: &[(Prop, &str)] = &[
    (YOUNG, "createYoungsModulus"),
    (POISSON, "createPoissonsRatio"),
    (RESTITUTION, "createCoeffRest"),
    (CHARACTERISTIC_VELOCITY, "createCharacteristicVelocity"),
    (FRICTION, "createCoeffFrict"),
    (ROLLING_FRICTION, "createCoeffRollFrict"),
    (FLUID_VISCOSITY, "createCoeffMu"),
    (MAXIMUM_RESTITUTION, "createCoeffRestMax"),
    (CRITICAL_STOKES, "createCoeffStc"),
    (MAX_STIFFNESS, "createCoeffMaxElasticStiffness"),
    (ADHESION_STIFFNESS, "createCoeffAdhesionStiffness"),
    (PLASTICITY_DEPTH, "createCoeffPlasticityDepth"),
];
