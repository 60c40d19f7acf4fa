//! `granlaw run`: LIGGGHTS with the plugin.
use crate::console;
use anyhow::{bail, Context};
use granlaw_tools::codes::liggghts::{Laws, Liggghts, Plugin, Preload, Route};
use granlaw_tools::codes::{self, Around};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Run LIGGGHTS with the Rust laws in it.
///
/// LIGGGHTS runs in this folder, in place of granlaw: input, output, exit status, Ctrl-C and signals are its own.
/// Without --laws the names ending in `/rs` are ours and all others LIGGGHTS's own; --record then implies --laws stock,
/// which is the same with LIGGGHTS's laws where they can be recorded. What the environment tells the plugin counts
/// (README has the list), and options win over it.
///
/// With --shadow the run is LIGGGHTS's own to the last bit, and in every contact call the Rust laws answer too, from the
/// same inputs. What differs is told at the end, and the exit status is then 3; it is 2 if no call could be compared.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw run -- -in deck.in                       a deck that names laws ending in /rs
  granlaw run --laws rust -- -in deck.in           any deck, on the Rust laws
  granlaw run --record calls.trace -- -in deck.in  LIGGGHTS's own laws, every contact call recorded
  granlaw run --probe scene.json -- -in deck.in    what the contacts of a scene do
  granlaw run --shadow -- -in deck.in              LIGGGHTS's laws and the Rust laws on the same inputs, all along
  granlaw run --laws rust --np 4 -- -in deck.in    on four MPI ranks")]
pub struct Args {
    /// Whose laws answer to the stock names.
    #[arg(long, value_enum)]
    laws: Option<Whose>,
    /// Record contact calls to this file; wall and rank are put before its extension.
    #[arg(long, value_name = "TRACE")]
    record: Option<PathBuf>,
    /// Record only every N-th step; by default all.
    #[arg(long, value_name = "N", requires = "record", value_parser = clap::value_parser!(u64).range(1..))]
    every: Option<u64>,
    /// How the pair style goes through the contacts of a step. Without it: batched where that is possible.
    #[arg(long, value_enum)]
    path: Option<Way>,
    /// Count what the contacts do, and write it to this file as JSON; the laws are those of --laws, by default LIGGGHTS's own.
    #[arg(long, value_name = "FILE")]
    probe: Option<PathBuf>,
    /// Compare the Rust laws with LIGGGHTS's own in every contact call.
    #[arg(long)]
    shadow: bool,
    /// Largest difference allowed, relative to the forces that the laws add up in a call. By default 0, as the laws are meant to agree to the last bit.
    #[arg(long, value_name = "ERROR", requires = "shadow", value_parser = console::tolerance)]
    tolerance: Option<f64>,
    /// Say once for each pair of types when the time step is too long for a contact or a bond, with the figures; contacts then go one by one.
    #[arg(long)]
    warn_timestep: bool,
    /// Run on N MPI ranks, with mpirun.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    np: u64,
    /// Arguments for LIGGGHTS.
    #[arg(last = true, required = true, value_name = "LIGGGHTS ARGUMENTS")]
    liggghts: Vec<String>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Whose {
    /// The Rust laws take over the stock names.
    Rust,
    /// LIGGGHTS's own laws run, where the plugin can record them.
    Stock,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Way {
    /// All of them in one call; an error where that is not possible.
    Batched,
    /// One by one.
    Contact,
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let deck = deck(&args.liggghts)?;
    let plugin = Plugin::find()?;
    let host = Liggghts::find()?;
    for (option, path) in [("--record", &args.record), ("--probe", &args.probe)] {
        let Some(path) = path else { continue };
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            bail!("{option} {}: there is no folder {}; make it first", path.display(), folder.display());
        }
    }
    if args.shadow && matches!(args.laws, Some(Whose::Rust)) {
        bail!("--shadow runs LIGGGHTS's own laws, with the Rust laws beside them; leave --laws rust out");
    }
    let laws = args.laws.map(|whose| match whose {
        Whose::Rust => Laws::Rust,
        Whose::Stock => Laws::Stock,
    });
    let route = args.path.map(|way| match way {
        Way::Batched => Route::Batched,
        Way::Contact => Route::Contact,
    });
    eprintln!("granlaw: plugin {}", plugin.path.display());
    let preload = Preload {
        laws,
        record: args.record.clone(),
        every: args.every,
        probe: args.probe.clone(),
        shadow: args.shadow,
        tolerance: args.tolerance,
        deck,
        alarm: args.warn_timestep,
        route,
        ..Preload::bare(&plugin)
    };
    // This is the user's own run, in his own environment.
    let ranks = usize::try_from(args.np)?;
    let mut command = codes::command(&host.program, ranks, Around::Users, &preload.env())?;
    command.args(&args.liggghts);
    // This process becomes LIGGGHTS, so that no signal or exit status can be lost in between.
    let failed = command.exec();
    Err(failed).with_context(|| format!("cannot start {}", command.get_program().to_string_lossy()))
}

/// The file name of the deck in LIGGGHTS's arguments, if there is one. It must be readable: LIGGGHTS itself ends without a
/// message if it is not.
fn deck(liggghts: &[String]) -> anyhow::Result<Option<String>> {
    let at = liggghts.iter().position(|a| a == "-in" || a == "-i");
    let Some(path) = at.and_then(|k| liggghts.get(k + 1)).map(Path::new) else { return Ok(None) };
    std::fs::File::open(path).with_context(|| format!("cannot read the deck {}", path.display()))?;
    Ok(path.file_name().map(|n| n.to_string_lossy().into_owned()))
}
