//! Small made-up crates in which the circles are known.
use super::circles::{arrows, circles, without_fronts};
use super::sources::modules;

/// The circles of a crate, without and with leave to need the front of one's own room.
fn found(files: &[(&str, &str)]) -> [Vec<Vec<String>>; 2] {
    let files: Vec<_> = files.iter().map(|(name, text)| (name.to_string(), text.to_string())).collect();
    let arrows = arrows(&modules(&files));
    [circles(&arrows), circles(&without_fronts(&arrows))]
}

const FRONT: (&str, &str) = ("room/mod.rs", "mod a;\nmod b;\npub use a::A;\npub use b::{self, B};");

#[test]
fn every_way_to_name_another_file_closes_the_circle() {
    let b = ("room/b.rs", "use super::a::A;\npub struct B(A);");
    for a in [
        "use crate::room::b::B; pub struct A(Box<B>);",
        "use super::{b::{self, B as Other}}; pub struct A(Box<Other>);",
        "use super::b; pub struct A(Box<b::B>);",
        "pub struct A(Box<super::b::B>);",
        "use super::B; pub struct A(Box<B>);",
        "use super::*; pub struct A(Box<B>);",
        "use crate::room; pub struct A(Box<room::B>);",
        "fn f() -> String { let c = '\"'; format!(\"{c}{}\", crate::room::b::f()) } pub struct A;",
        "struct A { #[serde(serialize_with = \"super::b::number\")] x: f64 }",
    ] {
        let [all, inner] = found(&[("lib.rs", "pub mod room;"), FRONT, ("room/a.rs", a), b]);
        assert_eq!(all, [["room/a.rs", "room/b.rs"]], "{a}");
        assert_eq!(all, inner, "{a}");
    }
}

#[test]
fn what_is_no_code_of_the_file_closes_none() {
    let b = ("room/b.rs", "use super::a::A;\npub struct B(A);");
    for a in [
        "pub struct A; // super::b::B",
        "/// See [`super::b::B`]. /* super::b::B */\npub struct A;",
        "pub struct A; const T: &str = \"use super::b::B;\"; const R: &str = r#\"\"super::b::B\"#;",
        "pub struct A; #[cfg(test)] mod tests { use super::super::b::B; fn f(b: B) {} }",
        "#[cfg(test)]\nuse super::b::B;\npub struct A;",
        "use other::b::B; pub struct A(B);",
        "pub struct A<'b>(&'b str);",
    ] {
        let [all, _] = found(&[("lib.rs", "pub mod room;"), FRONT, ("room/a.rs", a), b]);
        assert!(all.is_empty(), "{a}: {all:?}");
    }
}

#[test]
fn a_front_with_code_of_its_own_counts_unless_it_may_lead() {
    let a = ("room/a.rs", "use super::Shared;\npub fn a(s: Shared) {}");
    let alone = ("room/mod.rs", "mod a;\npub struct Shared;\npub use a::a;");
    assert!(found(&[alone, a])[0].is_empty());
    let calls = ("room/mod.rs", "mod a;\npub struct Shared;\npub use a::a;\npub fn f(s: Shared) { a(s) }");
    assert_eq!(found(&[calls, a]), [vec![vec!["room/a.rs".to_string(), "room/mod.rs".into()]], Vec::new()]);
}

#[test]
fn long_circles_are_found_and_what_hangs_on_them_is_not_part() {
    let [all, _] = found(&[
        ("a.rs", "use crate::b::B; use crate::leaf::L;"),
        ("b.rs", "use crate::c::C;"),
        ("c.rs", "use crate::a::A;"),
        ("leaf.rs", ""),
        ("above.rs", "use crate::a::A;"),
    ]);
    assert_eq!(all, [["a.rs", "b.rs", "c.rs"]]);
}
