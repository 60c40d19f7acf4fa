//! What someone may have meant who wrote an unknown word.

/// The message for an unknown word: the nearest known one if it is near, and all of them.
pub fn unknown(kind: &str, word: &str, known: &[&str]) -> String {
    let nearest =
        known.iter().min_by_key(|k| distance(word, k)).filter(|k| distance(word, k) <= 1 + k.len() / 4);
    let hint = nearest.map_or("; known".into(), |k| format!(", did you mean {k}? Known"));
    format!("unknown {kind} {word}{hint}: {}", known.join(", "))
}

/// How many letters must be changed, left out or put in to make `b` of `a`.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_suggested_and_far_ones_are_not() {
        assert_eq!(
            unknown("word", "titel", &["title", "ranks"]),
            "unknown word titel, did you mean title? Known: title, ranks"
        );
        assert_eq!(unknown("word", "xyzzy", &["title", "ranks"]), "unknown word xyzzy; known: title, ranks");
    }

    #[test]
    fn distances() {
        assert_eq!((distance("", "abc"), distance("abc", "abc"), distance("kitten", "sitting")), (3, 0, 3));
    }
}
