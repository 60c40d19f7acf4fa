//! Values for the variable of a deck that seeds its random numbers.

/// Distance between seeds. Multiplicative generators with close seeds begin with similar numbers.
const APART: u64 = 1_000_003;
/// Seeds must be prime numbers above the first of these for LIGGGHTS, and fit into an `int` of C.
const RANGE: std::ops::Range<u64> = 10_000..2_000_000_000;

/// A list of `many` seeds. It begins with `first`; the others are prime numbers, as LIGGGHTS wants them.
///
/// # Errors
/// More than one is wanted, and the first is no whole number.
pub fn seeds(first: &str, many: usize) -> Result<Vec<String>, String> {
    let begin: u64 = match first.parse() {
        Ok(n) => n,
        Err(_) if many <= 1 => 0,
        Err(_) => return Err(format!("{first} must be a whole number where more than one seed is wanted")),
    };
    let next = |k: u64| {
        let from = RANGE.start + (begin + k * APART) % (RANGE.end - RANGE.start);
        (from..).find(|n| prime(*n)).expect("there is no largest prime number").to_string()
    };
    Ok(std::iter::once(first.to_string()).chain((1..).map(next)).take(many).collect())
}

fn prime(n: u64) -> bool {
    n > 1 && (2..).take_while(|k| k * k <= n).all(|k| !n.is_multiple_of(k))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_are_different_prime_numbers_behind_the_first() {
        let all = seeds("32452867", 60).unwrap();
        let numbers: Vec<u64> = all.iter().map(|s| s.parse().unwrap()).collect();
        assert!(all.len() == 60 && all[0] == "32452867" && numbers[1..].iter().all(|n| prime(*n)));
        assert!(numbers.iter().all(|n| RANGE.contains(n)));
        let apart = |k: usize| numbers[..k].iter().all(|m| m.abs_diff(numbers[k]) > APART / 2);
        assert!((1..60).all(apart));
        assert_eq!(seeds("1999999999", 2).unwrap().len(), 2);
        assert_eq!(seeds("cold", 1).unwrap(), ["cold"]);
        assert!(seeds("cold", 2).unwrap_err().contains("whole number"));
        assert!(prime(2) && prime(10_007) && !prime(10_001) && !prime(1) && !prime(9));
    }
}
