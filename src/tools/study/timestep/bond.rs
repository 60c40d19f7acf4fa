//! Bonds: the modes of two bodies that a bond holds, and of many that hold each other.
use super::limit::{Asked, Contact, Limit};
use crate::probe::ParticleType;
use granlaw::chain::Chain;
use granlaw::model::Mode;

/// A kind of bond with its limits; `None` where these types do not bond.
pub(super) fn of(
    chain: &mut Chain,
    (who, laws): (&str, &str),
    types: [usize; 2],
    (gi, gj): (&ParticleType, Option<&ParticleType>),
    speed: f64,
    asked: &Asked,
) -> Option<Contact> {
    let kinds = (types[0] - 1, types[1] - 1);
    let looked = gi.sizes(gj).into_iter().map(|size| {
        let modes = chain.modes(kinds, &size, speed);
        let limits: Vec<Limit> = modes.into_iter().map(|m| limit(m.name, m.rotational, m.mode)).collect();
        (size, limits)
    });
    let shortest = |limits: &[Limit]| limits.iter().map(|l| l.critical).fold(f64::INFINITY, f64::min);
    let (size, limits) = looked.min_by(|a, b| shortest(&a.1).total_cmp(&shortest(&b.1)))?;
    let fastest = limits.iter().min_by(|a, b| a.critical.total_cmp(&b.critical))?;
    Some(Contact {
        who: who.into(),
        types,
        laws: laws.into(),
        speed,
        radii: [size.radi, size.radj],
        together: Some(together(fastest, asked.bonds)),
        accurate: None,
        limits,
    })
}

fn limit(name: &'static str, turns: bool, mode: Mode) -> Limit {
    Limit { name, turns, mode, critical: mode.step(), safe: mode.safe_bond() }
}

/// The fastest mode if every particle has this many bonds like the fastest of two bodies alone. As λmax of the whole is at most twice the
/// largest λmax(Mi⁻¹ ΣKii) of a particle, ω² is at most that many times as large. A long chain, with two bonds on each particle, does
/// reach that limit.
fn together(fastest: &Limit, bonds: u32) -> Limit {
    let mode = Mode { stiffness: f64::from(bonds) * fastest.mode.stiffness, ..fastest.mode };
    limit("many on each", fastest.turns, mode)
}
