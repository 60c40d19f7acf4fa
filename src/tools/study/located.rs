//! Fixed steps, shortened to end at events: first touch, last touch, the turning point, a change of branch.
use super::collision::{Collision, Outcome};
use super::motion::{Instant, Motion};
use granlaw::chain::Chain;
use granlaw::model::Kind;

/// Integrates the contact in steps of `h` \[s\]. Returns the outcome and the number of evaluations of the laws.
pub fn impact(chain: &mut Chain, collision: &Collision, h: f64, with_force: bool) -> (Outcome, u64) {
    let start = collision.start(h, 0.0, 0);
    let watched: Vec<bool> = chain.laws().map(|m| matches!(m.kind, Kind::Normal | Kind::Cohesion)).collect();
    let mut m = Motion::new(chain, &start, collision);
    let mut at = m.touch(start.bodies);
    let mut seen = Outcome::default();
    let limit = 1_000_000;
    for step in 0..limit {
        seen.peak = seen.peak.max(at.response.fn_);
        if with_force {
            seen.force.push((at.time, at.response.fn_));
        }
        if m.overlap_after(&at, h) < 0.0 && step > 0 {
            let last = bisect(h, 60, |h| m.overlap_after(&at, h) < 0.0);
            at = m.step(&at, last);
            seen.duration = at.time;
            seen.parted = true;
            break;
        }
        let begun = mode(&mut m, &at, &watched);
        let end = m.step(&at, h);
        let changed = mode(&mut m, &end, &watched) != begun;
        at = match changed {
            false => end,
            true => {
                let here = at.clone();
                // The event is found to a fraction of the step that is small against the error of the step itself.
                let part = bisect(h, 20, |h| {
                    let there = m.step(&here, h);
                    mode(&mut m, &there, &watched) != begun
                });
                m.step(&here, part)
            }
        };
        if !at.vn.is_finite() {
            break;
        }
    }
    let calls = m.calls;
    let Outcome { peak, duration, parted, force, .. } = seen;
    (Outcome { peak, duration, parted, force, ..collision.judge(&at.bodies) }, calls)
}

/// What must not change within a step: the direction of the motion, and the branch of each law that has branches.
fn mode(m: &mut Motion<'_>, at: &Instant, watched: &[bool]) -> (bool, Vec<&'static str>) {
    let branches = m.branches(at);
    let kept = branches.into_iter().zip(watched).filter(|(_, watched)| **watched).map(|(b, _)| b);
    (at.vn < 0.0, kept.collect())
}

/// The shortest time in (0, h] for which `beyond` holds, by `halvings` bisections; `beyond` holds at `h`.
fn bisect(h: f64, halvings: u32, mut beyond: impl FnMut(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, h);
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        if beyond(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}
