//! The document of a benchmark.
use super::scene::{quartiles, Options, Scene, Side, Timed};
use crate::codes::liggghts::{Liggghts, Plugin};
use crate::codes::Code;
use crate::report::page::{Bars, Cell, Group, Item, Page, Section, Spread, Table};
use crate::report::{About, Check, Outcome, Shows, Tolerance};
use std::fs;

/// Everything that was measured, as a document.
pub fn page(
    scenes: &[Scene],
    options: &Options,
    (host, plugin): (&Liggghts, &Plugin),
    load: [f64; 2],
) -> Page {
    Page {
        program: "granlaw bench".into(),
        headline: headline(scenes),
        about: about(scenes, options, (host, plugin), load),
        checks: scenes.iter().flat_map(checks).collect(),
        sections: vec![
            Section {
                title: "Time for pair contacts".into(),
                text: vec![format!(
                    "Medians of {} interleaved rounds; ratios are those of runs of the same round, bars reach over their quartiles. \
                     Time per contact is processor time.",
                    options.pairs
                )],
                items: vec![Item::Bars(bars(scenes)), Item::Table(short(scenes)), Item::Table(long(scenes))],
            },
            Section { title: "Scenes".into(), text: Vec::new(), items: vec![Item::Table(facts(scenes))] },
        ],
    }
}

fn headline(scenes: &[Scene]) -> String {
    // Only where the batched side wrote the same dumps as stock.
    let batched = |s: &Scene| s.side(Side::Batched).filter(|t| t.outcome == Outcome::Agreed).cloned();
    let ratio = |s: &Scene| Some(s.ratios(&batched(s)?, Side::Stock)?.0.at);
    let ratios: Vec<f64> = scenes.iter().filter_map(ratio).collect();
    match (ratios.iter().copied().reduce(f64::min), ratios.iter().copied().reduce(f64::max)) {
        (Some(low), Some(high)) => {
            format!("Batched, the same bits take {low:.2} to {high:.2} of LIGGGHTS's time for pair contacts")
        }
        _ => "Nothing ran batched".into(),
    }
}

fn about(scenes: &[Scene], options: &Options, (host, plugin): (&Liggghts, &Plugin), load: [f64; 2]) -> About {
    let mut lanes: Vec<_> = scenes.iter().filter_map(|s| s.lanes.clone()).collect();
    lanes.dedup();
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut notes: Vec<_> = lanes.iter().map(|l| format!("batched is {l}")).collect();
    notes.extend(options.lammps.iter().map(|l| format!("{} {}", l.name(), l.version())));
    notes.push(format!("load of the machine: {:.2} at the beginning, {:.2} at the end", load[0], load[1]));
    About {
        granlaw: env!("CARGO_PKG_VERSION").into(),
        liggghts: Some(host.version.clone()),
        plugin: Some(plugin.path.display().to_string()),
        machine: format!("{}, {cores} cores", processor()),
        command: options.command.clone(),
        notes,
    }
}

/// The name of the processor.
fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':'));
    model.map_or(std::env::consts::ARCH.into(), |(_, name)| name.trim().to_string())
}

/// The load of the machine: the average number of processes that wanted to run over the last minute.
pub fn load() -> f64 {
    let text = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    text.split(' ').next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN)
}

/// One check for all sides that wrote the same dumps as stock, and one for each of the others.
fn checks(scene: &Scene) -> Vec<Check> {
    let check = |name, outcome| Check {
        name,
        shows: Shows::Boundary,
        outcome,
        tolerance: Some(Tolerance {
            limit: 0.0,
            reason: "a faster way to the same forces must not change a bit of the run".into(),
        }),
        worst: None,
    };
    let agreed = |t: &&Timed| t.outcome == Outcome::Agreed && t.side != Side::Stock;
    let same: Vec<_> = scene.sides.iter().filter(agreed).map(|t| t.side.to_string()).collect();
    let others = scene.sides.iter().filter(|t| t.outcome != Outcome::Agreed);
    let others = others.map(|t| check(format!("{}: {}", scene.label(), t.side), t.outcome.clone()));
    let same =
        (!same.is_empty()).then(|| check(format!("{}: {}", scene.label(), same.join("; ")), Outcome::Agreed));
    same.into_iter().chain(others).collect()
}

/// The sides that appear in any scene, in the order in which they first do.
fn sides(scenes: &[Scene]) -> Vec<Side> {
    let mut found = Vec::new();
    for timed in scenes.iter().flat_map(|s| &s.sides).filter(|t| !t.pair.is_empty()) {
        if !found.contains(&timed.side) {
            found.push(timed.side);
        }
    }
    found
}

