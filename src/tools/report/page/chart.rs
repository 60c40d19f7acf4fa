//! Charts on two logarithmic axes: curves with error bars, the front of the best points ringed.
use super::{Chart, Mark, Trend};
use crate::report::axis::{drawable, Axis};
use crate::report::escape::html as esc;
use crate::report::frame::Frame;

const FRAME: Frame = Frame { width: 820.0, height: 470.0, left: 64.0, right: 272.0, top: 14.0, bottom: 44.0 };
/// Colours in the style sheet; more curves begin again with other marks.
const COLOURS: usize = 9;

/// The chart as an SVG element.
pub(super) fn svg(chart: &Chart) -> String {
    let marks = || chart.trends.iter().flat_map(|t| &t.marks);
    let x = Axis::decades(marks().flat_map(|m| [m.x.at, m.x.low, m.x.high]), &chart.x);
    let y = Axis::decades(marks().flat_map(|m| [m.y.at, m.y.low, m.y.high]), &chart.y);
    let place = |m: &Mark| Some((FRAME.across(x.place(m.x.at)?), FRAME.up(y.place(m.y.at)?)));
    let mut out = FRAME.axes(&x, &y, true);
    out += &front(chart, &place);
    for (place_in_legend, trend) in chart.trends.iter().enumerate() {
        let k = trend.look.unwrap_or(place_in_legend);
        out += &format!("<g class=\"c{}\">", k % COLOURS);
        out += &line(trend, &place);
        for mark in &trend.marks {
            let Some((px, py)) = place(mark) else { continue };
            out += &bars(mark, &x, &y, (px, py));
            let ring = if mark.front {
                format!("<path class=\"ring\" d=\"{}\"/>", disc(px, py, 7.0))
            } else {
                String::new()
            };
            let title = esc(&format!("{}: {}", trend.name, mark.label));
            out += &format!(
                "{ring}<path class=\"mark\" d=\"{}\"><title>{title}</title></path>",
                shape(k, px, py)
            );
        }
        out += &legend(place_in_legend, k, trend);
        out += "</g>";
    }
    let Frame { width, height, .. } = FRAME;
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">{out}</svg>",
        esc(&chart.caption)
    )
}

fn line(trend: &Trend, place: &dyn Fn(&Mark) -> Option<(f64, f64)>) -> String {
    if !trend.joined {
        return String::new();
    }
    let points: Vec<_> =
        trend.marks.iter().filter_map(place).map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
    format!("<path class=\"trend\" d=\"M{}\"/>", points.join("L"))
}

/// A line through the points that no other beats, from the cheapest on.
fn front(chart: &Chart, place: &dyn Fn(&Mark) -> Option<(f64, f64)>) -> String {
    let best = chart.trends.iter().flat_map(|t| &t.marks).filter(|m| m.front);
    let mut points: Vec<_> = best.filter_map(place).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let text: Vec<_> = points.iter().map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
    if text.is_empty() {
        return String::new();
    }
    format!("<path class=\"front\" d=\"M{}\"/>", text.join("L"))
}

fn bars(mark: &Mark, x: &Axis, y: &Axis, (px, py): (f64, f64)) -> String {
    let ends = |axis: &Axis, low: f64, high: f64| Some((axis.place(low)?, axis.place(high)?));
    let mut d = String::new();
    if let Some((low, high)) = ends(x, mark.x.low, mark.x.high).filter(|(l, h)| h > l) {
        d += &format!("M{:.1} {py:.1}H{:.1}", FRAME.across(low), FRAME.across(high));
    }
    // A lower end of zero is drawn at the bottom of the axis.
    if let Some((low, high)) = ends(y, mark.y.low, mark.y.high).filter(|(l, h)| h > l) {
        d += &format!("M{px:.1} {:.1}V{:.1}", FRAME.up(low), FRAME.up(high));
    }
    if d.is_empty() || !drawable(mark.x.at) {
        return String::new();
    }
    format!("<path class=\"bar\" d=\"{d}\"/>")
}

fn legend(row: usize, k: usize, trend: &Trend) -> String {
    let (x, y) = (FRAME.width - FRAME.right + 18.0, FRAME.top + 12.0 + 34.0 * row as f64);
    let line =
        if trend.joined { format!("<path class=\"trend\" d=\"M{x} {y}h24\"/>") } else { String::new() };
    format!(
        "{line}<path class=\"mark\" d=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text><text class=\"sub\" x=\"{}\" y=\"{}\">{}</text>",
        shape(k, x + 12.0, y),
        x + 32.0,
        y + 4.0,
        esc(&trend.name),
        x + 32.0,
        y + 18.0,
        esc(&trend.note),
    )
}

/// A mark of its own for each curve, so that colour is not needed.
fn shape(k: usize, x: f64, y: f64) -> String {
    match k % 6 {
        0 => disc(x, y, 3.6),
        1 => format!("M{:.1} {:.1}h6.4v6.4h-6.4z", x - 3.2, y - 3.2),
        2 => format!("M{x:.1} {:.1}l4 7h-8z", y - 4.4),
        3 => format!("M{x:.1} {:.1}l4.6 4.6l-4.6 4.6l-4.6 -4.6z", y - 4.6),
        4 => format!("M{:.1} {:.1}h8l-4 7z", x - 4.0, y - 2.8),
        _ => format!("M{:.1} {:.1}h2.4v3h3v2.4h-3v3h-2.4v-3h-3v-2.4h3z", x - 1.2, y - 4.2),
    }
}

fn disc(x: f64, y: f64, r: f64) -> String {
    format!("M{:.1} {y:.1}a{r} {r} 0 1 0 {} 0a{r} {r} 0 1 0 -{} 0", x - r, 2.0 * r, 2.0 * r)
}
