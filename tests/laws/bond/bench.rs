//! A bond on its own, with its properties by name.
use granlaw::chain::Chain;
use granlaw::laws::find;
use granlaw::model::*;
use nalgebra::{Rotation3, Vector3};
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
        let law = find(Kind::Cohesion, "bond/nonlinear").unwrap();
        let mut settings = Settings::new(law, false);
        // The last word on a setting holds.
        for (name, option) in &self.settings {
            settings.set(name, option).unwrap();
        }
        let of =
            law.meta.props.iter().map(|p| vec![self.values.get(p.name).copied().unwrap_or(0.0)]).collect();
        Setup { law, settings, values: Values { types: 1, of }, nktv2p: 1.0 }
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

/// Two bodies, or one and a wall, moved by hand.
pub struct Driven {
    chain: Chain,
    pub history: Vec<f64>,
    pub close: ClosePair,
    pub response: Response,
    pub bond_event: BondEvent,
    pub dt: f64,
}

impl Driven {
    /// Two equal spheres with D = `delta`, bonded in the step that has just been made.
    pub fn pair(deck: &Deck, delta: Vector3<f64>) -> Driven {
        let body = |tag, x| Body { tag, radius: 5e-4, mass: 1.3e-6, x, ..Body::default() };
        Driven::new(
            deck,
            ClosePair {
                i: body(1, delta),
                j: body(2, Vector3::zeros()),
                meff: 6.5e-7,
                ..ClosePair::default()
            },
        )
    }

    /// A sphere above a wall through the origin.
    pub fn wall(deck: &Deck, delta: Vector3<f64>) -> Driven {
        let i = Body { tag: 1, radius: 5e-4, mass: 1.3e-6, x: delta, ..Body::default() };
        let call = Call { is_wall: true, ..Call::default() };
        Driven::new(
            deck,
            ClosePair {
                call,
                i,
                j: Body { tag: -1, ..Body::default() },
                meff: 1.3e-6,
                ..ClosePair::default()
            },
        )
    }

    fn new(deck: &Deck, mut gap: ClosePair) -> Driven {
        let (chain, dt) = (deck.chain(), 1e-7);
        gap.call = Call { dt, update: true, counts: true, ..gap.call };
        let mut driven = Driven {
            history: vec![0.0; chain.row()],
            chain,
            close: gap,
            response: Response::default(),
            bond_event: BondEvent::None,
            dt,
        };
        driven.evaluate();
        assert_eq!(driven.bond_event, BondEvent::Begins);
        driven
    }

    fn evaluate(&mut self) {
        let g = &mut self.close;
        g.call.step += i64::from(g.call.update);
        g.delta = g.i.x - g.j.x;
        g.rsq = granlaw::lane::dot(&g.delta, &g.delta);
        self.response = Response::default();
        self.bond_event =
            self.chain.surfaces_close((0, 0), g, &mut self.history, &mut self.response).bond_event;
    }

    /// One step in which i moves with v, and both spin.
    pub fn step(&mut self, v: Vector3<f64>, omega_i: Vector3<f64>, omega_j: Vector3<f64>) {
        let way = v * self.dt;
        (self.close.i.v, self.close.i.omega, self.close.j.omega) = (v, omega_i, omega_j);
        self.close.i.x += way;
        self.evaluate();
    }

    /// One step to a place that is not summed up, so that it does not collect rounding.
    pub fn go(&mut self, delta: Vector3<f64>, v: Vector3<f64>, omega_i: Vector3<f64>, omega_j: Vector3<f64>) {
        (self.close.i.x, self.close.i.v) = (delta, v);
        (self.close.i.omega, self.close.j.omega) = (omega_i, omega_j);
        self.evaluate();
    }

    /// One step to a place, at rest afterwards.
    pub fn place(&mut self, delta: Vector3<f64>) {
        self.close.i.v = (delta - self.close.i.x) / self.dt;
        self.close.i.x = delta;
        self.evaluate();
        self.close.i.v = Vector3::zeros();
    }

    /// The part of its strength that the bond uses, as it is told to a probe.
    pub fn used(&mut self) -> f64 {
        let x = Contact { close: self.close, ..Contact::default() };
        let mut used = f64::NAN;
        self.chain.observe_each((0, 0), &x, &self.history, |_, terms| used = terms.load);
        used
    }

    /// What the law would answer elsewhere, without leave to write.
    pub fn query(&mut self, delta: Vector3<f64>) {
        let (x, call) = (self.close.i.x, self.close.call);
        (self.close.i.x, self.close.call.update) = (delta, false);
        self.evaluate();
        (self.close.i.x, self.close.call) = (x, call);
    }

    /// One step of a rigid rotation about the centre of j.
    pub fn turn_rigidly(&mut self, omega: &Vector3<f64>) {
        let before = self.close.i.x;
        let after = Rotation3::new(omega * self.dt) * before;
        self.step((after - before) / self.dt, *omega, *omega);
    }

    /// i and j change places; no slot of the bond is odd.
    pub fn swap(&mut self) {
        std::mem::swap(&mut self.close.i, &mut self.close.j);
        // The one that is moved by hand stays i.
        let shift = self.close.j.x;
        (self.close.i.x, self.close.j.x) = (self.close.i.x - shift, Vector3::zeros());
    }
}
