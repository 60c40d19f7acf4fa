//! Finds the longest step for an accuracy by trying impacts in shorter and shorter steps, at many phases of first touch.
use crate::study::adaptive::{impact, Aim};
use crate::study::collision::Collision;
use granlaw::chain::Chain;
use granlaw::pair::run_while;

/// The range of the search, and the accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// Longest step \[s\].
    pub longest: f64,
    /// About how long the contact lasts \[s\].
    pub period: f64,
    /// Largest mean error of the restitution: relative, or absolute where bodies should stick.
    pub accuracy: f64,
}

/// Phases of first touch.
const PHASES: usize = 24;
/// Ratio of each step to the one before.
const SHORTER: f64 = 0.9;
/// This many steps in a row must be good, as errors go up and down with the number of steps per contact.
const GOOD: usize = 5;
/// Ratio of the shortest step to the longest.
const LEAST: f64 = 1e-4;
/// From this ratio of the energy afterwards to that before, energy counts as created.
const CREATED: f64 = 1.01;

/// The longest step \[s\] below which all that were tried are good too; `None` if none of those tried is.
pub fn accurate(chain: &mut Chain, collision: &Collision, search: &Search) -> Option<f64> {
    let aim = Aim { tolerance: 1e-8, duration: search.period, longest: 0.1, with_force: false };
    let (exact, _) = impact(chain, collision, &aim);
    let truth = exact.parted.then_some(exact.restitution);
    let (mut dt, mut good, mut first) = (search.longest, 0, None);
    while dt >= LEAST * search.longest {
        if error(chain, collision, dt, search.period, truth) <= search.accuracy {
            good += 1;
            first = first.or(Some(dt));
        } else {
            (good, first) = (0, None);
        }
        if good == GOOD {
            return first;
        }
        dt *= SHORTER;
    }
    None
}

/// Mean error over the phases; infinite where energy comes from nothing.
fn error(chain: &mut Chain, collision: &Collision, dt: f64, period: f64, truth: Option<f64>) -> f64 {
    let steps = (4.0 * period / dt) as u64 + 12;
    let mut sum = 0.0;
    for phase in 0..PHASES {
        let start = collision.start(dt, (phase as f64 + 0.5) / PHASES as f64, steps);
        let mut last = start.bodies;
        run_while(chain, &start, |s| {
            last = s.bodies;
            true
        });
        let o = collision.judge(&last);
        if !o.finite || o.energy > CREATED {
            return f64::INFINITY;
        }
        sum += match truth {
            Some(e) => ((o.restitution - e) / e).abs(),
            None if o.apart => o.restitution.abs(),
            None => 0.0,
        };
    }
    sum / PHASES as f64
}
