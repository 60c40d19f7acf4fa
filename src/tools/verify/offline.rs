//! Verifies without LIGGGHTS, on recorded traces; the report says what that leaves out.
use super::checks::{self, Limit};
use super::{answers, two_body, VerifyError};
use crate::codes::RunError;
use crate::deck::{Asked, Deck, What};
use crate::report::{Case, Shows};
use crate::trace::Reader;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

const REASON: &str = "the same operations in the same order may differ by a few rounding errors of the peak";

/// One case for every recorded trace.
pub(super) fn cases(missing: &RunError) -> Result<Vec<Case>, VerifyError> {
    let folders = folders();
    let traces: Vec<_> = folders.iter().map(|f| traces(f)).find(|t| !t.is_empty()).unwrap_or_default();
    if traces.is_empty() {
        let looked = folders.iter().map(|f| f.display().to_string()).collect();
        return Err(VerifyError::NoTraces { missing: missing.to_string(), looked });
    }
    Ok(traces.iter().map(|t| case(t)).collect())
}

/// What such a run leaves out, in words.
pub(super) fn notes(missing: &RunError, decks: &[(String, Deck)], traces: usize) -> Vec<String> {
    let why = missing.to_string().lines().next().unwrap_or_default().to_string();
    let names: Vec<_> = decks.iter().map(|(name, _)| name.as_str()).collect();
    vec![
        format!("No live run: {why}"),
        format!("{traces} recorded traces were replayed in their place"),
        format!("decks that were not run: {} ({})", decks.len(), names.join(", ")),
        "checks that only a live run can make are left out: recorded, plugin and final of every case".into(),
    ]
}

/// The folders in which recorded traces are looked for: those of an installed granlaw, of its source, and here.
fn folders() -> Vec<PathBuf> {
    let exe = std::env::current_exe().and_then(|p| p.canonicalize()).unwrap_or_default();
    let share = exe.parent().and_then(Path::parent).map(|p| p.join("share/granlaw/reference_data"));
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("the crate lies in src/tools");
    share.into_iter().chain([top.join("reference_data"), PathBuf::from("reference_data")]).collect()
}

fn traces(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path());
    let mut found: Vec<_> = entries.filter(|p| p.is_file() && Reader::open(p).is_ok()).collect();
    found.sort();
    found
}

fn case(trace: &Path) -> Case {
    let begun = Instant::now();
    let name = trace.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let mut case = Case { name, deck: trace.display().to_string(), ..Case::default() };
    let one = [trace.to_path_buf()];
    match answers::describe(&one, &mut case) {
        Ok((_, 0)) => case.checks.push(checks::could_not("replay", Shows::Port, "no contact in the trace")),
        Ok((calls, _)) => case.calls = calls,
        Err(why) => case.checks.push(checks::could_not("replay", Shows::Port, why)),
    }
    let deck = deck(trace);
    case.title = deck.as_ref().map_or_else(|| format!("Recorded: {}", case.name), |d| d.title.clone());
    for asked in deck.map_or_else(usual, |d| d.checks) {
        check(&one, &asked, &mut case);
    }
    for name in ["recorded", "plugin"] {
        if case.checks.iter().all(|c| c.name != name) {
            case.checks.push(checks::skipped(name, Shows::Boundary, LEFT_OUT));
        }
    }
    case.seconds = begun.elapsed().as_secs_f64();
    case
}

const LEFT_OUT: &str = "needs a run of LIGGGHTS with the plugin";

/// The deck from which a trace was recorded, if it is in the same folder.
fn deck(trace: &Path) -> Option<Deck> {
    let name = Reader::open(trace).ok()?.header().deck.clone();
    Deck::read(&trace.with_file_name(name)).ok()
}

fn usual() -> Vec<Asked> {
    vec![Asked { what: What::Replay { limit: 1e-14 }, reason: REASON.into(), line: 0 }]
}

fn check(trace: &[PathBuf], asked: &Asked, case: &mut Case) {
    match &asked.what {
        What::Replay { limit } => {
            let (check, curves) = answers::replay(trace, Shows::Port, Limit::new(*limit, asked));
            case.checks.push(check);
            case.curves.splice(0..0, curves);
        }
        What::TwoBody { limit } => {
            let (check, curve) = two_body::check(trace, Limit::new(*limit, asked));
            case.checks.push(check);
            case.curves.extend(curve);
        }
        What::SameAs { deck } => {
            case.checks.push(checks::skipped(&format!("same as {deck}"), Shows::Port, LEFT_OUT))
        }
        What::Plugin => case.checks.push(checks::skipped("plugin", Shows::Boundary, LEFT_OUT)),
        What::Final(f) => {
            let name = format!("final {} of {}", f.column, f.id);
            case.checks.push(checks::skipped(&name, Shows::Physics, LEFT_OUT));
        }
    }
}
