//! The files of a page: drawings, numbers and the typed document.
use super::{bars, chart, heat, html, Bars, Cell, Chart, Item, Map, Page, Table};
use crate::report::folder::{place, save, Kind};
use crate::report::html::STYLE;
use crate::report::{summary, ReportError};
use serde::Serialize;
use std::fs;
use std::path::Path;

/// The names of those files, and how `report.json` begins.
const KIND: Kind =
    Kind { ours: &["index.html", "report.json", "figures", "csv"], format: "granlaw-study/1", what: "study" };

#[derive(Serialize)]
struct Document<'a> {
    format: &'static str,
    #[serde(flatten)]
    page: &'a Page,
}

/// Says early, before minutes of runs, whether [`write_page`] would refuse this folder.
///
/// # Errors
/// If the folder holds anything but an earlier page.
pub fn check_page_target(dir: &Path) -> Result<(), ReportError> {
    KIND.check(dir)
}

/// Writes all formats into the folder `dir`, which appears only when everything in it is complete.
///
/// # Errors
/// If a file cannot be written or the folder holds something else.
pub fn write_page(page: &Page, dir: &Path) -> Result<(), ReportError> {
    place(dir, &KIND, |fresh| {
        save(&fresh.join("index.html"), &html::page(page))?;
        let document = Document { format: KIND.format, page };
        let json = serde_json::to_string_pretty(&document).map_err(|e| ReportError::Format(e.into()))?;
        save(&fresh.join("report.json"), &(json + "\n"))?;
        for folder in ["figures", "csv"].map(|f| fresh.join(f)) {
            fs::create_dir(&folder).map_err(|e| ReportError::io(&folder, e))?;
        }
        page.sections.iter().flat_map(|s| &s.items).try_for_each(|item| files(item, fresh))
    })
}

fn files(item: &Item, dir: &Path) -> Result<(), ReportError> {
    let (name, svg, rows) = match item {
        Item::Table(t) => (&t.name, None, table(t)),
        Item::Chart(c) => (&c.name, Some(chart::svg(c)), marks(c)),
        Item::Map(m) => (&m.name, Some(heat::svg(m)), cells(m)),
        Item::Bars(b) => (&b.name, Some(bars::svg(b)), sizes(b)),
    };
    let name = summary::safe(name);
    if let Some(svg) = svg {
        save(&dir.join(format!("figures/{name}.svg")), &alone(&svg))?;
    }
    let path = dir.join(format!("csv/{name}.csv"));
    let write = || {
        let mut out = csv::Writer::from_path(&path)?;
        rows.iter().try_for_each(|row| out.write_record(row))?;
        Ok(out.flush()?)
    };
    write().map_err(|e: csv::Error| ReportError::io(&path, e.into()))
}

/// A drawing as a file of its own, with name space and style.
fn alone(svg: &str) -> String {
    svg.replacen("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ", 1).replacen(
        '>',
        &format!("><style>\n{STYLE}svg {{ background: var(--page); }}\n</style>"),
        1,
    ) + "\n"
}

fn table(t: &Table) -> Vec<Vec<String>> {
    let cell = |c: &Cell| match c {
        Cell::Text(text) => text.clone(),
        Cell::Number(x) => x.to_string(),
        Cell::Count(n) => n.to_string(),
    };
    std::iter::once(t.columns.clone()).chain(t.rows.iter().map(|r| r.iter().map(cell).collect())).collect()
}

fn marks(c: &Chart) -> Vec<Vec<String>> {
    let head =
        ["curve", "point", &c.x, "low", "high", &c.y, "low", "high", "on_front"].map(String::from).to_vec();
    let rows = c.trends.iter().flat_map(|t| t.marks.iter().map(move |m| (t, m))).map(|(t, m)| {
        let numbers = [m.x.at, m.x.low, m.x.high, m.y.at, m.y.low, m.y.high].map(|x| x.to_string());
        let words = [t.name.clone(), m.label.clone()];
        words.into_iter().chain(numbers).chain([m.front.to_string()]).collect()
    });
    std::iter::once(head).chain(rows).collect()
}

fn cells(m: &Map) -> Vec<Vec<String>> {
    let names = m.values.iter().map(|(name, _)| name.clone());
    let head = [m.x.label.clone(), m.y.label.clone(), "outcome".into()].into_iter().chain(names).collect();
    let nx = m.x.values.len();
    let row = |(k, class): (usize, &usize)| {
        let place = [m.x.values[k % nx], m.y.values[k / nx]].map(|x| x.to_string());
        let values = m.values.iter().map(|(_, v)| v[k].to_string());
        place.into_iter().chain([m.classes[*class].clone()]).chain(values).collect()
    };
    std::iter::once(head).chain(m.cells.iter().enumerate().map(row)).collect()
}

fn sizes(b: &Bars) -> Vec<Vec<String>> {
    let head = ["group", "series", &b.label, "low", "high"].map(String::from).to_vec();
    let row = |name: &str, series: usize, s: &super::Spread| {
        let numbers = [s.at, s.low, s.high].map(|x| x.to_string());
        [name.to_string(), b.series[series].clone()].into_iter().chain(numbers).collect()
    };
    let rows = b.groups.iter().flat_map(|g| g.bars.iter().map(move |(k, s)| row(&g.name, *k, s)));
    std::iter::once(head).chain(rows).collect()
}
