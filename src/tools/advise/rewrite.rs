//! The advised deck: the deck with some lines replaced. Only LIGGGHTS understands decks, so whether the result is what was
//! advised is read from a probe of its run (see [`super::check`]).
use super::ladder::Candidate;
use super::lines::{number, properties, spoken};
use super::scene::Scene;
use crate::trace::{Header, Property};
use granlaw::model::Kind;
use thiserror::Error;

/// Why a deck cannot be rewritten.
#[derive(Debug, Error, PartialEq)]
pub enum RewriteError {
    /// A line that has to change is missing, or appears more than once.
    #[error("the deck has {found} lines with {what}, and one is needed; write the advised deck by hand and name it with --advised FILE")]
    Lines {
        /// Which.
        what: String,
        /// How many.
        found: usize,
    },
    /// A number of steps cannot be read.
    #[error("line {line}: {what}; write the advised deck by hand and name it with --advised FILE")]
    Steps {
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
}

/// A command of a deck, with continued lines joined, and the line on which it begins.
struct Command {
    line: usize,
    words: Vec<String>,
    /// The lines as they were; they are kept if the command does not change.
    text: String,
    changed: bool,
}

/// The deck with the laws, properties and time step of a model of the ladder. It runs for the same simulated time.
///
/// # Errors
/// The lines that have to change are not those of a plain deck.
pub fn rewrite(deck: &str, scene: &Scene, candidate: &Candidate) -> Result<String, RewriteError> {
    let mut all = commands(deck);
    for (was, is) in scene.chains.iter().zip(&candidate.chains) {
        if spoken(was) != spoken(is) {
            models(&mut all, was, is)?;
        }
    }
    let mut new: Vec<Property> = properties(&scene.chains, &candidate.chains);
    new.retain(|p| !replaced(&mut all, p));
    let before = all.iter().position(|c| c.is(&["pair_style"])).unwrap_or(0);
    let fresh = new.iter().enumerate().map(|(k, p)| {
        let words = format!("fix granlaw{k} all property/global {}", values(p));
        Command {
            line: 0,
            words: words.split(' ').map(String::from).collect(),
            text: String::new(),
            changed: true,
        }
    });
    all.splice(before..before, fresh);
    if let Some(step) = candidate.step.filter(|s| *s != scene.dt()) {
        let at = only(&all, "timestep", |c| c.is(&["timestep"]))?;
        all[at].set(1, number(step));
        let written: f64 = number(step).parse().unwrap_or(step);
        steps(&mut all, scene.dt() / written)?;
    }
    Ok(all.iter().map(Command::written).collect())
}

fn commands(deck: &str) -> Vec<Command> {
    let mut all: Vec<Command> = Vec::new();
    let mut open = false;
    for (k, line) in deck.lines().enumerate() {
        let code = line.split('#').next().unwrap_or("").trim_end();
        let goes_on = code.ends_with('&');
        let words = code.trim_end_matches('&').split_whitespace().map(String::from);
        match all.last_mut().filter(|_| open) {
            Some(c) => {
                c.words.extend(words);
                c.text += &format!("{line}\n");
            }
            None => all.push(Command {
                line: k + 1,
                words: words.collect(),
                text: format!("{line}\n"),
                changed: false,
            }),
        }
        open = goes_on;
    }
    all
}

impl Command {
    fn is(&self, words: &[&str]) -> bool {
        self.words.len() > words.len() && words.iter().zip(&self.words).all(|(a, b)| a == b)
    }

    fn set(&mut self, at: usize, word: String) {
        self.words[at] = word;
        self.changed = true;
    }

