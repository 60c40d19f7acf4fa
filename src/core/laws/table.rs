//! The table of laws in the README.
use super::LAWS;
use crate::model::{Kind, Meta};
use std::fmt::Write;

/// One row per law: how it is selected, what it is, what it asks for.
pub fn markdown() -> String {
    let mut out =
        String::from("| in a deck | what it is | properties | settings | history |\n|---|---|---|---|---|\n");
    for kind in Kind::ALL {
        for m in LAWS.iter().map(|e| e.meta).filter(|m| m.kind == kind) {
            writeln!(out, "| {} |", cells(m).join(" | ")).expect("a String takes everything");
        }
    }
    out
}

fn cells(m: &Meta) -> [String; 5] {
    [
        format!("`{} {}`", m.kind.keyword(), m.called(false)),
        m.summary.into(),
        names(m.props.iter().map(|p| p.name)),
        names(m.settings.iter().map(|s| s.name)),
        names(m.slots.iter().map(|s| s.name)),
    ]
}

fn names<'a>(of: impl Iterator<Item = &'a str>) -> String {
    let all: Vec<_> = of.map(|n| format!("`{n}`")).collect();
    if all.is_empty() {
        "none".into()
    } else {
        all.join(" ")
    }
}
