//! Several contacts at once against one by one: every bit, at every width.
use super::recipe::{chain_of, for_all, Case, Check, Draw, Recipe, Switches};
use granlaw::lane::{Lane, Lanes, Pack};
use granlaw::laws::{made, no_history::NoHistory, LAWS};
use granlaw::model::*;
use nalgebra::Vector3;

type Outcome = Result<(), String>;

/// Response and history as they come out, in bits.
type Bits = Vec<u64>;

/// The contacts of a batch: the case, and more drawn beside it so that lanes take different branches. Some sit on
/// a branch edge: no overlap, no motion, history equal to the overlap.
fn batch(c: &Case, d: &mut Draw<'_>, width: usize) -> Vec<Case> {
    (0..width)
        .map(|_| {
            let mut c = c.clone();
            let g = &mut c.contact.close;
            (g.i.radius, g.meff) = (g.i.radius * d.within(0.5, 2.0), g.meff * d.within(0.5, 2.0));
            let s = &mut c.contact.surface;
            s.deltan *= d.within(0.01, 2.0);
            s.vn *= d.within(-1.0, 1.0);
            match (d.unit() * 8.0) as usize {
                0 => s.deltan = 0.0,
                1 => (s.vn, s.vtr, s.roll) = (0.0, Vector3::zeros(), Vector3::zeros()),
                2 => c.history.iter_mut().for_each(|h| *h = s.deltan),
                3 => c.history.iter_mut().for_each(|h| *h = 0.0),
                4 => s.roll *= 1e-6,
                5 => s.roll = s.en * 10.0,
                _ => s.vtr *= d.within(0.0, 1.0),
            }
            c
        })
        .collect()
}

/// What the normal law of a chain would hand on; lane by lane different.
fn handed_on(c: &Case) -> Response {
    let x = &c.contact.surface;
    let (kn, gamma) = (1e4, 0.3);
    let fn_ = kn * x.deltan - gamma * x.vn;
    let (torque_i, torque_j) = (x.vtr * (1e-3 * fn_), x.vtr * (5e-4 * fn_));
    let force = x.en * fn_;
    Response {
        fn_,
        kn,
        kt: 0.8 * kn,
        gamman: gamma,
        gammat: gamma,
        force,
        torque_i,
        torque_j,
        ..Response::default()
    }
}

fn params<W: Law>(r: &Recipe, c: &Case) -> W::Params {
    let coeffs = W::Params::coeffs(&r.setups[0].pair(c.types.0, c.types.1)).expect("usual values");
    W::Params::new(&coeffs, &c.contact.close.size())
}

fn one_by_one<W: Law>(r: &Recipe, call: &Call, cases: &[Case]) -> Vec<Bits> {
    let one = |c: &Case| {
        let mut h = W::History::zero::<f64>();
        W::History::lanes_mut::<f64>(&mut h).copy_from_slice(&c.history);
        let mut s = handed_on(c);
        W::intersect::<f64>(&params::<W>(r, c), call, &c.contact.surface, &mut h, &mut s);
        bits(&s, W::History::lanes::<f64>(&h), 0)
    };
    cases.iter().map(one).collect()
}

/// As many cases as the lane is wide, at once.
fn at_once<W: Law, L: Lane>(r: &Recipe, call: &Call, cases: &[Case]) -> Vec<Bits> {
    let number = |of: &dyn Fn(&Case) -> f64| L::from_fn(|k| of(&cases[k]));
    let vector = |of: &dyn Fn(&Case) -> Vector3<f64>| Vector3::from_fn(|a, _| number(&|c| of(c)[a]));
    let x = Surface {
        r: number(&|c| c.contact.surface.r),
        deltan: number(&|c| c.contact.surface.deltan),
        vn: number(&|c| c.contact.surface.vn),
        en: vector(&|c| c.contact.surface.en),
        vtr: vector(&|c| c.contact.surface.vtr),
        roll: vector(&|c| c.contact.surface.roll),
        cri: number(&|c| c.contact.surface.cri),
        crj: number(&|c| c.contact.surface.crj),
    };
    let mut s = Response {
        fn_: number(&|c| handed_on(c).fn_),
        kn: number(&|c| handed_on(c).kn),
        kt: number(&|c| handed_on(c).kt),
        gamman: number(&|c| handed_on(c).gamman),
        gammat: number(&|c| handed_on(c).gammat),
        force: vector(&|c| handed_on(c).force),
        torque_i: vector(&|c| handed_on(c).torque_i),
        torque_j: vector(&|c| handed_on(c).torque_j),
        ..Response::default()
    };
    let params: Vec<_> = cases.iter().map(|c| params::<W>(r, c)).collect();
    let mut h = W::History::zero::<L>();
    for (k, slot) in W::History::lanes_mut::<L>(&mut h).iter_mut().enumerate() {
        *slot = number(&|c| c.history[k]);
    }
    W::intersect::<L>(&W::Params::side_by_side::<L>(|k| params[k]), call, &x, &mut h, &mut s);
    (0..L::WIDTH).map(|k| bits(&s, W::History::lanes(&h), k)).collect()
}

