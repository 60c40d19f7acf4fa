//! Rust source as words: names and signs, without comments, texts and what is compiled for tests only.

/// A name, or a single sign. `::` is one word.
pub type Words = Vec<String>;

/// The words of a source. Comments, texts and characters are left out, as are items under `#[cfg(test)]`.
pub fn words(source: &str) -> Words {
    let mut rest = source;
    let mut words = Words::new();
    while let Some(first) = rest.chars().next() {
        let length = match first {
            _ if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            _ if rest.starts_with("/*") => comment(rest),
            _ if raw(rest).is_some() => raw(rest).unwrap_or(1),
            '"' => {
                let end = text(rest);
                // serde and clap take paths as texts.
                if words.last().is_some_and(|w| w == "=") && rest[1..end].contains("::") {
                    words.extend(path(rest[1..end].trim_end_matches('"')));
                }
                end
            }
            '\'' => character(rest),
            _ if first.is_alphanumeric() || first == '_' => {
                let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
                words.push(rest[..end].to_owned());
                end
            }
            _ if rest.starts_with("::") => {
                words.push("::".to_owned());
                2
            }
            _ => {
                if !first.is_whitespace() {
                    words.push(first.to_string());
                }
                first.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    without_tests(words)
}

/// The words of a text that is a path, such as `numbers::number`; of another, none.
fn path(text: &str) -> Vec<String> {
    let names: Vec<_> = text.split("::").collect();
    let name = |n: &&str| !n.is_empty() && n.chars().all(|c| c.is_alphanumeric() || c == '_');
    if !names.iter().all(name) {
        return Vec::new();
    }
    names.join(" :: ").split(' ').map(str::to_owned).collect()
}

/// The length of a comment that may hold others.
fn comment(source: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < source.len() {
        let rest = &source.as_bytes()[at..];
        if rest.starts_with(b"/*") {
            (depth, at) = (depth + 1, at + 2);
        } else if rest.starts_with(b"*/") {
            (depth, at) = (depth - 1, at + 2);
            if depth == 0 {
                return at;
            }
        } else {
            at += 1;
        }
    }
    source.len()
}

/// The length of a raw text, `r"…"` or `r#"…"#`, if one begins here.
fn raw(source: &str) -> Option<usize> {
    let body = source.strip_prefix("br").or_else(|| source.strip_prefix('r'))?;
    let marks = body.len() - body.trim_start_matches('#').len();
    let inside = body[marks..].strip_prefix('"')?;
    let end = format!("\"{}", "#".repeat(marks));
    Some(source.len() - inside.len() + inside.find(&end)? + end.len())
}

/// The length of a text in quotes.
fn text(source: &str) -> usize {
    let mut escaped = false;
    for (at, c) in source.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    source.len()
}

/// The length of a character in quotes; of a lifetime, that of its mark.
fn character(source: &str) -> usize {
    let mut inside = source.chars().skip(1);
    match (inside.next(), inside.next()) {
        (Some('\\'), Some(c)) => {
            source[2 + c.len_utf8()..].find('\'').map_or(source.len(), |end| 3 + c.len_utf8() + end)
        }
        (Some(c), Some('\'')) => 2 + c.len_utf8(),
        _ => 1,
    }
}

/// Drops each item under `#[cfg(test)]`: up to the end of its braces, or its semicolon.
fn without_tests(words: Words) -> Words {
    let mut kept = Words::new();
    let mut at = 0;
    while at < words.len() {
        let mark = ["#", "[", "cfg", "(", "test", ")", "]"];
        if words[at..].iter().take(mark.len()).eq(mark.iter()) {
            at = item_end(&words, at + mark.len());
        } else {
            kept.push(words[at].clone());
            at += 1;
        }
    }
    kept
}

/// Where the item that begins at `at` is over.
fn item_end(words: &Words, mut at: usize) -> usize {
    let (mut depth, import) = (
        0,
        words[at..].iter().find(|w| *w == "use" || *w == "mod" || *w == "fn").is_some_and(|w| w == "use"),
    );
    while at < words.len() {
        match words[at].as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => {
                depth -= 1;
                if depth == 0 && words[at] == "}" && !import {
                    return at + 1;
                }
            }
            ";" if depth == 0 => return at + 1,
            _ => {}
        }
        at += 1;
    }
    at
}