    fn written(&self) -> String {
        if self.changed {
            self.words.join(" ") + "\n"
        } else {
            self.text.clone()
        }
    }
}

fn only(all: &[Command], what: &str, is: impl Fn(&Command) -> bool) -> Result<usize, RewriteError> {
    let found: Vec<_> = (0..all.len()).filter(|k| is(&all[*k])).collect();
    match found[..] {
        [at] => Ok(at),
        _ => Err(RewriteError::Lines { what: what.into(), found: found.len() }),
    }
}

/// Puts other models and settings into the pair style, or into the walls that the chain stands for.
fn models(all: &mut [Command], was: &Header, is: &Header) -> Result<(), RewriteError> {
    let walls = was.who.strip_prefix("walls ").or(was.who.strip_prefix("wall "));
    let Some(ids) = walls else {
        let at = only(all, "pair_style gran", |c| c.is(&["pair_style", "gran"]))?;
        exchange(&mut all[at], 2, was, is);
        return Ok(());
    };
    for id in ids.split(", ") {
        let wall = |c: &Command| c.is(&["fix", id]) && c.words.get(3).is_some_and(|w| w == "wall/gran");
        let at = only(all, &format!("fix {id} … wall/gran"), wall)?;
        exchange(&mut all[at], 4, was, is);
    }
    Ok(())
}

/// Replaces the models and settings of one chain in a command by those of another. Models go where the old ones were, settings go
/// to the end.
fn exchange(c: &mut Command, from: usize, was: &Header, is: &Header) {
    let kinds: Vec<&str> = Kind::ALL.iter().map(|k| k.keyword()).collect();
    let settings: Vec<&String> = was.laws.iter().flat_map(|l| l.settings.keys()).collect();
    let known = |w: &String| kinds.contains(&w.as_str()) || settings.contains(&w);
    let mut rest = Vec::new();
    let mut words = c.words.split_off(from).into_iter();
    while let Some(w) = words.next() {
        if known(&w) {
            words.next();
        } else {
            rest.push(w);
        }
    }
    let new: Vec<String> = spoken(is).split(' ').map(String::from).collect();
    let models = new.chunks(2).filter(|p| kinds.contains(&p[0].as_str())).flatten().cloned();
    let options = new.chunks(2).filter(|p| !kinds.contains(&p[0].as_str())).flatten().cloned();
    c.words.extend(models.chain(rest).chain(options));
    c.changed = true;
}

fn values(p: &Property) -> String {
    let n = (p.values.len() as f64).sqrt().round();
    let per = if p.shape == "peratomtypepair" { format!(" {n}") } else { String::new() };
    let values: Vec<_> = p.values.iter().map(f64::to_string).collect();
    format!("{} {}{per} {}", p.name, p.shape, values.join(" "))
}

/// Gives a property of the deck these values. Returns whether the deck has that property.
fn replaced(all: &mut [Command], p: &Property) -> bool {
    let here = |c: &&mut Command| {
        c.is(&["fix"])
            && c.words.get(3).is_some_and(|w| w == "property/global")
            && c.words.get(4) == Some(&p.name)
    };
    let Some(c) = all.iter_mut().find(here) else { return false };
    c.words.truncate(4);
    c.words.extend(values(p).split(' ').map(String::from));
    c.changed = true;
    true
}

/// Multiplies numbers of steps by `many`: those of runs, of insertions and of output.
fn steps(all: &mut Vec<Command>, many: f64) -> Result<(), RewriteError> {
    let mut k = 0;
    while k < all.len() {
        let c = &mut all[k];
        let line = c.line;
        let strange = |what: String| RewriteError::Steps { line, what };
        match c.words.first().map(String::as_str) {
            Some("run") if c.words.len() == 2 => {
                // LIGGGHTS evaluates the expression, whatever it is.
                let name = format!("granlawRun{line}");
                let words = ["variable", &name, "equal", &format!("round({}*{many})", c.words[1])];
                let variable = Command {
                    line,
                    words: words.map(String::from).into(),
                    text: String::new(),
                    changed: true,
                };
                c.set(1, format!("${{{name}}}"));
                all.insert(k, variable);
                k += 1;
            }
            Some("run") => return Err(strange("run with more than a number of steps".into())),
            Some("thermo") => scaled(c, 1, many),
            Some("dump") => scaled(c, 4, many),
            Some("fix") => {
                if let Some(at) = c.words.iter().position(|w| w == "insert_every") {
                    scaled(c, at + 1, many);
                }
            }
            Some("if" | "jump" | "loop" | "next" | "include") => {
                return Err(strange(format!("{} may run any number of steps", c.words[0])))
            }
            _ => {}
        }
        k += 1;
    }
    Ok(())
}

fn scaled(c: &mut Command, at: usize, many: f64) {
    if let Some(n) = c.words.get(at).and_then(|w| w.parse::<f64>().ok()).filter(|n| *n > 0.0) {
        c.set(at, (n * many).round().max(1.0).to_string());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::LawSpec;

    fn chain(normal: &str, rolling: bool) -> Header {
        let law = |kind: &str, keyword: &str| LawSpec {
            kind: kind.into(),
            keyword: keyword.into(),
            taken_over: true,
            known: true,
            ..LawSpec::default()
        };
        let mut laws = vec![law("normal", normal), law("tangential", "history")];
        if rolling {
            laws.push(law("rolling", "cdt"));
            laws[2].settings.insert("torsionTorque".into(), "on".into());
        }
        Header { who: "walls a, b".into(), laws, ..Header::default() }
    }

    #[test]
    fn models_and_settings_change_places_and_the_rest_stays() {
        let deck = "fix a all wall/gran model hertz tangential history &\n  rolling_friction cdt primitive type 1 zplane 0.0 torsionTorque on # floor\n\
                    fix b all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes m torsionTorque on\nfix c all nve\n";
        let mut all = commands(deck);
        models(&mut all, &chain("hertz", true), &chain("hooke", false)).unwrap();
        let text: String = all.iter().map(Command::written).collect();
        let expected = "fix a all wall/gran model hooke tangential history primitive type 1 zplane 0.0\n\
                        fix b all wall/gran model hooke tangential history mesh n_meshes 1 meshes m\nfix c all nve\n";
        assert_eq!(text, expected);
        let missing = models(&mut commands("fix a all nve\n"), &chain("hertz", true), &chain("hooke", false));
        assert_eq!(missing.unwrap_err(), RewriteError::Lines { what: "fix a … wall/gran".into(), found: 0 });
    }

    #[test]
    fn steps_keep_the_time() {
        let mut all = commands(
            "thermo 1000\nrun 5000\ndump d all custom 200 f id\nfix i all insert/pack insert_every 50 x\n",
        );
        steps(&mut all, 0.2).unwrap();
        let text: String = all.iter().map(Command::written).collect();
        assert_eq!(
            text,
            "thermo 200\nvariable granlawRun2 equal round(5000*0.2)\nrun ${granlawRun2}\ndump d all custom 40 f id\n\
             fix i all insert/pack insert_every 10 x\n"
        );
        for bad in ["run 100 upto\n", "if \"1\" then \"run 5\"\n"] {
            assert!(matches!(steps(&mut commands(bad), 0.2), Err(RewriteError::Steps { line: 1, .. })));
        }
    }

    #[test]
    fn a_property_is_set_where_it_stands() {
        let p = Property {
            name: "coefficientRestitution".into(),
            unit: "1".into(),
            shape: "peratomtypepair".into(),
            values: vec![0.5, 0.6, 0.6, 0.7],
        };
        let mut all =
            commands("fix e all property/global coefficientRestitution peratomtypepair 2 .9 .9 .9 .9\n");
        assert!(replaced(&mut all, &p));
        assert_eq!(
            all[0].written(),
            "fix e all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7\n"
        );
        assert!(!replaced(&mut commands("fix e all nve\n"), &p));
    }
}
