//! A row of a field: laws and numbers, how bodies meet, and the limits of theory.
use super::cell::{Class, Found, CREATED};
use crate::study::adaptive::{impact, Aim};
use crate::study::bonded;
use crate::study::collision::{Collision, Outcome};
use crate::study::matter::Matter;
use crate::study::modes::{reached, Modes};
use granlaw::critical::{hertz, rayleigh};
use granlaw::model::Mode;
use granlaw::pair::run_while;
use std::f64::consts::PI;

/// What happens, and what is measured of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// An impact; the restitution is measured.
    Impact,
    /// An oblique impact; the final spin is measured.
    Oblique,
    /// A sphere at rest on a wall that is given a small velocity along the normal; it should stay calm.
    RestNormal,
    /// The same with a velocity along the wall.
    RestTangential,
    /// A rolling sphere comes to rest; the speed that is left is measured.
    Roll,
    /// Bonded spheres swing for this number of steps; their bonds may take energy, but never add it.
    Bonded(u64),
    /// A sphere hangs on a wall by a bond and comes to rest in this number of half periods; the speed that is left is measured.
    Hang(u64),
}

impl Scene {
    /// Whether bodies meet and part again.
    fn meets(self) -> bool {
        matches!(self, Scene::Impact | Scene::Oblique)
    }
}

/// A row.
#[derive(Clone, Debug)]
pub struct Row {
    /// The parameter.
    pub param: f64,
    /// Laws and numbers.
    pub matter: Matter,
    /// How bodies meet, at a few speeds.
    pub collisions: Vec<Collision>,
    /// What happens.
    pub scene: Scene,
    /// The stiffest normal mode that the contact reaches.
    pub normal: Mode,
    /// The stiffest tangential mode; without stiffness if there is no shear. Of bonds, the fastest of all modes.
    pub tangential: Mode,
    /// The step beyond which `fix check/timestep/gran` with 0.2 and 0.2 warns \[s\].
    pub warns: f64,
    /// Half a period of the loading stiffness \[s\].
    period: f64,
    /// The true value of what is measured, for each collision; NaN if the bodies should stick.
    truth: Vec<f64>,
}

/// Fractions of Rayleigh and Hertz times that are commonly given to the check.
const FRACTIONS: (f64, f64) = (0.2, 0.2);
/// Number of steps for which a sphere at rest is followed.
const WATCHED: u64 = 600;

impl Row {
    /// A row with the limits of theory and a converged solution.
    ///
    /// # Panics
    /// If the laws refuse the numbers, which is a bug of the field.
    pub fn new(param: f64, matter: Matter, collisions: Vec<Collision>, scene: Scene) -> Row {
        let fastest =
            collisions.iter().copied().max_by(|a, b| a.speed.total_cmp(&b.speed)).expect("a collision");
        let chain = || matter.chain().expect("a sound row");
        let Modes { normal, tangential, period } = reached(&mut chain(), &mut chain(), &fastest);
        let warns = warns(&matter, &fastest);
        let mut row =
            Row { param, matter, collisions, scene, normal, tangential, warns, period, truth: Vec::new() };
        row.truth = row.collisions.iter().map(|s| row.expected(s)).collect();
        row
    }

    /// A row of bonds. Steps are in units of the mode `unit`; `fastest` is the fastest mode by theory.
    pub fn bonded(
        param: f64,
        matter: Matter,
        collisions: Vec<Collision>,
        scene: Scene,
        [unit, fastest]: [Mode; 2],
    ) -> Row {
        let warns = warns(&matter, &collisions[0]);
        let (period, truth) = (PI / fastest.frequency(), vec![0.0; collisions.len()]);
        Row { param, matter, collisions, scene, normal: unit, tangential: fastest, warns, period, truth }
    }

    /// The unit of steps \[s\]: the critical step of the stiffest normal mode without damping, 2/ω.
    pub fn unit(&self) -> f64 {
        self.normal.step_centred()
    }

    /// The measured quantity of an outcome.
    fn measure(&self, o: &Outcome) -> f64 {
        match self.scene {
            Scene::Impact => o.restitution,
            Scene::Oblique => o.spin,
            Scene::Roll | Scene::Hang(_) => o.left,
            Scene::RestNormal | Scene::RestTangential | Scene::Bonded(_) => 0.0,
        }
    }

    fn expected(&self, collision: &Collision) -> f64 {
        if !self.scene.meets() {
            return 0.0;
        }
        let mut chain = self.matter.chain().expect("a sound row");
        let aim = Aim { tolerance: 1e-8, duration: self.period, longest: 0.1, with_force: false };
        let (o, _) = impact(&mut chain, collision, &aim);
        if o.parted {
            self.measure(&o)
        } else {
            f64::NAN
        }
    }

