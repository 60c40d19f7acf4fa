//! A scene on the terminal.
use super::page::word;
use super::scene::{quartiles, Scene, Side};
use crate::report::page::Spread;
use crate::report::Outcome;

/// A few lines on a scene.
pub fn table(scene: &Scene) -> String {
    let mut text = format!("{}: {}\n", scene.label(), facts(scene));
    text += &format!(
        "  {:<16} {:>9} {:>9} {:>8}  {:<22} {:<22}\n",
        "", "Pair [s]", "Loop [s]", "ns each", "Pair / stock", "Loop / stock"
    );
    for timed in &scene.sides {
        let median =
            |v: &[f64]| quartiles(v.iter().copied()).map_or("–".into(), |s| format!("{:.3}", s.at));
        let ratios = scene.ratios(timed, Side::Stock).filter(|_| timed.side != Side::Stock);
        text += &format!(
            "  {:<16} {:>9} {:>9} {:>8}  {:<22} {:<22} {}\n",
            timed.side.to_string(),
            median(&timed.pair),
            median(&timed.whole),
            scene.per_contact(timed).map_or("–".into(), |s| format!("{:.1}", s.at)),
            ratios.map_or(String::new(), |r| range(r.0)),
            ratios.map_or(String::new(), |r| range(r.1)),
            word(timed),
        );
    }
    let ours = scene.side(Side::Batched).and_then(|t| scene.ratios(t, Side::Lammps));
    if let Some((pair, whole)) = ours {
        text += &format!("  batched / LAMMPS: Pair {}, Loop {}\n", range(pair), range(whole));
    }
    text
}

fn facts(scene: &Scene) -> String {
    let mut facts = Vec::new();
    if let Some(c) = scene.clock {
        facts.push(format!("{} spheres, {} steps, {} rebuilds", c.particles, c.steps, c.builds));
    }
    facts.extend(scene.contacts().map(|n| format!("{n:.0} contacts a step")));
    facts.extend(scene.memory().map(|n| format!("{n:.0} bytes per neighbour")));
    facts.extend(scene.lanes.clone());
    facts.join(", ")
}

/// The median with its quartiles.
fn range(s: Spread) -> String {
    format!("{:.3} ({:.3}–{:.3})", s.at, s.low, s.high)
}

/// The result of the whole benchmark, in words.
pub fn summary(scenes: &[Scene]) -> String {
    let count =
        |f: fn(&Outcome) -> bool| scenes.iter().flat_map(|s| &s.sides).filter(|t| f(&t.outcome)).count();
    let other = count(|o| matches!(o, Outcome::Disagreed(_)));
    let (skipped, failed) =
        (count(|o| matches!(o, Outcome::Skipped(_))), count(|o| matches!(o, Outcome::CouldNotRun(_))));
    format!(
        "{} sides wrote stock's dumps to the last bit, {other} did not, {failed} could not run, {skipped} were not compared\n",
        count(|o| *o == Outcome::Agreed) - scenes.iter().filter(|s| s.sides[0].outcome == Outcome::Agreed).count()
    )
}
