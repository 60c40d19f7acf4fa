//! What the law asks for and what it remembers.
use crate::model::{AtomProp, Need, Prop, Range, Setting, Shape, Slot, Unit};

const NONE: Prop = Prop {
    name: "",
    symbol: "",
    shape: Shape::PerPair,
    unit: Unit::ONE,
    range: Range::at_least(0.0),
    usual: (0.0, 1.0),
    need: Need::Always,
    doc: "",
};

const fn stiffness(
    name: &'static str,
    symbol: &'static str,
    unit: Unit,
    usual: (f64, f64),
    doc: &'static str,
) -> Prop {
    Prop { name, symbol, unit, usual, doc, ..NONE }
}

const DAMPED: Need = Need::NotAll(&[("dampingBond", "off"), ("dampingBondSmooth", "off")]);

const fn damping(name: &'static str, symbol: &'static str, doc: &'static str) -> Prop {
    Prop { name, symbol, range: Range::within(0.0, 1.0), usual: (0.0, 0.5), need: DAMPED, doc, ..NONE }
}

const STRESS: Need = Need::When("stressBreak", "on");

/// The properties; the usual values of k and ku do not overlap, as ku ≥ k is asked for.
pub const PROPS: &[Prop] = &[
    Prop {
        name: "radiusMultiplierBondnonlinear",
        symbol: "λ",
        usual: (0.5, 1.0),
        doc: "bond radius over the smaller particle radius; 0 for no bonds between these types",
        ..NONE
    },
    stiffness(
        "stiffnessPerUnitAreaK_fn1",
        "k_n1",
        Unit::N_PER_M2_5,
        (1e7, 4e7),
        "compression, first loading (upstream: not per area, N/m^0.5)",
    ),
    stiffness(
        "stiffnessPerUnitAreaKu_fn1",
        "k_u,n1",
        Unit::N_PER_M2_5,
        (4e7, 1e8),
        "compression, unloading and reloading (upstream: N/m^0.5)",
    ),
    stiffness(
        "stiffnessPerUnitAreaKc_fn1",
        "k_c,n1",
        Unit::N_PER_M2_5,
        (0.0, 4e7),
        "compression, line through zero (upstream: N/m^0.5)",
    ),
    stiffness("stiffnessPerUnitAreaK_fn2", "k_n2", Unit::N_PER_M3, (1e9, 1e10), "tension, first loading"),
    stiffness(
        "stiffnessPerUnitAreaKu_fn2",
        "k_u,n2",
        Unit::N_PER_M3,
        (1e10, 3e10),
        "tension, unloading and reloading",
    ),
    stiffness(
        "stiffnessPerUnitAreaKc_fn2",
        "k_c,n2",
        Unit::N_PER_M3,
        (0.0, 1e10),
        "tension, line through zero",
    ),
    stiffness("stiffnessPerUnitAreaK_ft", "k_t", Unit::N_PER_M3, (1e9, 1e10), "shear"),
    stiffness("stiffnessPerUnitAreaK_tn", "k_tn", Unit::N_PER_M3, (1e9, 1e10), "twist, first loading"),
    stiffness(
        "stiffnessPerUnitAreaKu_tn",
        "k_u,tn",
        Unit::N_PER_M3,
        (1e10, 3e10),
        "twist, unloading and reloading",
    ),
    stiffness("stiffnessPerUnitAreaKc_tn", "k_c,tn", Unit::N_PER_M3, (0.0, 1e10), "twist, line through zero"),
    stiffness("stiffnessPerUnitAreaK_tt", "k_tt", Unit::N_PER_M3, (1e9, 1e10), "bending, first loading"),
    stiffness(
        "stiffnessPerUnitAreaKu_tt",
        "k_u,tt",
        Unit::N_PER_M3,
        (1e10, 3e10),
        "bending, unloading and reloading",
    ),
    stiffness(
        "stiffnessPerUnitAreaKc_tt",
        "k_c,tt",
        Unit::N_PER_M3,
        (0.0, 1e10),
        "bending, line through zero",
    ),
    damping("dampingNormalForceBondnonlinear", "η_n", "share of the normal force that opposes its velocity"),
    damping(
        "dampingTangentialForceBondnonlinear",
        "η_t",
        "share of the shear force that opposes its velocity",
    ),
    damping(
        "dampingNormalTorqueBondnonlinear",
        "η_tn",
        "share of the twisting torque that opposes its velocity",
    ),
    damping(
        "dampingTangentialTorqueBondnonlinear",
        "η_tt",
        "share of the bending torque that opposes its velocity",
    ),
    Prop {
        name: "maxDistanceBondnonlinear",
        symbol: "r_max",
        unit: Unit::M,
        range: Range::above(0.0),
        usual: (0.031, 0.05),
        need: Need::Unless("stressBreak", "on"),
        doc: "distance beyond which the bond breaks, from centre to centre; at a wall twice the distance",
        ..NONE
    },
    Prop {
        name: "maxSigmaBondnonlinear",
        symbol: "σ_max",
        unit: Unit::PA,
        range: Range::above(0.0),
        usual: (1e5, 1e7),
        need: STRESS,
        doc: "strength under normal force and bending",
        ..NONE
    },
    Prop {
        name: "maxTauBondnonlinear",
        symbol: "τ_max",
        unit: Unit::PA,
        range: Range::above(0.0),
        usual: (1e5, 1e7),
        need: STRESS,
        doc: "strength under shear and twist",
        ..NONE
    },
    Prop {
        name: "ratioTensionCompressionBondnonlinear",
        symbol: "γ",
        range: Range::above(0.0),
        usual: (0.1, 1.0),
        need: Need::All(&[("stressBreak", "on"), ("ratioTensionCompressionBond", "on")]),
        doc: "strength in tension over σ_max",
        ..NONE
    },
    Prop {
        name: "createDistanceBondnonlinear",
        symbol: "r_create",
        unit: Unit::M,
        range: Range::above(0.0),
        usual: (0.021, 0.03),
        doc: "distance below which a bond may begin, from centre to centre; at a wall twice the distance",
        ..NONE
    },
    Prop {
        name: "tsCreateBondnonlinear",
        symbol: "t_create",
        shape: Shape::Scalar,
        usual: (1.0, 2.0),
        need: Need::Unless("createBondAlways", "on"),
        doc: "number of the time step in which bonds begin, at least 1",
        ..NONE
    },
];

