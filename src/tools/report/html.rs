//! `index.html`: one page that needs neither network nor script to be read.
use super::escape::{count, differ, exact, html as esc, rough, seconds};
use super::{escape, figures, folder, summary};
use super::{About, Case, Check, Outcome, Parameter, Report, ReportError, Shows, Tolerance, Worst, Writer};
use std::path::Path;

pub(super) struct Html;

pub(super) const STYLE: &str = include_str!("style.css");
pub(super) const SCRIPT: &str = include_str!("sort.js");

impl Writer for Html {
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError> {
        folder::save(&dir.join("index.html"), &page(report))
    }
}

fn page(report: &Report) -> String {
    let ids = summary::ids(report);
    let verdict = summary::verdict(report);
    let headline = summary::headline(report);
    let sections: String = report.cases.iter().zip(&ids).map(|(case, id)| section(case, id)).collect();
    let rows: String = report.cases.iter().zip(&ids).map(|(case, id)| row(case, id)).collect();
    let table = if report.cases.is_empty() { String::new() } else { overview(&rows) };
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>granlaw: {headline}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header class=\"{class}\">\n<p class=\"program\">granlaw verify</p>\n\
         <h1><span class=\"sign\">{sign}</span> {headline}</h1>\n<p>Checks: {tally}.</p>\n</header>\n<main>\n\
         {about}{left_out}{table}{sections}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        class = class(&verdict),
        sign = verdict.sign(),
        tally = summary::tally(report.cases.iter().flat_map(|c| &c.checks)),
        about = compared(report),
        left_out = left_out(report),
    )
}

fn compared(report: &Report) -> String {
    let meaning = |s: &Shows| format!("<div><dt>{}</dt><dd>{}</dd></div>\n", s.word(), s.meaning());
    let meanings: String = Shows::ALL.iter().map(meaning).collect();
    let meanings = format!(
        "<dl>\n<div><dt>shows</dt><dd>what agreement of a check proves</dd></div>\n{meanings}</dl>\n"
    );
    about(&report.about, "What was compared", &meanings)
}

/// The programs that made a document, followed by `more`.
pub(super) fn about(a: &About, title: &str, more: &str) -> String {
    let or = |found: &Option<String>| found.clone().unwrap_or_else(|| "not found".into());
    let facts = [
        ("granlaw", a.granlaw.clone()),
        ("LIGGGHTS", or(&a.liggghts)),
        ("plugin", or(&a.plugin)),
        ("machine", a.machine.clone()),
        ("command", a.command.clone()),
    ];
    let facts: String =
        facts.iter().map(|(k, v)| format!("<div><dt>{k}</dt><dd>{}</dd></div>\n", esc(v))).collect();
    let notes: String = a.notes.iter().map(|note| format!("<li>{}</li>\n", esc(note))).collect();
    let notes = if notes.is_empty() { notes } else { format!("<h2>Notes</h2>\n<ul>\n{notes}</ul>\n") };
    format!(
        "<section>\n<h2>{title}</h2>\n<div class=\"about\">\n<dl>\n{facts}</dl>\n{more}</div>\n{notes}</section>\n"
    )
}

fn left_out(report: &Report) -> String {
    let groups = summary::skipped(report);
    if groups.is_empty() {
        return String::new();
    }
    let all = escape::plural(groups.iter().map(|(_, names)| names.len()).sum(), "check");
    let items: String = groups
        .iter()
        .map(|(why, names)| {
            let n = escape::plural(names.len(), "check");
            format!("<li>{n}: {}<br><small>{}</small></li>\n", esc(why), esc(&names.join(", ")))
        })
        .collect();
    format!("<section class=\"skip\">\n<h2>Left out: {all} skipped</h2>\n<ul>\n{items}</ul>\n</section>\n")
}

fn overview(rows: &str) -> String {
    format!(
        "<section>\n<h2>Cases</h2>\n<div class=\"wide\">\n<table class=\"sortable\">\n<thead><tr><th>case</th>\
         <th>verdict</th><th>checks</th><th>closest to its limit</th><th class=\"n\">calls</th>\
         <th class=\"n\">time</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n</section>\n"
    )
}

