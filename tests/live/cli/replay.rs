//! `granlaw replay`: recorded calls, whole and spoilt. Needs no LIGGGHTS: the traces are those of `reference_data/`.
use crate::built::source;
use crate::common::Scratch;
use std::fs;

fn trace(name: &str) -> String {
    fs::read_to_string(source().join("reference_data").join(name)).unwrap()
}

/// A trace with one number of its k-th row written otherwise.
fn by_hand(trace: &str, row: usize, column: &str, otherwise: impl Fn(f64) -> String) -> String {
    let mut lines: Vec<String> = trace.lines().map(String::from).collect();
    let head = lines.iter().position(|l| l.starts_with("step,")).unwrap();
    let at = lines[head].split(',').position(|c| c == column).unwrap();
    let mut fields: Vec<String> = lines[head + row].split(',').map(String::from).collect();
    let value: f64 = fields[at].parse().unwrap();
    assert!(value != 0.0, "nothing to change in {column}");
    fields[at] = otherwise(value);
    lines[head + row] = fields.join(",");
    lines.join("\n") + "\n"
}

#[test]
fn a_trace_that_agrees_ends_with_0() {
    let s = Scratch::new();
    s.file("a.csv", &trace("oblique.csv"));
    s.file("b.csv", &trace("wall.csv"));
    let words =
        ["a.csv: pair of oblique.in", "b.csv: wall w of wall.in", "equal to the last bit: force", "agreed: "];
    s.granlaw(&["replay", "a.csv", "b.csv"]).ends(0, &words);
}

#[test]
fn a_row_changed_by_hand_ends_with_1() {
    let s = Scratch::new();
    for (column, says) in [
        ("force_i.x", "force: "),
        ("after.deltaMax", "after.deltaMax: "),
        ("kn", "kn: "),
        ("en.y", "surface normal: "),
    ] {
        s.file("a.csv", &by_hand(&trace("oblique.csv"), 60, column, |x| format!("{:e}", 1.001 * x)));
        s.granlaw(&["replay", "a.csv"])
            .ends(1, &["DISAGREED: worst error", "allowed 1e-14", says, "at step "]);
    }
    // Within a tolerance that is asked for, the same trace agrees.
    s.granlaw(&["replay", "--tolerance", "1e-2", "a.csv"]).ends(0, &["agreed: worst error"]);
    s.file("b.csv", &trace("oblique.csv"));
    s.granlaw(&["replay", "a.csv", "b.csv"]).ends(1, &["a.csv", "b.csv", "DISAGREED"]);
}

#[test]
fn what_is_no_whole_trace_ends_with_2() {
    let s = Scratch::new();
    let whole = trace("oblique.csv");
    s.file("cut.csv", &whole[..whole.len() / 2]);
    s.file("line.csv", &whole[..whole.rfind("# end").unwrap()]);
    s.file("foreign.csv", "id,x\n1,2\n");
    s.file("empty.csv", "");
    s.file("newer.csv", &whole.replacen("# granlaw trace 1", "# granlaw trace 2", 1));
    s.file("word.csv", &by_hand(&whole, 3, "dt", |_| "often".into()));
    let end = whole.find("\n62,").unwrap() + 1;
    s.file("none.csv", &format!("{}# end 0\n", &whole[..end]));
    for (name, says) in [
        ("cut.csv", "the trace was cut short"),
        ("line.csv", "the trace was cut short"),
        ("foreign.csv", "this is not a trace; write one with granlaw run --record"),
        ("empty.csv", "this is not a trace"),
        ("newer.csv", "format \"2\" of traces is unknown here, which reads 1"),
        ("word.csv", "\"often\" in column dt is not a number"),
        ("none.csv", "no contact in it, so nothing was compared"),
        ("nowhere.csv", "nowhere.csv: No such file or directory (os error 2); check the path"),
    ] {
        let said = s.granlaw(&["replay", name]).ends(2, &[name, says]);
        assert!(said.out.is_empty(), "{name}: a verdict on nothing: {said}");
        assert_eq!(said.err.lines().count(), 1, "{said}");
        assert!(said.err.matches("os error").count() <= 1, "the same twice: {said}");
    }
}
