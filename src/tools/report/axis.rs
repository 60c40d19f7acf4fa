//! Axes of plots: from numbers to fractions of the plotting area, with round ticks in engineering notation.

/// Numbers beyond this would overflow the arithmetic of an axis; they are treated as not finite.
const HUGE: f64 = 1e150;

/// Relative errors outside these powers of ten are drawn at the edge; nothing useful lies beyond.
const DECADES: (i32, i32) = (-20, 20);

/// The power of ten where a logarithmic axis begins at the latest.
const ROUND_OFF: f64 = -17.0;

/// Share of a logarithmic axis below its first decade that is kept for errors of exactly zero.
const ZERO_STRIP: f64 = 0.1;

const PREFIXES: [(i32, &str); 10] = [
    (-15, "f"),
    (-12, "p"),
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
    (12, "T"),
];

pub(super) struct Tick {
    /// Its place, as a fraction of the axis.
    pub at: f64,
    pub text: String,
}

pub(super) struct Axis {
    pub label: String,
    pub ticks: Vec<Tick>,
    scale: Scale,
}

enum Scale {
    Linear {
        low: f64,
        high: f64,
    },
    /// Powers of ten of both ends, and the share of the axis below them.
    Log {
        low: f64,
        high: f64,
        strip: f64,
    },
}

/// Whether a number can be drawn.
pub(super) fn drawable(value: f64) -> bool {
    value.is_finite() && value.abs() < HUGE
}

impl Axis {
    /// A linear axis over the drawable values, widened at both ends by `margin` of their range.
    pub(super) fn linear(values: impl Iterator<Item = f64>, quantity: &str, unit: &str, margin: f64) -> Axis {
        let (low, high) = range(values.filter(|v| drawable(*v))).unwrap_or((0.0, 1.0));
        let widest = low.abs().max(high.abs());
        // If all values are equal, or nearly so, the axis still needs a width.
        let (low, high) = match high - low > 1e-12 * widest {
            true => (low - margin * (high - low), high + margin * (high - low)),
            false if widest == 0.0 => (-1.0, 1.0),
            false => (low - 0.5 * widest, high + 0.5 * widest),
        };
        let (power, unit) = engineering(low.abs().max(high.abs()), unit);
        let scale = Scale::Linear { low, high };
        let mut axis = Axis { label: format!("{quantity} [{unit}]"), ticks: Vec::new(), scale };
        axis.ticks = linear_ticks(low, high, power, &axis);
        axis
    }

    /// A linear axis from `low` to `high`.
    pub(super) fn exact(low: f64, high: f64, label: &str) -> Axis {
        let mut axis = Axis { label: label.into(), ticks: Vec::new(), scale: Scale::Linear { low, high } };
        axis.ticks = linear_ticks(low, high, 0, &axis);
        axis
    }

    /// A logarithmic axis of errors: as [`Axis::decades`], but at least down to round-off.
    pub(super) fn log(values: impl Iterator<Item = f64>, quantity: &str) -> Axis {
        Axis::down_to(ROUND_OFF, values, quantity)
    }

    /// A logarithmic axis over the magnitudes of the values, with a separate place for exact zeros.
    pub(super) fn decades(values: impl Iterator<Item = f64>, quantity: &str) -> Axis {
        Axis::down_to(f64::INFINITY, values, quantity)
    }

    /// An axis over whole decades that hold the magnitudes of the values and this power of ten.
    fn down_to(power: f64, values: impl Iterator<Item = f64>, quantity: &str) -> Axis {
        let sizes: Vec<f64> = values.filter(|v| drawable(*v)).map(f64::abs).collect();
        let positive = sizes.iter().copied().filter(|v| *v > 0.0).map(f64::log10);
        let (low, high) = range(positive).unwrap_or((-17.0, -12.0));
        let clamp = |power: f64| power.clamp(DECADES.0.into(), DECADES.1.into());
        let (low, high) = (clamp(low.floor().min(power)), clamp(high.ceil()));
        let high = if high > low { high } else { low + 1.0 };
        let strip = if sizes.contains(&0.0) { ZERO_STRIP } else { 0.0 };
        let scale = Scale::Log { low, high, strip };
        let mut axis = Axis { label: quantity.into(), ticks: Vec::new(), scale };
        axis.ticks = log_ticks(low as i32, high as i32, strip > 0.0, &axis);
        axis
    }

    /// A logarithmic axis from `low` to `high`, both above zero, with ticks at 1, 2 and 5.
    pub(super) fn ratio(low: f64, high: f64, label: &str) -> Axis {
        let scale = Scale::Log { low: low.log10(), high: high.log10(), strip: 0.0 };
        let mut axis = Axis { label: label.into(), ticks: Vec::new(), scale };
        let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
        // Over more than two decades ticks at 2 and 5 would be too close.
        let within: &[f64] = if last - first > 3 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let all = (first..=last).flat_map(|p| within.iter().map(move |m| m * 10f64.powi(p)));
        axis.ticks = all
            .filter(|v| (low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(v))
            .filter_map(|v| Some(Tick { at: axis.place(v)?, text: format!("{v}") }))
            .collect();
        axis
    }

    /// The fraction of the axis at which a number lies; `None` for one that cannot be drawn.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        if !drawable(value) {
            return None;
        }
        Some(match self.scale {
            Scale::Linear { low, high } => (value - low) / (high - low),
            Scale::Log { strip, .. } if value == 0.0 => 0.4 * strip,
            Scale::Log { low, high, strip } => {
                let inside = (value.abs().log10() - low) / (high - low);
                strip + (1.0 - strip) * inside.clamp(0.0, 1.0)
            }
        })
    }

    /// The fraction at which zero lies, if it is inside a linear axis.
    pub(super) fn origin(&self) -> Option<f64> {
        match self.scale {
            Scale::Linear { low, high } if low < 0.0 && high > 0.0 => self.place(0.0),
            _ => None,
        }
    }
}

