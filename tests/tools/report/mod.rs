//! The report writers, on a report made by hand: what they say, not only that they say something.
mod page;
mod sample;

use granlaw_tools::report::{write_all, Case, Curve, Outcome, Report, ReportError, Shows};
use std::fs;
use std::path::{Path, PathBuf};

/// A report folder in a temporary place that goes away with it.
struct Written {
    place: tempfile::TempDir,
}

impl Written {
    fn new(report: &Report) -> Written {
        let place = tempfile::tempdir().unwrap();
        write_all(report, &place.path().join("out")).unwrap();
        Written { place }
    }

    fn dir(&self) -> PathBuf {
        self.place.path().join("out")
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.dir().join(name)).unwrap()
    }
}

fn names(dir: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// The part of a page between two texts.
fn between<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let rest = page.split_once(from).unwrap_or_else(|| panic!("no {from}")).1;
    rest.split_once(to).unwrap_or_else(|| panic!("no {to} after {from}")).0
}

#[test]
fn the_folder_holds_every_format_and_nothing_else() {
    let out = Written::new(&sample::report());
    assert_eq!(names(&out.dir()), ["csv", "index.html", "junit.xml", "report.json", "report.md"]);
    assert_eq!(names(&out.dir().join("csv")), ["head_on_plastic.csv", "oblique_slip.csv"]);
    assert_eq!(names(out.place.path()), ["out"], "a temporary folder was left behind");
}

#[test]
fn the_page_says_what_happened_where() {
    let page = Written::new(&sample::report()).read("index.html");
    assert!(page.contains("<title>granlaw: 1 of 5 cases disagreed, 2 could not run</title>"));
    assert!(page.contains("Left out: 2 checks skipped"));
    assert!(
        page.contains("2 checks: LIGGGHTS was not found<br><small>wall_mesh: plugin, wall_mesh: two-body")
    );
    for (id, verdict) in [
        ("head_on_plastic", "✓ agreed"),
        ("oblique_slip", "✗ disagreed"),
        ("wall_mesh", "✓ agreed"),
        ("bad_property", "! could not run"),
        ("no_contact", "! could not run"),
    ] {
        let row = between(&page, &format!("<a href=\"#{id}\">"), "</tr>");
        assert!(row.contains(verdict), "{id}: {row}");
        let head = between(&page, &format!("<section class=\"case\" id=\"{id}\">"), "</h2>");
        assert!(head.contains(verdict), "{id}: {head}");
    }
    let failed = between(&page, "id=\"oblique_slip\"", "</section>");
    assert!(failed.contains("step 455<br><small>f_i.x of 1-2</small>"));
    assert!(failed.contains("<code>12.2<mark>8</mark><br>12.2<mark>5</mark></code>"), "got over expected");
    assert!(failed.contains("3.1e-3<br><small>relative to the peak force</small>"));
    assert!(failed.contains("1e-14<br><small>round-off of a few operations</small>"));
    let stopped = between(&page, "id=\"bad_property\"", "</section>");
    assert!(stopped.contains("<details open>") && stopped.contains("ERROR: Illegal value"));
    assert!(between(&page, "id=\"no_contact\"", "</section>").contains("nothing was checked"));
}

#[test]
fn the_page_stands_alone() {
    let page = Written::new(&sample::report()).read("index.html");
    for reaching_out in ["http:", "https:", "src=", "<link", "@import", "url("] {
        assert!(!page.contains(reaching_out), "{reaching_out}");
    }
    assert_eq!(page.matches("<section").count(), page.matches("</section>").count());
    assert_eq!(page.matches("<svg").count(), 8, "four plots for each of two cases with histories");
}

#[test]
fn parameters_are_a_matrix_per_type_pair() {
    let page = Written::new(&sample::report()).read("index.html");
    let row = between(&page, "<i>k2max/kn</i>", "per type pair");
    assert!(row.contains(
        "<th></th><th>1</th><th>2</th></tr><tr><th>1</th><td class=\"n\">5</td><td class=\"n\">4</td>"
    ));
    assert!(row.contains("<tr><th>2</th><td class=\"n\">4</td><td class=\"n\">12.5</td></tr>"));
    let row = between(&page, "<i>E</i>", "per type");
    assert!(
        row.contains("<th>1</th><th>2</th></tr><tr><td class=\"n\">5e6</td><td class=\"n\">7.25e7</td></tr>")
    );
    assert!(between(&page, "<i>vc</i>", "</tr>").contains("<td>2</td><td>m/s</td>"));
}

