//! Repeats the loads of a probe: a contact is pressed, sheared, rolled and pulled until it carries what it carried in the run.
//!
//! Nothing is integrated here: the bodies are moved in small prescribed steps. How a lasting contact moves depends on its neighbours and
//! cannot be repeated; what it can carry, and how deep it gets, depends on its laws alone.
use crate::probe::Pressed;
use granlaw::chain::Chain;
use granlaw::model::{Body, Call, ClosePair, Contact, Kind, Response, Surface};
use nalgebra::Vector3;

/// The first and the largest overlap that are tried, relative to what a spring of the largest stiffness of the run would
/// need.
const FIRST: f64 = 0.01;
const DEEPEST: f64 = 100.0;
/// The relative precision to which the overlap under a load is found.
const NEAR: f64 = 1e-3;
/// Shear per step, relative to the overlap, and the number of steps after which a contact that still slides is taken to carry
/// nothing.
const SHEAR: f64 = 0.002;
const SHEARED: usize = 4000;
/// Number of steps of rolling, and of pulling apart.
const ROLLED: usize = 20;
const PULLED: usize = 1000;

/// What a contact can carry.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Overlap under the mean load, after the largest load \[m\]; infinite if no overlap that was tried carries the load.
    pub overlap: f64,
    /// Tangential force that it still carries at rest, over the normal load, after it was sheared until it carried what it did in
    /// the run.
    pub shear: f64,
    /// Torque against rolling and against torsion, over normal load times R*.
    pub torque: [f64; 2],
    /// Largest attraction while it is pulled apart, over the normal load; not more than there was in the run.
    pub tension: f64,
    /// Circular frequency of the normal spring under the largest load \[rad/s\].
    pub omega: f64,
}

/// Presses, shears, rolls and pulls. `dt` \[s\] is the time step that the laws see; its size does not matter, as forces are
/// read at rest.
pub fn hold(chain: &mut Chain, load: &Pressed, dt: f64) -> Held {
    let mut rig = Rig::new(chain, load, dt);
    let mut held = Held { overlap: f64::INFINITY, ..Held::default() };
    if !rig.press(load.push.max(load.normal)) {
        return held;
    }
    held.omega = rig.omega();
    rig.ease(load.normal);
    held.overlap = rig.overlap;
    held.shear = rig.shear(load.tangential) / load.normal;
    let lever = load.normal * load.partners.reff();
    held.torque = [Vector3::z(), Vector3::x()].map(|axis| rig.roll(axis) / lever);
    held.tension = rig.pull().min(load.pull) / load.normal;
    held
}

/// A contact with its history, moved in prescribed steps.
struct Rig<'a> {
    chain: &'a mut Chain,
    load: &'a Pressed,
    dt: f64,
    overlap: f64,
    slip: f64,
    spin: Vector3<f64>,
    history: Vec<f64>,
}