fn bits<L: Lane>(s: &Response<L>, h: &[L], k: usize) -> Bits {
    let scalars = [s.fn_, s.kn, s.kt, s.gamman, s.gammat, s.kc, s.fo];
    let vectors = [s.force, s.torque_i, s.torque_j];
    let all = scalars.iter().chain(vectors.iter().flatten()).chain(h);
    all.map(|x| x.lane(k).to_bits()).collect()
}

fn same<W: Law, L: Lane>(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    let cases = batch(c, d, L::WIDTH);
    // A batch belongs to one pair of types with the same switches; the call is the same for all.
    let call = c.contact.close.call;
    let (alone, together) = (one_by_one::<W>(r, &call, &cases), at_once::<W, L>(r, &call, &cases));
    match (0..L::WIDTH).find(|k| alone[*k] != together[*k]) {
        None => Ok(()),
        Some(k) => Err(format!(
            "lane {k} of {} differs from the contact alone: {:x?} {:x?} {:?}",
            L::WIDTH,
            alone[k],
            together[k],
            cases[k]
        )),
    }
}

fn every_width<W: Law>(r: &Recipe, c: &Case, d: &mut Draw<'_>) -> Outcome {
    same::<W, Pack<1>>(r, c, d)?;
    same::<W, Pack<4>>(r, c, d)?;
    same::<W, Pack<8>>(r, c, d)
}

type LaneCheck = fn(&Recipe, &Case, &mut Draw<'_>) -> Outcome;

/// The check above for every law with lanes.
#[derive(Clone, Copy, Debug)]
struct Checked;

impl ForLanes for Checked {
    type Made = LaneCheck;
    fn make<W: Law>() -> LaneCheck {
        every_width::<W>
    }
}

#[test]
fn lanes_answer_as_single_contacts_do_to_the_last_bit() {
    let mut n = 0;
    for entry in LAWS {
        // Which form of a law it is hangs on the settings.
        let check: Check = |r, c, d| made::<Checked>(&r.setups[0]).map_or(Ok(()), |check| check(r, c, d));
        for_all(&chain_of(&[entry.meta.keyword]), Switches::Any, 1000, None, check)
            .unwrap_or_else(|e| panic!("{}: {e}", entry.meta.keyword));
        n += usize::from(entry.meta.reach == Reach::Overlap);
    }
    assert!(n >= 7, "only {n} laws with lanes");
}

/// Coulomb friction whose batch lets all lanes slip where one does.
struct AllSlip;

impl Law for AllSlip {
    type Params = ();
    type History = [f64; 0];
    const META: Meta = NoHistory::META;

    fn intersect<L: Lane>(_: &(), _: &Call, x: &Surface<L>, _: &mut [L; 0], s: &mut Response<L>) {
        let speed = granlaw::lane::norm(&x.vtr);
        let coulomb = L::splat(0.1) * s.fn_.abs();
        let viscous = s.gammat * speed;
        let size = if L::any(viscous.gt(coulomb)) { coulomb } else { viscous };
        s.force -= x.en * size;
    }
    fn observe(_: &(), _: &Contact, _: &[f64; 0]) -> Observation {
        Observation::default()
    }
}

#[test]
fn a_branch_taken_for_all_lanes_because_of_one_is_seen() {
    let chain = chain_of(&["no_history"]);
    let error = for_all(&chain, Switches::Any, 1000, None, every_width::<AllSlip>).unwrap_err();
    assert!(error.contains("differs from the contact alone"), "{error}");
    for_all(&chain, Switches::Any, 1000, None, same::<AllSlip, Pack<1>>).unwrap();
}
