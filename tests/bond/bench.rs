//! A bond on its own, with its properties by name.
use granlaw::chain::Chain;
use granlaw::law::*;
use granlaw::laws::find;
use std::collections::BTreeMap;

/// What a deck says of the bond.
#[derive(Clone, Debug)]
pub struct Deck {
    pub values: BTreeMap<&'static str, f64>,
    pub settings: Vec<(&'static str, &'static str)>,
}

impl Deck {
    /// Stiffnesses of the documented convention that make all branches reachable with micrometres and milliradians.
    pub fn documented() -> Deck {
        let values = [
            ("radiusMultiplierBondnonlinear", 0.8),
            ("stiffnessPerUnitAreaK_fn1", 4e7),
            ("stiffnessPerUnitAreaKu_fn1", 8e7),
            ("stiffnessPerUnitAreaKc_fn1", 2e7),
            ("stiffnessPerUnitAreaK_fn2", 1e10),
            ("stiffnessPerUnitAreaKu_fn2", 2e10),
            ("stiffnessPerUnitAreaKc_fn2", 5e9),
            ("stiffnessPerUnitAreaK_ft", 4e9),
            ("stiffnessPerUnitAreaK_tn", 4e9),
            ("stiffnessPerUnitAreaKu_tn", 8e9),
            ("stiffnessPerUnitAreaKc_tn", 2e9),
            ("stiffnessPerUnitAreaK_tt", 1e10),
            ("stiffnessPerUnitAreaKu_tt", 2e10),
            ("stiffnessPerUnitAreaKc_tt", 5e9),
            ("createDistanceBondnonlinear", 1.1e-3),
            ("maxDistanceBondnonlinear", 1.5e-3),
            ("tsCreateBondnonlinear", 1.0),
        ];
        Deck { values: values.into(), settings: vec![("bondConvention", "documented")] }
    }

    pub fn set(mut self, name: &'static str, value: f64) -> Deck {
        self.values.insert(name, value);
        self
    }

    pub fn with(mut self, setting: &'static str, option: &'static str) -> Deck {
        self.settings.push((setting, option));
        self
    }

    pub fn setup(&self) -> Setup {
        let meta = find(Kind::Cohesion, "bond/nonlinear").unwrap().meta;
        let mut settings = Settings::new(meta, false);
        for (name, option) in &self.settings {
            settings.set(name, option).unwrap();
        }
        let of = meta.props.iter().map(|p| vec![self.values.get(p.name).copied().unwrap_or(0.0)]).collect();
        Setup { meta, settings, values: Values { types: 1, of }, nktv2p: 1.0 }
    }

    pub fn chain(&self) -> Chain {
        Chain::packed(&[self.setup()]).unwrap()
    }
}

/// The largest difference of a number and its expectation, relative to the largest expectation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    difference: f64,
    peak: f64,
}

impl Worst {
    pub fn add(&mut self, got: f64, expected: f64) {
        let off = (got - expected).abs();
        // NaN must not slip through.
        self.difference = if off.is_nan() { f64::INFINITY } else { self.difference.max(off) };
        self.peak = self.peak.max(expected.abs());
    }

    pub fn relative(&self) -> f64 {
        match (self.difference, self.peak) {
            (0.0, _) => 0.0,
            (d, p) => d / p,
        }
    }
}