fn bars(scenes: &[Scene]) -> Bars {
    let sides: Vec<_> = sides(scenes).into_iter().filter(|s| *s != Side::Stock).collect();
    let group = |scene: &Scene| {
        let bar = |(k, side): (usize, &Side)| Some((k, scene.ratios(scene.side(*side)?, Side::Stock)?.0));
        Group { name: scene.label(), bars: sides.iter().enumerate().filter_map(bar).collect() }
    };
    Bars {
        name: "pair".into(),
        caption: "Time for pair contacts, LIGGGHTS's own laws = 1".into(),
        label: "Pair time / Pair time of stock LIGGGHTS".into(),
        series: sides.iter().map(ToString::to_string).collect(),
        groups: scenes.iter().map(group).collect(),
    }
}

/// The short table, with a line per scene.
fn short(scenes: &[Scene]) -> Table {
    let sides = sides(scenes);
    let mut columns = vec!["scene".to_string()];
    columns.extend(sides.iter().map(|s| format!("{s} [ns]")));
    columns.extend(["Pair, batched/stock", "Loop, batched/stock"].map(String::from));
    let row = |scene: &Scene| {
        let cost = |side: &Side| scene.side(*side).and_then(|t| scene.per_contact(t));
        let ratios = scene.side(Side::Batched).and_then(|t| scene.ratios(t, Side::Stock));
        let mut row = vec![Cell::from(scene.label())];
        row.extend(sides.iter().map(|s| number(cost(s))));
        row.extend([number(ratios.map(|r| r.0)), number(ratios.map(|r| r.1))]);
        row
    };
    Table {
        name: "contacts".into(),
        caption: "Time per contact, and parts of the time that LIGGGHTS's own laws take".into(),
        columns,
        rows: scenes.iter().map(row).collect(),
    }
}

fn number(spread: Option<Spread>) -> Cell {
    spread.map_or(Cell::from("–"), |s| Cell::Number(s.at))
}

/// The full table, with a line per scene and side.
fn long(scenes: &[Scene]) -> Table {
    let heads = [
        "scene",
        "ranks",
        "side",
        "Pair [s]",
        "Loop [s]",
        "per contact [ns]",
        "Pair/stock",
        "low",
        "high",
        "Loop/stock",
        "low",
        "high",
        "rounds",
        "dump",
    ];
    let row = |scene: &Scene, timed: &Timed| {
        let median = |v: &[f64]| number(quartiles(v.iter().copied()));
        let mut row =
            vec![scene.name.clone().into(), Cell::Count(scene.ranks as u64), timed.side.to_string().into()];
        row.extend([median(&timed.pair), median(&timed.whole), number(scene.per_contact(timed))]);
        let ratios = scene.ratios(timed, Side::Stock).filter(|_| timed.side != Side::Stock);
        for spread in [ratios.map(|r| r.0), ratios.map(|r| r.1)] {
            let of = |f: fn(Spread) -> f64| spread.map_or(Cell::from("–"), |s| Cell::Number(f(s)));
            row.extend([of(|s| s.at), of(|s| s.low), of(|s| s.high)]);
        }
        row.extend([Cell::Count(timed.pair.len() as u64), word(timed).into()]);
        row
    };
    Table {
        name: "sides".into(),
        caption: "All sides: medians, and the quartiles of the ratios".into(),
        columns: heads.map(String::from).to_vec(),
        rows: scenes.iter().flat_map(|s| s.sides.iter().map(move |t| row(s, t))).collect(),
    }
}

/// Whether the dumps of a side agree, in a word.
pub(super) fn word(timed: &Timed) -> String {
    match &timed.outcome {
        Outcome::Agreed if timed.side == Side::Stock => "the measure".into(),
        Outcome::Agreed => "identical".into(),
        Outcome::Disagreed(why) => format!("DIFFERS: {why}"),
        Outcome::Skipped(why) => why.clone(),
        Outcome::CouldNotRun(why) => format!("COULD NOT RUN: {why}"),
    }
}

fn facts(scenes: &[Scene]) -> Table {
    let heads = [
        "scene",
        "what it is",
        "ranks",
        "spheres",
        "steps",
        "contacts per step",
        "neighbours",
        "rebuilds",
        "bytes per neighbour",
    ];
    let row = |s: &Scene| {
        let count = |n: Option<u64>| n.map_or(Cell::from("–"), Cell::Count);
        let (clock, account) = (s.clock, s.account);
        vec![
            s.name.clone().into(),
            s.title.clone().into(),
            Cell::Count(s.ranks as u64),
            count(clock.map(|c| c.particles)),
            count(clock.map(|c| c.steps)),
            count(s.contacts().map(|n| n.round() as u64)),
            count(account.map(|a| a.neighbours)),
            count(clock.map(|c| c.builds)),
            count(s.memory().map(|b| b.round() as u64)),
        ]
    };
    Table {
        name: "scenes".into(),
        caption: "The scenes; the last column is what the batched path keeps beside LIGGGHTS's own arrays"
            .into(),
        columns: heads.map(String::from).to_vec(),
        rows: scenes.iter().map(row).collect(),
    }
}
