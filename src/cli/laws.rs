//! `granlaw laws`: lists the laws and what they need.
use crate::console;
use anyhow::bail;
use granlaw::laws::LAWS;
use granlaw::model::{Entry, Kind, Need, Newton, Prop, Setting, Support};
use granlaw_tools::spelling;
use serde_json::{json, Value};
use std::fmt::{self, Write};
use std::process::ExitCode;

/// List the contact laws, or explain one.
///
/// Each law is selected in a deck as LIGGGHTS's own are, with `/rs` behind its name; under `granlaw run --laws rust` the
/// plain name selects it too.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  granlaw laws\n  granlaw laws hooke/hysteresis\n  granlaw laws --json")]
pub struct Args {
    /// Show the properties, settings and history of this law.
    law: Option<String>,
    /// Everything about the laws, as JSON.
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let laws = chosen(args.law.as_deref())?;
    let mut text = String::new();
    if args.json {
        let all: Vec<_> = laws.iter().map(|law| as_json(law)).collect();
        writeln!(text, "{}", serde_json::to_string_pretty(&all)?)?;
    } else if args.law.is_some() {
        laws.iter().try_for_each(|law| explain(&mut text, law))?;
    } else {
        list(&mut text, &laws)?;
    }
    console::print(&text);
    Ok(ExitCode::SUCCESS)
}

fn chosen(name: Option<&str>) -> anyhow::Result<Vec<&'static Entry>> {
    let Some(name) = name else { return Ok(LAWS.iter().collect()) };
    let keyword = name.strip_suffix("/rs").unwrap_or(name);
    let laws: Vec<_> = LAWS.iter().filter(|e| e.meta.keyword == keyword).collect();
    if laws.is_empty() {
        let known: Vec<_> = LAWS.iter().map(|e| e.meta.keyword).collect();
        bail!("{}", spelling::unknown("law", name, &known));
    }
    Ok(laws)
}

fn list(t: &mut String, laws: &[&Entry]) -> fmt::Result {
    for kind in Kind::ALL {
        for meta in laws.iter().map(|e| e.meta).filter(|m| m.kind == kind) {
            writeln!(t, "{:<17} {:<20} {}", kind.keyword(), meta.called(false), meta.summary)?;
        }
    }
    writeln!(t, "\n`granlaw laws <law>` shows what a law needs.")
}

fn explain(t: &mut String, law: &Entry) -> fmt::Result {
    let meta = law.meta;
    writeln!(t, "{} {}\n  {}", meta.kind.keyword(), meta.called(false), meta.summary)?;
    if law.liggghts.stock_id.is_none() {
        writeln!(t, "  LIGGGHTS has no law of that name: plain {} is the same", meta.keyword)?;
    }
    if !meta.props.is_empty() {
        writeln!(t, "\nProperties (fix ID all property/global <name> <shape> <values>):")?;
    }
    for p in meta.props {
        writeln!(t, "  {} {}  {} [{}], {}", p.name, p.shape.keyword(), p.symbol, p.unit.label, p.range)?;
        writeln!(t, "      {}{}", p.doc, needed(p.need))?;
    }
    if law.settings().next().is_some() {
        writeln!(t, "\nSettings (behind the models in pair_style gran and fix wall/gran):")?;
    }
    for s in law.settings() {
        writeln!(t, "  {} {}  {}", s.name, s.options.join("|"), default(s))?;
        writeln!(t, "      {}{}", s.doc, support(law.support(s.name)))?;
    }
    if !meta.atoms.is_empty() {
        writeln!(
            t,
            "\nRead of each atom where the deck gives it (fix ID all property/atom <name> scalar ...):"
        )?;
    }
    for a in meta.atoms {
        writeln!(t, "  {}\n      {}", a.name, a.doc)?;
    }
    if !meta.slots.is_empty() {
        writeln!(t, "\nHistory kept per contact:")?;
    }
    for s in meta.slots {
        writeln!(
            t,
            "  {} [{}]{}{}",
            s.name,
            s.unit.label,
            if s.newton == Newton::Odd { ", odd under i-j swap" } else { "" },
            needed(s.need).replace("needed", "kept"),
        )?;
    }
    writeln!(t, "\nSources:")?;
    for r in meta.references {
        writeln!(t, "  {r}")?;
    }
    for e in meta.exceptions {
        writeln!(t, "\nException to the rule {:?}: {}", e.rule, e.why)?;
    }
    Ok(())
}

fn needed(need: Need) -> String {
    match need {
        Need::Always => String::new(),
        Need::When(setting, option) => format!(" (needed with {setting} {option})"),
        Need::Unless(setting, option) => format!(" (not needed with {setting} {option})"),
        Need::All(these) => format!(" (needed with {})", listed(these)),
        Need::NotAll(these) => format!(" (not needed with {})", listed(these)),
    }
}

fn listed(these: &[(&str, &str)]) -> String {
    these.iter().map(|(setting, option)| format!("{setting} {option}")).collect::<Vec<_>>().join(", ")
}

fn default(s: &Setting) -> String {
    s.default.map_or("must be chosen".into(), |d| format!("default {d}"))
}

fn support(s: Support) -> &'static str {
    match s {
        Support::Full => "",
        Support::OwnOnly => " (only under the /rs name)",
        Support::StockIgnores => " (LIGGGHTS's own law ignores it, and so does ours under the stock name)",
        Support::Refused => " (refused when switched on)",
    }
}

fn as_json(law: &Entry) -> Value {
    let (m, binding) = (law.meta, law.liggghts);
    let prop = |p: &Prop| {
        json!({"name": p.name, "symbol": p.symbol, "shape": p.shape.keyword(), "unit": p.unit.label,
            "range": p.range.to_string(), "usual": p.usual, "doc": p.doc, "needed": needed(p.need).trim()})
    };
    let setting = |s: &Setting| {
        json!({"name": s.name, "options": s.options, "default": s.default, "doc": s.doc,
            "support": format!("{:?}", law.support(s.name))})
    };
    json!({
        "kind": m.kind.name(), "selected_by": m.kind.keyword(), "keyword": m.called(false), "stock_keyword": m.keyword,
        "id": binding.id, "stock_id": binding.stock_id, "summary": m.summary,
        "properties": m.props.iter().map(prop).collect::<Vec<_>>(),
        "settings": law.settings().map(setting).collect::<Vec<_>>(),
        "history": m.slots.iter().map(|s| json!({"name": s.name, "unit": s.unit.label,
            "newton": s.newton == Newton::Odd, "kept": needed(s.need).replace("needed", "kept").trim()}))
            .collect::<Vec<_>>(),
        "per_atom": m.atoms.iter().map(|a| json!({"name": a.name, "doc": a.doc})).collect::<Vec<_>>(),
        "per_atom_output": m.outputs.iter().map(|a| json!({"name": a.name, "doc": a.doc})).collect::<Vec<_>>(),
        "stress_strain_exponent": m.stress_strain_exponent, "coarse_graining": m.coarse_graining,
        "references": m.references,
        "exceptions": m.exceptions.iter().map(|e| json!({"rule": format!("{:?}", e.rule), "why": e.why}))
            .collect::<Vec<_>>(),
    })
}