/// The vertices of an answer's path in the n-th plot of a case, in tenths of the drawing's unit.
fn vertices(page: &str, case: &str, plot: usize, answer: &str) -> Vec<(i32, i32)> {
    let section = between(page, &format!("id=\"{case}\""), "</section>");
    let svg = section.split("<svg").nth(plot + 1).unwrap();
    let from = format!("data-answer=\"{answer}\"");
    let path = between(svg, &from, "/>").split_once("d=\"").unwrap().1;
    let numbers = |text: &str| -> Vec<i32> {
        text.trim_end_matches(['"', '0', 'h']).split(' ').filter_map(|n| n.parse().ok()).collect()
    };
    let mut out: Vec<(i32, i32)> = Vec::new();
    for stroke in path.trim_end_matches('"').split('M').filter(|s| !s.is_empty()) {
        let (start, steps) = stroke.split_once("h0").unwrap();
        let start = numbers(&format!("{start} "));
        out.push((start[0], start[1]));
        for step in steps.split('l').filter(|s| !s.is_empty()) {
            let (dx, dy) = step.split_once(' ').unwrap();
            let last = *out.last().unwrap();
            out.push((last.0 + dx.parse::<i32>().unwrap(), last.1 + dy.parse::<i32>().unwrap()));
        }
    }
    out
}

#[test]
fn plotted_points_are_the_data() {
    let mut report = sample::report();
    let mut lone = sample::curves(3);
    lone.truncate(1);
    (lone[0].time, lone[0].overlap) = (vec![0.0, 1.0, 2.0], vec![0.0, 4.0, 1.0]);
    report.cases[0].curves = lone;
    let page = Written::new(&report).read("index.html");
    let points = vertices(&page, "head_on_plastic", 1, "stock");
    // Evenly spaced in time, and the overlaps 0, 4, 1 in proportion, upwards.
    assert_eq!(points.len(), 3);
    assert_eq!(points[1].0 - points[0].0, points[2].0 - points[1].0);
    let (rise, fall) = (points[0].1 - points[1].1, points[2].1 - points[1].1);
    // Places are rounded to whole tenths, three roundings in all.
    assert!((4 * fall - 3 * rise).abs() <= 8, "{points:?}");
    assert!(rise > 1500, "the curve fills the plot: {points:?}");
}

#[test]
fn long_curves_are_thinned_but_keep_their_peak() {
    let page = Written::new(&sample::report()).read("index.html");
    let points = vertices(&page, "oblique_slip", 0, "replay");
    assert!((300..=1750).contains(&points.len()), "{}", points.len());
    let section = between(&page, "id=\"oblique_slip\"", "</section>");
    assert!(section.contains("data-answer=\"replay\" data-points=\"20000\""));
    // Stock and replay peak together: before the curve was spoiled both are the same.
    let top = |answer| vertices(&page, "oblique_slip", 0, answer).iter().map(|p| p.1).min();
    assert_eq!(top("replay"), top("stock"));
    assert!(section.contains("plugin: 2 not finite, not drawn."));
}