    /// Number of steps of `dt` \[s\] that the scene takes.
    pub fn length(&self, dt: f64) -> u64 {
        match self.scene {
            Scene::RestNormal | Scene::RestTangential => WATCHED,
            Scene::Roll => self.collisions[0].rest.map_or(0, |r| (r.time / dt) as u64),
            Scene::Bonded(steps) => steps,
            Scene::Hang(half) => (half as f64 * self.period / dt) as u64,
            // Long enough for the slowest contact, and at least a few steps.
            Scene::Impact | Scene::Oblique => (4.0 * self.period / dt) as u64 + 12,
        }
    }

    /// How many steps before first touch the collisions of a cell begin.
    pub fn before(&self, phases: usize) -> Vec<f64> {
        match self.scene {
            Scene::Impact | Scene::Oblique => (0..phases).map(|k| (k as f64 + 0.5) / phases as f64).collect(),
            _ => vec![0.0],
        }
    }

    /// The result of all collisions in steps of `step` units.
    pub fn at(&self, step: f64, phases: usize) -> Found {
        let dt = step * self.unit();
        let mut chain = self.matter.chain().expect("a sound row");
        let (mut outcomes, mut missed) = (Vec::new(), 0);
        for collision in &self.collisions {
            if let Some(bonded) = collision.row() {
                outcomes.push(bonded::run(
                    &mut chain,
                    collision,
                    &bonded,
                    (dt, self.length(dt)),
                    bonded::Look::Energy,
                ));
                continue;
            }
            for before in self.before(phases) {
                let start = collision.start(dt, before, self.length(dt));
                let (mut last, mut out) = (start.bodies, false);
                run_while(&mut chain, &start, |s| {
                    last = s.bodies;
                    out |= s.touching && s.contact.surface.vn > 0.0;
                    s.bodies[0].x.iter().all(|x| x.abs() < 1e6)
                });
                missed += usize::from(!out);
                outcomes.push(collision.judge(&last));
            }
        }
        let missed = missed as f64 / outcomes.len() as f64;
        Found { missed, ..self.judge(&outcomes, phases) }
    }

    /// The same from given outcomes, collision by collision, each with all its phases.
    pub fn judge(&self, outcomes: &[Outcome], phases: usize) -> Found {
        let each = self.before(phases).len();
        Found::of(outcomes, |k, o| {
            let (got, truth) = (self.measure(o), self.truth[k / each]);
            let error = match self.scene {
                Scene::RestNormal | Scene::RestTangential | Scene::Bonded(_) => 0.0,
                Scene::Roll | Scene::Hang(_) => got.abs(),
                // If the bodies should stick, the speed of separation is the error.
                _ if truth.is_nan() && o.apart => got.abs(),
                _ if truth.is_nan() => 0.0,
                _ => ((got - truth) / truth).abs(),
            };
            (error, self.scene.meets() && truth.is_nan() == o.apart)
        })
    }

    /// The ratio of energies from which on energy counts as created, at a step in units. Velocity Verlet conserves an energy of its own; for
    /// a sphere that still swings the true energy varies about it by 1/(1 − s²), where s is the step over the critical one.
    fn created(&self, step: f64) -> f64 {
        let critical = match self.scene {
            Scene::RestNormal => self.normal.step_centred(),
            Scene::RestTangential => self.tangential.step_centred(),
            _ => return CREATED,
        };
        let s = step * self.unit() / critical;
        if s < 1.0 {
            CREATED / (1.0 - s * s)
        } else {
            CREATED
        }
    }

    /// The class of a result, at a step in units.
    pub fn class(&self, step: f64, found: &Found) -> Class {
        let stops = matches!(self.scene, Scene::Roll | Scene::Hang(_));
        let limits = if stops { (1e-4, 1e-2) } else { (0.01, 0.1) };
        found.class(limits, self.created(step), step * self.unit() > self.warns)
    }
}

/// The step beyond which LIGGGHTS's check warns \[s\].
fn warns(matter: &Matter, collision: &Collision) -> f64 {
    let value = |name| matter.value(name).expect("a value of the row");
    let (young, poisson) = (value("youngsModulus"), value("poissonsRatio"));
    let e_star = young / (2.0 * (1.0 - poisson * poisson));
    let [i, j] = collision.bodies();
    let speed = i.v.norm().max(j.v.norm());
    let of = |b: &granlaw::model::Body| {
        let r = FRACTIONS.0 * rayleigh(b.radius, collision.density, young, poisson);
        r.min(FRACTIONS.1 * hertz(b.mass, b.radius, e_star, speed))
    };
    if collision.wall {
        of(&i)
    } else {
        of(&i).min(of(&j))
    }
}
