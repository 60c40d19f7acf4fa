//! Velocity Verlet in single precision: the same laws, written over lanes, with `f32` in each.
use super::matter::Matter;
use super::shot::{Outcome, Shot};
use granlaw::lane::dot;
use granlaw::law::{Body, Call, Kind, LaneLaw, Setup, Size, Stage, Surface};
use granlaw::laws::{hertz::Hertz, history::History, hooke::Hooke, hooke_hysteresis::HookeHysteresis};
use nalgebra::Vector3;

/// A law in single precision, with a common interface for laws whose coefficients have different types.
trait Kernel {
    fn touch(&mut self, call: &Call, x: &Surface<f32>, s: &mut Stage<f32>);
}

struct Prepared<W: LaneLaw> {
    fit: W::FitOf<f32>,
    history: W::HistoryOf<f32>,
}

impl<W: LaneLaw> Kernel for Prepared<W> {
    fn touch(&mut self, call: &Call, x: &Surface<f32>, s: &mut Stage<f32>) {
        W::touch_lanes(&self.fit, call, x, &mut self.history, s);
    }
}

fn prepare<W: LaneLaw>(setup: &Setup, size: &Size) -> Option<Box<dyn Kernel>>
where
    W::FitOf<f32>: 'static,
{
    let coeffs = W::coeffs(&setup.pair(0, 0)).ok()?;
    let fit = W::side_by_side::<f32>(|_| W::fit_at(&W::fit(&coeffs, size), 0.0));
    let zeros = vec![0.0f32; W::META.slots.len()];
    let history = W::HistoryOf::<f32>::try_from(&zeros[..]).ok()?;
    Some(Box::new(Prepared::<W> { fit, history }))
}

/// The laws of a chain; `None` if there is one that is not written over lanes.
fn kernels(matter: &Matter, size: &Size) -> Option<Vec<Box<dyn Kernel>>> {
    let one = |setup: &Setup| match (setup.meta.kind, setup.meta.keyword) {
        (Kind::Normal, "hooke") => prepare::<Hooke>(setup, size),
        (Kind::Normal, "hertz") => prepare::<Hertz>(setup, size),
        (Kind::Normal, "hooke/hysteresis") => prepare::<HookeHysteresis>(setup, size),
        (Kind::Tangential, "history") => prepare::<History>(setup, size),
        _ => None,
    };
    matter.setups().ok()?.iter().map(one).collect()
}

/// A sphere in single precision.
#[derive(Clone, Copy)]
struct Ball {
    radius: f32,
    mass: f32,
    x: Vector3<f32>,
    v: Vector3<f32>,
    omega: Vector3<f32>,
}

impl Ball {
    fn new(b: &Body) -> Ball {
        let narrow = |v: &Vector3<f64>| v.map(|c| c as f32);
        let (x, v, omega) = (narrow(&b.x), narrow(&b.v), narrow(&b.omega));
        Ball { radius: b.radius as f32, mass: b.mass as f32, x, v, omega }
    }

    fn wide(&self, b: &Body) -> Body {
        let wide = |v: &Vector3<f32>| v.map(f64::from);
        Body { x: wide(&self.x), v: wide(&self.v), omega: wide(&self.omega), ..*b }
    }

    fn kick(&mut self, half: f32, force: &Vector3<f32>, torque: &Vector3<f32>) {
        self.v += force * (half / self.mass);
        self.omega += torque * (half / 0.4 / (self.radius * self.radius * self.mass));
    }
}

/// Integrates two spheres in steps of `dt` \[s\], from `before` steps ahead of first touch; `None` for walls and for laws that are
/// not written over lanes.
pub fn impact(matter: &Matter, shot: &Shot, dt: f64, before: f64) -> Option<Outcome> {
    let start = shot.start(dt, before, 0);
    let [i, j] = start.bodies;
    let (radi, radj, massi, massj) = (i.radius, j.radius, i.mass, j.mass);
    let size = Size { radi, radj, massi, massj, meff: shot.meff(), is_wall: false };
    let mut kernels = kernels(matter, &size).filter(|_| !shot.wall && shot.rest.is_none())?;
    let mut balls = start.bodies.each_ref().map(Ball::new);
    let (call, half) = (Call { dt, step: 1, update: true, ..Call::default() }, (0.5 * dt) as f32);
    let (mut stage, mut seen) = (Stage::<f32>::default(), Outcome::default());
    for step in 1..100_000_000u64 {
        kick(&mut balls, &stage, half);
        balls.iter_mut().for_each(|b| b.x += b.v * dt as f32);
        stage = Stage::default();
        let time = (step as f64 - before) * dt;
        if let Some(surface) = surface(&balls) {
            kernels.iter_mut().for_each(|k| k.touch(&call, &surface, &mut stage));
            seen.peak = seen.peak.max(stage.fn_.into());
        } else if time > dt {
            (seen.duration, seen.parted) = (time, true);
        }
        kick(&mut balls, &stage, half);
        if seen.parted || !balls[0].x.x.is_finite() {
            break;
        }
    }
    let bodies = [balls[0].wide(&i), balls[1].wide(&j)];
    Some(Outcome { peak: seen.peak, duration: seen.duration, parted: seen.parted, ..shot.judge(&bodies) })
}

fn kick(balls: &mut [Ball; 2], stage: &Stage<f32>, half: f32) {
    balls[0].kick(half, &stage.force, &stage.torque_i);
    balls[1].kick(half, &-stage.force, &stage.torque_j);
}

/// The surface model for two overlapping spheres.
fn surface(balls: &[Ball; 2]) -> Option<Surface<f32>> {
    let [i, j] = balls;
    let delta = i.x - j.x;
    let r = dot(&delta, &delta).sqrt();
    let deltan = i.radius + j.radius - r;
    if deltan < 0.0 {
        return None;
    }
    let (en, v) = (delta / r, i.v - j.v);
    let (cri, crj) = (i.radius - 0.5 * deltan, j.radius - 0.5 * deltan);
    let vn = dot(&v, &en);
    let vtr = (v - en * vn) - ((i.omega * cri + j.omega * crj) / r).cross(&delta);
    Some(Surface { deltan, vn, en, vtr, roll: i.omega - j.omega, cri, crj })
}
