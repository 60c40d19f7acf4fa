//! Bars: groups of numbers with their ranges, one bar for each series.
use super::{Bars, Spread};
use crate::report::axis::{drawable, Axis};
use crate::report::escape::{html as esc, plain};
use crate::report::frame::Frame;

/// Thickness of a bar, and the gap between groups.
const BAR: f64 = 13.0;
const GAP: f64 = 12.0;
/// Colours in the style sheet.
const COLOURS: usize = 9;

/// The bars as an SVG element, one below the other.
pub(super) fn svg(bars: &Bars) -> String {
    let tall = |g: &super::Group| GAP + BAR * g.bars.len() as f64;
    let height = 66.0 + bars.groups.iter().map(tall).sum::<f64>();
    let frame = Frame { width: 820.0, height, left: 150.0, right: 60.0, top: 28.0, bottom: 38.0 };
    let highs = bars.groups.iter().flat_map(|g| &g.bars).map(|(_, s)| s.high).filter(|x| drawable(*x));
    let x = Axis::exact(0.0, highs.fold(0.0, f64::max).max(f64::MIN_POSITIVE) * 1.04, &bars.label);
    let mut y = Axis::exact(0.0, 1.0, "");
    y.ticks.clear();
    let mut out = frame.axes(&x, &y, true) + &legend(bars, &frame);
    let mut top = frame.top + 0.5 * GAP;
    for group in &bars.groups {
        let middle = top + 0.5 * BAR * group.bars.len() as f64;
        out += &format!(
            "<text class=\"y\" x=\"{}\" y=\"{:.1}\">{}</text>",
            frame.left - 8.0,
            middle + 4.0,
            esc(&group.name)
        );
        for (series, spread) in &group.bars {
            out += &bar(bars, group, *series, spread, (&frame, &x, top));
            top += BAR;
        }
        top += GAP;
    }
    format!(
        "<svg viewBox=\"0 0 820 {height}\" role=\"img\" aria-label=\"{}\">{out}</svg>",
        esc(&bars.caption)
    )
}

fn bar(bars: &Bars, group: &super::Group, series: usize, s: &Spread, at: (&Frame, &Axis, f64)) -> String {
    let (frame, axis, top) = at;
    let place = |value: f64| axis.place(value).map(|f| frame.across(f));
    let (Some(end), Some(low), Some(high)) = (place(s.at), place(s.low), place(s.high)) else {
        return String::new();
    };
    let (left, middle, bottom) = (frame.left, top + 0.5 * BAR, top + BAR - 1.0);
    let title = esc(&format!("{}, {}: {} ({} to {})", group.name, bars.series[series], s.at, s.low, s.high));
    let whisker = if high > low {
        format!("<path class=\"whisker\" d=\"M{low:.1} {middle:.1}H{high:.1}\"/>")
    } else {
        String::new()
    };
    format!(
        "<g class=\"c{}\"><path class=\"mark\" d=\"M{left} {top:.1}H{end:.1}V{bottom:.1}H{left}z\"><title>{title}</title></path>\
         {whisker}<text class=\"sub\" x=\"{:.1}\" y=\"{:.1}\">{}</text></g>",
        series % COLOURS,
        high.max(end) + 5.0,
        middle + 4.0,
        plain(s.at),
    )
}

fn legend(bars: &Bars, frame: &Frame) -> String {
    let mut x = frame.left;
    let mut out = String::new();
    for (k, name) in bars.series.iter().enumerate() {
        out += &format!(
            "<g class=\"c{}\"><path class=\"mark\" d=\"M{x} 6h11v11h-11z\"/><text x=\"{}\" y=\"16\">{}</text></g>",
            k % COLOURS,
            x + 16.0,
            esc(name)
        );
        x += 34.0 + 6.6 * name.chars().count() as f64;
    }
    out
}
