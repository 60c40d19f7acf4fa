//! LIGGGHTS with the plugin on decks made here.
use crate::built::{alone, built, source};
use crate::common::{Said, Scratch};
use granlaw_tools::codes::environment::VARIABLES;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A scratch folder with a deck and the mesh that decks of bonds use.
pub fn scratch(deck: &str) -> Scratch {
    let s = Scratch::new();
    s.file("deck.in", deck);
    fs::copy(source().join("liggghts_inputs/plane.stl"), s.path("plane.stl")).unwrap();
    s
}

/// Run the deck of a scratch folder, with another library before the plugin if its name is not empty.
pub fn run(s: &Scratch, ranks: usize, library: &str) -> Said {
    let preload = format!("{library} {}", built().join("libgranlaw_liggghts.so").display());
    let mut command = if ranks == 1 {
        let mut command = alone(Path::new("liggghts"), &s.path(""));
        command.env("LD_PRELOAD", &preload);
        command
    } else {
        let mut command = Command::new("mpirun");
        command.current_dir(s.path("")).args(["--allow-run-as-root", "--oversubscribe", "-np"]);
        command.arg(ranks.to_string()).arg("-x").arg(format!("LD_PRELOAD={preload}")).arg("liggghts");
        command
    };
    VARIABLES.iter().for_each(|v| {
        command.env_remove(v.name);
    });
    Said::of(command.args(["-in", "deck.in"]))
}

/// The tables of numbers that LIGGGHTS printed below a line of words that begins with `Step`, by step.
pub fn thermo(said: &Said) -> BTreeMap<u64, Vec<f64>> {
    let mut rows = BTreeMap::new();
    let mut columns = 0;
    for line in said.out.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        if words.first() == Some(&"Step") {
            columns = words.len();
        } else if columns > 0 && words.len() == columns {
            let numbers: Result<Vec<f64>, _> = words.iter().map(|w| w.parse()).collect();
            let Ok(numbers) = numbers else { continue };
            rows.insert(numbers[0] as u64, numbers[1..].to_vec());
        }
    }
    rows
}

/// The frames of a text dump by step: the numbers of each line.
pub fn frames(text: &str) -> BTreeMap<u64, Vec<Vec<f64>>> {
    let mut frames = BTreeMap::new();
    for frame in text.split("ITEM: TIMESTEP\n").skip(1) {
        let step = frame.lines().next().unwrap().parse().unwrap();
        let rows =
            frame.lines().skip_while(|l| !l.starts_with("ITEM: ATOMS") && !l.starts_with("ITEM: ENTRIES"));
        let numbers = |l: &str| l.split_whitespace().map(|w| w.parse().unwrap()).collect();
        frames.insert(step, rows.skip(1).map(numbers).collect());
    }
    frames
}
