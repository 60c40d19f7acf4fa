//! `granlaw stability`: where the methods fail.
use super::speed::{finish, options, progress};
use clap::builder::PossibleValuesParser;
use granlaw_tools::report::page::check_page_target;
use granlaw_tools::study::stability;
use std::path::PathBuf;
use std::process::ExitCode;

/// Map where LIGGGHTS's time integration fails.
///
/// For each law, what becomes of an impact, of a sphere at rest, or of bonds, over the time step and one parameter: errors, energy from
/// nothing, blow-up; with the limits of theory and those of LIGGGHTS's own check of the step. LIGGGHTS itself is run at
/// places on both sides of the borders that are found. Takes about a minute.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw stability
  granlaw stability --out maps --full
  granlaw stability --map k2max

The result is a folder: index.html to look at, figures/*.svg, csv/*.csv with all numbers, report.json.

Exit status: 0 LIGGGHTS does as the maps say, 1 it does not, 2 something could not run.")]
pub struct Args {
    /// Folder for the result; an earlier one in it is replaced.
    #[arg(long, value_name = "DIR", default_value = "granlaw-stability")]
    out: PathBuf,
    /// Only this map; may be given several times.
    #[arg(long = "map", value_name = "NAME", value_parser = names())]
    maps: Vec<String>,
    /// Finer maps, more phases, more places in LIGGGHTS: about eight times as long.
    #[arg(long)]
    full: bool,
}

fn names() -> PossibleValuesParser {
    stability::names().into()
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    check_page_target(&args.out)?;
    let options = options(&args.maps, args.full)?;
    let study = stability::run(&options, &progress());
    finish(&stability::page(&study, &options), &args.out)
}
