//! The grammar of the comments: one line, one statement; `README.md` has the table.
use super::asked::{After, Asked, Deck, Final, What};
use super::error::DeckError;
use crate::spelling;
use std::path::Path;

const MARK: &str = "# granlaw:";
const STATEMENTS: [&str; 5] = ["title", "ranks", "after", "every", "check"];
const REPLAY_REASON: &str =
    "the same operations in the same order may differ by a few rounding errors of the peak";
const PLUGIN_REASON: &str = "the same operations on the same numbers give the same bits";
const CHECKS: [&str; 5] = ["replay", "plugin", "two-body", "final", "same-as"];

type Said<T> = Result<T, String>;

/// What the comments have said so far.
#[derive(Default)]
struct Draft {
    title: Option<String>,
    ranks: Option<usize>,
    after: Option<After>,
    every: Option<u64>,
    checks: Vec<Asked>,
}

/// The deck that `text` describes.
pub(super) fn deck(path: &Path, text: &str) -> Result<Deck, DeckError> {
    let mut draft = Draft::default();
    for (k, line) in text.lines().enumerate() {
        let number = k + 1;
        let wrong = |what| DeckError::Comment { path: path.to_path_buf(), line: number, what };
        match line.strip_prefix(MARK) {
            Some(rest) => draft.statement(rest.trim(), number).map_err(wrong)?,
            None if meant(line) => {
                return Err(wrong(format!(
                    "a comment for granlaw begins with exactly `{MARK}`, at the start of the line"
                )))
            }
            None => {}
        }
    }
    let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    if draft.checks.is_empty() {
        let always = |what, reason: &str| Asked { what, reason: reason.into(), line: 0 };
        draft.checks =
            vec![always(What::Replay { limit: 1e-14 }, REPLAY_REASON), always(What::Plugin, PLUGIN_REASON)];
    }
    Ok(Deck {
        path: path.to_path_buf(),
        title: draft.title.unwrap_or(file),
        ranks: draft.ranks.unwrap_or(1),
        variables: Vec::new(),
        after: draft.after,
        every: draft.every.unwrap_or(1),
        checks: draft.checks,
    })
}

/// Whether a line was probably meant for granlaw although it does not begin as it must.
fn meant(line: &str) -> bool {
    let rest = line.trim_start().strip_prefix('#').map(|r| r.trim_start_matches([' ', '\t', '#']));
    rest.and_then(|r| r.get(..7)).is_some_and(|word| word.eq_ignore_ascii_case("granlaw"))
        && rest.is_some_and(|r| {
            r[7..].trim_start().starts_with(':')
                || STATEMENTS.iter().any(|s| r[7..].trim_start().starts_with(s))
        })
}

impl Draft {
    fn statement(&mut self, rest: &str, line: usize) -> Said<()> {
        let (word, value) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        let value = value.trim();
        match word {
            "title" if value.is_empty() => Err("title: a line of text is missing".into()),
            "title" => once(&mut self.title, word, value.to_string()),
            "ranks" => once(&mut self.ranks, word, count(word, value)?),
            "every" => once(&mut self.every, word, count(word, value)?),
            "after" => once(&mut self.after, word, After { deck: beside(word, value)?, line }),
            "check" => self.check(value, line),
            _ => Err(spelling::unknown("statement", word, &STATEMENTS)),
        }
    }

    fn check(&mut self, value: &str, line: usize) -> Said<()> {
        let Some((what, reason)) = value.split_once(" because ") else {
            return Err(format!("check {value}: say why: every check ends in ` because <reason>`"));
        };
        let words: Vec<_> = what.split_whitespace().collect();
        let what = match words[..] {
            ["replay", "<=", limit] => What::Replay { limit: tolerance(limit)? },
            ["plugin", "identical"] => What::Plugin,
            ["two-body", "<=", limit] => What::TwoBody { limit: tolerance(limit)? },
            ["final", column, "of", id, "=", value, "within", limit] => What::Final(Final {
                column: column.to_string(),
                id: id
                    .parse()
                    .map_err(|_| format!("check final: particle id {id} must be a whole number"))?,
                value: number(value)?,
                limit: tolerance(limit)?,
            }),
            ["same-as", deck, "identical"] => What::SameAs { deck: beside("check same-as", deck)? },
            [word, ..] if CHECKS.contains(&word) => {
                return Err(format!("check {what}: must read `{}`", form(word)))
            }
            [word, ..] => return Err(spelling::unknown("check", word, &CHECKS)),
            [] => return Err(format!("check: name one of {}", CHECKS.join(", "))),
        };
        if reason.trim().is_empty() {
            return Err("check: the reason after `because` is missing".into());
        }
        let twice = |a: &Asked| match (&a.what, &what) {
            (What::Final(a), What::Final(b)) => (&a.column, a.id) == (&b.column, b.id),
            (What::SameAs { deck: a }, What::SameAs { deck: b }) => a == b,
            (a, b) => std::mem::discriminant(a) == std::mem::discriminant(b),
        };
        if let Some(before) = self.checks.iter().find(|a| twice(a)) {
            return Err(format!("check {value}: line {} asks for it already", before.line));
        }
        self.checks.push(Asked { what, reason: reason.trim().to_string(), line });
        Ok(())
    }
}

fn form(check: &str) -> &'static str {
    match check {
        "replay" => "check replay <= 1e-14 because <reason>",
        "plugin" => "check plugin identical because <reason>",
        "two-body" => "check two-body <= 1e-9 because <reason>",
        "same-as" => "check same-as <other>.in identical because <reason>",
        _ => "check final <column> of <id> = <value> within <tolerance> because <reason>",
    }
}

