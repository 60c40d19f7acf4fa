//! `granlaw speed`: what each method costs, and how wrong it is.
use crate::console;
use anyhow::Context;
use clap::builder::PossibleValuesParser;
use granlaw_tools::codes;
use granlaw_tools::report::page::{check_page_target, write_page, Page};
use granlaw_tools::report::Outcome;
use granlaw_tools::study::in_liggghts::Bench;
use granlaw_tools::study::{speed, Options};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Chart the error of every method against its cost.
///
/// Impacts with every normal law, head-on and oblique, a sphere that rolls to rest, and bonds: in LIGGGHTS as it is, in LIGGGHTS with
/// the Rust laws, with and without their settings centredDamping and touchFraction, and here with better integrators, each over
/// its time step. Takes about a minute and a half. Costs are measured: let nothing else run meanwhile.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw speed
  granlaw speed --out charts --full
  granlaw speed --case damped-0.5 --case stick-slip

The result is a folder: index.html to look at, figures/*.svg, csv/*.csv with all numbers, report.json.

Exit status: 0 orders and savings are as claimed, 1 something is not, 2 something could not run.")]
pub struct Args {
    /// Folder for the result; an earlier one in it is replaced.
    #[arg(long, value_name = "DIR", default_value = "granlaw-speed")]
    out: PathBuf,
    /// Only this case; may be given several times.
    #[arg(long = "case", value_name = "NAME", value_parser = names())]
    cases: Vec<String>,
    /// More phases, more steps in LIGGGHTS, more repetitions: about four times as long.
    #[arg(long)]
    full: bool,
}

fn names() -> PossibleValuesParser {
    speed::cases().into_iter().map(|c| c.name).collect::<Vec<_>>().into()
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    check_page_target(&args.out)?;
    let options = options(&args.cases, args.full)?;
    let study = speed::run(&options, &progress());
    finish(&speed::page(&study, &options), &args.out)
}

/// The options of a study, with LIGGGHTS and the plugin if they are found.
pub fn options(only: &[String], full: bool) -> anyhow::Result<Options> {
    ctrlc::set_handler(codes::interrupt).context("cannot watch for Ctrl-C")?;
    let bench = Bench::find(Duration::from_secs(120));
    if let Err(e) = &bench {
        eprintln!("granlaw: nothing runs in LIGGGHTS: {e}");
    }
    let command = std::env::args().collect::<Vec<_>>().join(" ");
    Ok(Options { only: only.to_vec(), full, bench, command })
}

/// Reports progress on standard error, with the time since the beginning.
pub fn progress() -> impl Fn(&str) + Sync {
    let begun = Instant::now();
    move |what: &str| eprintln!("{:>6.1} s  {what}", begun.elapsed().as_secs_f64())
}

/// Writes the page, and prints its summary.
pub fn finish(page: &Page, out: &Path) -> anyhow::Result<ExitCode> {
    write_page(page, out)?;
    let mut text = format!("{}\n", page.headline);
    for check in &page.checks {
        text += &match &check.outcome {
            Outcome::Agreed => format!("agreed         {}\n", check.name),
            Outcome::Disagreed(why) => format!("DISAGREED      {}: {why}\n", check.name),
            Outcome::Skipped(why) => format!("skipped        {}: {why}\n", check.name),
            Outcome::CouldNotRun(why) => format!("COULD NOT RUN  {}: {why}\n", check.name),
        };
    }
    page.about.notes.iter().for_each(|note| text += &format!("{note}\n"));
    console::print(&format!("{text}{}\n", out.join("index.html").display()));
    Ok(ExitCode::from(page.exit_code()))
}
