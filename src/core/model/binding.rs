//! How a law stands in LIGGGHTS: numbers, names and habits that are the host's and no physics.
use super::Setting;

/// What a law does to the flag by which LIGGGHTS keeps a pair's history across a neighbour rebuild.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactFlag {
    /// Sets it: the history is to be kept.
    Set,
    /// Clears it.
    Clear,
    /// Leaves it as it is.
    #[default]
    Leave,
}

/// How far LIGGGHTS's name and ours share a setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// Does the same under our name and under the stock name.
    Full,
    /// Ours alone: not offered where the law has taken over a stock name.
    OwnOnly,
    /// Works under our name; the stock law reads it and ignores it, so the taken-over law does too and says so.
    StockIgnores,
    /// Known to LIGGGHTS, not done here: refused when it is switched on.
    Refused,
}

/// How a law is bound to LIGGGHTS.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// The number under which the plugin registers `<keyword>/rs`: 48 to 63, unique among the laws of a kind.
    pub id: u8,
    /// The number of LIGGGHTS's own law of that name, if it has one: below 16.
    pub stock_id: Option<u8>,
    /// Settings that LIGGGHTS's own law lacks.
    pub own_settings: &'static [&'static str],
    /// Settings that LIGGGHTS's own law reads and ignores.
    pub ignored: &'static [&'static str],
    /// Settings of LIGGGHTS's own law that are not done here; `doc` says why.
    pub refused: &'static [Setting],
    /// The contact flag after an evaluation in which surfaces overlap, and after one in which they do not. Not read of a
    /// law that acts across gaps, which says it in every evaluation.
    pub contact_flags: [ContactFlag; 2],
}

impl Binding {
    /// A law that no LIGGGHTS knows, such as one of another crate.
    pub const NONE: Binding = Binding::new(0, None);

    /// A law with these numbers whose settings all do the same as LIGGGHTS's, and that keeps a history while surfaces
    /// overlap.
    pub const fn new(id: u8, stock_id: Option<u8>) -> Binding {
        let contact_flags = [ContactFlag::Set, ContactFlag::Clear];
        Binding { id, stock_id, own_settings: &[], ignored: &[], refused: &[], contact_flags }
    }
}
