//! Chains and contacts drawn at random from what the laws say of themselves.
use granlaw::chain::Chain;
use granlaw::laws::LAWS;
use granlaw::model::*;
use nalgebra::Vector3;
use proptest::collection::vec;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

/// Numbers between 0 and 1, handed out one by one; the length bounds what a case may ask for.
pub struct Draw<'a>(std::slice::Iter<'a, f64>);

pub const DRAWS: usize = 256;

impl<'a> Draw<'a> {
    pub fn of(numbers: &'a [f64]) -> Draw<'a> {
        Draw(numbers.iter())
    }
}

impl Draw<'_> {
    pub fn unit(&mut self) -> f64 {
        *self.0.next().expect("more draws than DRAWS")
    }
    pub fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    pub fn flip(&mut self) -> bool {
        self.unit() >= 0.5
    }
    pub fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.within(-size, size))
    }
    pub fn direction(&mut self) -> Vector3<f64> {
        let v = self.vector(1.0);
        // All draws shrunk to the same end still give a direction.
        (v + Vector3::new(0.0, 0.0, if v.norm() < 1e-3 { 1.0 } else { 0.0 })).normalize()
    }
    /// Either end one time in eight each, as that is where laws go wrong; logarithmic over wide ranges.
    fn usual(&mut self, (lo, hi): (f64, f64)) -> f64 {
        let u = self.unit();
        match u {
            _ if u < 0.125 => lo,
            _ if u >= 0.875 => hi,
            _ if lo > 0.0 && hi / lo > 100.0 => lo * (hi / lo).powf((u - 0.125) / 0.75),
            _ => lo + (hi - lo) * (u - 0.125) / 0.75,
        }
    }
}

/// What the settings are.
#[derive(Clone, Copy, PartialEq)]
pub enum Switches {
    Default,
    Any,
    /// Any, but this one at this option.
    With(&'static str, &'static str),
}

/// Something wrong, planted behind the chain: sees the contact and the history before, may bend what came out.
#[derive(Clone, Copy)]
pub enum Fault {
    Touch(fn(&Contact, &[f64], &mut [f64], &mut Response)),
    Apart(fn(&mut [f64])),
    Beyond(fn(&ClosePair, &mut [f64], &mut Response)),
    Observe(fn(&mut Observation)),
}

/// Laws with their numbers, from which chains are made.
#[derive(Clone)]
pub struct Recipe {
    pub setups: Vec<Setup>,
    pub fault: Option<Fault>,
}

pub type Laws = Vec<&'static Entry>;

impl Recipe {
    pub fn draw(laws: &Laws, switches: Switches, d: &mut Draw<'_>) -> Recipe {
        let one = |law: &&'static Entry| {
            let settings = settings(law, switches, d);
            let of = law.meta.props.iter().map(|p| values(p, d)).collect();
            Setup { law, settings, values: Values { types: 2, of }, nktv2p: 1.0 }
        };
        Recipe { setups: laws.iter().map(one).collect(), fault: None }
    }

    pub fn subject(&self) -> Subject {
        let slots = self.setups.iter().flat_map(|s| s.slots()).copied().collect();
        let chain = Chain::packed(&self.setups).expect("usual values are allowed");
        Subject { chain, slots, fault: self.fault }
    }

    pub fn names(&self) -> String {
        let chosen = |s: &Setup| {
            let on: Vec<_> = s
                .settings
                .chosen()
                .filter(|(_, o)| *o != "off")
                .map(|(n, o)| if o == "on" { n } else { o })
                .collect();
            format!("{} {on:?}", s.law.meta.keyword)
        };
        self.setups.iter().map(chosen).collect::<Vec<_>>().join(" + ")
    }

    pub fn slots(&self) -> usize {
        self.setups.iter().map(|s| s.slots().count()).sum()
    }
}

fn settings(law: &'static Entry, switches: Switches, d: &mut Draw<'_>) -> Settings {
    let mut settings = Settings::new(law, false);
    for s in law.meta.settings {
        let option = match switches {
            Switches::Default if s.default.is_some() => continue,
            Switches::Default => s.options[0],
            Switches::With(name, option) if s.name == name => option,
            _ => s.options[(d.unit() * s.options.len() as f64) as usize],
        };
        settings.set(s.name, option).unwrap();
    }
    settings
}

/// For two types, the same for 1-2 as for 2-1.
fn values(p: &Prop, d: &mut Draw<'_>) -> Vec<f64> {
    let (a, b, c) = (d.usual(p.usual), d.usual(p.usual), d.usual(p.usual));
    match p.shape {
        Shape::Scalar => vec![a],
        Shape::PerType => vec![a, b],
        Shape::PerPair => vec![a, c, c, b],
    }
}

/// A chain under test, with or without a fault.
pub struct Subject {
    chain: Chain,
    pub slots: Vec<Slot>,
    fault: Option<Fault>,
}

impl Subject {
    pub fn surfaces_intersect(&mut self, types: (usize, usize), x: &Contact, h: &mut [f64]) -> Response {
        let (before, mut s) = (h.to_vec(), Response::default());
        self.chain.surfaces_intersect(types, x, h, &mut s);
        if let Some(Fault::Touch(bend)) = self.fault {
            bend(x, &before, h, &mut s);
        }
        s
    }

    pub fn surfaces_close(&mut self, types: (usize, usize), x: &ClosePair, h: &mut [f64]) -> Response {
        let mut s = Response::default();
        self.chain.surfaces_close(types, x, h, &mut s);
        match self.fault {
            Some(Fault::Apart(bend)) => bend(h),
            Some(Fault::Beyond(bend)) => bend(x, h, &mut s),
            _ => {}
        }
        s
    }