#[test]
fn the_markdown_is_this() {
    let mut report = sample::report();
    report.cases.truncate(3);
    insta::assert_snapshot!(Written::new(&report).read("report.md"), @r##"
    # granlaw verify

    **✗ 1 of 3 cases disagreed** (6 agreed, 2 disagreed, 2 skipped)

    granlaw 0.1.0 · LIGGGHTS: LIGGGHTS-PUBLIC 3.8.0, compiled 2023-01-05 · plugin: target/release/libgranlaw_liggghts.so · linux x86_64, 2 cores

    | case | verdict | checks | closest to its limit | time |
    |---|---|---|---|--:|
    | head_on_plastic | ✓ agreed | 5 agreed | two-body: 3.06e-11 of 1e-9 | 0.61 s |
    | oblique_slip | ✗ disagreed | 2 disagreed | plugin: NaN of 0 | 1.90 s |
    | wall_mesh | ✓ agreed | 1 agreed, 2 skipped | replay: 2.2e-16 of 1e-14 | 0.00 s |

    ### ✗ oblique_slip: Oblique impact, slip with spin \| μ = 0.1

    liggghts_inputs/oblique_slip.in · normal hooke, tangential history, rolling cdt

    - **replay** (port) disagreed: 3.1e-3 of the peak force at step 455, limit 1e-14
      - worst at step 455, f_i.x of 1-2
      - got `12.28`, expected `12.25`
      - error 3.1e-3 relative to the peak force
      - limit 1e-14 because round-off of a few operations
    - **plugin** (boundary) disagreed: dump.txt differs
      - worst at step 456, f_i.x of 1-2
      - got `NaN`, expected `12.25`
      - error NaN relative to the peak force
      - limit 0 because the same operations in the same order give the same bits

    ### Left out, and notes

    - deck big_scene.in: only every 100th step was recorded
    - 2 checks skipped because LIGGGHTS was not found: wall_mesh: plugin, wall_mesh: two-body
    "##);
}

#[test]
fn the_csv_is_this() {
    let curve = |answer: &str, error: Vec<f64>| Curve {
        answer: answer.into(),
        time: vec![0.0, 1e-7],
        overlap: vec![0.1 + 0.2, 2.5e-4],
        force: vec![-0.0, f64::NAN],
        error,
    };
    let case = Case {
        name: "tiny".into(),
        curves: vec![curve("stock", vec![]), curve("a,b", vec![0.0, f64::INFINITY])],
        ..Case::default()
    };
    let out = Written::new(&Report { cases: vec![case], ..Report::default() });
    insta::assert_snapshot!(out.read("csv/tiny.csv"), @r##"
    answer,time_s,overlap_m,force_N,error
    stock,0.0,0.30000000000000004,-0.0,
    stock,1e-7,0.00025,NaN,
    "a,b",0.0,0.30000000000000004,-0.0,0.0
    "a,b",1e-7,0.00025,NaN,inf
    "##);
}

#[test]
fn the_csv_keeps_every_row_of_a_thinned_plot() {
    let out = Written::new(&sample::report());
    let mut table = csv::Reader::from_path(out.dir().join("csv/oblique_slip.csv")).unwrap();
    let rows: Vec<(String, f64, f64, f64, Option<f64>)> = table.deserialize().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 60_000);
    let stock = &sample::curves(20_000)[0];
    for (k, row) in rows.iter().take(20_000).enumerate() {
        assert_eq!((row.1, row.2, row.3, row.4), (stock.time[k], stock.overlap[k], stock.force[k], None));
    }
}

#[test]
fn junit_counts_what_the_report_counts() {
    let report = sample::report();
    let xml = Written::new(&report).read("junit.xml");
    let back = quick_junit::Report::deserialize_from_str(&xml).unwrap();
    let names: Vec<_> = back.test_suites.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(names, ["head_on_plastic", "oblique_slip", "wall_mesh", "bad_property", "no_contact"]);
    let counts = report.counts();
    // The case without checks adds one test of its own, in error.
    assert_eq!(back.tests, 12);
    assert_eq!((back.failures, back.errors), (counts.disagreed, counts.could_not_run + 1));
    let skipped: usize = back.test_suites.iter().map(|s| s.disabled).sum();
    assert_eq!(skipped, counts.skipped);
    assert!(xml.contains("got 12.28, expected 12.25") && xml.contains("LIGGGHTS was not found"));
}

#[test]
fn json_holds_the_types_and_survives_what_is_not_a_number() {
    let text = Written::new(&sample::report()).read("report.json");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["format"], "granlaw-report/1");
    assert_eq!((&json["exit_code"], &json["counts"]["skipped"]), (&2.into(), &2.into()));
    let case = &json["cases"][1];
    assert_eq!((&case["id"], &case["verdict"]["is"]), (&"oblique_slip".into(), &"disagreed".into()));
    assert_eq!(case["checks"][0]["worst"]["got"], 12.28);
    assert_eq!(case["checks"][0]["shows"], "port");
    assert_eq!(case["checks"][1]["worst"]["got"], "NaN");
    assert_eq!(json["cases"][0]["parameters"][2]["values"], serde_json::json!([5.0, 4.0, 4.0, 12.5]));
}

#[test]
fn no_text_becomes_markup() {
    let evil = "<script>alert('x')</script>\"&|";
    let mut report = sample::report();
    let about = &mut report.about;
    for text in [&mut about.granlaw, &mut about.machine, &mut about.command, &mut about.notes[0]] {
        *text = evil.into();
    }
    (about.liggghts, about.plugin) = (Some(evil.into()), Some(evil.into()));
    for case in &mut report.cases {
        for text in [&mut case.name, &mut case.title, &mut case.deck] {
            *text = evil.into();
        }
        case.laws = vec![evil.into()];
        case.log = Some(evil.into());
        case.curves.iter_mut().for_each(|c| c.answer = evil.into());
        for p in &mut case.parameters {
            (p.name, p.symbol, p.unit, p.shape) = (evil.into(), evil.into(), evil.into(), evil.into());
        }
        for check in &mut case.checks {
            check.name = evil.into();
            if let Some(w) = &mut check.worst {
                (w.what, w.norm) = (evil.into(), evil.into());
            }
            check.tolerance.as_mut().unwrap().reason = evil.into();
            if let Outcome::Disagreed(why) | Outcome::Skipped(why) | Outcome::CouldNotRun(why) =
                &mut check.outcome
            {
                *why = evil.into();
            }
        }
    }
    let out = Written::new(&report);
    let (page, summary) = (out.read("index.html"), out.read("report.md"));
    assert_eq!(page.matches("<script").count(), 1, "the page's own script and no other");
    assert!(page.matches("&lt;script&gt;").count() > 40, "every field is still there to be read");
    assert!(!summary.contains("<script") && summary.contains("&lt;script&gt;"));
    let xml = quick_junit::Report::deserialize_from_str(&out.read("junit.xml")).unwrap();
    assert_eq!(xml.test_suites[0].test_cases[0].name.as_str(), evil);
    // Names of files and links lose what is not safe there.
    assert!(out.dir().join("csv/_script_alert__x____script____.csv").exists());
}

