//! What the README says of the code is what the code says of itself.
use granlaw::laws::table::markdown;
use granlaw_tools::codes::environment::{passed_on_markdown, variables_markdown};
use granlaw_tools::trace::columns_markdown;
use std::ops::Range;
use std::path::Path;

/// Where the text between `<!-- name: ... -->` and `<!-- end name -->` stands.
fn between(text: &str, name: &str) -> Range<usize> {
    let begin = text.find(&format!("<!-- {name}:")).expect("the begin mark");
    let begin = begin + text[begin..].find("-->\n").expect("the end of the mark") + 4;
    begin..text.find(&format!("<!-- end {name} -->")).expect("the end mark")
}

fn check(name: &str, made: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let mut text = std::fs::read_to_string(&path).unwrap();
    let made = format!("{}\n", made.trim_end());
    let at = between(&text, name);
    if text[at.clone()] == made {
        return;
    }
    let bless = "GRANLAW_BLESS=1 cargo test --test tools readme -- --test-threads 1";
    assert!(std::env::var_os("GRANLAW_BLESS").is_some(), "README's {name} are old; make them again: {bless}");
    text.replace_range(at, &made);
    std::fs::write(&path, text).unwrap();
}

#[test]
fn the_table_of_laws_is_made_from_the_laws() {
    check("laws", &markdown());
}

#[test]
fn the_table_of_columns_is_made_from_the_columns() {
    check("columns", &columns_markdown());
}

#[test]
fn the_tables_of_the_environment_are_made_from_its_lists() {
    check("environment", &variables_markdown());
    check("passed on", &passed_on_markdown());
}

#[test]
fn the_sections_are_found_and_differ() {
    let text = "<!-- laws: made -->\na\n<!-- end laws -->\n<!-- columns: made -->\nb\n<!-- end columns -->\n";
    assert_eq!((&text[between(text, "laws")], &text[between(text, "columns")]), ("a\n", "b\n"));
}
