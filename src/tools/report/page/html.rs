//! `index.html` of a page: it needs neither network nor script to be read.
use super::{bars, chart, heat, Cell, Item, Page, Section, Table};
use crate::report::escape::{count, html as esc, plain};
use crate::report::html::{about, badge, class, error, limit, SCRIPT, STYLE};
use crate::report::summary;
use crate::report::{Check, Outcome, Worst};

pub(super) fn page(page: &Page) -> String {
    let headline = esc(&page.headline);
    let sections: String = page.sections.iter().map(section).collect();
    let verdict = page.verdict();
    let (tally, tone) = match page.checks.is_empty() {
        true => (String::new(), "good"),
        false => (format!("<p>Checks: {}.</p>\n", summary::tally(page.checks.iter())), class(&verdict)),
    };
    let checked = match page.checks.is_empty() {
        true => String::new(),
        false => {
            format!("<section>\n<h2>What was held against a limit</h2>\n{}</section>\n", checks(&page.checks))
        }
    };
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>granlaw: {headline}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header class=\"{tone}\">\n<p class=\"program\">{program}</p>\n<h1>{headline}</h1>\n{tally}</header>\n<main>\n\
         {checked}{sections}{about}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        program = esc(&page.program),
        about = about(&page.about, "How this was made", ""),
    )
}

impl Page {
    /// The worst outcome of the checks: could not run, then disagreed, then agreed.
    pub fn verdict(&self) -> Outcome {
        let rank = |o: &Outcome| match o {
            Outcome::CouldNotRun(_) => 0,
            Outcome::Disagreed(_) => 1,
            Outcome::Agreed => 2,
            Outcome::Skipped(_) => 3,
        };
        self.checks.iter().map(|c| c.outcome.clone()).min_by_key(rank).unwrap_or(Outcome::Agreed)
    }

    /// The exit code: 0 all agreed or was skipped, 1 something disagreed, 2 something could not run.
    pub fn exit_code(&self) -> u8 {
        match self.verdict() {
            Outcome::CouldNotRun(_) => 2,
            Outcome::Disagreed(_) => 1,
            Outcome::Agreed | Outcome::Skipped(_) => 0,
        }
    }
}

/// As in a report of decks, but without the time step, as a study checks results of many runs.
fn checks(checks: &[Check]) -> String {
    let rows: String = checks.iter().map(check).collect();
    format!(
        "<table class=\"checks\">\n<thead><tr><th>check</th><th>outcome</th><th>furthest off</th><th>error</th>\
         <th>limit</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n"
    )
}

fn check(check: &Check) -> String {
    let why = check.outcome.why().map(|why| format!("<br><small>{}</small>", esc(why))).unwrap_or_default();
    let found = |w: &Worst| {
        let numbers = format!("{} against {}", plain(w.got), plain(w.expected));
        format!("{}<br><small>{numbers}</small>", esc(&w.what))
    };
    let cells = [
        ("check", format!("<b>{}</b><br><small>shows {}</small>", esc(&check.name), check.shows.word())),
        ("outcome", badge(&check.outcome) + &why),
        ("furthest off", check.worst.as_ref().map(found).unwrap_or_default()),
        ("error", check.worst.as_ref().map(error).unwrap_or_default()),
        ("limit", check.tolerance.as_ref().map(limit).unwrap_or_default()),
    ];
    let cell = |(name, text): &(&str, String)| format!("<td data-label=\"{name}\"><div>{text}</div></td>");
    format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>())
}

fn section(section: &Section) -> String {
    let text: String = section.text.iter().map(|p| format!("<p>{}</p>\n", esc(p))).collect();
    let items: String = section.items.iter().map(item).collect();
    format!("<section>\n<h2>{}</h2>\n{text}{items}</section>\n", esc(&section.title))
}

fn item(item: &Item) -> String {
    match item {
        Item::Table(t) => table(t),
        Item::Chart(c) => figure(&c.name, &c.caption, &chart::svg(c)),
        Item::Map(m) => figure(&m.name, &m.caption, &heat::svg(m)),
        Item::Bars(b) => figure(&b.name, &b.caption, &bars::svg(b)),
    }
}

fn figure(name: &str, caption: &str, svg: &str) -> String {
    let file = summary::safe(name);
    format!(
        "<figure class=\"large\"><figcaption>{} <small><a href=\"csv/{file}.csv\">numbers</a> · \
         <a href=\"figures/{file}.svg\">drawing</a></small></figcaption>{svg}</figure>\n",
        esc(caption)
    )
}

fn table(t: &Table) -> String {
    let number = |k: usize| t.rows.iter().all(|r| !matches!(r[k], Cell::Text(_)));
    let tone = |k: usize| if number(k) { " class=\"n\"" } else { "" };
    let head: String =
        t.columns.iter().enumerate().map(|(k, c)| format!("<th{}>{}</th>", tone(k), esc(c))).collect();
    let cell = |(k, c): (usize, &Cell)| {
        let (sort, text) = match c {
            Cell::Text(text) => (String::new(), esc(text)),
            Cell::Number(x) => (format!(" data-sort=\"{x}\""), plain(*x)),
            Cell::Count(n) => (format!(" data-sort=\"{n}\""), count(*n)),
        };
        format!("<td{}{sort}>{text}</td>", tone(k))
    };
    let row = |r: &Vec<Cell>| format!("<tr>{}</tr>\n", r.iter().enumerate().map(cell).collect::<String>());
    let rows: String = t.rows.iter().map(row).collect();
    let file = summary::safe(&t.name);
    format!(
        "<p class=\"caption\">{} <small><a href=\"csv/{file}.csv\">numbers</a></small></p>\n<div class=\"wide\">\n\
         <table class=\"sortable plain\">\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n",
        esc(&t.caption)
    )
}
