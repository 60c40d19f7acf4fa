//! Plots as inline SVG. Drawn by hand, because colours must come from the page's style sheet to follow light, dark
//! and print, which the plotting crates' back ends do not do.
use super::axis::Axis;
use super::escape::html as esc;
use super::frame::Frame;
use std::collections::BTreeSet;

const FRAME: Frame = Frame { width: 480.0, height: 280.0, left: 60.0, right: 14.0, top: 28.0, bottom: 44.0 };
/// Points are rounded to tenths of a unit: that keeps the text short and is finer than any screen.
const FINE: f64 = 10.0;
/// Curves above this many points are thinned.
const MANY: usize = 1500;
/// Number of sections of a thinned curve, about one for every two units of the plot's width.
const STRETCHES: usize = 250;

/// One answer in a plot.
pub(super) struct Series<'a> {
    pub answer: &'a str,
    pub points: Vec<(f64, f64)>,
}

/// One plot.
pub(super) struct Plot<'a> {
    pub title: &'a str,
    pub x: Axis,
    pub y: Axis,
    pub series: Vec<Series<'a>>,
    /// Dots instead of lines, for values that jump.
    pub dots: bool,
    /// Limits, drawn as horizontal lines, each with the name of its answer.
    pub limits: Vec<(&'a str, f64)>,
}

type Spot = Option<(i32, i32)>;

impl Plot<'_> {
    /// The plot as an SVG element, or a sentence if there is nothing to draw.
    pub(super) fn svg(&self) -> String {
        let drawn: Vec<Vec<Spot>> = self.series.iter().map(|s| self.spots(s)).collect();
        if !drawn.iter().flatten().any(Option::is_some) {
            return "<p class=\"empty\">nothing to draw</p>".into();
        }
        let lines: String = self.series.iter().zip(&drawn).map(|(s, spots)| self.line(s, spots)).collect();
        format!(
            "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}{}\
             <g transform=\"scale({})\">{lines}</g>{}</svg>",
            FRAME.width,
            FRAME.height,
            esc(self.title),
            FRAME.axes(&self.x, &self.y, true),
            self.limits(),
            1.0 / FINE,
            self.legend(),
        )
    }

    /// A sentence on the points that could not be drawn; empty if all could.
    pub(super) fn missing(&self) -> String {
        let lost = |s: &Series| s.points.iter().filter(|p| self.spot(p).is_none()).count();
        let counted = self.series.iter().map(|s| (s.answer, lost(s))).filter(|(_, n)| *n > 0);
        counted.map(|(answer, n)| format!("{answer}: {n} not finite, not drawn. ")).collect()
    }

    fn spot(&self, point: &(f64, f64)) -> Spot {
        let (x, y) = (FRAME.across(self.x.place(point.0)?), FRAME.up(self.y.place(point.1)?));
        Some(((FINE * x).round() as i32, (FINE * y).round() as i32))
    }

    fn spots(&self, series: &Series) -> Vec<Spot> {
        thin(&series.points.iter().map(|p| self.spot(p)).collect::<Vec<_>>())
    }

    fn line(&self, series: &Series, spots: &[Spot]) -> String {
        let path = if self.dots { dots(spots) } else { strokes(spots) };
        let (answer, class) = (esc(series.answer), class(series.answer));
        let shape = if self.dots { "dots" } else { "line" };
        let all = series.points.len();
        format!(
            "<path class=\"{shape} {class}\" data-answer=\"{answer}\" data-points=\"{all}\" d=\"{path}\"/>"
        )
    }

    fn limits(&self) -> String {
        let (left, right) = (FRAME.left, FRAME.width - FRAME.right);
        let draw = |(answer, limit): &(&str, f64)| {
            let (y, class) = (FRAME.up(self.y.place(*limit)?), class(answer));
            let line = format!("<path class=\"limit {class}\" d=\"M{left} {y:.1}H{right}\"/>");
            let text = format!("limit of {}", esc(answer));
            // The name stands above its line, or below it at the upper edge.
            let at = if y - 14.0 < FRAME.top { y + 12.0 } else { y - 4.0 };
            Some(format!("{line}<text class=\"note\" x=\"{}\" y=\"{at:.1}\">{text}</text>", right - 4.0))
        };
        self.limits.iter().filter_map(draw).collect()
    }

    fn legend(&self) -> String {
        let mut x = FRAME.left;
        let mut out = String::new();
        for series in &self.series {
            let class = class(series.answer);
            let (from, to) = (x * FINE, (x + 24.0) * FINE);
            let sample = match self.dots {
                true => format!("<path class=\"dots {class}\" d=\"M{} 130h0\"/>", (from + to) / 2.0),
                false => format!("<path class=\"line {class}\" d=\"M{from} 130H{to}\"/>"),
            };
            out += &format!("<g transform=\"scale({})\">{sample}</g>", 1.0 / FINE);
            out += &format!("<text x=\"{}\" y=\"17\">{}</text>", x + 29.0, esc(series.answer));
            // The width of the text is not known here; 6.4 units for each letter is enough at this size.
            x += 29.0 + 6.4 * series.answer.chars().count() as f64 + 14.0;
        }
        out
    }
}