fn once<T>(slot: &mut Option<T>, word: &str, value: T) -> Said<()> {
    match slot.replace(value) {
        Some(_) => Err(format!("{word}: said twice; one is enough")),
        None => Ok(()),
    }
}

/// The name of a deck in the same folder.
fn beside(word: &str, deck: &str) -> Said<String> {
    if deck.is_empty() || deck.contains(['/', ' ', '\t']) {
        return Err(format!("{word} {deck}: must be the file name of one deck in the same folder"));
    }
    Ok(deck.to_string())
}

fn count<T: std::str::FromStr + PartialOrd + From<u8>>(word: &str, value: &str) -> Said<T> {
    let n = value.parse().ok().filter(|n| *n >= T::from(1));
    n.ok_or_else(|| format!("{word} {value}: must be a whole number, at least 1"))
}

fn number(text: &str) -> Said<f64> {
    let x = text.parse().ok().filter(|x: &f64| x.is_finite());
    x.ok_or_else(|| format!("{text}: must be a number such as 0.25 or -1.5e-3"))
}

fn tolerance(text: &str) -> Said<f64> {
    let x = number(text).ok().filter(|x| *x >= 0.0);
    x.ok_or_else(|| format!("tolerance {text}: must be a number, 0 or above, such as 1e-9"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Deck, String> {
        deck(Path::new("d/case.in"), text).map_err(|e| e.to_string())
    }

    #[test]
    fn everything_that_can_be_said() {
        let text = "units si\n# granlaw: title Two spheres\n# granlaw: ranks 2\n# granlaw: after first.in\n\
            # granlaw: every 10\n# plain comment\n# granlaw: check replay <= 1e-14 because rounding\n\
            # granlaw: check plugin identical because same bits\n# granlaw: check two-body <= 1e-9 because it grows\n\
            # granlaw: check final vx of 1 = -0.25 within 1e-6 because (E3), and because dt is small\n\
            # granlaw: check same-as twin.in identical because both do the same\n";
        let d = parse(text).unwrap();
        assert_eq!((d.title.as_str(), d.ranks, d.every), ("Two spheres", 2, 10));
        assert_eq!(d.after, Some(After { deck: "first.in".into(), line: 4 }));
        assert_eq!(d.checks.len(), 5);
        assert_eq!(d.checks[2].what, What::TwoBody { limit: 1e-9 });
        let last = Final { column: "vx".into(), id: 1, value: -0.25, limit: 1e-6 };
        assert_eq!(d.checks[3].what, What::Final(last));
        assert_eq!(d.checks[3].reason, "(E3), and because dt is small");
        assert_eq!(d.checks[3].line, 10);
        assert_eq!(d.checks[4].what, What::SameAs { deck: "twin.in".into() });
    }

    #[test]
    fn a_deck_that_says_nothing_gets_the_usual_checks() {
        let d = parse("# about granlaw: a prose comment\nunits si\n").unwrap();
        assert_eq!((d.title.as_str(), d.ranks, d.every, d.after), ("case.in", 1, 1, None));
        let what: Vec<_> = d.checks.into_iter().map(|c| c.what).collect();
        assert_eq!(what, [What::Replay { limit: 1e-14 }, What::Plugin]);
    }

    #[test]
    fn mistakes_name_file_line_and_what_would_be_right() {
        for (text, says) in [
            ("\n# granlaw: titel x", "d/case.in:2: unknown statement titel, did you mean title?"),
            ("# granlaw: ranks two", "ranks two: must be a whole number, at least 1"),
            ("# granlaw: every 0", "every 0: must be"),
            ("# granlaw: after ../x.in", "file name of one deck"),
            ("# granlaw: check replay <= 1e-14", "because <reason>"),
            (
                "# granlaw: check replay < 1e-14 because x",
                "must read `check replay <= 1e-14 because <reason>`",
            ),
            ("# granlaw: check replay <= -1 because x", "tolerance -1: must be a number, 0 or above"),
            ("# granlaw: check replay <= nan because x", "tolerance nan"),
            ("# granlaw: check plugin because x", "check plugin identical"),
            ("# granlaw: check twobody <= 1 because x", "did you mean two-body?"),
            ("# granlaw: check final vx 1 = 2 within 3 because x", "check final <column> of <id>"),
            ("# granlaw: check final vx of a = 2 within 3 because x", "particle id a"),
            ("# granlaw: check final vx of 1 = x within 3 because x", "x: must be a number"),
            ("# granlaw: check same-as twin.in because x", "check same-as <other>.in identical"),
            ("# granlaw: check same-as ../twin.in identical because x", "same-as ../twin.in: must be the file name"),
            (
                "# granlaw: check same-as a.in identical because x\n# granlaw: check same-as a.in identical because y",
                "line 1",
            ),
            ("# granlaw: title a\n# granlaw: title b", "d/case.in:2: title: said twice"),
            (
                "# granlaw: check plugin identical because x\n# granlaw: check plugin identical because y",
                "line 1",
            ),
            ("# granlaw check plugin identical because x", "begins with exactly `# granlaw:`"),
            ("#granlaw: ranks 2", "begins with exactly"),
            ("  # Granlaw: ranks 2", "begins with exactly"),
        ] {
            let error = parse(text).expect_err(text);
            assert!(error.contains(says), "{text}\n gave: {error}\n instead of: {says}");
        }
    }
}
