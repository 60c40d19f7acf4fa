//! Documents of studies: what their files say.
use granlaw_tools::report::page::*;
use granlaw_tools::report::{Check, Outcome, ReportError, Shows, Worst};
use std::fs;

fn mark(x: f64, y: f64, front: bool) -> Mark {
    let spread = |at: f64| Spread { at, low: 0.5 * at, high: 2.0 * at };
    Mark { label: format!("{x} steps"), x: spread(x), y: spread(y), front }
}

fn page() -> Page {
    let table = Table {
        name: "costs".into(),
        caption: "What it costs".into(),
        columns: vec!["method".into(), "cost [µs]".into(), "steps".into()],
        rows: vec![
            vec!["a <b>".into(), 0.0123.into(), 1234u64.into()],
            vec!["c".into(), 4e-7.into(), 5u64.into()],
        ],
    };
    let trend = |name: &str, marks| Trend {
        name: name.into(),
        note: "order 2".into(),
        joined: true,
        look: None,
        marks,
    };
    let chart = Chart {
        name: "errors".into(),
        caption: "Error over cost".into(),
        x: "cost [µs]".into(),
        y: "error [1]".into(),
        trends: vec![
            trend("good", vec![mark(1.0, 1e-2, true), mark(10.0, 1e-4, true)]),
            trend("bad", vec![mark(5.0, 1e-1, false), mark(50.0, f64::NAN, false)]),
        ],
    };
    let map = Map {
        name: "field".into(),
        caption: "A field".into(),
        x: Scale { label: "dt [1]".into(), values: vec![0.1, 1.0, 10.0], log: true },
        y: Scale { label: "e [1]".into(), values: vec![0.0, 1.0], log: false },
        classes: vec!["fine".into(), "wrong".into()],
        cells: vec![0, 0, 1, 0, 1, 1],
        values: vec![("error".into(), vec![0.1, 0.2, 0.3, 0.4, 0.5, f64::INFINITY])],
        borders: vec![Border {
            name: "theory".into(),
            points: vec![(1.0, 0.0), (1.0, 1.0), (f64::NAN, 1.0)],
        }],
        spots: vec![
            Spot { x: 1.0, y: 0.0, agrees: true, label: "as here".into() },
            Spot { x: 1.0, y: 1.0, agrees: false, label: "not as here".into() },
        ],
    };
    let worst = Worst {
        step: 0,
        what: "somewhere".into(),
        got: 2.0,
        expected: 1.0,
        error: 1.0,
        norm: "relative".into(),
    };
    let check = Check {
        name: "orders".into(),
        shows: Shows::Physics,
        outcome: Outcome::Agreed,
        tolerance: None,
        worst: Some(worst),
    };
    let items = vec![Item::Table(table), Item::Chart(chart), Item::Map(map)];
    let section = Section { title: "All & more".into(), text: vec!["Words.".into()], items };
    Page {
        program: "granlaw test".into(),
        headline: "a > b".into(),
        checks: vec![check],
        sections: vec![section],
        ..Page::default()
    }
}

fn written(page: &Page) -> tempfile::TempDir {
    let place = tempfile::tempdir().unwrap();
    write_page(page, &place.path().join("out")).unwrap();
    place
}

fn read(place: &tempfile::TempDir, name: &str) -> String {
    fs::read_to_string(place.path().join("out").join(name)).unwrap()
}

#[test]
fn every_number_is_in_a_file_of_its_own() {
    let place = written(&page());
    assert_eq!(read(&place, "csv/costs.csv"), "method,cost [µs],steps\na <b>,0.0123,1234\nc,0.0000004,5\n");
    let marks = read(&place, "csv/errors.csv");
    assert!(marks.starts_with("curve,point,cost [µs],low,high,error [1],low,high,on_front\n"), "{marks}");
    assert!(marks.contains("good,10 steps,10,5,20,0.0001,0.00005,0.0002,true\n"), "{marks}");
    assert!(marks.contains("bad,50 steps,50,25,100,NaN,NaN,NaN,false\n"), "{marks}");
    let cells = "dt [1],e [1],outcome,error\n0.1,0,fine,0.1\n1,0,fine,0.2\n10,0,wrong,0.3\n0.1,1,fine,0.4\n\
                 1,1,wrong,0.5\n10,1,wrong,inf\n";
    assert_eq!(read(&place, "csv/field.csv"), cells);
}