#[test]
fn an_empty_report_is_an_error_in_every_format() {
    let report = Report::default();
    assert_eq!(report.exit_code(), 2);
    let out = Written::new(&report);
    assert!(out.read("index.html").contains("<span class=\"sign\">!</span> nothing was checked"));
    assert!(out.read("report.md").contains("**! nothing was checked** (no checks)"));
    let xml = quick_junit::Report::deserialize_from_str(&out.read("junit.xml")).unwrap();
    assert_eq!((xml.tests, xml.errors), (1, 1));
}

#[test]
fn a_case_with_skipped_checks_only_is_no_pass() {
    let no = Outcome::Skipped("no LIGGGHTS".into());
    let checks = vec![sample::check("plugin", Shows::Boundary, no, 0.0, None)];
    let report =
        Report { cases: vec![Case { name: "a".into(), checks, ..Case::default() }], ..Report::default() };
    let out = Written::new(&report);
    assert!(out.read("report.md").contains("**! 1 of 1 case could not run** (1 skipped)"));
    let xml = quick_junit::Report::deserialize_from_str(&out.read("junit.xml")).unwrap();
    assert_eq!((xml.tests, xml.errors), (2, 1));
}

#[test]
fn decks_of_the_same_name_keep_apart() {
    let named = |name: &str, overlap: f64| {
        let mut curves = sample::curves(3);
        curves[0].overlap[0] = overlap;
        Case { name: name.into(), curves, ..Case::default() }
    };
    let cases =
        vec![named("a", 1.0), named("A", 2.0), named("a", 3.0), named("a-2", 4.0), named("../x", 5.0)];
    let out = Written::new(&Report { cases, ..Report::default() });
    assert_eq!(names(&out.dir().join("csv")), ["A-2.csv", "_x.csv", "a-2-2.csv", "a-3.csv", "a.csv"]);
    for (file, overlap) in [("a", "1.0"), ("A-2", "2.0"), ("a-3", "3.0"), ("a-2-2", "4.0"), ("_x", "5.0")] {
        let text = out.read(&format!("csv/{file}.csv"));
        assert!(text.contains(&format!("stock,0.0,{overlap},")), "{file}: {text}");
        assert!(out.read("index.html").contains(&format!("<a href=\"csv/{file}.csv\">")));
    }
}

#[test]
fn an_earlier_report_is_replaced_whole() {
    let out = Written::new(&sample::report());
    let mut second = sample::report();
    second.cases.truncate(1);
    write_all(&second, &out.dir()).unwrap();
    assert_eq!(names(&out.dir().join("csv")), ["head_on_plastic.csv"]);
    assert!(out.read("report.md").contains("the only case agreed"));
    assert_eq!(names(out.place.path()), ["out"]);
}

#[test]
fn what_is_not_ours_is_refused_and_left_alone() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    fs::create_dir(at("thesis")).unwrap();
    fs::write(at("thesis/thesis.tex"), "years").unwrap();
    fs::create_dir(at("other")).unwrap();
    fs::write(at("other/report.json"), "{\"format\": \"another tool\"}").unwrap();
    fs::write(at("file"), "text").unwrap();
    write_all(&sample::report(), &at("grown")).unwrap();
    fs::write(at("grown/notes.txt"), "mine").unwrap();
    for (name, why) in [
        ("thesis", "thesis.tex"),
        ("other", "no report of ours"),
        ("file", "not a folder"),
        ("grown", "notes.txt"),
    ] {
        let error = write_all(&Report::default(), &at(name)).unwrap_err();
        assert!(matches!(error, ReportError::Taken { .. }), "{error}");
        let said = error.to_string();
        assert!(said.contains(name) && said.contains(why) && said.contains("name a new folder"), "{said}");
    }
    assert_eq!(fs::read_to_string(at("thesis/thesis.tex")).unwrap(), "years");
    assert!(fs::read_to_string(at("grown/report.md")).unwrap().contains("oblique_slip"));
    assert_eq!(names(place.path()), ["file", "grown", "other", "thesis"], "nothing half-written is left");
}

#[test]
fn new_and_empty_folders_are_filled() {
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(place.path().join("empty")).unwrap();
    for name in ["empty", "not/yet/there"] {
        write_all(&sample::report(), &place.path().join(name)).unwrap();
        assert!(place.path().join(name).join("index.html").exists(), "{name}");
    }
}
