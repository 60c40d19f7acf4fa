//! `use` lines, taken apart.
use super::words::Words;

/// One name that a `use` line brings.
pub struct Import {
    /// Its path, as written.
    pub path: Words,
    /// What it is called here; `*` for everything.
    pub name: String,
    /// Whether it is handed on.
    pub public: bool,
}

/// The imports of a source, and what else there is without the declarations of its children.
pub fn imports(words: &Words) -> (Vec<Import>, Words) {
    let (mut found, mut code) = (Vec::new(), Words::new());
    let mut i = 0;
    while i < words.len() {
        if words[i] == "use" {
            let end = i + words[i..].iter().position(|w| w == ";").expect("an end of a use line");
            let public = i > 0 && matches!(words[i - 1].as_str(), "pub" | ")");
            leaves(&words[i + 1..end], &[], public, &mut found);
            i = end;
        } else if words[i] == "mod" && words.get(i + 2).is_some_and(|w| w == ";") {
            i += 2;
        } else {
            code.push(words[i].clone());
        }
        i += 1;
    }
    (found, code)
}

/// The leaves of a tree such as `a::{b, c::{d as e, self}}`.
fn leaves(tree: &[String], before: &[String], public: bool, found: &mut Vec<Import>) {
    let mut path = before.to_vec();
    let mut renamed = None;
    for (i, word) in tree.iter().enumerate() {
        match word.as_str() {
            "{" => {
                let parts = parts(&tree[i + 1..tree.len() - 1]);
                return parts.iter().for_each(|part| leaves(part, &path, public, found));
            }
            "as" => {
                renamed = tree.get(i + 1).cloned();
                break;
            }
            "::" => {}
            name => path.push(name.to_owned()),
        }
    }
    let last = path.last().cloned().unwrap_or_default();
    if last == "*" || (last == "self" && path.len() > 1) {
        path.pop();
    }
    let own = if last == "*" { last } else { path.last().cloned().unwrap_or_default() };
    found.push(Import { path, name: renamed.unwrap_or(own), public });
}

/// The parts between commas that stand in no further braces.
fn parts(words: &[String]) -> Vec<&[String]> {
    let mut depth = 0;
    let split = words.split(|w| {
        depth += i32::from(w == "{") - i32::from(w == "}");
        depth == 0 && w == ","
    });
    split.filter(|part| !part.is_empty()).collect()
}
