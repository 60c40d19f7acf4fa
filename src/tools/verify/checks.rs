//! Makes checks of the report out of comparisons.
use crate::deck::Asked;
use crate::report::{Check, Outcome, Shows, Tolerance, Worst};

/// A limit with its reason, as the deck gives them.
#[derive(Clone, Copy)]
pub(super) struct Limit<'a> {
    pub limit: f64,
    pub reason: &'a str,
}

impl<'a> Limit<'a> {
    pub fn new(limit: f64, asked: &'a Asked) -> Limit<'a> {
        Limit { limit, reason: &asked.reason }
    }

    fn tolerance(self) -> Option<Tolerance> {
        Some(Tolerance { limit: self.limit, reason: self.reason.into() })
    }
}

/// A check of a number against a limit.
pub(super) fn within(name: &str, shows: Shows, limit: Limit<'_>, worst: Worst) -> Check {
    let outcome = if worst.error <= limit.limit {
        Outcome::Agreed
    } else {
        let Worst { step, what, got, expected, error, norm } = &worst;
        Outcome::Disagreed(format!(
            "{what} at step {step} is {got:e} where {expected:e} was expected: {error:.2e} {norm}, allowed {:e}",
            limit.limit
        ))
    };
    Check { name: name.into(), shows, outcome, tolerance: limit.tolerance(), worst: Some(worst) }
}

/// A check of answers that were allowed to differ and do not.
pub(super) fn equal(name: &str, shows: Shows, limit: Limit<'_>) -> Check {
    Check { tolerance: limit.tolerance(), ..bare(name, shows, Outcome::Agreed) }
}

/// A check of answers that must be the same to the last bit: `difference` says where they are not.
pub(super) fn identical(
    name: &str,
    shows: Shows,
    reason: &str,
    difference: Option<(String, Option<Worst>)>,
) -> Check {
    let tolerance = Limit { limit: 0.0, reason }.tolerance();
    let (outcome, worst) = match difference {
        None => (Outcome::Agreed, None),
        Some((text, worst)) => (Outcome::Disagreed(text), worst),
    };
    Check { name: name.into(), shows, outcome, tolerance, worst }
}

/// A comparison that could not be made.
pub(super) fn could_not(name: &str, shows: Shows, why: impl Into<String>) -> Check {
    bare(name, shows, Outcome::CouldNotRun(why.into()))
}

/// A comparison that was left out.
pub(super) fn skipped(name: &str, shows: Shows, why: impl Into<String>) -> Check {
    bare(name, shows, Outcome::Skipped(why.into()))
}

fn bare(name: &str, shows: Shows, outcome: Outcome) -> Check {
    Check { name: name.into(), shows, outcome, tolerance: None, worst: None }
}
