//! `granlaw advise`: how simple a model is good enough for a scene, and how large a step.
use crate::console;
use anyhow::{bail, Context};
use granlaw_tools::advise::check::{check, with, CheckError, Deeds, Runner};
use granlaw_tools::advise::fresh::fresh;
use granlaw_tools::advise::rewrite::rewrite;
use granlaw_tools::advise::seeds::seeds;
use granlaw_tools::advise::{self, rules, Candidate, Found, Options, Scene};
use granlaw_tools::codes;
use granlaw_tools::codes::liggghts::{Liggghts, Plugin};
use granlaw_tools::deck::Deck;
use granlaw_tools::probe::Probe;
use granlaw_tools::report::page::{check_page_target, write_page};
use granlaw_tools::report::About;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// Find the simplest model and the largest step that are good enough for a scene.
///
/// The deck runs once with a probe in it, which counts what its contacts do. Examples of every important class of contacts
/// are then repeated by two bodies alone, with simpler laws (fitted where a property stands for an effect) and with
/// larger steps. What stays within the accuracy in every class is good enough; the cheapest is recommended, with the
/// measurement behind it. Nothing is recommended that was not tried.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw advise deck.in
  granlaw run --probe scene.json -- -in deck.in && granlaw advise scene.json
  granlaw advise scene.json --accuracy 0.05 --time-accuracy 0.5
  granlaw advise scenes/settling_box.in --check --held-out --out advice
  granlaw advise scenes/hopper.in --check --seeds 16
  granlaw advise deck.in --check --advised by_hand.in

Exit status: 0 there is advice, and it holds where it was held to something; 1 no model that was tried is within the
accuracy, or something is outside of its bounds; 2 something could not run.")]
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
    /// Run the deck and the advised deck in full, and compare bulk observables and times: four runs.
    #[arg(long)]
    check: bool,
    /// Run both decks N times, each time with another value of --fresh's variable, and compare means: one run of each does
    /// not tell the effect of the advice from chance.
    #[arg(long, value_name = "N", default_value_t = 1, requires = "check", value_parser = clap::value_parser!(u16).range(1..=200))]
    seeds: u16,
    /// Largest difference of a bulk observable.
    #[arg(long, value_name = "PART", default_value_t = rules::BULK, value_parser = error)]
    bound: f64,
    /// Try the advised model on the contacts of another run, which differs from the first by --fresh.
    #[arg(long)]
    held_out: bool,
    /// The variable of the deck that makes another run of it, such as a seed, and a value for it.
    #[arg(long, value_name = "NAME=VALUE", default_value = "seed=32452867", value_parser = variable)]
    fresh: (String, String),
    /// Check this deck in place of the one that is made from the advice.
    #[arg(long, value_name = "DECK", requires = "check")]
    advised: Option<PathBuf>,
    /// Write the advised deck to this file.
    #[arg(long, value_name = "FILE")]
    write_deck: Option<PathBuf>,
    /// Folder for the report: index.html with histograms and the ladder of models, CSV, JSON; an earlier one is replaced.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write everything that was found to this file as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Stop a run that takes longer than this.
    #[arg(long, value_name = "SECONDS", default_value_t = 3600.0, value_parser = console::seconds)]
    time_limit: f64,
}

fn error(text: &str) -> Result<f64, String> {
    let limit = text.parse().ok().filter(|x: &f64| *x > 0.0 && *x < 1.0);
    limit.ok_or("must be a number between 0 and 1, such as 0.02".into())
}

fn variable(text: &str) -> Result<(String, String), String> {
    let parts = text.split_once('=').filter(|(name, value)| !name.is_empty() && !value.is_empty());
    parts.map(|(n, v)| (n.into(), v.into())).ok_or("must be NAME=VALUE, such as seed=32452867".into())
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    args.out.iter().try_for_each(|dir| check_page_target(dir))?;
    let options =
        Options { accuracy: args.accuracy, time: args.time_accuracy.map_or(1.0, |t| t / args.accuracy) };
    let (found, probe, about) = if is_probe(&args.scene)? {
        if args.check || args.held_out || args.write_deck.is_some() {
            bail!("{} is a probe; --check, --held-out and --write-deck need the deck", args.scene.display());
        }
        let probe = Probe::read(&args.scene)?;
        let (advice, _) = advise::advise(&probe, options)?;
        (Found { advice, check: None, fresh: None }, probe, About::default())
    } else {
        on_deck(args, options)?
    };
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(&found)?;
        std::fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    console::print(&advise::text(&found));
    if let Some(dir) = &args.out {
        write_page(&advise::page(&found, &probe, described(about)), dir)?;
        console::print(&format!("\n{}\n", dir.join("index.html").display()));
    }
    Ok(ExitCode::from(u8::from(!found.holds())))
}

