//! `report.md`: for CI summaries and pull requests. The verdict, one line per case, the details of what failed.
use super::escape::{exact, markdown as esc, rough, seconds};
use super::{escape, folder, summary, Case, Check, Outcome, Report, ReportError, Writer};
use std::path::Path;

pub(super) struct Markdown;

/// This many lines of a log are shown, from its end, where LIGGGHTS says what went wrong.
const LOG_LINES: usize = 30;

impl Writer for Markdown {
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError> {
        folder::save(&dir.join("report.md"), &page(report))
    }
}

fn page(report: &Report) -> String {
    let ids = summary::ids(report);
    let cases = || report.cases.iter().zip(ids.iter().map(String::as_str));
    let verdict = summary::verdict(report);
    let checks = summary::tally(report.cases.iter().flat_map(|c| &c.checks));
    let mut parts = vec![
        "# granlaw verify".to_owned(),
        format!("**{} {}** ({checks})", verdict.sign(), summary::headline(report)),
        about(report),
    ];
    if !report.cases.is_empty() {
        let rows: Vec<_> = cases().map(|(case, id)| row(case, id)).collect();
        let head = "| case | verdict | checks | closest to its limit | time |\n|---|---|---|---|--:|";
        parts.push(format!("{head}\n{}", rows.join("\n")));
    }
    parts.extend(cases().filter_map(|(case, id)| failure(case, id)));
    parts.extend(left_out(report));
    parts.retain(|part| !part.is_empty());
    parts.join("\n\n") + "\n"
}

fn about(report: &Report) -> String {
    let a = &report.about;
    let or = |x: &Option<String>| x.as_deref().map_or("not found".into(), esc);
    let machine = if a.machine.is_empty() { String::new() } else { format!(" · {}", esc(&a.machine)) };
    format!(
        "granlaw {} · LIGGGHTS: {} · plugin: {}{machine}",
        esc(&a.granlaw),
        or(&a.liggghts),
        or(&a.plugin)
    )
}

fn row(case: &Case, id: &str) -> String {
    let verdict = case.verdict();
    let closest = case.closest().map_or_else(|| summary::no_closest(&verdict).into(), closest);
    let (sign, word) = (verdict.sign(), verdict.word());
    let (checks, time) = (summary::tally(case.checks.iter()), seconds(case.seconds));
    format!("| {} | {sign} {word} | {checks} | {closest} | {time} |", esc(id))
}

fn closest(check: &Check) -> String {
    let error = check.worst.as_ref().map_or(f64::NAN, |w| w.error);
    let limit = check.tolerance.as_ref().map_or(f64::NAN, |t| t.limit);
    format!("{}: {} of {}", esc(&check.name), rough(error), rough(limit))
}

/// What went wrong in a case, check by check; `None` for a case that agreed.
fn failure(case: &Case, id: &str) -> Option<String> {
    let verdict = case.verdict();
    let failed = |c: &&Check| matches!(c.outcome, Outcome::Disagreed(_) | Outcome::CouldNotRun(_));
    if verdict == Outcome::Agreed {
        return None;
    }
    let mut lines = vec![format!("### {} {}: {}", verdict.sign(), esc(id), esc(&case.title)), String::new()];
    let facts: Vec<_> =
        [&case.deck, &case.laws.join(", ")].into_iter().filter(|f| !f.is_empty()).map(|f| esc(f)).collect();
    if !facts.is_empty() {
        lines.extend([facts.join(" · "), String::new()]);
    }
    let before = lines.len();
    lines.extend(case.checks.iter().filter(failed).flat_map(details));
    if lines.len() == before {
        lines.push(format!("- {}: {}", verdict.word(), esc(verdict.why().unwrap_or_default())));
    }
    lines.extend(case.log.as_deref().map(log));
    Some(lines.join("\n"))
}

fn details(check: &Check) -> Vec<String> {
    let why = esc(check.outcome.why().unwrap_or_default());
    let mut lines =
        vec![format!("- **{}** ({}) {}: {why}", esc(&check.name), check.shows.word(), check.outcome.word())];
    if let Some(w) = &check.worst {
        lines.push(format!("  - worst at step {}, {}", w.step, esc(&w.what)));
        lines.push(format!("  - got `{}`, expected `{}`", exact(w.got), exact(w.expected)));
        lines.push(format!("  - error {} {}", rough(w.error), esc(&w.norm)));
    }
    if let Some(t) = &check.tolerance {
        lines.push(format!("  - limit {} because {}", rough(t.limit), esc(&t.reason)));
    }
    lines
}

fn log(log: &str) -> String {
    let lines: Vec<_> = log.trim_end().lines().collect();
    let end = lines[lines.len().saturating_sub(LOG_LINES)..].join("\n");
    // The blank line matters: without it the first empty line of the log would end the block.
    format!(
        "\n<details><summary>end of the log</summary>\n\n<pre>\n{}\n</pre>\n\n</details>",
        escape::html(&end)
    )
}

fn left_out(report: &Report) -> Option<String> {
    let groups = summary::skipped(report);
    if groups.is_empty() && report.about.notes.is_empty() {
        return None;
    }
    let mut lines: Vec<_> = report.about.notes.iter().map(|note| format!("- {}", esc(note))).collect();
    for (why, names) in &groups {
        let (n, names) = (escape::plural(names.len(), "check"), esc(&names.join(", ")));
        lines.push(format!("- {n} skipped because {}: {names}", esc(why)));
    }
    Some(format!("### Left out, and notes\n\n{}", lines.join("\n")))
}
