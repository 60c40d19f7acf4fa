//! `granlaw timestep`: how long the time step of a deck may be.
use crate::console;
use anyhow::{bail, Context};
use granlaw_tools::codes;
use granlaw_tools::codes::liggghts::{resolve, Liggghts, Plugin};
use granlaw_tools::deck::Deck;
use granlaw_tools::study::timestep::{advise, Advice, Asked, Contact, Limit};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// Say how long the time step of a deck may be.
///
/// LIGGGHTS runs the first steps of the deck with its own laws, in a folder of its own, and the plugin reads laws, coefficients and particles.
/// For every pair of types and every wall: the longest stable step of each mode by linear theory, the longest at which
/// no energy is created, and the longest at which the restitution of an impact is as accurate as asked for, found by
/// trying; and what LIGGGHTS's own check of the step would say. Of bonds: the same for each of their modes, and with many bonds on
/// every particle.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  granlaw timestep deck.in
  granlaw timestep deck.in --accuracy 1e-3 --speed 2.5
  granlaw timestep deck.in --steps 50000 --json

Exit status: 0 the deck's step is short enough, 1 it is too long, 2 something could not run.")]
pub struct Args {
    /// The deck.
    #[arg(value_name = "DECK")]
    deck: PathBuf,
    /// Largest error of the restitution of an impact, relative, as the mean over the phases of first touch.
    #[arg(long, value_name = "E", default_value_t = 0.01, value_parser = above_zero)]
    accuracy: f64,
    /// Speed of the impacts; without it, the fastest that the watched steps show.
    #[arg(long, value_name = "V", value_parser = above_zero)]
    speed: Option<f64>,
    /// How many bonds each particle is assumed to have: 2 in a chain, 12 in a closest packing.
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..))]
    bonds: u32,
    /// How many steps of the deck are run and watched. Particles that are inserted later are not seen.
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Seconds after which the run is stopped.
    #[arg(long, value_name = "S", default_value_t = 300.0, value_parser = above_zero)]
    time_limit: f64,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

fn above_zero(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite() && *x > 0.0);
    number.ok_or_else(|| "must be a number above 0".into())
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    ctrlc::set_handler(codes::interrupt).context("cannot watch for Ctrl-C")?;
    let deck = Deck::read(&args.deck)?;
    let (host, plugin) = (Liggghts::find()?, Plugin::find()?);
    let probe = resolve(&host, &plugin, &deck, args.steps, Duration::from_secs_f64(args.time_limit))?;
    let asked = Asked { accuracy: args.accuracy, speed: args.speed, bonds: args.bonds };
    let advice = advise(&probe, &asked);
    let Some(recommended) = advice.recommended() else {
        bail!("{}: no contact to look at: {}", args.deck.display(), advice.notes.join("; "));
    };
    match args.json {
        true => console::print(&(serde_json::to_string_pretty(&advice)? + "\n")),
        false => console::print(&told(&args.deck, &advice)),
    }
    Ok(ExitCode::from(u8::from(advice.dt > recommended)))
}

fn told(deck: &Path, a: &Advice) -> String {
    let mut out = format!("{}: time step {}\n", deck.display(), s(a.dt));
    for g in &a.grains {
        let ([r, r2], [d, d2]) = (g.radius, g.density);
        let range = |a: f64, b: f64| if b <= a * 1.0001 { n(a) } else { format!("{} to {}", n(a), n(b)) };
        out += &format!(
            "  type {}: {} particles, radius {} m, density {} kg/m³, fastest {} m/s\n",
            g.kind,
            g.count,
            range(r, r2),
            range(d, d2),
            n(g.fastest)
        );
    }
    a.contacts.iter().for_each(|c| out += &contact(c, a));
    if let Some(stock) = &a.stock {
        let says = if stock.warns(a.dt, (0.2, 0.2)) { "would warn" } else { "would say nothing" };
        out += &format!(
            "\nLIGGGHTS's fix check/timestep/gran: Rayleigh time {}, Hertz time {}; with 0.2 0.2 it {says}\n",
            s(stock.rayleigh),
            s(stock.hertz)
        );
    }
    a.notes.iter().for_each(|note| out += &format!("note: {note}\n"));
    let Some(shortest) = a.shortest() else { return out };
    let recommended = shortest.recommended();
    let verdict = match () {
        _ if a.dt > shortest.critical() => "unstable",
        _ if a.dt > shortest.safe() => "too long: energy may come from nothing",
        _ if a.dt > recommended => "too long for this accuracy",
        _ => "short enough",
    };
    let what = format!("{}, types {}-{}", shortest.who, shortest.types[0], shortest.types[1]);
    out + &format!(
        "\nrecommended for {} of the restitution: at most {} ({what}); the deck's {} is {verdict}\n",
        n(a.accuracy),
        s(recommended),
        s(a.dt)
    )
}

fn contact(c: &Contact, a: &Advice) -> String {
    let radii = if c.radii[1] > 0.0 {
        format!("radii {} and {}", n(c.radii[0]), n(c.radii[1]))
    } else {
        format!("radius {}", n(c.radii[0]))
    };
    let mut out = format!(
        "\n{}, types {}-{}: {}, {radii} m, {} at {} m/s\n",
        c.who,
        c.types[0],
        c.types[1],
        c.laws,
        if c.together.is_some() { "blows" } else { "impact" },
        n(c.speed)
    );
    out += &format!(
        "  {:<18}{:>14}{:>16}{:>12}{:>12}{:>12}\n",
        "mode", "k [N/m]", "γ [N s/m]", "m [kg]", "stable [s]", "safe [s]"
    );
    c.limits.iter().for_each(|l| out += &limit(l, l.name));
    if let Some(l) = &c.together {
        if a.bonds > 1 {
            out += &limit(l, &format!("{} such on each", a.bonds));
        }
        return out + "  k with what damping adds; of what turns, k in N m and m in kg m²; stable with many: a lower bound\n";
    }
    let accurate = c.accurate.map_or("none that was tried".into(), s);
    out + &format!("  for {} of the restitution: {accurate}\n", n(a.accuracy))
}

fn limit(l: &Limit, name: &str) -> String {
    let m = &l.mode;
    let numbers = [n(m.stiffness), n(m.damping), n(m.mass), n(l.critical), n(l.safe)];
    let [k, gamma, mass, critical, safe] = numbers;
    format!("  {name:<18}{k:>14}{gamma:>16}{mass:>12}{critical:>12}{safe:>12}\n")
}

/// A number to three digits.
fn n(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        a if (1e-2..1e5).contains(&a) => {
            let decimals = (2.0 - a.log10().floor()).max(0.0) as usize;
            let text = format!("{x:.decimals$}");
            if text.contains('.') {
                text.trim_end_matches('0').trim_end_matches('.').into()
            } else {
                text
            }
        }
        _ => format!("{x:.2e}"),
    }
}

fn s(x: f64) -> String {
    format!("{} s", n(x))
}
