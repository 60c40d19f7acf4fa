//! `granlaw advise`: how simple a model a scene bears, and how large a step.
use anyhow::Context;
use granlaw::advise::{self, Options};
use granlaw::deck::Deck;
use granlaw::liggghts::{self, Folder, Host, Laws, Plugin, Preload};
use granlaw::probe::Probe;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// Find the simplest model and the largest step that a scene bears.
///
/// The deck runs once with a probe in it, which counts what its contacts do. Examples of every important class of contacts
/// are then lived through again by two bodies, with simpler laws (fitted where a property stands for an effect) and with
/// larger steps. What stays within the accuracy in every class is good enough; the cheapest is recommended, with the
/// measurement behind it. Nothing is recommended that was not tried.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw advise deck.in
  granlaw run --probe scene.json -- -in deck.in && granlaw advise scene.json
  granlaw advise scene.json --accuracy 0.05 --time-accuracy 0.5

Exit status: 0 there is advice, 1 no model that was tried is within the accuracy, 2 something could not run.")]
pub struct Args {
    /// A deck, or a probe that `granlaw run --probe` wrote.
    #[arg(value_name = "DECK|PROBE")]
    scene: PathBuf,
    /// Largest error of restitution (absolute), contact time (relative) and spin (over the impact speed), in every
    /// important class of contacts.
    #[arg(long, value_name = "ERROR", default_value_t = 0.02, value_parser = error)]
    accuracy: f64,
    /// Largest error of contact times, where they matter less; by default as --accuracy.
    #[arg(long, value_name = "ERROR", value_parser = error)]
    time_accuracy: Option<f64>,
    /// Write everything that was found to this file as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Stop a run that takes longer than this.
    #[arg(long, value_name = "SECONDS", default_value_t = 3600.0, value_parser = crate::verify::seconds)]
    time_limit: f64,
}

fn error(text: &str) -> Result<f64, String> {
    let limit = text.parse().ok().filter(|x: &f64| *x > 0.0 && *x < 1.0);
    limit.ok_or("must be a number between 0 and 1, such as 0.02".into())
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let probe = match is_probe(&args.scene)? {
        true => Probe::read(&args.scene)?,
        false => probed(args)?,
    };
    let options =
        Options { accuracy: args.accuracy, time: args.time_accuracy.map_or(1.0, |t| t / args.accuracy) };
    let (advice, _) = advise::advise(&probe, options)?;
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(&advice)?;
        std::fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    crate::print(&advise::text(&advice));
    Ok(ExitCode::from(u8::from(advice.chosen.is_none())))
}

/// A probe is JSON, and a deck is not.
fn is_probe(path: &Path) -> anyhow::Result<bool> {
    let mut first = [0u8];
    let mut file = std::fs::File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(file.read(&mut first)? == 1 && first == *b"{")
}

/// Runs the deck in a folder of its own.
fn probed(args: &Args) -> anyhow::Result<Probe> {
    ctrlc::set_handler(liggghts::interrupt).context("cannot watch for Ctrl-C")?;
    let deck = Deck::read(&args.scene)?;
    let (host, plugin) = (Host::find()?, Plugin::find()?);
    eprintln!("granlaw: plugin {}", plugin.path.display());
    let folder = Folder::new(&deck)?;
    let path = folder.path().join("granlaw-probe.json");
    let preload = Preload {
        plugin: &plugin,
        laws: Laws::Stock,
        record: None,
        every: 1,
        probe: Some(path.clone()),
        deck: Some(deck.file()),
        route: None,
    };
    folder.run(&host, &deck, Some(&preload), Duration::from_secs_f64(args.time_limit))?;
    Ok(Probe::read(&path)?)
}