#[test]
fn drawings_show_every_point_that_has_a_place() {
    let place = written(&page());
    let chart = read(&place, "figures/errors.svg");
    assert!(chart.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" ") && chart.contains("<style>"));
    // Three points and two samples in the legend; one point has no place.
    assert_eq!(chart.matches("class=\"mark\"").count(), 5);
    assert_eq!((chart.matches("class=\"ring\"").count(), chart.matches("class=\"front\"").count()), (2, 1));
    assert_eq!(chart.matches("class=\"bar\"").count(), 3);
    let map = read(&place, "figures/field.svg");
    // One path for each outcome, and one sample each.
    assert_eq!(map.matches("class=\"cell t0\"").count(), 2);
    assert_eq!(map.matches("class=\"cell t7\"").count(), 2);
    assert_eq!((map.matches("spot same").count(), map.matches("spot differs").count()), (2, 2));
    assert!(map.contains("not as here") && map.contains(">theory<"));
}

#[test]
fn the_page_says_all_of_it_and_escapes_it() {
    let place = written(&page());
    let html = read(&place, "index.html");
    assert!(html.contains("<title>granlaw: a &gt; b</title>") && html.contains("<h2>All &amp; more</h2>"));
    assert!(html.contains("data-sort=\"0.0123\">0.0123</td>"), "{html}");
    assert!(html.contains("a &lt;b&gt;") && !html.contains("a <b>"));
    assert!(
        html.contains("<td data-label=\"furthest off\"><div>somewhere<br><small>2.00 against 1.00</small>")
    );
    assert_eq!(html.matches("<svg ").count(), 2);
    let json: serde_json::Value = serde_json::from_str(&read(&place, "report.json")).unwrap();
    assert_eq!(json["format"], "granlaw-study/1");
    assert_eq!(json["sections"][0]["items"][1]["chart"]["trends"][1]["marks"][1]["y"]["at"], "NaN");
}

#[test]
fn the_worst_check_decides_the_exit_code() {
    let check =
        |outcome| Check { name: "c".into(), shows: Shows::Physics, outcome, tolerance: None, worst: None };
    let code = |outcomes: Vec<Outcome>| {
        Page { checks: outcomes.into_iter().map(check).collect(), ..page() }.exit_code()
    };
    let (bad, stopped) = (Outcome::Disagreed("x".into()), Outcome::CouldNotRun("y".into()));
    assert_eq!(code(vec![]), 0);
    assert_eq!(code(vec![Outcome::Agreed, Outcome::Skipped("z".into())]), 0);
    assert_eq!(code(vec![Outcome::Agreed, bad.clone()]), 1);
    assert_eq!(code(vec![bad, stopped]), 2);
}

#[test]
fn only_an_earlier_study_is_replaced() {
    let place = written(&page());
    let out = place.path().join("out");
    write_page(&page(), &out).unwrap();
    assert!(check_page_target(&out).is_ok());
    fs::write(out.join("notes.txt"), "mine").unwrap();
    let error = write_page(&page(), &out).unwrap_err();
    assert!(matches!(error, ReportError::Taken { .. }) && error.to_string().contains("notes.txt"), "{error}");
    assert_eq!(fs::read_to_string(out.join("notes.txt")).unwrap(), "mine");
    // A report of verify is no study.
    let other = place.path().join("other");
    fs::create_dir(&other).unwrap();
    fs::write(other.join("report.json"), "{\n  \"format\": \"granlaw-report/1\"").unwrap();
    assert!(check_page_target(&other).unwrap_err().to_string().contains("is no study of ours"));
}
