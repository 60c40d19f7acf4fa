//! The reasons for advice, in words and numbers.
use super::found::Advice;
use super::ladder::Trial;
use super::lines::{number, percent};

/// The reasons, in sentences with numbers.
pub(super) fn reasons(a: &Advice) -> Vec<String> {
    let mut all = Vec::new();
    let whole = &a.ladder[0];
    let worst = |t: &Trial| {
        t.worst.map_or("no error".into(), |(what, size, k)| {
            format!("{what} wrong by {} in {}", percent(size), a.groups[k].name)
        })
    };
    if !a.groups.is_empty() {
        all.push(format!(
            "{} classes of contacts were tried, which stand for {} of the impacts and {} of the momentum exchanged",
            a.groups.len(),
            percent(a.covered.0),
            percent(a.covered.1)
        ));
    }
    all.extend(a.untried.iter().map(|u| {
        format!(
            "{u} acts across gaps, which two bodies from their first touch on do not show: its chain and the time step stay as they are"
        )
    }));
    for r in a.ladder.iter().filter(|r| r.changes.len() == 1) {
        let name = r.name();
        all.push(match (&r.refused, r.holds, r.step) {
            (Some(why), ..) => format!("{name} could not be tried: {why}"),
            (_, false, _) => format!("{name} is not good enough: {}", worst(&r.model)),
            (_, true, Some(step)) => {
                format!("{name} is good enough ({}), up to a step of {} s", worst(&r.model), number(step))
            }
            (_, true, None) => format!("{name} is good enough, but in no step that was tried"),
        });
    }
    if !a.untried.is_empty() {
        return all;
    }
    all.push(match (whole.step, &whole.at_step) {
        (Some(step), Some(t)) if step >= a.dt => {
            format!("the laws as they are bear a step of {} s: {}", number(step), worst(t))
        }
        (Some(step), _) => format!(
            "the deck's own step of {} s is too large for {}: the laws as they are need {} s",
            number(a.dt),
            percent(a.options.accuracy),
            number(step)
        ),
        _ => format!(
            "the laws as they are are not within {} in any step that was tried",
            percent(a.options.accuracy)
        ),
    });
    all
}
