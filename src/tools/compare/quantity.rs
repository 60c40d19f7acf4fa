//! The norm of all comparisons: the largest difference over a history, relative to the peak of the expected values.
use crate::report;
use nalgebra::Vector3;

/// Where a number comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spot {
    /// Time step.
    pub step: i64,
    /// Numbers of the two particles.
    pub tags: (i64, i64),
    /// Line of the trace.
    pub line: u64,
}

/// The largest difference of a quantity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// Where it is.
    pub spot: Spot,
    /// Which component, for instance `.x`; empty for a scalar.
    pub part: &'static str,
    /// The answer on trial.
    pub got: f64,
    /// The reference answer.
    pub expected: f64,
    /// The absolute difference; infinite where only one of the two is a number or either is NaN.
    pub difference: f64,
}

/// One physical quantity over a whole history.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// The largest finite magnitude that was expected.
    pub peak: f64,
    /// The largest difference; `None` while all values are equal.
    pub worst: Option<Worst>,
}

const AXES: [&str; 3] = [".x", ".y", ".z"];

impl Quantity {
    /// A quantity of which nothing was compared yet.
    pub fn new(name: impl Into<String>) -> Quantity {
        Quantity { name: name.into(), peak: 0.0, worst: None }
    }

    /// Compare two numbers.
    #[inline]
    pub fn number(&mut self, spot: Spot, got: f64, expected: f64) {
        self.raise(expected.abs());
        self.hold(spot, "", got, expected);
    }

    /// Compare two vectors: the error of each component is relative to the peak of the length.
    #[inline]
    pub fn vector(&mut self, spot: Spot, got: &Vector3<f64>, expected: &Vector3<f64>) {
        self.raise(expected.norm());
        for (k, part) in AXES.into_iter().enumerate() {
            self.hold(spot, part, got[k], expected[k]);
        }
    }

    fn raise(&mut self, size: f64) {
        if size > self.peak && size.is_finite() {
            self.peak = size;
        }
    }

    fn hold(&mut self, spot: Spot, part: &'static str, got: f64, expected: f64) {
        // Equal infinities agree; NaN agrees with nothing, so that it can never pass for an answer.
        if got == expected {
            return;
        }
        let difference = (got - expected).abs();
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        if self.worst.as_ref().is_none_or(|w| difference > w.difference) {
            self.worst = Some(Worst { spot, part, got, expected, difference });
        }
    }

    /// The largest difference relative to the peak; infinite if the peak is 0 and something differs.
    pub fn error(&self) -> f64 {
        self.worst.as_ref().map_or(0.0, |w| w.difference / self.peak)
    }

    /// Whether every value was equal to the last bit (zeros of either sign are equal).
    pub fn identical(&self) -> bool {
        self.worst.is_none()
    }

    /// The largest difference, as it stands in a report; `None` if nothing differs.
    pub fn report(&self) -> Option<report::Worst> {
        self.worst.as_ref().map(|w| report::Worst {
            step: w.spot.step,
            what: format!("{}{} of {}-{}", self.name, w.part, w.spot.tags.0, w.spot.tags.1),
            got: w.got,
            expected: w.expected,
            error: self.error(),
            norm: format!("relative to the peak of {}", self.name),
        })
    }

    /// The quantity with the largest error.
    pub fn worst_of(all: &[Quantity]) -> Option<&Quantity> {
        all.iter().max_by(|a, b| a.error().total_cmp(&b.error()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_is_the_largest_difference_over_the_peak() {
        let mut q = Quantity::new("force");
        let spot = |step| Spot { step, tags: (1, 2), line: 0 };
        q.vector(spot(1), &Vector3::new(3.0, 4.5, 0.0), &Vector3::new(3.0, 4.0, 0.0));
        q.vector(spot(2), &Vector3::new(0.25, 0.0, 0.0), &Vector3::zeros());
        assert_eq!((q.peak, q.error(), q.identical()), (5.0, 0.1, false));
        let w = q.report().unwrap();
        assert_eq!((w.step, w.what.as_str(), w.got, w.expected), (1, "force.y of 1-2", 4.5, 4.0));
    }

    #[test]
    fn equal_values_are_identical_and_nan_never_is() {
        let mut q = Quantity::new("kt");
        for x in [0.0, 1.0, f64::INFINITY] {
            q.number(Spot::default(), x, x);
        }
        q.number(Spot::default(), 0.0, -0.0);
        assert!(q.identical() && q.error() == 0.0);
        for (got, expected) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, f64::NAN), (f64::INFINITY, 1.0)]
        {
            let mut q = Quantity::new("kt");
            q.number(Spot::default(), 1.0, 1.0);
            q.number(Spot::default(), got, expected);
            assert_eq!((q.error(), q.identical()), (f64::INFINITY, false));
        }
    }

    #[test]
    fn something_where_nothing_was_expected_is_infinitely_wrong() {
        let mut q = Quantity::new("torque");
        q.number(Spot::default(), 1e-300, 0.0);
        assert_eq!(q.error(), f64::INFINITY);
    }
}
