//! The frame of a drawing: its place on the sheet, axes with ticks and grid.
use super::axis::Axis;
use super::escape::html as esc;

/// The sheet and the margins of the plotting area on it, in units of the drawing.
pub(super) struct Frame {
    pub width: f64,
    pub height: f64,
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// The place of a fraction of the horizontal axis.
    pub(super) fn across(&self, fraction: f64) -> f64 {
        self.left + fraction * (self.width - self.right - self.left)
    }

    /// The place of a fraction of the vertical axis.
    pub(super) fn up(&self, fraction: f64) -> f64 {
        self.height - self.bottom - fraction * (self.height - self.bottom - self.top)
    }

    /// Grid lines under the curves, or short ticks outside where cells fill the area.
    pub(super) fn axes(&self, x: &Axis, y: &Axis, grid: bool) -> String {
        let Frame { left, top, .. } = *self;
        let (right, bottom) = (self.width - self.right, self.height - self.bottom);
        let mut out = String::new();
        for tick in &x.ticks {
            let (at, text) = (self.across(tick.at), &tick.text);
            let line = if grid { format!("{top}V{bottom}") } else { format!("{bottom}v4") };
            out += &format!("<path class=\"grid\" d=\"M{at:.1} {line}\"/>");
            out += &format!("<text class=\"x\" x=\"{at:.1}\" y=\"{}\">{text}</text>", bottom + 15.0);
        }
        for tick in &y.ticks {
            let (at, text) = (self.up(tick.at), &tick.text);
            let line = if grid { format!("H{right}") } else { "h-4".into() };
            out += &format!("<path class=\"grid\" d=\"M{left} {at:.1}{line}\"/>");
            out += &format!("<text class=\"y\" x=\"{}\" y=\"{:.1}\">{text}</text>", left - 6.0, at + 4.0);
        }
        if let Some(at) = y.origin().map(|f| self.up(f)) {
            out += &format!("<path class=\"axis\" d=\"M{left} {at:.1}H{right}\"/>");
        }
        out += &format!("<path class=\"axis\" d=\"M{left} {top}V{bottom}H{right}\"/>");
        let middle = (left + right) / 2.0;
        out +=
            &format!("<text class=\"x\" x=\"{middle}\" y=\"{}\">{}</text>", self.height - 8.0, esc(&x.label));
        let (label, middle) = (esc(&y.label), (top + bottom) / 2.0);
        out + &format!("<text class=\"x\" transform=\"translate(13 {middle}) rotate(-90)\">{label}</text>")
    }
}
