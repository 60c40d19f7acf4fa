//! What the commands share: numbers in, text out.
use std::io::Write;

/// The largest difference that is allowed.
pub fn tolerance(text: &str) -> Result<f64, String> {
    let limit = text.parse().ok().filter(|x: &f64| x.is_finite() && *x >= 0.0);
    limit.ok_or("must be a number, 0 or above, such as 1e-12".into())
}

/// A time above 0, in seconds.
pub fn seconds(text: &str) -> Result<f64, String> {
    let limit = text.parse().ok().filter(|s: &f64| *s > 0.0 && *s < 1e9);
    limit.ok_or("must be a number of seconds above 0".into())
}

/// Prints to standard output. A reader that closes the pipe early is no error.
pub fn print(text: &str) {
    let _ = std::io::stdout().write_all(text.as_bytes());
}
