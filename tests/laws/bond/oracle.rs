//! The Rust law along the paths of `scripts/oracle/bond.py`, carrying its own history.
use super::bench::{Deck, Worst};
use granlaw::model::*;
use nalgebra::Vector3;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The law rounds some fifty operations per step, and what is carried along ninety of them.
const LIMIT: f64 = 1e-13;

const CASES: [&str; 12] = [
    "pair",
    "reversed_tags",
    "damped",
    "smooth",
    "wall",
    "wall_smooth",
    "far",
    "stress",
    "stress_shear",
    "no_tension_no_bend",
    "no_compression_no_shear_no_twist",
    "equal_k",
];

/// One file of the oracle.
struct Case {
    said: BTreeMap<String, String>,
    rows: Vec<Vec<f64>>,
}

impl Case {
    fn read(name: &str) -> Case {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("reference_data/bond/oracle_{name}.csv"));
        let text = fs::read_to_string(&path).unwrap();
        let said = text.lines().filter_map(|l| l.strip_prefix("# ")?.split_once(" = "));
        let said = said.map(|(k, v)| (k.to_string(), v.to_string())).collect();
        let rows = text.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit()));
        let rows = rows.map(|l| l.split(',').map(|n| n.parse().unwrap()).collect()).collect();
        Case { said, rows }
    }

    fn numbers(&self, key: &str) -> Vec<f64> {
        self.said[key].split(' ').map(|n| n.parse().unwrap()).collect()
    }

    fn is(&self, key: &str) -> bool {
        self.said[key] == "True"
    }

    fn deck(&self) -> Deck {
        const LINES: [(&str, [&str; 3]); 4] = [
            ("k1", ["stiffnessPerUnitAreaK_fn1", "stiffnessPerUnitAreaKu_fn1", "stiffnessPerUnitAreaKc_fn1"]),
            ("k2", ["stiffnessPerUnitAreaK_fn2", "stiffnessPerUnitAreaKu_fn2", "stiffnessPerUnitAreaKc_fn2"]),
            ("ktn", ["stiffnessPerUnitAreaK_tn", "stiffnessPerUnitAreaKu_tn", "stiffnessPerUnitAreaKc_tn"]),
            ("ktt", ["stiffnessPerUnitAreaK_tt", "stiffnessPerUnitAreaKu_tt", "stiffnessPerUnitAreaKc_tt"]),
        ];
        const ETA: [&str; 4] = [
            "dampingNormalForceBondnonlinear",
            "dampingTangentialForceBondnonlinear",
            "dampingNormalTorqueBondnonlinear",
            "dampingTangentialTorqueBondnonlinear",
        ];
        const OFF: [(&str, &str); 5] = [
            ("tension", "tensionStress"),
            ("compression", "compressionStress"),
            ("shear", "shearStress"),
            ("twist", "normalTorqueStress"),
            ("bend", "shearTorqueStress"),
        ];
        let one = |key: &str| self.numbers(key)[0];
        let mut deck = Deck::documented();
        for (key, names) in LINES {
            deck.values.extend(names.into_iter().zip(self.numbers(key)));
        }
        deck.values.extend(ETA.into_iter().zip(self.numbers("eta")));
        deck = deck
            .set("radiusMultiplierBondnonlinear", one("lam"))
            .set("stiffnessPerUnitAreaK_ft", one("kt"))
            .set("createDistanceBondnonlinear", one("near"))
            .set("maxDistanceBondnonlinear", one("far"))
            .set("tsCreateBondnonlinear", one("at"));
        if self.is("smooth") {
            deck = deck.with("dampingBondSmooth", "on");
        }
        for (_, setting) in OFF.iter().filter(|(word, _)| self.said["off"].split(' ').any(|w| w == *word)) {
            deck = deck.with(setting, "off");
        }
        if self.said["strength"] != "None" {
            let strength = self.numbers("strength");
            deck = deck.set("maxSigmaBondnonlinear", strength[0]).set("maxTauBondnonlinear", strength[1]);
            deck = deck.with("stressBreak", "on").with("ratioTensionCompressionBond", "on");
            deck = deck.set("ratioTensionCompressionBondnonlinear", one("ratio"));
        }
        deck
    }

    /// What the law sees in a row.
    fn gap(&self, row: &[f64]) -> ClosePair {
        let three = |k: usize| Vector3::new(row[2 + 3 * k], row[3 + 3 * k], row[4 + 3 * k]);
        let (radii, masses, tags) = (self.numbers("radii"), self.numbers("masses"), self.numbers("tags"));
        let body = |k: usize, x, v, omega| Body {
            tag: tags[k] as i64,
            radius: radii[k],
            mass: masses[k],
            x,
            v,
            omega,
            ..Body::default()
        };
        let (x, delta) = (three(0), three(1));
        let (i, mut j) = (body(0, x, three(2), three(4)), body(1, x - delta, three(3), three(5)));
        let is_wall = self.is("wall");
        let mut meff = i.mass * j.mass / (i.mass + j.mass);
        if is_wall {
            (j.tag, j.radius, j.mass, meff) = (-1, 0.0, 0.0, i.mass);
        }
        let call = Call {
            dt: self.numbers("dt")[0],
            step: row[0] as i64,
            update: row[1] == 1.0,
            is_wall,
            ..Call::default()
        };
        ClosePair { call, i, j, delta, rsq: granlaw::lane::dot(&delta, &delta), meff }
    }
}

