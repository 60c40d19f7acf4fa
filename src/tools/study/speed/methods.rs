//! The methods by which a contact is integrated.
use super::bonds;
use super::case::{Case, Measure};
use super::truth::Truth;
use crate::study::bonded::{self, Look};
use crate::study::collision::{Follow, Outcome};
use crate::study::matter::Matter;
use crate::study::{adaptive, located, single};
use granlaw::chain::Chain;
use granlaw::pair::run_while;

/// A method of integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// LIGGGHTS with its own laws.
    Stock,
    /// LIGGGHTS with our laws in their place.
    Plugin,
    /// LIGGGHTS with our laws and both settings on.
    PluginTimed,
    /// LIGGGHTS's scheme, in our own code.
    Verlet,
    /// The same with both settings on.
    VerletTimed,
    /// The same in single precision.
    Single,
    /// Fixed steps that end at events.
    Located,
    /// Adaptive extrapolation.
    Adaptive,
}

/// The methods that do not need LIGGGHTS.
pub const OURS: [Method; 5] =
    [Method::Verlet, Method::VerletTimed, Method::Single, Method::Located, Method::Adaptive];

impl Method {
    /// The name in legends.
    pub fn name(self) -> &'static str {
        match self {
            Method::Stock => "LIGGGHTS, its own laws",
            Method::Plugin => "LIGGGHTS, Rust laws",
            Method::PluginTimed => "LIGGGHTS, Rust laws, both settings",
            Method::Verlet => "velocity Verlet",
            Method::VerletTimed => "velocity Verlet, both settings",
            Method::Single => "velocity Verlet, single precision",
            Method::Located => "steps that end at events",
            Method::Adaptive => "adaptive extrapolation",
        }
    }

    /// Whether it runs in LIGGGHTS.
    pub fn is_live(self) -> bool {
        matches!(self, Method::Stock | Method::Plugin | Method::PluginTimed)
    }

    /// The laws with the settings of this method.
    pub fn matter(self, case: &Case) -> Matter {
        match self {
            Method::PluginTimed | Method::VerletTimed => case.matter.clone().timed(),
            _ => case.matter.clone(),
        }
    }
}

/// A method that is prepared to run a case many times.
pub struct Runner<'a> {
    method: Method,
    case: &'a Case,
    matter: Matter,
    chain: Chain,
    duration: f64,
}

impl<'a> Runner<'a> {
    /// Prepares a method; `None` if it cannot do the case.
    pub fn new(method: Method, case: &'a Case, truth: &Truth) -> Option<Runner<'a>> {
        let matter = method.matter(case);
        let chain = matter.chain().ok()?;
        let duration = truth.outcome.duration;
        let works = match method {
            Method::Single => single::impact(&matter, &case.collision, 0.1 * duration, 0.5).is_some(),
            Method::Located | Method::Adaptive => match case.collision.row() {
                Some(bonded) => bonded.beads == 2 && case.measure == Measure::Restitution,
                None => case.collision.rest.is_none(),
            },
            // Bonds have no such settings.
            Method::VerletTimed | Method::PluginTimed | Method::Stock => case.collision.row().is_none(),
            _ => true,
        };
        works.then_some(Runner { method, case, matter, chain, duration })
    }

    /// Runs one contact in about `n` steps, with first touch `before` steps after the start, and with the force history if asked for.
    /// For the adaptive method `n` is the inverse of its tolerance.
    pub fn run(&mut self, n: f64, before: f64, with_force: bool) -> Outcome {
        let (collision, h) = (&self.case.collision, self.duration / n);
        match self.method {
            Method::Verlet if collision.row().is_some() => {
                let bonded = collision.row().expect("a row");
                let look =
                    if self.case.measure == Measure::Spin { Look::End } else { Look::Once { with_force } };
                bonded::run(
                    &mut self.chain,
                    collision,
                    &bonded,
                    bonds::steps(self.case, self.duration, n),
                    look,
                )
            }
            Method::Single => single::impact(&self.matter, collision, h, before).unwrap_or_default(),
            Method::Located => located::impact(&mut self.chain, collision, h, with_force).0,
            Method::Adaptive => {
                let duration = self.duration;
                let aim = adaptive::Aim { tolerance: 1.0 / n, duration, longest: 0.3, with_force };
                adaptive::impact(&mut self.chain, collision, &aim).0
            }
            _ => {
                // Bodies that still touch after twenty times the expected duration count as stuck.
                let steps = collision.rest.map_or(20.0 * n, |r| r.time / h);
                let start = collision.start(h, before, steps as u64);
                let mut follow = Follow::new(collision, &start, before, with_force);
                let mut last = start.bodies;
                run_while(&mut self.chain, &start, |s| {
                    last = s.bodies;
                    follow.step(s)
                });
                follow.end(&last)
            }
        }
    }
}
