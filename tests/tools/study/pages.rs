//! The checks on a study's page, each with a fault that turns it.
use granlaw_tools::codes::RunError;
use granlaw_tools::report::page::{Page, Spread};
use granlaw_tools::report::Outcome;
use granlaw_tools::study::{speed, stability, Options};

const NONE: Result<granlaw_tools::study::in_liggghts::Bench, RunError> =
    Err(RunError::NoPlugin { looked: Vec::new() });

fn is(page: &Page, check: &str) -> Option<Outcome> {
    page.checks.iter().find(|c| c.name == check).map(|c| c.outcome.clone())
}

#[test]
fn the_checks_of_speed_fail_when_they_should() {
    let only = vec!["undamped".to_string()];
    let options = Options { only, full: false, bench: NONE, command: String::new() };
    let mut study = speed::run(&options, &|_| ());
    let page = speed::page(&study, &options);
    assert_eq!((is(&page, "orders"), page.exit_code()), (Some(Outcome::Agreed), 0));
    assert!(matches!(is(&page, "runs of LIGGGHTS"), Some(Outcome::Skipped(_))));
    assert_eq!(is(&page, "LIGGGHTS and our integration"), None);

    // Curves as LIGGGHTS would give them.
    let mut stock = study.found[0].curves[0].clone();
    stock.method = speed::Method::Stock;
    let plugin = speed::Curve { method: speed::Method::Plugin, ..stock.clone() };
    study.found[0].curves.extend([stock, plugin]);
    study.apart = Some(1e-9);
    let name = "Rust laws in place of LIGGGHTS's";
    let page = speed::page(&study, &options);
    assert_eq!(is(&page, name), Some(Outcome::Agreed));
    assert_eq!(is(&page, "LIGGGHTS and our integration"), Some(Outcome::Agreed));
    // Planted: another last digit, another motion, an order that is none.
    let last = study.found[0].curves.len() - 1;
    study.found[0].curves[last].points[2].error.at *= 1.0 + 1e-15;
    study.apart = Some(1e-5);
    study.found[0].curves[0].points.iter_mut().for_each(|p| p.error = Spread::exact(1e-3));
    let page = speed::page(&study, &options);
    for check in [name, "LIGGGHTS and our integration", "orders"] {
        assert!(matches!(is(&page, check), Some(Outcome::Disagreed(_))), "{check}");
    }
    assert_eq!(page.exit_code(), 1);
    study.trouble.push("LIGGGHTS stopped".into());
    assert_eq!(speed::page(&study, &options).exit_code(), 1, "nothing was asked of it");
}

#[test]
fn the_map_of_a_study_holds_what_was_found() {
    let only = vec!["rest-normal".to_string()];
    let options = Options { only, full: false, bench: NONE, command: String::new() };
    let study = stability::run(&options, &|_| ());
    let m = &study.mapped[0];
    assert_eq!((study.mapped.len(), m.cells.len()), (1, m.steps.len() * m.field.rows.len()));
    // Where energy is first created is where linear theory has it.
    for (onset, row) in m.onset.iter().zip(&m.field.rows) {
        let theory = row.normal.step() / row.unit();
        let onset = onset.expect("an onset");
        assert!((onset / theory - 1.0).abs() < 0.02, "e = {}: {onset} where theory has {theory}", row.param);
    }
    let page = stability::page(&study, &options);
    assert!(matches!(is(&page, "runs of LIGGGHTS"), Some(Outcome::Skipped(_))) && page.exit_code() == 0);
}
