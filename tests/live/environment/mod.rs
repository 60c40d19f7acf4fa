//! The environment: every variable that the sources read stands in the list, and none that is not named changes a verdict.
mod run;
mod sources;
mod verdicts;

use granlaw_tools::codes::environment::{Reader, VARIABLES};

/// A value for each variable of the plugin that it refuses or that stops a recorded run.
fn disturbing() -> Vec<(&'static str, &'static str)> {
    let value = |name| match name {
        "GRANLAW_LAWS" => "rusty",
        "GRANLAW_RECORD" => "no/where/trace.csv",
        "GRANLAW_EVERY" => "0",
        "GRANLAW_PATH" => "batched",
        "GRANLAW_LANES" => "3",
        "GRANLAW_PROBE" => "no/where/scene.json",
        "GRANLAW_SHADOW" => "perhaps",
        "GRANLAW_TOLERANCE" => "much",
        "GRANLAW_FOLLOW" => "some",
        "GRANLAW_STEPS" => "0",
        "GRANLAW_TIMESTEP" => "loud",
        "GRANLAW_DECK" => "another.in",
        other => panic!("{other}: which value of it would disturb a run?"),
    };
    let read = VARIABLES.iter().filter(|v| v.reader == Reader::Plugin);
    read.map(|v| (v.name, value(v.name))).collect()
}