    /// What the normal law tells.
    pub fn observe(&mut self, types: (usize, usize), x: &Contact, h: &[f64]) -> Observation {
        let mut terms = self.chain.observe(types, x, h)[0];
        if let Some(Fault::Observe(bend)) = self.fault {
            bend(&mut terms);
        }
        terms
    }
}

/// A contact with what its history held before.
#[derive(Clone, Debug)]
pub struct Case {
    pub types: (usize, usize),
    pub contact: Contact,
    pub history: Vec<f64>,
}

impl Case {
    pub fn draw(slots: usize, d: &mut Draw<'_>) -> Case {
        let is_wall = d.unit() >= 0.75;
        let types = (d.flip() as usize, d.flip() as usize);
        let i = body(1, d);
        let j = body(2, d);
        let call = Call { dt: 1e-6, step: 7, update: d.flip(), counts: false, is_wall };
        // From a thousandth to a twentieth of the radius: elastic for some plasticity depths, plastic for others.
        let overlap = i.radius * d.within(1e-3, 0.05);
        let history = (0..slots).map(|_| i.radius * d.within(-0.02, 0.06)).collect();
        Case { types, contact: placed(call, i, j, d.direction(), overlap), history }
    }

    /// The same with another overlap and normal velocity, as the laws would see them.
    pub fn at(&self, deltan: f64, vn: f64) -> Contact {
        let mut x = self.contact;
        (x.surface.deltan, x.surface.vn) = (deltan, vn);
        x
    }
}

pub fn body(tag: i64, d: &mut Draw<'_>) -> Body {
    let radius = d.within(1e-3, 1e-2);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3) * d.within(500.0, 8000.0);
    Body { tag, radius, mass, x: d.vector(0.02), v: d.vector(1.0), omega: d.vector(100.0), ..Body::default() }
}

/// i stays where it is, j comes to overlap with it; a wall stands still.
pub fn placed(call: Call, i: Body, j: Body, en: Vector3<f64>, overlap: f64) -> Contact {
    let j = if call.is_wall {
        Body { tag: -1, x: i.x - en * (i.radius - overlap), ..Body::default() }
    } else {
        Body { x: i.x - en * (i.radius + j.radius - overlap), ..j }
    };
    let surface = Surface { deltan: overlap, ..Surface::default() };
    reseen(&Contact { close: ClosePair { call, i, j, meff: i.mass, ..ClosePair::default() }, surface })
}

/// The contact as the surface model sees it after its bodies were moved.
pub fn reseen(x: &Contact) -> Contact {
    let mut gap = x.close;
    gap.delta = gap.i.x - gap.j.x;
    gap.rsq = granlaw::lane::dot(&gap.delta, &gap.delta);
    if gap.call.is_wall {
        return Contact::wall(gap, x.surface.deltan);
    }
    gap.meff = gap.i.mass * gap.j.mass / (gap.i.mass + gap.j.mass);
    Contact::pair(gap)
}

/// Every normal law with every tangential and rolling law or none.
pub fn chains() -> Vec<Laws> {
    let of = |kind| LAWS.iter().filter(move |e| e.meta.kind == kind);
    let or_none = |kind| std::iter::once(None).chain(of(kind).map(Some));
    let mut all = Vec::new();
    for n in of(Kind::Normal) {
        for t in or_none(Kind::Tangential) {
            for r in or_none(Kind::Rolling) {
                all.push([Some(n), t, r].into_iter().flatten().collect());
            }
        }
    }
    all
}

pub fn chain_of(names: &[&str]) -> Laws {
    names.iter().map(|n| LAWS.iter().find(|e| e.meta.keyword == *n).expect("a law")).collect()
}

pub type Check = fn(&Recipe, &Case, &mut Draw<'_>) -> Result<(), String>;

/// A rule over many random cases of one chain, the same ones every time; what it says of the smallest case that
/// breaks it.
pub fn for_all(
    laws: &Laws,
    switches: Switches,
    cases: u32,
    fault: Option<Fault>,
    check: impl Fn(&Recipe, &Case, &mut Draw<'_>) -> Result<(), String>,
) -> Result<(), String> {
    for_all_of(laws, switches, cases, fault, DRAWS, |recipe, d| {
        let case = Case::draw(recipe.slots(), d);
        check(recipe, &case, d)
    })
}

/// The same for a rule that draws its own cases, from so many draws. Settings that exclude each other are passed over.
pub fn for_all_of(
    laws: &Laws,
    switches: Switches,
    cases: u32,
    fault: Option<Fault>,
    draws: usize,
    check: impl Fn(&Recipe, &mut Draw<'_>) -> Result<(), String>,
) -> Result<(), String> {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 200, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let outcome = runner.run(&vec(0.0..1.0, draws), |numbers: Vec<f64>| {
        let mut d = Draw::of(&numbers);
        let recipe = Recipe { fault, ..Recipe::draw(laws, switches, &mut d) };
        if let Err(LawError::Senseless { what, .. }) = Chain::packed(&recipe.setups) {
            return Err(TestCaseError::reject(what));
        }
        check(&recipe, &mut d).map_err(|e| TestCaseError::fail(format!("{}: {e}", recipe.names())))
    });
    outcome.map_err(|e| match e {
        TestError::Fail(why, _) => why.to_string(),
        TestError::Abort(why) => why.to_string(),
    })
}