fn row(case: &Case, id: &str) -> String {
    let verdict = case.verdict();
    // Sorted by rank, what needs attention comes first.
    let rank = match verdict {
        Outcome::CouldNotRun(_) => 0,
        Outcome::Disagreed(_) => 1,
        Outcome::Skipped(_) | Outcome::Agreed => 2,
    };
    let share = case.closest().and_then(Check::share).unwrap_or(-1.0);
    format!(
        "<tr><td><a href=\"#{id}\">{id}</a><br><small>{}</small></td><td data-sort=\"{rank}\">{}</td><td>{}</td>\
         <td data-sort=\"{share}\">{}</td><td class=\"n\" data-sort=\"{}\">{}</td>\
         <td class=\"n\" data-sort=\"{}\">{}</td></tr>\n",
        esc(&case.title),
        badge(&verdict),
        summary::tally(case.checks.iter()),
        case.closest().map_or_else(|| summary::no_closest(&verdict).into(), closest),
        case.calls,
        count(case.calls),
        case.seconds,
        seconds(case.seconds),
    )
}

fn closest(check: &Check) -> String {
    let error = check.worst.as_ref().map_or(f64::NAN, |w| w.error);
    let limit = check.tolerance.as_ref().map_or(f64::NAN, |t| t.limit);
    format!("{}<br><small>{} of {}</small>", esc(&check.name), rough(error), rough(limit))
}

fn section(case: &Case, id: &str) -> String {
    let verdict = case.verdict();
    let laws: String = case.laws.iter().map(|law| format!("<li>{}</li>", esc(law))).collect();
    let figures: String = figures::figures(case).concat();
    let figures = match figures.as_str() {
        "" => "<p class=\"empty\">No history was kept, so nothing is plotted.</p>\n".into(),
        some => format!(
            "<div class=\"figures\">\n{some}</div>\n<p class=\"data\"><a href=\"csv/{id}.csv\">Numbers behind the plots</a></p>\n"
        ),
    };
    format!(
        "<section class=\"case\" id=\"{id}\">\n<h2>{badge} {id}</h2>\n<p class=\"title\">{title}</p>\n\
         <p class=\"facts\">{deck}{calls} contact calls · {time}</p>\n<ul class=\"laws\">{laws}</ul>\n\
         {checks}{log}{parameters}{figures}</section>\n",
        badge = badge(&verdict),
        title = esc(&case.title),
        deck = if case.deck.is_empty() {
            String::new()
        } else {
            format!("<code>{}</code> · ", esc(&case.deck))
        },
        calls = count(case.calls),
        time = seconds(case.seconds),
        checks = match case.checks.is_empty() {
            true => format!("<p class=\"why\">{}</p>\n", esc(verdict.why().unwrap_or_default())),
            false => checks(&case.checks),
        },
        log = log(case, &verdict),
        parameters = parameters(&case.parameters),
    )
}

fn checks(checks: &[Check]) -> String {
    let rows: String = checks.iter().map(check).collect();
    format!(
        "<table class=\"checks\">\n<thead><tr><th>check</th><th>outcome</th><th>worst at</th><th>got, expected</th>\
         <th>error</th><th>limit</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n"
    )
}

fn check(check: &Check) -> String {
    let why = check.outcome.why().map(|why| format!("<br><small>{}</small>", esc(why))).unwrap_or_default();
    let cells = [
        ("check", format!("<b>{}</b><br><small>shows {}</small>", esc(&check.name), check.shows.word())),
        ("outcome", badge(&check.outcome) + &why),
        ("worst at", check.worst.as_ref().map_or_else(|| nowhere(check), place)),
        ("got, expected", check.worst.as_ref().map(values).unwrap_or_default()),
        ("error", check.worst.as_ref().map(error).unwrap_or_default()),
        ("limit", check.tolerance.as_ref().map(limit).unwrap_or_default()),
    ];
    // On narrow screens the label stands beside the cell; the inner element keeps the cell together.
    let cell = |(name, text): &(&str, String)| format!("<td data-label=\"{name}\"><div>{text}</div></td>");
    format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>())
}

