//! How much of its strength a bond uses, as a probe is told it.
use super::bench::{Deck, Driven};
use granlaw::model::BondEvent;
use nalgebra::Vector3;

const BEGUN: f64 = 1.02e-3;
const STIFFNESS: f64 = 1e10;

/// The part used after a pull, and whether the bond still holds.
fn pulled(deck: &Deck, to: f64) -> (f64, bool) {
    let mut pair = Driven::pair(deck, Vector3::x() * BEGUN);
    pair.place(Vector3::x() * to);
    (pair.used(), pair.bond_event != BondEvent::Ends)
}

fn by_stress(sigma: f64, tau: f64) -> Deck {
    let deck = Deck::documented().with("stressBreak", "on");
    deck.set("maxSigmaBondnonlinear", sigma).set("maxTauBondnonlinear", tau)
}

#[test]
fn stress_over_strength_reaches_one_where_the_bond_breaks() {
    let stress = |to: f64| STIFFNESS * (to - BEGUN);
    for (to, part) in [(1.021e-3, 0.2), (1.024e-3, 0.8), (1.025e-3, 1.0 - 1e-9)] {
        let (used, holds) = pulled(&by_stress(stress(1.025e-3) * (1.0 + 1e-9), 1e9), to);
        assert!(holds && (used - part).abs() < 1e-8, "{to}: {used}");
    }
    // Half the strength is used twice as much, and is too little where 4/5 of the whole were used.
    let half = by_stress(0.5 * stress(1.025e-3), 1e9);
    let (used, holds) = pulled(&half, 1.022e-3);
    assert!(holds && (used - 0.8).abs() < 1e-8, "{used}");
    assert!(!pulled(&half, 1.024e-3).1);
}

#[test]
fn shear_and_bending_use_strength_too() {
    let sheared = |deck: &Deck| {
        let mut pair = Driven::pair(deck, Vector3::x() * BEGUN);
        (0..20).for_each(|_| pair.step(Vector3::zeros(), Vector3::z() * 100.0, Vector3::z() * 100.0));
        pair.used()
    };
    let (strong, weak) = (sheared(&by_stress(1e12, 2e9)), sheared(&by_stress(1e12, 1e9)));
    assert!(strong > 0.0 && (weak / strong - 2.0).abs() < 1e-9, "{weak} {strong}");
    let bent = |sigma: f64| {
        let mut pair = Driven::pair(&by_stress(sigma, 1e12), Vector3::x() * BEGUN);
        (0..20).for_each(|_| pair.step(Vector3::zeros(), Vector3::z() * 100.0, Vector3::z() * -100.0));
        pair.used()
    };
    assert!(bent(1e9) > 0.0 && (bent(1e9) / bent(2e9) - 2.0).abs() < 1e-9);
}

#[test]
fn by_distance_it_is_the_way_to_where_it_tears() {
    let deck = Deck::documented();
    let (used, holds) = pulled(&deck, 1.2e-3);
    assert!(holds && (used - (1.2e-3 - BEGUN) / (1.5e-3 - BEGUN)).abs() < 1e-9, "{used}");
    assert_eq!(pulled(&deck, BEGUN - 1e-5).0, 0.0);
}
