//! A law that is not in `LAWS`, as another crate would have it: put into a chain with laws of ours, it reads what the normal
//! law hands on, keeps a slot that a setting adds, and gives every atom a number.
use granlaw::chain::Chain;
use granlaw::lane::{Lane, Lanes};
use granlaw::laws::find;
use granlaw::model::*;
use nalgebra::Vector3;

/// A spring whose adhesion is handed on.
struct Sticky;

#[derive(Clone, Copy, Lanes)]
struct Params<L = f64> {
    k: L,
}

impl Parameters for Params {
    type Coeffs = f64;
    fn coeffs(p: &Pair<'_>) -> Result<f64, LawError> {
        Ok(p.get("kSticky"))
    }
    fn new(k: &f64, _: &Size) -> Params {
        Params { k: *k }
    }
}

impl Law for Sticky {
    type Params = Params;
    type History = [f64; 0];
    const META: Meta = Meta {
        props: &[Prop::new("kSticky", "k", Shape::PerPair, Unit::N_PER_M, Range::above(0.0), "stiffness")],
        publishes: &[Channel::Kc, Channel::Fo],
        ..Meta::new(Kind::Normal, "sticky", "a spring that tells its adhesion")
    };

    fn intersect<L: Lane>(p: &Params<L>, _: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        (s.fn_, s.kn, s.kc, s.fo) = (p.k * x.deltan, p.k, L::splat(0.5) * p.k, p.k * x.deltan);
        s.force += x.en * s.fn_;
    }
    fn observe(p: &Params, _: &Contact, _: &[f64; 0]) -> Observation {
        Observation { branch: "spring", stiffness: p.k, ..Observation::default() }
    }
}

/// Friction that grows with the adhesion, and counts its evaluations where a setting asks for it.
struct Grip;

impl Law for Grip {
    type Params = ();
    type History = [f64; 1];
    const META: Meta = Meta {
        settings: &[Setting::off("count", "keep the number of evaluations")],
        slots: &[Slot { need: Need::When("count", "on"), ..Slot::even("evaluations", Unit::ONE) }],
        reads: &[Channel::Kc, Channel::Fo],
        ..Meta::new(Kind::Tangential, "grip", "friction by the adhesion")
    };

    fn intersect<L: Lane>(_: &(), call: &Call, x: &Surface<L>, [n]: &mut [L; 1], s: &mut Response<L>) {
        if call.update {
            *n += L::splat(1.0);
        }
        s.force -= x.vtr * (s.fo / s.kc);
    }
    fn observe(_: &(), _: &Contact, _: &[f64; 1]) -> Observation {
        Observation::default()
    }
}

/// A liquid that acts across a gap and flows from i to j.
struct Liquid;

impl GapLaw for Liquid {
    const META: Meta = Meta {
        reach: Reach::Beyond,
        outputs: &[AtomProp { name: "flux", place: 0, doc: "liquid that arrives" }],
        ..Meta::new(Kind::Cohesion, "liquid", "a flux between neighbours")
    };
    type Coeffs = ();
    type Params = ();
    type History = [f64; 0];

    fn coeffs(_: &Pair<'_>) -> Result<(), LawError> {
        Ok(())
    }
    fn reach(_: &(), _: bool) -> f64 {
        0.02
    }
    fn params(_: &(), _: &Size) {}
    fn interact(_: &(), _: &ClosePair, _: &mut [f64; 0], _: &mut Response, e: &mut Effects) {
        e.outputs[0][0] -= 2.0;
        e.outputs[1][0] += 2.0;
    }
    fn modes(_: &(), _: &Size, _: f64) -> Vec<NamedMode> {
        Vec::new()
    }
    fn observe(_: &(), _: &ClosePair, _: &[f64; 0]) -> Observation {
        Observation::default()
    }
}

static STICKY: Entry = Entry::law::<Sticky>();
static GRIP: Entry = Entry::law::<Grip>();
static LIQUID: Entry = Entry::gap_law::<Liquid>();

fn setup(law: &'static Entry, values: &[f64], chosen: &[(&str, &str)]) -> Setup {
    let mut settings = Settings::new(law, false);
    chosen.iter().for_each(|(name, option)| settings.set(name, option).unwrap());
    let of = values.iter().map(|v| vec![*v]).collect();
    Setup { law, settings, values: Values { types: 1, of }, nktv2p: 1.0 }
}

fn contact() -> Contact {
    let call = Call { dt: 1e-6, step: 1, update: true, ..Call::default() };
    let (en, vtr) = (Vector3::x(), Vector3::y() * 3.0);
    let surface = Surface { deltan: 1e-4, en, vtr, ..Surface::default() };
    Contact { close: ClosePair { call, ..ClosePair::default() }, surface }
}

#[test]
fn a_law_of_another_crate_runs_in_a_chain_and_reads_what_is_handed_on() {
    let setups = [setup(&STICKY, &[1e4], &[]), setup(&GRIP, &[], &[("count", "on")])];
    // Its slot lies anywhere in a row that others use too.
    let mut chain = Chain::new(&setups, &[vec![], vec![2]]).unwrap();
    let (mut row, mut s) = ([7.0; 4], Response::default());
    row[2] = 0.0;
    let done = chain.surfaces_intersect((0, 0), &contact(), &mut row, &mut s);
    assert_eq!((s.force.x, s.force.y), (1.0, -3.0 * (1.0 / 5e3)));
    assert_eq!(row, [7.0, 7.0, 1.0, 7.0]);
    assert_eq!((done.set, done.clear), (0b101, 0));
    chain.surfaces_close((0, 0), &contact().close, &mut row, &mut Response::default());
    assert_eq!(row, [7.0, 7.0, 0.0, 7.0]);
}

#[test]
fn a_slot_that_the_settings_do_not_call_for_takes_no_room() {
    let setups = [setup(&STICKY, &[1e4], &[]), setup(&GRIP, &[], &[])];
    let mut chain = Chain::packed(&setups).unwrap();
    assert_eq!(chain.row(), 0);
    chain.surfaces_intersect((0, 0), &contact(), &mut [], &mut Response::default());
}

#[test]
fn what_no_law_hands_on_cannot_be_read() {
    let hertz = find(Kind::Normal, "hertz").unwrap();
    for setups in
        [vec![setup(&GRIP, &[], &[])], vec![setup(hertz, &[5e6, 0.3, 0.5], &[]), setup(&GRIP, &[], &[])]]
    {
        let error = Chain::packed(&setups).err().expect("refused").to_string();
        assert!(error.starts_with("grip/rs: reads kc, which no law before it"), "{error}");
    }
}

#[test]
fn what_a_law_gives_to_atoms_is_added_up() {
    let mut chain = Chain::packed(&[setup(&LIQUID, &[], &[])]).unwrap();
    let done = chain.surfaces_close((0, 0), &contact().close, &mut [], &mut Response::default());
    assert_eq!(done.outputs, [[-2.0], [2.0]]);
    let other = Chain::packed(&[setup(&STICKY, &[1e4], &[])]).unwrap().surfaces_intersect(
        (0, 0),
        &contact(),
        &mut [],
        &mut Response::default(),
    );
    assert_eq!(other.outputs, [[0.0], [0.0]]);
}
