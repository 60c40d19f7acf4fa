//! `granlaw verify`: decks in, a verdict on each out.
use crate::console;
use anyhow::Context;
use granlaw_tools::codes;
use granlaw_tools::report::{self, Case, Check, Counts, Outcome, Report};
use granlaw_tools::verify::{Options, Plan};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Prove the laws on LIGGGHTS decks and write a report.
///
/// Each deck runs on LIGGGHTS's own laws and again while every contact call is recorded; the recorded calls are replayed
/// through the Rust laws; the deck runs on the Rust laws inside LIGGGHTS; where the deck asks for it, two free particles
/// are integrated on our own and numbers are held against closed forms. `# granlaw:` comments in the deck say what is
/// checked and how closely. Without LIGGGHTS, recorded traces are replayed and the report says what that leaves out.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw verify                               every deck in liggghts_inputs/
  granlaw verify my_deck.in --out my_report    one deck
  granlaw verify decks/ --shard 1/4            the first quarter of a folder, for one of four machines

The report is a folder: index.html to look at, report.md for pull requests, report.json, junit.xml, csv/ behind the plots.

Exit status: 0 everything agreed, 1 something disagreed, 2 something could not run: a deck that fails, has no contact,
runs past the time limit or holds a property that the law refuses.")]
pub struct Args {
    /// Decks, and folders of decks (*.in).
    #[arg(value_name = "DECK|DIR", default_value = "liggghts_inputs")]
    decks: Vec<PathBuf>,
    /// Folder for the report; an earlier report in it is replaced.
    #[arg(long, value_name = "DIR", default_value = "granlaw-report")]
    out: PathBuf,
    /// How many decks run at the same time; 0 stands for one per core.
    #[arg(long, value_name = "N", default_value_t = 0)]
    jobs: usize,
    /// Take only every n-th deck, beginning with the k-th.
    #[arg(long, value_name = "K/N", value_parser = shard)]
    shard: Option<(usize, usize)>,
    /// Stop a run that takes longer than this.
    #[arg(long, value_name = "SECONDS", default_value_t = 120.0, value_parser = console::seconds)]
    time_limit: f64,
    /// How many contacts of the Rust laws go side by side. Two particles alone would go one at a time, and what the processor
    /// can is to be proved too.
    #[arg(long, value_name = "N", default_value = "widest", value_parser = ["1", "4", "8", "widest"])]
    lanes: String,
    /// Refuse to go on without LIGGGHTS and plugin.
    #[arg(long)]
    require_liggghts: bool,
}

fn shard(text: &str) -> Result<(usize, usize), String> {
    let parts = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    parts.filter(|(k, n)| (1..=*n).contains(k)).ok_or("must be K/N with 1 <= K <= N, for instance 1/4".into())
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    ctrlc::set_handler(codes::interrupt).context("cannot watch for Ctrl-C")?;
    report::check_target(&args.out)?;
    let plan = Plan::new(Options {
        decks: args.decks.clone(),
        jobs: args.jobs,
        shard: args.shard,
        limit: Duration::from_secs_f64(args.time_limit),
        lanes: args.lanes.clone(),
        require_liggghts: args.require_liggghts,
        command: std::env::args().collect::<Vec<_>>().join(" "),
    })?;
    match (plan.plugin(), plan.missing()) {
        (Some(plugin), _) => eprintln!("granlaw: plugin {}", plugin.path.display()),
        (_, Some(missing)) => eprintln!("granlaw: no live runs, recorded traces only: {missing}"),
        (None, None) => {}
    }
    let bar = progress(plan.cases());
    let report = plan.run(&|case| {
        bar.suspend(|| console::print(&line(case)));
        bar.inc(1);
    });
    bar.finish_and_clear();
    let report = report?;
    report::write_all(&report, &args.out)?;
    console::print(&ending(&report, args));
    Ok(ExitCode::from(report.exit_code()))
}

/// A bar on standard error, if that is a terminal.
fn progress(cases: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{elapsed:>4} [{bar:30}] {pos}/{len} decks");
    ProgressBar::new(cases as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// One line on a case; below it what did not agree.
fn line(case: &Case) -> String {
    let verdict = case.verdict();
    let errors: Vec<_> = case.checks.iter().filter_map(brief).collect();
    let mut text =
        format!("{:<13} {:<28} {:>6.1} s  {}\n", word(&verdict), case.name, case.seconds, errors.join(", "));
    for check in &case.checks {
        if let Outcome::Disagreed(why) | Outcome::CouldNotRun(why) = &check.outcome {
            text +=
                &format!("    {} {}: {}\n", check.name, word(&check.outcome), why.replace('\n', "\n    "));
        }
    }
    text
}

fn brief(check: &Check) -> Option<String> {
    let name = &check.name;
    match (&check.outcome, &check.worst) {
        (Outcome::Agreed, Some(w)) if w.error > 0.0 => Some(format!("{name} {:.1e}", w.error)),
        (Outcome::Agreed, _) => Some(format!("{name} identical")),
        (Outcome::Skipped(_), _) => Some(format!("{name} skipped")),
        _ => None,
    }
}

fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Agreed => "agreed",
        Outcome::Disagreed(_) => "DISAGREED",
        Outcome::Skipped(_) => "skipped",
        Outcome::CouldNotRun(_) => "COULD NOT RUN",
    }
}

fn ending(report: &Report, args: &Args) -> String {
    let Counts { agreed, disagreed, skipped, could_not_run } = report.counts();
    let mut text = format!(
        "\n{} cases, {agreed} checks agreed, {disagreed} disagreed, {could_not_run} could not run, {skipped} skipped\n",
        report.cases.len(),
    );
    report.about.notes.iter().for_each(|note| text += &format!("{note}\n"));
    let out = &args.out;
    text + &format!("report: {} and {}\n", out.join("index.html").display(), out.join("report.md").display())
}