/// What stands in place of the worst difference if there is none.
fn nowhere(check: &Check) -> String {
    if check.outcome == Outcome::Agreed { "nowhere<br><small>every bit is equal</small>" } else { "" }.into()
}

fn place(worst: &Worst) -> String {
    format!("step {}<br><small>{}</small>", worst.step, esc(&worst.what))
}

fn values(worst: &Worst) -> String {
    let (got, expected) = (exact(worst.got), exact(worst.expected));
    let ((same, got), (_, expected)) = differ(&got, &expected);
    let mark = |tail: &str| if tail.is_empty() { String::new() } else { format!("<mark>{tail}</mark>") };
    format!("<code>{same}{}<br>{same}{}</code>", mark(got), mark(expected))
}

/// The error of a check and what it is relative to.
pub(super) fn error(worst: &Worst) -> String {
    format!("{}<br><small>{}</small>", rough(worst.error), esc(&worst.norm))
}

/// The limit of a check and its reason.
pub(super) fn limit(tolerance: &Tolerance) -> String {
    format!("{}<br><small>{}</small>", rough(tolerance.limit), esc(&tolerance.reason))
}

fn log(case: &Case, verdict: &Outcome) -> String {
    let open = if *verdict == Outcome::Agreed { "" } else { " open" };
    let block = |log: &String| {
        let text = esc(log.trim_end());
        format!("<details{open}><summary>What LIGGGHTS said</summary>\n<pre>{text}</pre></details>\n")
    };
    case.log.as_ref().map(block).unwrap_or_default()
}

fn parameters(parameters: &[Parameter]) -> String {
    if parameters.is_empty() {
        return String::new();
    }
    let rows: String = parameters.iter().map(parameter).collect();
    format!(
        "<div class=\"wide\">\n<table class=\"parameters\">\n<thead><tr><th>symbol</th><th>parameter</th><th>value</th>\
         <th>unit</th><th>given</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n"
    )
}

fn parameter(p: &Parameter) -> String {
    format!(
        "<tr><td><i>{}</i></td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        esc(&p.symbol),
        esc(&p.name),
        matrix(p),
        esc(&p.unit),
        esc(&p.shape)
    )
}

/// A single number, a row with atom types above it, or a square with atom types above and beside it.
fn matrix(p: &Parameter) -> String {
    let n = p.values.len();
    let side = (1..=n).find(|k| k * k >= n).unwrap_or(0);
    let square = p.shape == "per type pair" && side * side == n;
    let columns = if square { side } else { n };
    let cell = |v: &f64| format!("<td class=\"n\">{}</td>", exact(*v));
    if n <= 1 {
        return p.values.first().map_or("–".into(), |v| exact(*v));
    }
    let corner = if square { "<th></th>" } else { "" };
    let head: String = (1..=columns).map(|k| format!("<th>{k}</th>")).collect();
    let row = |(k, values): (usize, &[f64])| {
        let side = if square { format!("<th>{}</th>", k + 1) } else { String::new() };
        format!("<tr>{side}{}</tr>", values.iter().map(cell).collect::<String>())
    };
    let rows: String = p.values.chunks(columns).enumerate().map(row).collect();
    format!("<table class=\"matrix\"><tr>{corner}{head}</tr>{rows}</table>")
}

/// An outcome as a coloured word.
pub(super) fn badge(outcome: &Outcome) -> String {
    format!("<span class=\"badge {}\">{} {}</span>", class(outcome), outcome.sign(), outcome.word())
}

/// The style of an outcome.
pub(super) fn class(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Agreed => "good",
        Outcome::Disagreed(_) => "bad",
        Outcome::Skipped(_) => "skip",
        Outcome::CouldNotRun(_) => "stop",
    }
}
