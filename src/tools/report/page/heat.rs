//! Maps: a field of coloured cells, with borders and with points at which another program was run.
use super::{Map, Scale, Spot};
use crate::report::axis::Axis;
use crate::report::escape::html as esc;
use crate::report::frame::Frame;

const FRAME: Frame = Frame { width: 820.0, height: 440.0, left: 64.0, right: 272.0, top: 14.0, bottom: 46.0 };
/// Colours in the style sheet, from good to bad.
const TONES: usize = 8;
/// Strokes of borders in the style sheet.
const STROKES: usize = 6;

/// The map as an SVG element.
pub(super) fn svg(map: &Map) -> String {
    let (x, y) = (Side::new(&map.x), Side::new(&map.y));
    let mut out = cells(map) + &FRAME.axes(&x.axis, &y.axis, false);
    let place = |(px, py): (f64, f64)| Some((FRAME.across(x.inside(px)?), FRAME.up(y.inside(py)?)));
    for (k, border) in map.borders.iter().enumerate() {
        let mut d = String::new();
        let mut pen_down = false;
        for point in &border.points {
            let at = place(*point);
            if let Some((px, py)) = at {
                d += &format!("{}{px:.1} {py:.1}", if pen_down { "L" } else { "M" });
            }
            pen_down = at.is_some();
        }
        out += &format!(
            "<path class=\"border under\" d=\"{d}\"/><path class=\"border b{}\" d=\"{d}\"/>",
            k % STROKES
        );
    }
    for spot in &map.spots {
        if let Some(at) = place((spot.x, spot.y)) {
            out += &dot(spot, at);
        }
    }
    let Frame { width, height, .. } = FRAME;
    out += &legend(map);
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">{out}</svg>",
        esc(&map.caption)
    )
}

/// An axis over the cells; it ends half a cell beyond the middles of the first and the last.
struct Side {
    axis: Axis,
}

impl Side {
    fn new(scale: &Scale) -> Side {
        let (first, last) = (scale.values[0], scale.values[scale.values.len() - 1]);
        let n = (scale.values.len().max(2) - 1) as f64;
        let axis = if scale.log {
            let half = (last / first).powf(0.5 / n);
            Axis::ratio(first / half, last * half, &scale.label)
        } else {
            let half = 0.5 * (last - first) / n;
            Axis::exact(first - half, last + half, &scale.label)
        };
        Side { axis }
    }

    fn inside(&self, value: f64) -> Option<f64> {
        self.axis.place(value).filter(|at| (-1e-9..=1.0 + 1e-9).contains(at))
    }
}

/// One path for each outcome; neighbouring cells of a row are drawn as one bar.
fn cells(map: &Map) -> String {
    let (nx, ny) = (map.x.values.len(), map.y.values.len());
    let mut paths = vec![String::new(); map.classes.len()];
    for row in 0..ny {
        let cells = &map.cells[row * nx..(row + 1) * nx];
        let (top, bottom) = (FRAME.up((row + 1) as f64 / ny as f64), FRAME.up(row as f64 / ny as f64));
        let mut from = 0;
        for k in 1..=nx {
            if k < nx && cells[k] == cells[from] {
                continue;
            }
            let (left, right) = (FRAME.across(from as f64 / nx as f64), FRAME.across(k as f64 / nx as f64));
            paths[cells[from]] += &format!("M{left:.1} {top:.1}H{right:.1}V{bottom:.1}H{left:.1}z");
            from = k;
        }
    }
    let path = |(k, d): (usize, &String)| format!("<path class=\"cell t{}\" d=\"{d}\"/>", tone(map, k));
    paths.iter().enumerate().map(path).collect()
}

/// Spreads the outcomes evenly over the colours; the first and the last get those at the ends.
fn tone(map: &Map, class: usize) -> usize {
    let n = map.classes.len().max(2) - 1;
    (class * (TONES - 1) + n / 2) / n
}

fn dot(spot: &Spot, (x, y): (f64, f64)) -> String {
    let class = if spot.agrees { "same" } else { "differs" };
    let d = if spot.agrees {
        format!("M{:.1} {y:.1}a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0", x - 3.2)
    } else {
        format!("M{:.1} {:.1}l8 8m0 -8l-8 8", x - 4.0, y - 4.0)
    };
    format!("<path class=\"spot {class}\" d=\"{d}\"><title>{}</title></path>", esc(&spot.label))
}

fn legend(map: &Map) -> String {
    let x = FRAME.width - FRAME.right + 18.0;
    let mut y = FRAME.top + 6.0;
    let mut out = String::new();
    for (k, class) in map.classes.iter().enumerate().filter(|(k, _)| map.cells.contains(k)) {
        out += &format!("<path class=\"cell t{}\" d=\"M{x} {y}h22v12h-22z\"/>", tone(map, k));
        out += &format!("<text x=\"{}\" y=\"{}\">{}</text>", x + 30.0, y + 10.0, esc(class));
        y += 20.0;
    }
    y += 8.0;
    for (k, border) in map.borders.iter().enumerate() {
        let d = format!("M{x} {}h22", y + 6.0);
        out += &format!(
            "<path class=\"border under\" d=\"{d}\"/><path class=\"border b{}\" d=\"{d}\"/>",
            k % STROKES
        );
        out += &format!("<text x=\"{}\" y=\"{}\">{}</text>", x + 30.0, y + 10.0, esc(&border.name));
        y += 20.0;
    }
    for (agrees, word) in [(true, "live, same outcome"), (false, "live, another outcome")] {
        if map.spots.iter().any(|s| s.agrees == agrees) {
            let spot = Spot { agrees, ..Spot::default() };
            out += &dot(&spot, (x + 11.0, y + 6.0));
            out += &format!("<text x=\"{}\" y=\"{}\">{word}</text>", x + 30.0, y + 10.0);
            y += 20.0;
        }
    }
    out
}
