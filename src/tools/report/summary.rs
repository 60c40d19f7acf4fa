//! What several writers need: words for outcomes, names for files, the check closest to its limit, what was skipped.
use super::{escape, Case, Check, Outcome, Report, Shows};
use std::collections::HashSet;

impl Outcome {
    /// The outcome in one or two words.
    pub(super) fn word(&self) -> &'static str {
        match self {
            Outcome::Agreed => "agreed",
            Outcome::Disagreed(_) => "disagreed",
            Outcome::Skipped(_) => "skipped",
            Outcome::CouldNotRun(_) => "could not run",
        }
    }

    /// A sign, so that colour is not needed.
    pub(super) fn sign(&self) -> &'static str {
        match self {
            Outcome::Agreed => "✓",
            Outcome::Disagreed(_) => "✗",
            Outcome::Skipped(_) => "–",
            Outcome::CouldNotRun(_) => "!",
        }
    }

    /// The reason, if the outcome has one.
    pub(super) fn why(&self) -> Option<&str> {
        match self {
            Outcome::Agreed => None,
            Outcome::Disagreed(why) | Outcome::Skipped(why) | Outcome::CouldNotRun(why) => Some(why),
        }
    }
}

impl Shows {
    /// All four, in the order in which they are explained.
    pub(super) const ALL: [Shows; 4] = [Shows::Port, Shows::Boundary, Shows::Integrator, Shows::Physics];

    /// The name as in `report.json`.
    pub(super) fn word(self) -> &'static str {
        match self {
            Shows::Port => "port",
            Shows::Boundary => "boundary",
            Shows::Integrator => "integrator",
            Shows::Physics => "physics",
        }
    }

    /// What agreement shows.
    pub(super) fn meaning(self) -> &'static str {
        match self {
            Shows::Port => "the Rust law does what LIGGGHTS's own law does",
            Shows::Boundary => "the plugin hands LIGGGHTS what the law computed",
            Shows::Integrator => "the time integration is understood",
            Shows::Physics => "the answer is right: a closed form or another independent source",
        }
    }
}

impl Check {
    /// The error over the limit, infinite if the limit is zero and the error is not; `None` if either is missing.
    pub(super) fn share(&self) -> Option<f64> {
        let (worst, limit) = (self.worst.as_ref()?, self.tolerance.as_ref()?.limit);
        let share = match worst.error.abs() {
            0.0 => 0.0,
            error => error / limit,
        };
        Some(if share.is_nan() { f64::INFINITY } else { share })
    }
}

impl Case {
    /// The check with the largest error over its limit.
    pub(super) fn closest(&self) -> Option<&Check> {
        let shares = self.checks.iter().filter_map(|c| Some((c, c.share()?)));
        shares.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(check, _)| check)
    }
}

/// What is written in place of the closest check, if a case has none.
pub(super) fn no_closest(verdict: &Outcome) -> &'static str {
    if *verdict == Outcome::Agreed {
        "every bit is equal"
    } else {
        "–"
    }
}

/// The verdict in one sentence.
pub(super) fn headline(report: &Report) -> String {
    let all = report.cases.len();
    let ended = |f: fn(&Outcome) -> bool| report.cases.iter().filter(|c| f(&c.verdict())).count();
    let bad = ended(|o| matches!(o, Outcome::Disagreed(_)));
    let not_run = ended(|o| matches!(o, Outcome::CouldNotRun(_)));
    let of = escape::plural(all, "case");
    match (bad, not_run) {
        _ if all == 0 => "nothing was checked".into(),
        (0, 0) if all == 1 => "the only case agreed".into(),
        (0, 0) => format!("all {of} agreed"),
        (bad, 0) => format!("{bad} of {of} disagreed"),
        (0, not_run) => format!("{not_run} of {of} could not run"),
        (bad, not_run) => format!("{bad} of {of} disagreed, {not_run} could not run"),
    }
}

/// The outcome of the whole report, of the same kind as its exit code.
pub(super) fn verdict(report: &Report) -> Outcome {
    match report.exit_code() {
        0 => Outcome::Agreed,
        1 => Outcome::Disagreed(headline(report)),
        _ => Outcome::CouldNotRun(headline(report)),
    }
}

/// A name for each case that is unique in the report and safe in file names and links.
pub(super) fn ids(report: &Report) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut id = |case: &Case| {
        let base = safe(&case.name);
        let numbered = (2..).map(|k| format!("{base}-{k}"));
        std::iter::once(base.clone())
            .chain(numbered)
            // Some file systems do not distinguish capitals from small letters.
            .find(|name| taken.insert(name.to_lowercase()))
            .expect("the numbers do not run out")
    };
    report.cases.iter().map(&mut id).collect()
}

/// Turns a text into one that may be the name of a file.
pub(super) fn safe(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || "-_.".contains(c) { c } else { '_' };
    // File names may hold 255 bytes, extension and number included.
    let name: String = name.chars().take(120).map(plain).collect();
    match name.trim_start_matches('.') {
        "" => "case".into(),
        rest => rest.into(),
    }
}

/// Skipped checks by reason, in order of appearance: the reason, and `case: check` for each.
pub(super) fn skipped(report: &Report) -> Vec<(String, Vec<String>)> {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for (case, id) in report.cases.iter().zip(ids(report)) {
        for check in &case.checks {
            let Outcome::Skipped(why) = &check.outcome else { continue };
            let name = format!("{id}: {}", check.name);
            match groups.iter_mut().find(|(reason, _)| reason == why) {
                Some((_, names)) => names.push(name),
                None => groups.push((why.clone(), vec![name])),
            }
        }
    }
    groups
}

/// The counts in words, such as `4 agreed, 1 skipped`; outcomes that did not occur are left out.
pub(super) fn tally<'a>(checks: impl Iterator<Item = &'a Check>) -> String {
    let mut found: Vec<(&str, usize)> =
        [("agreed", 0), ("disagreed", 0), ("could not run", 0), ("skipped", 0)].to_vec();
    for check in checks {
        let entry = found.iter_mut().find(|(word, _)| *word == check.outcome.word());
        entry.expect("every outcome has its word in the list").1 += 1;
    }
    let some: Vec<_> = found.iter().filter(|(_, n)| *n > 0).map(|(word, n)| format!("{n} {word}")).collect();
    if some.is_empty() {
        "no checks".into()
    } else {
        some.join(", ")
    }
}
