//! `granlaw replay`: recorded contact calls through the Rust laws.
use crate::console;
use anyhow::bail;
use granlaw_tools::compare::Quantity;
use granlaw_tools::replay::{replay, Replay};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Replay recorded contact calls through the Rust laws.
///
/// Every call is evaluated again on the inputs and the history that the trace holds, and compared with what LIGGGHTS
/// made of it. Errors are relative to the peak of each quantity over the trace.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw run --record calls.trace -- -in deck.in
  granlaw replay calls.trace

Exit status: 0 agreed, 1 disagreed, 2 a trace cannot be replayed.")]
pub struct Args {
    /// Traces, as `granlaw run --record` writes them.
    #[arg(required = true, value_name = "TRACE")]
    traces: Vec<PathBuf>,
    /// Largest error allowed, relative to the peak of each quantity.
    #[arg(long, value_name = "ERROR", default_value_t = 1e-14, value_parser = console::tolerance)]
    tolerance: f64,
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let mut agreed = true;
    for path in &args.traces {
        let replay = replay(path)?;
        if replay.touches == 0 {
            bail!(
                "{}: no contact in it, so nothing was compared; record a run in which surfaces touch",
                path.display()
            );
        }
        let good = replay.error() <= args.tolerance;
        agreed &= good;
        let mut text = String::new();
        describe(&mut text, path, &replay, good, args.tolerance)?;
        console::print(&text);
    }
    Ok(ExitCode::from(u8::from(!agreed)))
}

fn describe(t: &mut String, path: &Path, replay: &Replay, good: bool, tolerance: f64) -> std::fmt::Result {
    let header = &replay.header;
    let laws: Vec<_> = header.laws.iter().map(|l| format!("{} {}", l.kind, l.keyword)).collect();
    writeln!(t, "{}: {} of {}", path.display(), header.who, header.deck)?;
    writeln!(t, "  {}", laws.join(", "))?;
    writeln!(t, "  {} calls, {} with contact", replay.calls, replay.touches)?;
    let exact: Vec<_> = replay.quantities.iter().filter(|q| q.identical()).map(|q| q.name.as_str()).collect();
    if !exact.is_empty() {
        writeln!(t, "  equal to the last bit: {}", exact.join(", "))?;
    }
    for q in replay.quantities.iter().filter(|q| !q.identical()) {
        differs(t, q)?;
    }
    let verdict = if good { "agreed" } else { "DISAGREED" };
    writeln!(t, "  {verdict}: worst error {:.2e}, allowed {tolerance:e}", replay.error())
}

fn differs(t: &mut String, q: &Quantity) -> std::fmt::Result {
    let Some(w) = q.report() else { return Ok(()) };
    let (name, error) = (&q.name, w.error);
    writeln!(
        t,
        "  {name}: {error:.2e} of the peak, at step {}: {} is {:e} where {:e} was recorded",
        w.step, w.what, w.got, w.expected
    )
}