fn range(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.fold(None, |found, v| match found {
        None => Some((v, v)),
        Some((low, high)) => Some((v.min(low), v.max(high))),
    })
}

/// The power of ten, a multiple of three, that makes numbers up to `widest` readable, and the unit with that prefix.
fn engineering(widest: f64, unit: &str) -> (i32, String) {
    if widest == 0.0 {
        return (0, unit.into());
    }
    let power = 3 * (widest.log10() / 3.0 + 1e-9).floor() as i32;
    match PREFIXES.iter().find(|(p, _)| *p == power) {
        Some((_, prefix)) => (power, format!("{prefix}{unit}")),
        None => (power, format!("10{} {unit}", superscript(power))),
    }
}

fn linear_ticks(low: f64, high: f64, power: i32, axis: &Axis) -> Vec<Tick> {
    let one = 10f64.powi(power);
    let step = round_step((high - low) / 5.0);
    let decimals = (f64::from(power) - step.log10() - 1e-9).ceil().max(0.0) as usize;
    let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
    // Far from zero ticks may be closer than doubles can tell apart, so their number is limited.
    (0..=(last - first).clamp(0.0, 12.0) as i32)
        .filter_map(|k| {
            let value = (first + f64::from(k)) * step;
            // Adding zero turns -0 into 0.
            Some(Tick { at: axis.place(value)?, text: format!("{:.decimals$}", value / one + 0.0) })
        })
        .collect()
}

/// The next of 1, 2, 5 times a power of ten.
fn round_step(raw: f64) -> f64 {
    let base = 10f64.powf(raw.log10().floor());
    let round = [1.0, 2.0, 5.0].into_iter().find(|m| m * base >= raw * (1.0 - 1e-9));
    round.unwrap_or(10.0) * base
}

fn log_ticks(low: i32, high: i32, zero: bool, axis: &Axis) -> Vec<Tick> {
    let every = ((high - low + 6) / 7).max(1);
    let decades = (low..=high).filter(|p| (p - low) % every == 0);
    let zero = zero.then(|| (0.0, "0".to_owned()));
    decades
        .map(|p| (10f64.powi(p), format!("10{}", superscript(p))))
        .chain(zero)
        .filter_map(|(value, text)| Some(Tick { at: axis.place(value)?, text }))
        .collect()
}

fn superscript(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    power.to_string().chars().map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|t| t.text.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_and_carry_a_prefix() {
        let axis = Axis::linear([0.0, 1.13e-4].into_iter(), "time", "s", 0.0);
        assert_eq!((axis.label.as_str(), texts(&axis)), ("time [µs]", vec!["0", "50", "100"]));
        let axis = Axis::linear([-0.2, 1.4].into_iter(), "force", "N", 0.0);
        assert_eq!((axis.label.as_str(), texts(&axis)), ("force [N]", vec!["0.0", "0.5", "1.0"]));
        let axis = Axis::linear([2e-20, 4e-20].into_iter(), "overlap", "m", 0.0);
        assert_eq!(axis.label, "overlap [10⁻²¹ m]");
    }

    #[test]
    fn degenerate_ranges_stay_finite() {
        for values in [vec![], vec![0.0], vec![3.0, 3.0], vec![f64::NAN, f64::INFINITY], vec![1e149, -1e149]]
        {
            let axis = Axis::linear(values.iter().copied(), "x", "m", 0.05);
            assert!(!axis.ticks.is_empty(), "{values:?}");
            assert!(axis.ticks.iter().all(|t| (-0.01..=1.01).contains(&t.at)), "{values:?}");
        }
    }

    #[test]
    fn a_ratio_keeps_its_ends() {
        let axis = Axis::ratio(0.05, 0.9, "share");
        assert_eq!(texts(&axis), ["0.05", "0.1", "0.2", "0.5"]);
        assert_eq!((axis.place(0.05), axis.place(0.9)), (Some(0.0), Some(1.0)));
        assert_eq!(texts(&Axis::ratio(1.0, 1e4, "ratio")), ["1", "10", "100", "1000", "10000"]);
    }

    #[test]
    fn exact_zeros_have_their_own_place_on_a_log_axis() {
        let axis = Axis::log([0.0, 3e-16, -2e-14].into_iter(), "error");
        assert_eq!(texts(&axis), ["10⁻¹⁷", "10⁻¹⁶", "10⁻¹⁵", "10⁻¹⁴", "10⁻¹³", "0"]);
        let (zero, small) = (axis.place(0.0).unwrap(), axis.place(3e-16).unwrap());
        assert!(zero < ZERO_STRIP && small > ZERO_STRIP);
        assert_eq!(axis.place(2e-14), axis.place(-2e-14));
        assert_eq!(axis.place(f64::NAN), None);
    }
}
