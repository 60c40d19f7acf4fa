//! The question, and the answer for one kind of contact.
use granlaw::model::Mode;
use serde::Serialize;

/// The question.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Largest mean relative error of the restitution of an impact.
    pub accuracy: f64,
    /// Speed of the impacts \[m/s\]; without it, the fastest that the scene shows.
    pub speed: Option<f64>,
    /// How many bonds each particle is assumed to have.
    pub bonds: u32,
}

/// A kind of contact with its limits.
#[derive(Clone, Debug, Serialize)]
pub struct Contact {
    /// `pair`, or `wall` and the name of its fix.
    pub who: String,
    /// Atom types from 1; of a wall, that of its material behind that of the particle.
    pub types: [usize; 2],
    /// The laws, as the deck has them.
    pub laws: String,
    /// Speed of the impact that was looked at \[m/s\].
    pub speed: f64,
    /// Radii of the spheres that need the shortest step \[m\]; of a wall, 0.
    pub radii: [f64; 2],
    /// The modes: along the normal, along the surface, and the fastest contact that the scene has shown; or those of a bond.
    pub limits: Vec<Limit>,
    /// Of bonds: the fastest mode if every particle has as many of them as asked for. The step of linear theory is then a lower
    /// bound.
    pub together: Option<Limit>,
    /// Longest step for the accuracy \[s\]; `None` if no step that was tried is short enough, or if nothing was tried.
    pub accurate: Option<f64>,
}

/// A mode with its longest steps.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Limit {
    /// Its name.
    pub name: &'static str,
    /// Whether it turns the bodies about each other: then stiffness is in N m/rad and mass in kg m².
    pub turns: bool,
    /// The linear oscillator.
    #[serde(with = "ModeFields")]
    pub mode: Mode,
    /// Longest stable step of linear theory \[s\].
    pub critical: f64,
    /// Longest step at which no contact of the maps creates energy \[s\].
    pub safe: f64,
}

/// The fields of a [`Mode`] in JSON.
#[derive(Serialize)]
#[serde(remote = "Mode")]
struct ModeFields {
    stiffness: f64,
    damping: f64,
    mass: f64,
}

impl Contact {
    /// The longest stable step of linear theory \[s\].
    pub fn critical(&self) -> f64 {
        self.limits.iter().map(|l| l.critical).fold(f64::INFINITY, f64::min)
    }

    /// The longest step at which no energy is created \[s\].
    pub fn safe(&self) -> f64 {
        self.limits.iter().chain(&self.together).map(|l| l.safe).fold(f64::INFINITY, f64::min)
    }

    /// The longest step that is both safe and accurate \[s\].
    pub fn recommended(&self) -> f64 {
        self.accurate.unwrap_or(f64::INFINITY).min(self.safe())
    }
}
