//! A document of sections with text, tables, charts, maps and bars: what the studies return. Nothing here depends on physics.
//!
//! [`write_page`] makes the folder: `index.html` for people, `figures/*.svg`, `csv/*.csv` with the numbers of every table,
//! chart and map, and `report.json` for programs.
mod bars;
mod chart;
mod files;
mod heat;
mod html;

pub use files::{check_page_target, write_page};

use super::{numbers, About, Check};
use serde::Serialize;

/// A document.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Page {
    /// The command that made it, for instance `granlaw speed`.
    pub program: String,
    /// The result in one sentence.
    pub headline: String,
    /// The programs that made it.
    pub about: About,
    /// The checks against limits.
    pub checks: Vec<Check>,
    /// The sections, in order.
    pub sections: Vec<Section>,
}

/// A part with a heading.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Section {
    /// The heading.
    pub title: String,
    /// Paragraphs above the items.
    pub text: Vec<String>,
    /// Tables, charts and maps.
    pub items: Vec<Item>,
}

/// What a section shows.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Item {
    /// Rows and columns.
    Table(Table),
    /// Curves on logarithmic axes.
    Chart(Chart),
    /// A field of outcomes.
    Map(Map),
    /// Numbers side by side.
    Bars(Bars),
}

/// Rows and columns.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Table {
    /// Names its CSV file; unique in the page.
    pub name: String,
    /// One line for people.
    pub caption: String,
    /// The heads of the columns, with units.
    pub columns: Vec<String>,
    /// The rows, each with as many cells as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A number, shown to three digits.
    Number(#[serde(serialize_with = "numbers::number")] f64),
    /// A whole number.
    Count(u64),
}

impl From<&str> for Cell {
    fn from(text: &str) -> Cell {
        Cell::Text(text.into())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Cell {
        Cell::Number(number)
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Cell {
        Cell::Count(count)
    }
}

/// Curves on two logarithmic axes, with error bars.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Chart {
    /// Names its files; unique in the page.
    pub name: String,
    /// One line for people.
    pub caption: String,
    /// The quantity of the horizontal axis, with its unit.
    pub x: String,
    /// The quantity of the vertical axis, with its unit.
    pub y: String,
    /// The curves, in the order of the legend.
    pub trends: Vec<Trend>,
}

/// A curve.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Trend {
    /// What it shows.
    pub name: String,
    /// What the legend adds, for instance an order.
    pub note: String,
    /// Whether its points are joined.
    pub joined: bool,
    /// The number of its colour and mark, so that curves of one kind look alike in several charts; without it, its place in `curves`.
    pub look: Option<usize>,
    /// The points.
    pub marks: Vec<Mark>,
}

/// A point with its spread.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Mark {
    /// What it is, for instance a number of steps.
    pub label: String,
    /// Its horizontal coordinate, with its range.
    pub x: Spread,
    /// Its vertical coordinate, with its range.
    pub y: Spread,
    /// Whether no other point is better in both coordinates; it is drawn with a ring.
    pub front: bool,
}

/// A number and the range that it was found in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Spread {
    /// The number.
    #[serde(serialize_with = "numbers::number")]
    pub at: f64,
    /// Lower end.
    #[serde(serialize_with = "numbers::number")]
    pub low: f64,
    /// Upper end.
    #[serde(serialize_with = "numbers::number")]
    pub high: f64,
}

impl Spread {
    /// A number without spread.
    pub fn exact(at: f64) -> Spread {
        Spread { at, low: at, high: at }
    }
}

/// A field of outcomes over two quantities, with borders and points of comparison.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Map {
    /// Names its files; unique in the page.
    pub name: String,
    /// One line for people.
    pub caption: String,
    /// Across.
    pub x: Scale,
    /// Up.
    pub y: Scale,
    /// The outcomes, from good to bad; those that occur are in the legend.
    pub classes: Vec<String>,
    /// The outcome of each cell, an index into `classes`, row by row from the first `y`.
    pub cells: Vec<usize>,
    /// Numbers behind the cells, by name, in the same order; for the CSV file.
    pub values: Vec<(String, Vec<f64>)>,
    /// Lines across the field.
    pub borders: Vec<Border>,
    /// Points at which another program was run.
    pub spots: Vec<Spot>,
}

/// One side of a map: the middles of its cells, evenly spaced, at least two.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Scale {
    /// The quantity with its unit.
    pub label: String,
    /// The middles.
    #[serde(serialize_with = "numbers::numbers")]
    pub values: Vec<f64>,
    /// Whether they are evenly spaced in their logarithm.
    pub log: bool,
}

/// A line on a map.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Border {
    /// What it separates, or where it comes from.
    pub name: String,
    /// Its points; parts outside the map are not drawn.
    pub points: Vec<(f64, f64)>,
}

/// A point on a map.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Spot {
    /// Across.
    pub x: f64,
    /// Up.
    pub y: f64,
    /// Whether the other answer was the same.
    pub agrees: bool,
    /// What was found, in words.
    pub label: String,
}

/// Numbers of several series, group by group.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Bars {
    /// Names its files; unique in the page.
    pub name: String,
    /// One line for people.
    pub caption: String,
    /// What is shown, with its unit.
    pub label: String,
    /// The series, in the order of the legend.
    pub series: Vec<String>,
    /// The groups, from the top.
    pub groups: Vec<Group>,
}

/// A group of bars.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Group {
    /// The label of the group.
    pub name: String,
    /// The bars, each with the index of its series and its number.
    pub bars: Vec<(usize, Spread)>,
}
