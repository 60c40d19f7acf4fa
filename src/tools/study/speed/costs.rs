//! The cost of a computation: medians of repeated timings, with their quartiles.
use crate::report::page::Spread;
use std::time::Instant;

/// A time and its spread \[s\].
pub type Cost = Spread;

/// The median and the quartiles of some numbers.
pub fn quartiles(mut numbers: Vec<f64>) -> Spread {
    numbers.sort_by(f64::total_cmp);
    let at = |q: f64| {
        let x = q * (numbers.len() as f64 - 1.0);
        let (k, part) = (x as usize, x.fract());
        let next = numbers[(k + 1).min(numbers.len() - 1)];
        numbers[k] + part * (next - numbers[k])
    };
    Spread { at: at(0.5), low: at(0.25), high: at(0.75) }
}

/// Time of `work` divided by `units`, over `rounds` rounds. One more round before them, to warm up, is not counted.
pub fn time(rounds: usize, units: f64, mut work: impl FnMut()) -> Cost {
    let one = |_| {
        let begun = Instant::now();
        work();
        begun.elapsed().as_secs_f64() / units
    };
    let all: Vec<f64> = (0..=rounds).map(one).skip(1).collect();
    quartiles(all)
}
