//! The command line: one file per command; each turns its arguments into one call of the library.
use clap::{Parser, Subcommand};
use std::process::ExitCode;

mod advise;
mod bench;
mod console;
mod laws;
mod replay;
mod run;
mod speed;
mod stability;
mod timestep;
mod verify;

/// Contact laws for LIGGGHTS, and the proof that they are right.
#[derive(Parser)]
#[command(
    name = "granlaw",
    version,
    arg_required_else_help = true,
    after_help = "Exit status: 0 everything agreed, 1 something disagreed, 2 something could not run.\n\
        `granlaw <command> --help` explains a command and gives examples."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Laws(laws::Args),
    Run(run::Args),
    Replay(replay::Args),
    Verify(verify::Args),
    Speed(speed::Args),
    Stability(stability::Args),
    Bench(bench::Args),
    Advise(advise::Args),
    Timestep(timestep::Args),
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Laws(args) => laws::run(&args),
        Command::Run(args) => run::run(&args),
        Command::Replay(args) => replay::run(&args),
        Command::Verify(args) => verify::run(&args),
        Command::Speed(args) => speed::run(&args),
        Command::Stability(args) => stability::run(&args),
        Command::Bench(args) => bench::run(&args),
        Command::Advise(args) => advise::run(&args),
        Command::Timestep(args) => timestep::run(&args),
    };
    done.unwrap_or_else(|error| {
        eprintln!("granlaw: {}", told(&error));
        ExitCode::from(2)
    })
}

/// The error with its causes, without those whose text it already contains.
fn told(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).fold(String::new(), |told, cause| match told.is_empty() {
        true => cause,
        false if told.contains(&cause) => told,
        false => format!("{told}: {cause}"),
    })
}
