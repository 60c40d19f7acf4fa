//! Histograms of quantities that span many decades, in bounded memory.
use serde::{Deserialize, Serialize};

/// Bins in an octave. The width of a bin is at most an eighth of its lower edge.
const PARTS: u64 = 8;
/// The bits of an `f64` that are below its exponent and the bits that number the bin in the octave.
const BELOW: u32 = 52 - PARTS.trailing_zeros();
/// The lowest bin begins at 2⁻⁶⁴ and the highest ends at 2⁶⁴; values beyond count in the outermost bins.
const LOWEST: u64 = (1023 - 64) * PARTS;
const BINS: usize = 128 * PARTS as usize;

/// How often each size occurred. The edges of the bins are the powers of two, and seven numbers evenly between each two of them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "Written", into = "Written")]
pub struct Histogram {
    counts: Vec<u64>,
    zero: u64,
    count: u64,
    sum: f64,
    range: Option<(f64, f64)>,
}

/// A bin that is not empty. Its values are at least `from` and below `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bin {
    /// Lower edge.
    pub from: f64,
    /// Upper edge.
    pub to: f64,
    /// Number of values.
    pub count: u64,
}

impl Histogram {
    /// Counts `x`, `weight` times. What is not above zero counts as zero; NaN is not counted.
    pub fn add(&mut self, x: f64, weight: u64) {
        if x.is_nan() {
            return;
        }
        let x = x.max(0.0);
        self.count += weight;
        self.sum += x * weight as f64;
        let (low, high) = self.range.unwrap_or((x, x));
        self.range = Some((low.min(x), high.max(x)));
        if x == 0.0 {
            self.zero += weight;
            return;
        }
        if self.counts.is_empty() {
            self.counts = vec![0; BINS];
        }
        self.counts[bin(x)] += weight;
    }

    /// Adds the counts of another histogram.
    pub fn merge(&mut self, other: &Histogram) {
        if self.counts.is_empty() {
            self.counts.clone_from(&other.counts);
        } else {
            self.counts.iter_mut().zip(&other.counts).for_each(|(a, b)| *a += b);
        }
        self.zero += other.zero;
        self.count += other.count;
        self.sum += other.sum;
        self.range = match (self.range, other.range) {
            (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
            (a, b) => a.or(b),
        };
    }

    /// Number of values counted.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Number of values that were zero.
    pub fn zero(&self) -> u64 {
        self.zero
    }

    /// Their mean; `None` if there are none.
    pub fn mean(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }

    /// The smallest and the largest, exactly; `None` if there are none.
    pub fn range(&self) -> Option<(f64, f64)> {
        self.range
    }

    /// The bins that are not empty, from the lowest; zeros are in none of them.
    pub fn bins(&self) -> impl Iterator<Item = Bin> + '_ {
        let filled = self.counts.iter().enumerate().filter(|(_, n)| **n > 0);
        filled.map(|(k, n)| Bin { from: edge(k), to: edge(k + 1), count: *n })
    }

    /// The quantile: a size that this share of all values does not exceed, to the width of a bin; `None` if there are none.
    pub fn quantile(&self, share: f64) -> Option<f64> {
        let (low, high) = self.range?;
        let wanted = (share * self.count as f64).max(1.0);
        let mut seen = self.zero as f64;
        if seen >= wanted {
            return Some(0.0);
        }
        for b in self.bins() {
            seen += b.count as f64;
            if seen >= wanted {
                return Some(b.to.clamp(low, high));
            }
        }
        Some(high)
    }
}

fn bin(x: f64) -> usize {
    ((x.to_bits() >> BELOW).saturating_sub(LOWEST) as usize).min(BINS - 1)
}

fn edge(k: usize) -> f64 {
    f64::from_bits((k as u64 + LOWEST) << BELOW)
}

/// A histogram in a file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    count: u64,
    zero: u64,
    sum: f64,
    range: Option<(f64, f64)>,
    /// `[from, to, count]` of each bin with something in it.
    bins: Vec<(f64, f64, u64)>,
}

impl From<Histogram> for Written {
    fn from(h: Histogram) -> Written {
        let bins = h.bins().map(|b| (b.from, b.to, b.count)).collect();
        // JSON has no infinity.
        let finite = |x: f64| x.clamp(f64::MIN, f64::MAX);
        let range = h.range.map(|(low, high)| (finite(low), finite(high)));
        Written { count: h.count, zero: h.zero, sum: finite(h.sum), range, bins }
    }
}

impl From<Written> for Histogram {
    fn from(w: Written) -> Histogram {
        let mut counts = if w.bins.is_empty() { Vec::new() } else { vec![0; BINS] };
        w.bins.iter().for_each(|(from, to, n)| counts[bin(0.5 * (from + to))] += n);
        Histogram { counts, zero: w.zero, count: w.count, sum: w.sum, range: w.range }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_size_lies_between_the_edges_of_its_bin() {
        let mut x = 1e-15;
        while x < 1e15 {
            let k = bin(x);
            assert!(edge(k) <= x && x < edge(k + 1), "{x:e}");
            assert_eq!(bin(edge(k)), k);
            x *= 1.0437;
        }
        assert_eq!((edge(bin(1.0)), edge(bin(1.0) + 1)), (1.0, 1.125));
        assert_eq!((bin(1e-300), bin(f64::INFINITY)), (0, BINS - 1));
    }

    #[test]
    fn counts_mean_range_and_quantiles() {
        let mut h = Histogram::default();
        (1..=1000).for_each(|k| h.add(f64::from(k), 1));
        h.add(0.0, 10);
        h.add(-1.0, 1);
        h.add(f64::NAN, 7);
        assert_eq!((h.count(), h.zero(), h.range()), (1011, 11, Some((0.0, 1000.0))));
        assert_eq!(h.mean(), Some(500_500.0 / 1011.0));
        let median = h.quantile(0.5).unwrap();
        assert!((495.0..=495.0 * 1.125).contains(&median), "{median}");
        assert_eq!((h.quantile(0.01), h.quantile(1.0)), (Some(0.0), Some(1000.0)));
        assert_eq!(Histogram::default().quantile(0.5), None);
    }

    #[test]
    fn a_file_and_a_merge_lose_nothing() {
        let (mut a, mut b, mut both) = <(Histogram, Histogram, Histogram)>::default();
        for k in 0..500 {
            let x = 1e-9 * 1.1f64.powi(k);
            [&mut both, if k % 3 == 0 { &mut a } else { &mut b }].into_iter().for_each(|h| h.add(x, 2));
        }
        let text = serde_json::to_string(&b).unwrap();
        a.merge(&serde_json::from_str(&text).unwrap());
        assert_eq!((a.count(), a.range()), (both.count(), both.range()));
        assert!(a.bins().eq(both.bins()));
    }
}
