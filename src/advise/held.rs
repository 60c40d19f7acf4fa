//! Loads of a probe, held once more: a contact is pressed, sheared and rolled by hand until it bears what it bore.
//!
//! Nothing moves by itself here. What a lasting contact does with its neighbours cannot be known from it alone, but what
//! it can bear, and how far it gives, can.
use crate::chain::Chain;
use crate::law::{Body, Call, Contact, Gap, Kind, Stage, Surface};
use crate::probe::Pressed;
use nalgebra::Vector3;

/// Overlap is raised by this part of what a spring of the largest stiffness of the run would need.
const PRESS: f64 = 0.01;
/// Pressing ends at so many times that overlap.
const DEEPEST: usize = 40;
/// Shear per step, relative to the overlap, and the steps after which a contact that still slides bears nothing.
const SHEAR: f64 = 0.002;
const SHEARED: usize = 4000;
/// Steps of rolling.
const ROLLED: usize = 20;

/// What a contact bears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Overlap under the normal load \[m\]; infinite if no overlap that was tried bears it.
    pub overlap: f64,
    /// Tangential force that it still bears at rest, over the normal load, once it was sheared until it bore what it bore
    /// in the run.
    pub shear: f64,
    /// Torque against rolling and against torsion, over normal load times R*.
    pub torque: [f64; 2],
    /// Circular frequency of the normal spring under the load \[rad/s\].
    pub omega: f64,
}

/// Presses, shears and rolls. `dt` \[s\] is the step by which histories grow; as forces are told at rest, it does not
/// matter which.
pub fn hold(chain: &mut Chain, load: &Pressed, dt: f64) -> Held {
    let mut rig = Rig::new(chain, load, dt);
    let mut held = Held { overlap: f64::INFINITY, ..Held::default() };
    let step = PRESS * load.normal / load.kn;
    let deep = (1..DEEPEST * (1.0 / PRESS) as usize).find(|k| {
        rig.overlap = *k as f64 * step;
        rig.touch().fn_ >= load.normal
    });
    if deep.is_none() {
        return held;
    }
    held.overlap = rig.overlap;
    held.omega = rig.omega();
    held.shear = rig.shear(load.tangential) / load.normal;
    let lever = load.normal * load.partners.reff();
    held.torque = [Vector3::z(), Vector3::x()].map(|axis| rig.roll(axis) / lever);
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
