//! Loads of a probe, held once more: a contact is pressed, sheared, rolled and pulled by hand until it bears what it bore.
//!
//! Nothing moves by itself here. What a lasting contact does with its neighbours cannot be known from it alone, but what
//! it can bear, and how far it gives, can.
use crate::probe::Pressed;
use granlaw::chain::Chain;
use granlaw::law::{Body, Call, Contact, Gap, Kind, Stage, Surface};
use nalgebra::Vector3;

/// The first overlap that is tried, relative to what a spring of the largest stiffness of the run would need; and the
/// largest.
const FIRST: f64 = 0.01;
const DEEPEST: f64 = 100.0;
/// The overlap under a load is found to this part of itself.
const NEAR: f64 = 1e-3;
/// Shear per step, relative to the overlap, and the steps after which a contact that still slides bears nothing.
const SHEAR: f64 = 0.002;
const SHEARED: usize = 4000;
/// Steps of rolling, and those in which a contact is pulled apart.
const ROLLED: usize = 20;
const PULLED: usize = 1000;

/// What a contact bears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Overlap under the mean load, once the contact bore its largest \[m\]; infinite if no overlap that was tried does.
    pub overlap: f64,
    /// Tangential force that it still bears at rest, over the normal load, once it was sheared until it bore what it bore
    /// in the run.
    pub shear: f64,
    /// Torque against rolling and against torsion, over normal load times R*.
    pub torque: [f64; 2],
    /// Attraction that it bears while it is pulled apart, over the normal load; no more than there was in the run.
    pub tension: f64,
    /// Circular frequency of the normal spring under the largest load \[rad/s\].
    pub omega: f64,
}

/// Presses, shears, rolls and pulls. `dt` \[s\] is the step by which histories grow; as forces are told at rest, it does
/// not matter which.
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

/// A contact with its history, moved by hand.
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
        let gap = Gap { call, i, j, delta, rsq: delta.norm_squared(), meff: p.meff };
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
        Contact { gap, surface }
    }

    fn touch(&mut self) -> Stage {
        let mut s = Stage::default();
        let (types, x) = (self.types(), self.contact());
        self.chain.touch(types, &x, &mut self.history, &mut s);
        s
    }

    /// Presses from nothing until the contact repels with a force \[N\]. The result is whether it does.
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

    /// Withdraws until the contact repels with no more than a force \[N\].
    fn ease(&mut self, wanted: f64) {
        let mut step = 0.1 * self.overlap;
        while step > NEAR * NEAR * self.overlap {
            if self.touch().force.x <= wanted {
                return;
            }
            // Surfaces that have parted may have no force at all, which is too far as well.
            if self.tried(-step, |push| push.is_nan() || push < wanted) {
                step *= 0.5;
            }
        }
    }

    /// Changes the overlap, unless that goes too far: then everything is as before, and the result is true.
    fn tried(&mut self, by: f64, too_far: impl Fn(f64) -> bool) -> bool {
        let before = (self.overlap, self.history.clone());
        self.overlap += by;
        let over = too_far(self.touch().force.x);
        if over {
            (self.overlap, self.history) = before;
        }
        over
    }

    /// Slides until the contact bears a tangential force \[N\], rests, and tells what it still bears.
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

    /// Rolls about an axis, slowly and without slip, and tells the torque against it \[N m\].
    fn roll(&mut self, axis: Vector3<f64>) -> f64 {
        let still = self.touch();
        self.spin = axis * (SHEAR * self.overlap / self.dt / self.load.partners.reff());
        let turned = (0..ROLLED).map(|_| self.touch()).last().unwrap_or_default();
        self.spin = Vector3::zeros();
        (still.torque_i - turned.torque_i).dot(&axis)
    }

    /// Pulls the contact apart, and tells the largest attraction on the way \[N\].
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