const fn on(name: &'static str, doc: &'static str) -> Setting {
    Setting::on(name, doc)
}
const fn off(name: &'static str, doc: &'static str) -> Setting {
    Setting::off(name, doc)
}

/// The settings, with the names and defaults of LIGGGHTS-INL; the last is ours.
pub const SETTINGS: &[Setting] = &[
    off("stressBreak", "break at a stress instead of a distance"),
    on("tensionStress", "normal force in tension"),
    on("compressionStress", "normal force in compression"),
    on("shearStress", "shear force"),
    on("normalTorqueStress", "twisting torque"),
    on("shearTorqueStress", "bending torque"),
    off("createBondAlways", "bonds begin whenever two bodies are near enough, also where one has just broken"),
    on("dampingBond", "damp each mode by a share of its load"),
    off("dampingBondSmooth", "let the damping vanish near rest instead of changing sign"),
    off("ratioTensionCompressionBond", "another strength in tension than in compression (with stressBreak on)"),
    Setting {
        name: "bondConvention",
        options: &["documented", "upstream"],
        default: None,
        doc: "documented: the published equations, frame-independent, all forces per bond area (K_fn1 in N/m^2.5); \
              upstream: the numbers of LIGGGHTS-INL's header, faults included, compression without the area (K_fn1 in N/m^0.5)",
    },
];

/// Read of each atom.
pub const ATOMS: &[AtomProp] = &[AtomProp {
    name: "bondnonlinear_random_id",
    place: 0,
    doc: "two atoms with the same number bond while the time step is below it",
}];

const DOCUMENTED: Need = Need::When("bondConvention", "documented");
const UPSTREAM: Need = Need::When("bondConvention", "upstream");

const fn slot(name: &'static str, unit: Unit, need: Need) -> Slot {
    Slot { need, ..Slot::even(name, unit) }
}
const fn ours(name: &'static str, unit: Unit) -> Slot {
    slot(name, unit, DOCUMENTED)
}
const fn theirs(name: &'static str) -> Slot {
    slot(name, Unit::RAD, UPSTREAM)
}

/// The history. No slot changes sign when i and j change places: vectors are stored as seen by the lower tag.
pub const SLOTS: &[Slot] = &[
    Slot::even("r0", Unit::M),
    Slot::even("deltaMax", Unit::M),
    Slot::even("deltaMin", Unit::M),
    Slot::even("ftx", Unit::N),
    Slot::even("fty", Unit::N),
    Slot::even("ftz", Unit::N),
    Slot::even("fromx", Unit::M),
    Slot::even("fromy", Unit::M),
    Slot::even("fromz", Unit::M),
    Slot::even("thetatx", Unit::RAD),
    Slot::even("thetaty", Unit::RAD),
    Slot::even("thetatz", Unit::RAD),
    ours("thetan", Unit::RAD),
    ours("thetanMax", Unit::RAD),
    ours("thetanMin", Unit::RAD),
    ours("centrex", Unit::RAD),
    ours("centrey", Unit::RAD),
    ours("centrez", Unit::RAD),
    ours("rho", Unit::RAD),
    theirs("thetanx"),
    theirs("thetany"),
    theirs("thetanz"),
    theirs("thetanMaxx"),
    theirs("thetanMaxy"),
    theirs("thetanMaxz"),
    theirs("thetanMinx"),
    theirs("thetanMiny"),
    theirs("thetanMinz"),
    theirs("thetatMaxx"),
    theirs("thetatMaxy"),
    theirs("thetatMaxz"),
    theirs("thetatMinx"),
    theirs("thetatMiny"),
    theirs("thetatMinz"),
];
