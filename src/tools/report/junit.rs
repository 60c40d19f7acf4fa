//! `junit.xml`: one suite per case, one test per check, as CI servers read it.
use super::{escape, folder, summary, Case, Check, Outcome, Report, ReportError, Writer};
use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};
use std::path::Path;
use std::time::Duration;

pub(super) struct Junit;

impl Writer for Junit {
    fn write(&self, report: &Report, dir: &Path) -> Result<(), ReportError> {
        let mut xml = quick_junit::Report::new("granlaw verify");
        for (case, id) in report.cases.iter().zip(summary::ids(report)) {
            xml.add_test_suite(suite(case, &id));
        }
        if report.cases.is_empty() {
            xml.add_test_suite(suite(&Case::default(), "granlaw"));
        }
        let xml = xml.to_string().map_err(|e| ReportError::Format(e.into()))?;
        folder::save(&dir.join("junit.xml"), &xml)
    }
}

fn suite(case: &Case, id: &str) -> TestSuite {
    let mut suite = TestSuite::new(id);
    if let Ok(time) = Duration::try_from_secs_f64(case.seconds) {
        suite.set_time(time);
    }
    suite.add_test_cases(case.checks.iter().map(|check| test(check, id)));
    let judged = |c: &Check| !matches!(c.outcome, Outcome::Skipped(_));
    // If nothing was compared, the case has not passed; servers would count an empty suite as passed.
    if !case.checks.iter().any(judged) {
        let verdict = case.verdict();
        suite.add_test_case(named("verdict", id, status(&verdict, verdict.why().unwrap_or_default().into())));
    }
    if let Some(log) = &case.log {
        suite.set_system_out(log);
    }
    suite
}

fn test(check: &Check, id: &str) -> TestCase {
    named(&check.name, id, status(&check.outcome, details(check)))
}

fn named(name: &str, id: &str, status: TestCaseStatus) -> TestCase {
    let mut test = TestCase::new(name, status);
    test.set_classname(id);
    test
}

fn status(outcome: &Outcome, details: String) -> TestCaseStatus {
    let mut status = match outcome {
        Outcome::Agreed => TestCaseStatus::success(),
        Outcome::Disagreed(_) => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Outcome::CouldNotRun(_) => TestCaseStatus::non_success(NonSuccessKind::Error),
        Outcome::Skipped(_) => TestCaseStatus::skipped(),
    };
    if let Some(why) = outcome.why() {
        status.set_message(why).set_type(outcome.word()).set_description(details);
    }
    status
}

/// The lines under the message: where and what differs, by how much, and the limit with its reason.
fn details(check: &Check) -> String {
    let mut lines = vec![format!("{}: {}", check.shows.word(), check.shows.meaning())];
    if let Some(w) = &check.worst {
        let (got, expected) = (escape::exact(w.got), escape::exact(w.expected));
        lines.push(format!("worst at step {}: {}", w.step, w.what));
        lines.push(format!("got {got}, expected {expected}"));
        lines.push(format!("error {} {}", escape::rough(w.error), w.norm));
    }
    if let Some(t) = &check.tolerance {
        lines.push(format!("limit {} because {}", escape::rough(t.limit), t.reason));
    }
    lines.join("\n")
}
