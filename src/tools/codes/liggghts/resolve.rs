//! What LIGGGHTS makes of a deck.
use super::{Laws, Liggghts, Plugin, Preload};
use crate::codes::{run, Folder, Run, RunError};
use crate::deck::Deck;
use crate::probe::Probe;
use std::time::Duration;

/// The first steps of a deck, watched: laws, coefficients and particles as LIGGGHTS resolves them, and what its contacts do. It
/// runs in a folder of its own, on LIGGGHTS's own laws where they have the deck's names.
///
/// # Errors
/// It cannot be run, or `limit` is over.
pub fn resolve(
    host: &Liggghts,
    plugin: &Plugin,
    deck: &Deck,
    steps: u64,
    limit: Duration,
) -> Result<Probe, RunError> {
    let folder = Folder::new(deck)?;
    if let Some(before) = deck.first().map_err(|e| RunError::Deck(e.to_string()))? {
        let environment = Preload::new(plugin, Laws::Own).env();
        run(host, &Run { deck: &before, environment, limit }, &folder)?;
    }
    let path = folder.path().join("granlaw-probe.json");
    let preload =
        Preload { probe: Some(path.clone()), steps: Some(steps), ..Preload::new(plugin, Laws::Stock) };
    run(host, &Run { deck, environment: preload.env(), limit }, &folder)?;
    Ok(Probe::read(&path)?)
}
