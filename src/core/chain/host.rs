//! What a chain asks of the program that finds its contacts: how far to look, and what its walls do.
use super::Chain;
use crate::model::{LawError, Reach};

/// What is known of a wall before the run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wall {
    /// The gap beyond which the wall does not list a particle \[m\]; `None` where it looks as far as the chain asks.
    pub skin: Option<f64>,
    /// Whether it turns or changes its shape.
    pub turns: bool,
}

/// LIGGGHTS lists neighbours up to this multiple of the sum of their radii, as more would cost too much.
const FARTHEST: f64 = 10.0;

impl Chain {
    /// The multiple of the sum of radii up to which contacts must be found; 1 where no law acts across a gap. `rmin` is
    /// the smallest radius \[m\].
    ///
    /// # Errors
    /// It exceeds 10.
    pub fn contact_distance_factor(&self, rmin: f64) -> Result<f64, LawError> {
        let mut factor = 1.0f64;
        for link in self.links.iter().filter(|l| l.meta.reach == Reach::Beyond) {
            let law = link.meta.called(false);
            if rmin <= 0.0 || rmin.is_nan() {
                let what = format!("acts across gaps and needs radii, but the smallest is {rmin} m; create the particles or their templates before the first run");
                return Err(LawError::Senseless { law, what });
            }
            let (pair, wall) = (link.kernel.reach(false), link.kernel.reach(true));
            // A tenth more, so that a contact is still seen in the step in which it ends.
            let own = 1.1 * (pair / (2.0 * rmin)).max(wall / rmin);
            if own > FARTHEST {
                let what = format!("acts up to a distance of {:e} m, {own:.3} times the smallest diameter with a margin of a tenth; LIGGGHTS would look for neighbours that far, {FARTHEST} times is the most. Take smaller distances or strengths, or larger particles", pair.max(wall));
                return Err(LawError::Senseless { law, what });
            }
            factor = factor.max(own);
        }
        Ok(factor)
    }

    /// Whether a wall lets the laws do what they do. `rmin` is the smallest radius \[m\].
    ///
    /// # Errors
    /// It turns, which a law that holds particles to a point of it cannot follow; or it loses particles from sight that
    /// a law still acts on.
    pub fn check_wall(&self, wall: &Wall, rmin: f64) -> Result<(), LawError> {
        for link in &self.links {
            let law = link.meta.called(false);
            if link.meta.anchors && wall.turns {
                let what = "holds particles to a point of a wall, which may move but not turn or change its shape; give this wall another chain of laws".into();
                return Err(LawError::Senseless { law, what });
            }
            let gap = link.kernel.reach(true) - rmin;
            if let Some(skin) = wall.skin.filter(|skin| gap > *skin) {
                let what = format!("acts up to a gap of {gap:e} m from a wall, but LIGGGHTS lists particles near a primitive wall only up to the skin of {skin:e} m: the force would vanish and come back. Raise the skin with neighbor, or take a mesh wall");
                return Err(LawError::Senseless { law, what });
            }
        }
        Ok(())
    }

    /// What users should know of a set-up that is allowed but asks for trouble.
    pub fn remarks(&self) -> impl Iterator<Item = &str> {
        self.links.iter().flat_map(|l| l.kernel.remarks()).map(String::as_str)
    }
}