fn described(about: About) -> About {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    About {
        granlaw: env!("CARGO_PKG_VERSION").into(),
        machine: format!("{} {}, {cores} cores", std::env::consts::OS, std::env::consts::ARCH),
        command: std::env::args().collect::<Vec<_>>().join(" "),
        ..about
    }
}

/// A probe is JSON, and a deck is not.
fn is_probe(path: &Path) -> anyhow::Result<bool> {
    let mut first = [0u8];
    let mut file = std::fs::File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(file.read(&mut first)? == 1 && first == *b"{")
}

/// Runs the deck, each time in a folder of its own.
fn on_deck(args: &Args, options: Options) -> anyhow::Result<(Found, Probe, About)> {
    ctrlc::set_handler(codes::interrupt).context("cannot watch for Ctrl-C")?;
    let deck = Deck::read(&args.scene)?;
    let text = read(&args.scene)?;
    let (host, plugin) = (Liggghts::find()?, Plugin::find()?);
    eprintln!("granlaw: plugin {}", plugin.path.display());
    let about = About {
        liggghts: Some(host.version.clone()),
        plugin: Some(plugin.path.display().to_string()),
        ..About::default()
    };
    let limit = Duration::from_secs_f64(args.time_limit);
    let runner = Runner { host: &host, plugin: &plugin, deck: &deck, limit };
    eprintln!("granlaw: {} runs with a probe", deck.file());
    let probe = runner.probe(&text, true)?;
    eprintln!("granlaw: models and steps are tried on its contacts");
    let (advice, scene) = advise::advise(&probe, options)?;
    let candidate = advice.chosen.map(|k| advice.ladder[k].clone());
    let mut found = Found { advice, check: None, fresh: None };
    let Some(candidate) = candidate else { return Ok((found, probe, about)) };
    let held_out = args.held_out && !scene.groups.is_empty();
    if args.held_out && !held_out {
        eprintln!("granlaw: nothing was tried, so there is nothing to hold fresh contacts against");
    }
    let (name, value) = &args.fresh;
    // If the advice is to leave the deck as it is, there is nothing to compare.
    let stays = found.advice.lines.is_empty() && args.advised.is_none();
    let many = if stays { 0 } else { usize::from(args.seeds) - 1 };
    let values = seeds(value, many.max(usize::from(held_out))).map_err(anyhow::Error::msg)?;
    let others = again(&runner, &text, &probe, (name, &values), held_out)?;
    if let Some(other) = others.first().filter(|_| held_out) {
        let run = format!("{name}={value}");
        found.fresh = Some(fresh(&Scene::of(other)?, &scene, &candidate, &run, &options)?);
    }
    let did = Deeds { first: &probe, others: &others, variable: name, values: &values[..many] };
    advised(args, &runner, &text, (&scene, &candidate), did, &mut found)?;
    Ok((found, probe, about))
}

fn read(path: &Path) -> anyhow::Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

/// Runs the deck with other values of the variable, and returns the probes. If `held_out` is asked for, the first of them follows
/// all contacts, as the advice will be tried on those.
fn again(
    runner: &Runner<'_>,
    text: &str,
    first: &Probe,
    (name, values): (&str, &[String]),
    held_out: bool,
) -> anyhow::Result<Vec<Probe>> {
    if values.is_empty() {
        return Ok(Vec::new());
    }
    eprintln!("granlaw: it runs again, with {name}={}", values.join(", "));
    let texts: Vec<_> = values.iter().map(|value| with(text, name, value)).collect();
    let (near, far) = texts.split_at(usize::from(held_out));
    let others = [runner.probes(near, true)?, runner.probes(far, false)?].concat();
    if let Some((value, _)) = values.iter().zip(&others).find(|(_, o)| o.chains == first.chains) {
        return Err(CheckError::Same(format!("{name}={value}")).into());
    }
    Ok(others)
}

/// Makes the advised deck, and runs it if that is asked for.
fn advised(
    args: &Args,
    runner: &Runner<'_>,
    text: &str,
    (scene, candidate): (&Scene, &Candidate),
    did: Deeds<'_>,
    found: &mut Found,
) -> anyhow::Result<()> {
    let made = match &args.advised {
        Some(path) => read(path)?,
        None if args.check || args.write_deck.is_some() => rewrite(text, scene, candidate)?,
        None => return Ok(()),
    };
    if let Some(path) = &args.write_deck {
        std::fs::write(path, &made).with_context(|| format!("cannot write {}", path.display()))?;
    }
    if !args.check {
        return Ok(());
    }
    if made == text {
        eprintln!("granlaw: the deck stays as it is, so there is nothing to check");
        return Ok(());
    }
    eprintln!("granlaw: the advised deck runs with a probe, then both run without");
    // A deck from the user may hold anything; it is only judged by what it does.
    let expected = Some(candidate).filter(|_| args.advised.is_none());
    found.check = Some(check(runner, (text, &made), did, expected, args.bound)?);
    Ok(())
}
