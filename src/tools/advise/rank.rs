//! What each term of the laws contributes to a scene, from the probe alone.
use crate::probe::{Contacts, Probe};
use serde::Serialize;

/// A term of the laws of a scene.
#[derive(Clone, Debug, Serialize)]
pub struct Term {
    /// The chain: `pair` or `wall ID`.
    pub who: String,
    /// The law, or its dashpot, which is a term of its own; a direction where the laws have no Rust twins.
    pub term: String,
    /// Its share of the work that all contacts took out of the motion; negative where it gave some back.
    pub dissipated: f64,
    /// Its share of the momentum that all contacts exchanged.
    pub impulse: f64,
    /// Its share of the angular momentum exchanged by torques that are not the lever of a force; 0 if there are none.
    pub turn: f64,
}

/// All terms; the one that dissipates most comes first.
pub fn rank(probe: &Probe) -> Vec<Term> {
    let mut terms: Vec<Term> = probe.chains.iter().flat_map(of).collect();
    let sum = |f: &dyn Fn(&Term) -> f64| terms.iter().map(f).sum::<f64>();
    let (work, impulse, turn) = (sum(&|t| t.dissipated), sum(&|t| t.impulse), sum(&|t| t.turn));
    for t in &mut terms {
        for (x, of) in [(&mut t.dissipated, work), (&mut t.impulse, impulse), (&mut t.turn, turn)] {
            *x = if of > 0.0 { *x / of } else { 0.0 };
        }
    }
    terms.sort_by(|a, b| b.dissipated.total_cmp(&a.dissipated));
    terms
}

/// The terms of a chain in J, N s and N m s, summed over its pairs of types.
fn of(c: &Contacts) -> Vec<Term> {
    let term = |term: String, dissipated: f64, impulse: f64, turn: f64| Term {
        who: c.header.who.clone(),
        term,
        dissipated,
        impulse,
        turn,
    };
    let sum = |f: &dyn Fn(&crate::probe::TypePair) -> f64| c.pairs.iter().map(f).sum::<f64>();
    if c.pairs.iter().all(|p| p.laws.is_empty()) {
        return vec![
            term("normal force".into(), -sum(&|p| p.work.normal), sum(&|p| p.impulse.normal), 0.0),
            term(
                "tangential force".into(),
                -sum(&|p| p.work.tangential),
                sum(&|p| p.impulse.tangential),
                0.0,
            ),
            term("rolling".into(), -sum(&|p| p.work.rolling), 0.0, 0.0),
            term("torsion".into(), -sum(&|p| p.work.torsion), 0.0, 0.0),
        ];
    }
    let mut all = Vec::new();
    for (k, law) in c.header.laws.iter().enumerate() {
        let damped = sum(&|p| p.laws[k].damped);
        let name = format!("{} {}", law.kind, law.keyword);
        let (work, impulse) = (-sum(&|p| p.laws[k].work), sum(&|p| p.laws[k].impulse));
        // The torque of a tangential force is the lever of that force, which counts with its impulse.
        let turn = if impulse > 0.0 { 0.0 } else { sum(&|p| p.laws[k].turn) };
        if damped > 0.0 {
            all.push(term(format!("{name}: spring"), work - damped, impulse, turn));
            all.push(term(format!("{name}: dashpot"), damped, 0.0, 0.0));
        } else {
            all.push(term(name, work, impulse, turn));
        }
    }
    all
}