/// The style of an answer. Stock is drawn first, wide and pale, so that lines on top of it stay visible.
fn class(answer: &str) -> &'static str {
    match answer {
        "stock" => "stock",
        "replay" => "replay",
        "plugin" => "plugin",
        "two-body" => "two-body",
        _ => "other",
    }
}

/// Thins long curves. In every section the first and last point and the extremes of both coordinates are kept, so that no peak is
/// lost.
fn thin(spots: &[Spot]) -> Vec<Spot> {
    if spots.len() <= MANY {
        return spots.to_vec();
    }
    let mut kept = Vec::new();
    for stretch in spots.chunks(spots.len().div_ceil(STRETCHES)) {
        let there = || stretch.iter().enumerate().filter_map(|(k, spot)| Some((k, (*spot)?)));
        let keep: BTreeSet<usize> = [
            there().next().map(|(k, _)| k),
            there().min_by_key(|(_, spot)| spot.0).map(|(k, _)| k),
            there().max_by_key(|(_, spot)| spot.0).map(|(k, _)| k),
            there().min_by_key(|(_, spot)| spot.1).map(|(k, _)| k),
            there().max_by_key(|(_, spot)| spot.1).map(|(k, _)| k),
            there().next_back().map(|(k, _)| k),
            stretch.iter().position(Option::is_none),
        ]
        .into_iter()
        .flatten()
        .collect();
        kept.extend(keep.into_iter().map(|k| stretch[k]));
    }
    kept
}

/// A line through the points, broken where one is missing.
fn strokes(spots: &[Spot]) -> String {
    let mut path = String::new();
    let mut last: Spot = None;
    for spot in spots {
        match (last, spot) {
            (Some(before), Some(here)) if before == *here => continue,
            // Relative coordinates are shorter.
            (Some((x0, y0)), Some((x, y))) => path += &format!("l{} {}", x - x0, y - y0),
            // A line of length zero draws a single point as a dot.
            (None, Some((x, y))) => path += &format!("M{x} {y}h0"),
            (_, None) => {}
        }
        last = *spot;
    }
    path
}

/// A dot at each point; points at the same place are drawn once.
fn dots(spots: &[Spot]) -> String {
    let places: BTreeSet<(i32, i32)> = spots.iter().flatten().copied().collect();
    places.into_iter().map(|(x, y)| format!("M{x} {y}h0")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_every_peak_and_gap() {
        let mut spots: Vec<Spot> = (0..100_000).map(|k| Some((k / 20, 50))).collect();
        spots[41_234] = Some((41_234 / 20, 900));
        spots[77_777] = Some((77_777 / 20, -900));
        spots[9_999] = None;
        let kept = thin(&spots);
        assert!(kept.len() <= MANY + STRETCHES, "{}", kept.len());
        for wanted in [spots[0], spots[41_234], spots[77_777], None, spots[99_999]] {
            assert!(kept.contains(&wanted), "{wanted:?} got lost");
        }
    }

    #[test]
    fn short_curves_are_drawn_point_by_point() {
        let spots = [Some((0, 0)), Some((10, 5)), None, Some((20, 5)), Some((20, 5)), Some((30, 0))];
        assert_eq!(thin(&spots), spots);
        assert_eq!(strokes(&spots), "M0 0h0l10 5M20 5h0l10 -5");
        assert_eq!(dots(&spots), "M0 0h0M10 5h0M20 5h0M30 0h0");
    }
}