/// Differences of forces and torques, and what was seen on the way.
#[derive(Default)]
struct Found {
    force: Worst,
    torque_i: Worst,
    torque_j: Worst,
    branches: BTreeSet<&'static str>,
    broke: bool,
}

fn follow(case: &Case, deck: &Deck) -> Result<Found, String> {
    let mut chain = deck.chain();
    let (mut h, mut found) = (vec![0.0; chain.row()], Found::default());
    for row in &case.rows {
        let gap = case.gap(row);
        let mut s = Response::default();
        let done = chain.surfaces_close((0, 0), &gap, &mut h, &mut s);
        let expected = |k: usize| Vector3::new(row[20 + 3 * k], row[21 + 3 * k], row[22 + 3 * k]);
        for axis in 0..3 {
            found.force.add(s.force[axis], expected(0)[axis]);
            found.torque_i.add(s.torque_i[axis], expected(1)[axis]);
            found.torque_j.add(s.torque_j[axis], expected(2)[axis]);
        }
        let bonded = h[0] != 0.0;
        if bonded != (row[29] == 1.0) {
            return Err(format!("step {}: bonded {bonded}, which the oracle denies", row[0]));
        }
        found.broke |= done.bond_event == BondEvent::Ends;
        if bonded && gap.call.update {
            let x = Contact { close: gap, ..Contact::default() };
            found.branches.insert(chain.observe((0, 0), &x, &h)[0].branch);
        }
    }
    Ok(found)
}

#[test]
fn forces_and_torques_follow_the_oracle() {
    for name in CASES {
        let case = Case::read(name);
        let found = follow(&case, &case.deck()).unwrap_or_else(|e| panic!("{name}: {e}"));
        for (what, worst) in
            [("force", found.force), ("torque_i", found.torque_i), ("torque_j", found.torque_j)]
        {
            println!("{name} {what} {:.1e}", worst.relative());
            assert!(
                worst.relative() <= LIMIT,
                "{name}: {what} differs by {:e} of its peak",
                worst.relative()
            );
        }
        assert_eq!(found.broke, ["far", "stress", "stress_shear"].contains(&name), "{name}");
        if ["pair", "smooth", "wall"].contains(&name) {
            assert_eq!(found.branches.len(), 6, "{name} visits only {:?}", found.branches);
        }
    }
}

/// Each property, off by a millionth, is seen in some case.
#[test]
fn a_property_off_by_a_millionth_turns_red() {
    let cases: Vec<_> = CASES.iter().map(|name| Case::read(name)).collect();
    let names = Deck::documented().values.keys().copied().collect::<Vec<_>>();
    for name in names.into_iter().filter(|n| !n.contains("Distance") && !n.contains("tsCreate")) {
        let red = cases.iter().any(|case| {
            let mut deck = case.deck();
            *deck.values.get_mut(name).unwrap() *= 1.0 + 1e-6;
            follow(case, &deck)
                .is_ok_and(|f| [f.force, f.torque_i, f.torque_j].iter().any(|w| w.relative() > 1e3 * LIMIT))
        });
        assert!(red, "{name} may be anything");
    }
}

#[test]
fn a_bond_that_breaks_a_step_late_turns_red() {
    let case = Case::read("far");
    let deck = case.deck().set("maxDistanceBondnonlinear", 8.3e-4);
    assert!(follow(&case, &deck).is_err_and(|e| e.contains("which the oracle denies")));
}
