//! Every law, one file each.
use crate::model::{Alone, Entry, ForLanes, Kind, Setup};
use dashpot::Viscous;
use hooke_hysteresis::HookeHysteresis;

pub mod bond_nonlinear;
pub mod cdt;
pub mod cdt_jkr;
pub mod dashpot;
pub mod formulas;
pub mod friction;
pub mod hertz;
pub mod history;
pub mod hooke;
pub mod hooke_hysteresis;
pub mod no_history;
pub mod normal;
pub mod prop;
pub mod table;
pub mod timing;

/// All laws, one line each, with what `U` makes of those over lanes. A law that is not here answers to no name.
pub const fn all<U: ForLanes>() -> &'static [Entry<U>] {
    const {
        &[
            Entry::law::<hooke::Hooke>().or_with::<hooke::Hooke<Viscous>>("viscous", "on"),
            Entry::law::<hertz::Hertz>(),
            Entry::law::<HookeHysteresis>().or_with::<HookeHysteresis<Viscous>>("viscous", "on"),
            Entry::gap_law::<bond_nonlinear::BondNonlinear>(),
            Entry::law::<no_history::NoHistory>(),
            Entry::law::<history::History>(),
            Entry::law::<cdt::Cdt>(),
            Entry::law::<cdt_jkr::CdtJkr>(),
        ]
    }
}

/// All laws.
pub static LAWS: &[Entry] = all::<Alone>();

/// What `U` makes of a law as it is set up; nothing of one that is not in [`LAWS`] or has no lanes.
pub fn made<U: ForLanes>(setup: &Setup) -> Option<U::Made> {
    let law = (setup.law.meta.kind, setup.law.meta.keyword);
    all::<U>().iter().find(|e| (e.meta.kind, e.meta.keyword) == law)?.make(setup)
}

/// The law of a kind with a name, given as LIGGGHTS has it (`hooke`) or as our own (`hooke/rs`).
pub fn find(kind: Kind, name: &str) -> Option<&'static Entry> {
    let keyword = name.strip_suffix("/rs").unwrap_or(name);
    LAWS.iter().find(|e| e.meta.kind == kind && e.meta.keyword == keyword)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn names_and_numbers_are_unique_within_a_kind() {
        let mut seen = HashSet::new();
        for e in LAWS {
            assert!(seen.insert((e.meta.kind, e.meta.keyword.to_string())), "{} twice", e.meta.keyword);
            let id = e.liggghts.id;
            assert!(seen.insert((e.meta.kind, format!("id {id}"))), "id {id} twice");
            assert!((48..64).contains(&id), "{}: own numbers are 48 to 63", e.meta.keyword);
            assert!(e.liggghts.stock_id.is_none_or(|id| id < 16), "{}", e.meta.keyword);
        }
    }

    #[test]
    fn a_law_is_found_by_either_name() {
        assert_eq!(find(Kind::Normal, "hooke/hysteresis/rs").unwrap().meta.keyword, "hooke/hysteresis");
        assert!(find(Kind::Rolling, "hooke").is_none());
    }
}