impl Rig<'_> {
    fn new<'a>(chain: &'a mut Chain, load: &'a Pressed, dt: f64) -> Rig<'a> {
        let history = vec![0.0; chain.row()];
        Rig { chain, load, dt, overlap: 0.0, slip: 0.0, spin: Vector3::zeros(), history }
    }

    fn types(&self) -> (usize, usize) {
        let [i, j] = self.load.partners.types;
        (i - 1, j - 1)
    }

    fn contact(&self) -> Contact {
        let p = &self.load.partners;
        let body =
            |k: usize| Body { tag: 1 + k as i64, radius: p.radius[k], mass: p.mass[k], ..Body::default() };
        let (mut i, j) = (body(0), body(1));
        (i.v, i.omega) = (Vector3::y() * self.slip, self.spin);
        let delta = Vector3::x() * (p.radius[0] + p.radius[1] - self.overlap);
        i.x = delta;
        let call = Call { dt: self.dt, step: 1, update: true, counts: false, is_wall: p.wall };
        let gap = ClosePair { call, i, j, delta, rsq: delta.norm_squared(), meff: p.meff };
        let lever = |k: usize| if p.radius[k] > 0.0 { p.radius[k] - 0.5 * self.overlap } else { 0.0 };
        let surface = Surface {
            r: delta.x,
            deltan: self.overlap,
            vn: 0.0,
            en: Vector3::x(),
            vtr: i.v,
            roll: self.spin,
            cri: lever(0),
            crj: lever(1),
        };
        Contact { close: gap, surface }
    }

    fn touch(&mut self) -> Response {
        let mut s = Response::default();
        let (types, x) = (self.types(), self.contact());
        self.chain.surfaces_intersect(types, &x, &mut self.history, &mut s);
        s
    }

    /// Presses, from first touch, until the contact repels with a force \[N\]. Returns whether that was reached.
    fn press(&mut self, wanted: f64) -> bool {
        let scale = wanted / self.load.kn;
        let mut step = FIRST * scale;
        while self.overlap < DEEPEST * scale {
            if !self.tried(step, |push| push >= wanted) {
                step *= 1.1;
            } else if step <= NEAR * self.overlap {
                self.overlap += step;
                return self.touch().force.x >= wanted;
            } else {
                step *= 0.5;
            }
        }
        false
    }

    /// Moves the bodies apart until the contact repels with no more than a force \[N\].
    fn ease(&mut self, wanted: f64) {
        let mut step = 0.1 * self.overlap;
        while step > NEAR * NEAR * self.overlap {
            if self.touch().force.x <= wanted {
                return;
            }
            // Surfaces that have parted have no force; that is too far as well.
            if self.tried(-step, |push| push.is_nan() || push < wanted) {
                step *= 0.5;
            }
        }
    }

    /// Changes the overlap. If that goes too far, everything is put back, and the result is true.
    fn tried(&mut self, by: f64, too_far: impl Fn(f64) -> bool) -> bool {
        let before = (self.overlap, self.history.clone());
        self.overlap += by;
        let over = too_far(self.touch().force.x);
        if over {
            (self.overlap, self.history) = before;
        }
        over
    }

    /// Slides until the contact carries a tangential force \[N\], stops, and returns the force that is left at rest.
    fn shear(&mut self, wanted: f64) -> f64 {
        let mut borne = 0.0;
        for _ in 0..SHEARED {
            self.slip = SHEAR * self.overlap / self.dt;
            self.touch();
            self.slip = 0.0;
            borne = -self.touch().force.y;
            if borne >= wanted {
                break;
            }
        }
        borne
    }

    /// Rolls about an axis, slowly and without slip, and returns the torque against that \[N m\].
    fn roll(&mut self, axis: Vector3<f64>) -> f64 {
        let still = self.touch();
        self.spin = axis * (SHEAR * self.overlap / self.dt / self.load.partners.reff());
        let turned = (0..ROLLED).map(|_| self.touch()).last().unwrap_or_default();
        self.spin = Vector3::zeros();
        (still.torque_i - turned.torque_i).dot(&axis)
    }

    /// Pulls the contact apart, and returns the largest attraction on the way \[N\].
    fn pull(&mut self) -> f64 {
        let whole = self.overlap;
        let mut most = 0.0f64;
        for k in (1..PULLED).rev() {
            self.overlap = whole * k as f64 / PULLED as f64;
            most = most.max(-self.touch().force.x);
        }
        most
    }

    fn omega(&mut self) -> f64 {
        let springs: Vec<_> =
            self.chain.laws().map(|m| matches!(m.kind, Kind::Normal | Kind::Cohesion)).collect();
        let (types, x, mut stiffness) = (self.types(), self.contact(), 0.0f64);
        self.chain.observe_each(types, &x, &self.history, |k, t| {
            stiffness += if springs[k] { t.stiffness } else { 0.0 };
        });
        (stiffness.max(0.0) / self.load.partners.meff).sqrt()
    }
}
