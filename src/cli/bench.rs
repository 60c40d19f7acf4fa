//! `granlaw bench`: what the Rust laws cost inside LIGGGHTS.
use crate::console;
use anyhow::Context;
use granlaw_tools::bench::{self, Options};
use granlaw_tools::codes::lammps::Lammps;
use granlaw_tools::codes::liggghts::{Liggghts, Plugin};
use granlaw_tools::codes::{self, RunError};
use granlaw_tools::report::page::{check_page_target, write_page};
use indicatif::ProgressBar;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Time the Rust laws inside LIGGGHTS against LIGGGHTS's own.
///
/// Each round runs a deck on LIGGGHTS alone, on the Rust laws contact by contact, and on the Rust laws batched; the order
/// turns round from one round to the next. All must write the same dumps, byte for byte. A deck may hold other laws in
/// its two sides: it sees the variable `rust`, 0 or 1, and says `# bench: dumps differ`, and
/// `# bench: plugin on both sides` where both are ours. A file DECK.lammps beside
/// DECK.in is run by LAMMPS, if there is one. Let nothing else run meanwhile.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw bench                                     all decks of benchmarks/
  granlaw bench benchmarks/fcc16.in --pairs 9       one deck, more rounds
  granlaw bench --lanes 1,4 --np 1,2                narrower vectors as sides of their own, on one rank and on two
  granlaw bench my_deck.in --lammps ~/venv/bin/lmp

The result is a folder: index.html to look at, figures/*.svg, csv/*.csv with all numbers, report.json.

Exit status: 0 all dumps are those of LIGGGHTS alone, 1 some are not, 2 something could not run.")]
pub struct Args {
    /// Decks, and folders of decks (*.in).
    #[arg(value_name = "DECK|DIR", default_value = "benchmarks")]
    decks: Vec<PathBuf>,
    /// How many rounds of each deck.
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u64).range(1..))]
    pairs: u64,
    /// The numbers of MPI ranks to run on.
    #[arg(long, value_name = "N,...", default_value = "1", value_delimiter = ',',
        value_parser = clap::value_parser!(u64).range(1..))]
    np: Vec<u64>,
    /// Widths of the batched path that are run too.
    #[arg(long, value_name = "N,...", value_delimiter = ',', value_parser = ["1", "4", "8"])]
    lanes: Vec<String>,
    /// LAMMPS; without it the `lmp` of PATH, if there is one.
    #[arg(long, value_name = "PROGRAM")]
    lammps: Option<PathBuf>,
    /// Folder for the result; an earlier one in it is replaced.
    #[arg(long, value_name = "DIR", default_value = "granlaw-bench")]
    out: PathBuf,
    /// Stop a run that takes longer than this.
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0, value_parser = console::seconds)]
    time_limit: f64,
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    ctrlc::set_handler(codes::interrupt).context("cannot watch for Ctrl-C")?;
    check_page_target(&args.out)?;
    let (host, plugin) = (Liggghts::find()?, Plugin::find()?);
    let all = |numbers: &[u64]| numbers.iter().map(|n| usize::try_from(*n)).collect::<Result<Vec<_>, _>>();
    let options = Options {
        decks: args.decks.clone(),
        pairs: all(&[args.pairs])?[0],
        ranks: all(&args.np)?,
        lanes: args.lanes.iter().map(|n| n.parse()).collect::<Result<_, _>>()?,
        lammps: lammps(args)?,
        limit: Duration::from_secs_f64(args.time_limit),
        command: std::env::args().collect::<Vec<_>>().join(" "),
    };
    eprintln!("granlaw: plugin {}", plugin.path.display());
    let begin = bench::load();
    let bar = ProgressBar::new_spinner();
    bar.enable_steady_tick(Duration::from_millis(500));
    let scenes =
        bench::run(&options, (&host, &plugin), &|doing| bar.set_message(doing.to_string()), &|scene| {
            bar.suspend(|| console::print(&bench::table(scene)))
        });
    bar.finish_and_clear();
    let scenes = scenes?;
    let page = bench::page(&scenes, &options, (&host, &plugin), [begin, bench::load()]);
    write_page(&page, &args.out)?;
    console::print(&format!("\n{}{}\n", bench::summary(&scenes), args.out.join("index.html").display()));
    Ok(ExitCode::from(page.exit_code()))
}

/// LAMMPS, which need not be there unless it is named.
fn lammps(args: &Args) -> Result<Option<Lammps>, RunError> {
    match Lammps::find(args.lammps.as_deref()) {
        Err(RunError::NoProgram { .. }) => Ok(None),
        found => found.map(Some),
    }
}
