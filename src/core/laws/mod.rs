//! Every law, one file each.
use crate::law::{Alone, Entry, ForLanes, Kind};

pub mod bond_nonlinear;
pub mod cdt;
pub mod cdt_jkr;
pub mod formulas;
pub mod hertz;
pub mod history;
pub mod hooke;
pub mod hooke_hysteresis;
pub mod no_history;
pub mod prop;
pub mod table;
pub mod timing;

/// All laws, one line each, with what `U` makes of those that have lanes. A law that is not here does not exist.
pub const fn all<U: ForLanes>() -> &'static [Entry<U>] {
    const {
        &[
            Entry::lanes::<hooke::Hooke>(),
            Entry::lanes::<hertz::Hertz>(),
            Entry::lanes::<hooke_hysteresis::HookeHysteresis>(),
            Entry::scalar::<bond_nonlinear::BondNonlinear>(),
            Entry::lanes::<no_history::NoHistory>(),
            Entry::lanes::<history::History>(),
            Entry::lanes::<cdt::Cdt>(),
            Entry::lanes::<cdt_jkr::CdtJkr>(),
        ]
    }
}

/// All laws.
pub static LAWS: &[Entry] = all::<Alone>();

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
            assert!(seen.insert((e.meta.kind, format!("id {}", e.meta.id))), "id {} twice", e.meta.id);
            assert!(e.meta.stock_id.is_none_or(|id| id < 16), "{}", e.meta.keyword);
        }
    }

    #[test]
    fn a_law_is_found_by_either_name() {
        assert_eq!(find(Kind::Normal, "hooke/hysteresis/rs").unwrap().meta.keyword, "hooke/hysteresis");
        assert!(find(Kind::Rolling, "hooke").is_none());
    }
}
