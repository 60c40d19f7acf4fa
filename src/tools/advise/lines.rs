//! Advice as lines for the deck.
use super::ladder::Candidate;
use super::scene::Scene;
use crate::trace::{Header, LawSpec, Property};
use granlaw::laws::find;
use granlaw::model::Kind;
use serde::Serialize;

/// A line to put into the deck.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Line {
    /// The line, or the part of it that changes.
    pub text: String,
    /// Where it goes.
    pub place: String,
}

/// The lines that turn the deck into a model of the ladder; lines that stay as they are are left out.
pub(super) fn lines(scene: &Scene, candidate: &Candidate) -> Vec<Line> {
    let mut all = Vec::new();
    for (was, is) in scene.chains.iter().zip(&candidate.chains) {
        if spoken(was) != spoken(is) {
            let wall = is.who.strip_prefix("walls ").or(is.who.strip_prefix("wall "));
            all.push(match wall {
                Some(id) => Line {
                    text: spoken(is),
                    place: format!(
                        "behind wall/gran in fix {id}; the primitive or mesh comes before the settings"
                    ),
                },
                None => Line {
                    text: format!("pair_style gran {}", spoken(is)),
                    place: "in place of the pair_style".into(),
                },
            });
        }
    }
    for p in properties(&scene.chains, &candidate.chains) {
        let per =
            if p.shape == "peratomtypepair" { format!(" {}", scene.chains[0].types) } else { String::new() };
        let values: Vec<_> = p.values.iter().map(f64::to_string).collect();
        let text = format!("property/global {} {}{per} {}", p.name, p.shape, values.join(" "));
        all.push(Line { text, place: format!("in the fix with {}, or in a new one", p.name) });
    }
    if let Some(step) = candidate.step.filter(|s| *s != scene.dt()) {
        let text = format!("timestep {}", number(step));
        let many = scene.dt() / step;
        all.push(Line {
            text,
            place: format!("in place of the timestep; numbers of steps times {}", number(many)),
        });
    }
    all
}

/// Properties that are new or have other values.
pub(super) fn properties(was: &[Header], is: &[Header]) -> Vec<Property> {
    let of = |chains: &[Header]| -> Vec<Property> {
        chains.iter().flat_map(|h| &h.laws).flat_map(|l| l.properties.clone()).collect()
    };
    let old = of(was);
    let mut new: Vec<Property> = Vec::new();
    for p in of(is) {
        let known = |all: &[Property]| all.iter().any(|o| o.name == p.name && o.values == p.values);
        if !known(&old) && !known(&new) {
            new.push(p);
        }
    }
    new
}

/// The models and settings of a chain, as they are written in a deck.
pub(super) fn spoken(h: &Header) -> String {
    let words = Kind::ALL.iter().filter_map(|k| h.law(*k).map(|l| format!("{} {}", k.keyword(), called(l))));
    let mut settings: Vec<String> = Vec::new();
    for l in &h.laws {
        for (name, option) in &l.settings {
            let text = format!("{name} {option}");
            if default(l, name) != Some(option.as_str()) && !settings.contains(&text) {
                settings.push(text);
            }
        }
    }
    words.chain(settings).collect::<Vec<_>>().join(" ")
}

fn called(l: &LawSpec) -> String {
    if l.taken_over {
        l.keyword.clone()
    } else {
        format!("{}/rs", l.keyword)
    }
}

fn default(l: &LawSpec, setting: &str) -> Option<&'static str> {
    find(l.kind()?, &l.keyword)?.settings().find(|s| s.name == setting)?.default
}

/// A number in as few digits as it has.
pub(super) fn number(x: f64) -> String {
    let short: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if (1e-3..1e5).contains(&short.abs()) {
        short.to_string()
    } else {
        format!("{short:e}")
    }
}

pub(super) fn percent(x: f64) -> String {
    let p = 100.0 * x;
    match p.abs() {
        a if a >= 10.0 => format!("{p:.0} %"),
        a if a >= 1.0 => format!("{p:.1} %"),
        a if a >= 0.01 || a == 0.0 => format!("{p:.2} %"),
        _ => format!("{p:.0e} %"),
    }
}
