//! Numbers as text, and escaping, which is done nowhere else.

/// Text that is safe between tags and inside quoted attributes of HTML and SVG.
pub(super) fn html(raw: &str) -> String {
    let mut out = String::with_capacity(raw.len());
    for c in raw.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\n' | '\t' => out.push(c),
            // Control characters, such as terminal colours in a log, are not allowed in a page.
            _ if c.is_control() => out.push('\u{fffd}'),
            _ => out.push(c),
        }
    }
    out
}

/// Text that is safe in one line or table cell of Markdown, where it must not become markup either.
pub(super) fn markdown(raw: &str) -> String {
    let mut out = String::with_capacity(raw.len());
    for c in raw.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\\' | '`' | '*' | '[' | ']' | '|' | '~' | '#' => out.extend(['\\', c]),
            _ if c.is_control() => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

/// All digits of a number, the shortest that read back as the same number.
pub(super) fn exact(value: f64) -> String {
    // From a million on, an exponent is easier to read than zeros.
    let text = if value.abs() >= 1e6 { format!("{value:e}") } else { format!("{value:?}") };
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// A number to three digits, for errors and limits.
pub(crate) fn rough(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let text = format!("{value:.2e}");
    match text.split_once('e') {
        Some((digits, power)) if digits.contains('.') => {
            format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
        }
        _ => text,
    }
}

/// A number to three digits, with an exponent only for very large and very small ones.
pub(super) fn plain(value: f64) -> String {
    let size = value.abs();
    if !(1e-2..1e5).contains(&size) {
        return rough(value);
    }
    let decimals = (2.0 - size.log10().floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

/// A wall-clock time.
pub(super) fn seconds(value: f64) -> String {
    match value {
        v if !v.is_finite() => "–".into(),
        v if v < 10.0 => format!("{v:.2} s"),
        v => format!("{v:.0} s"),
    }
}

/// A count with thin gaps between thousands, as people read it.
pub(super) fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut out = String::new();
    for (k, c) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(c);
    }
    out
}

/// `1 check`, `2 checks`.
pub(super) fn plural(n: usize, noun: &str) -> String {
    format!("{n} {noun}{}", if n == 1 { "" } else { "s" })
}

/// Splits two texts after their common beginning, so that the digits that differ can be marked.
pub(super) fn differ<'a>(a: &'a str, b: &'a str) -> ((&'a str, &'a str), (&'a str, &'a str)) {
    let same = a.bytes().zip(b.bytes()).take_while(|(x, y)| x == y).count();
    // Numbers are ASCII, but a cut inside a character must not panic whatever is passed.
    let cut = (0..=same).rev().find(|&k| a.is_char_boundary(k) && b.is_char_boundary(k)).unwrap_or(0);
    (a.split_at(cut), b.split_at(cut))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_taken_apart() {
        assert_eq!(html("a<b> & \"c\" 'd'\u{1b}"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;\u{fffd}");
        assert_eq!(markdown("a|b\n<i> [x](y) `z` *"), "a\\|b &lt;i&gt; \\[x\\](y) \\`z\\` \\*");
    }

    #[test]
    fn numbers_keep_what_they_promise() {
        for (value, all, three) in [
            (0.0, "0", "0"),
            (3.0, "3", "3e0"),
            (0.1 + 0.2, "0.30000000000000004", "3e-1"),
            (1.23456e-15, "1.23456e-15", "1.23e-15"),
            (-5e6, "-5e6", "-5e6"),
            (123456.5, "123456.5", "1.23e5"),
            (f64::NAN, "NaN", "NaN"),
            (f64::INFINITY, "inf", "inf"),
        ] {
            assert_eq!((exact(value).as_str(), rough(value).as_str()), (all, three));
        }
        assert_eq!(count(1234567), "1\u{202f}234\u{202f}567");
        assert_eq!(count(12), "12");
    }

    #[test]
    fn plain_numbers_have_three_digits() {
        for (value, text) in
            [(0.0, "0"), (0.0123, "0.0123"), (1.0, "1.00"), (25.37, "25.4"), (2613.2, "2613"), (4e-7, "4e-7")]
        {
            assert_eq!(plain(value), text);
        }
    }

    #[test]
    fn the_digits_that_differ_are_found() {
        assert_eq!(differ("-0.3360", "-0.3361"), (("-0.336", "0"), ("-0.336", "1")));
        assert_eq!(differ("NaN", "1"), (("", "NaN"), ("", "1")));
        assert_eq!(differ("é", "è"), (("", "é"), ("", "è")));
    }
}
