//! Velocity Verlet in single precision: the same laws, written over lanes, with `f32` in each.
use super::collision::{Collision, Outcome};
use super::matter::Matter;
use granlaw::lane::{dot, Lanes};
use granlaw::laws::made;
use granlaw::model::{Body, Call, ForLanes, Law, Parameters, Response, Setup, Size, Slots, Surface};
use nalgebra::Vector3;

/// A law in single precision, with a common interface for laws whose coefficients have different types.
trait Kernel {
    fn surfaces_intersect(&mut self, call: &Call, x: &Surface<f32>, s: &mut Response<f32>);
}

struct Prepared<W: Law> {
    params: <W::Params as Lanes>::Of<f32>,
    history: <W::History as Lanes>::Of<f32>,
}

impl<W: Law> Kernel for Prepared<W> {
    fn surfaces_intersect(&mut self, call: &Call, x: &Surface<f32>, s: &mut Response<f32>) {
        W::intersect(&self.params, call, x, &mut self.history, s);
    }
}

/// Makes a kernel of every law over lanes.
#[derive(Clone, Copy, Debug)]
struct Single;

impl ForLanes for Single {
    type Made = fn(&Setup, &Size) -> Option<Box<dyn Kernel>>;
    fn make<W: Law>() -> Self::Made {
        |setup, size| {
            let params = W::Params::new(&W::Params::coeffs(&setup.pair(0, 0)).ok()?, size);
            let params = W::Params::side_by_side::<f32>(|_| params);
            Some(Box::new(Prepared::<W> { params, history: W::History::zero::<f32>() }))
        }
    }
}

/// The laws of a chain; `None` if there is one that is not written over lanes.
fn kernels(matter: &Matter, size: &Size) -> Option<Vec<Box<dyn Kernel>>> {
    let one = |setup: &Setup| made::<Single>(setup)?(setup, size);
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
pub fn impact(matter: &Matter, collision: &Collision, dt: f64, before: f64) -> Option<Outcome> {
    let start = collision.start(dt, before, 0);
    let [i, j] = start.bodies;
    let (radi, radj, massi, massj) = (i.radius, j.radius, i.mass, j.mass);
    let size = Size { radi, radj, massi, massj, frozen: [false; 2], meff: collision.meff(), is_wall: false };
    let mut kernels = kernels(matter, &size).filter(|_| !collision.wall && collision.rest.is_none())?;
    let mut balls = start.bodies.each_ref().map(Ball::new);
    let (call, half) = (Call { dt, step: 1, update: true, ..Call::default() }, (0.5 * dt) as f32);
    let (mut response, mut seen) = (Response::<f32>::default(), Outcome::default());
    for step in 1..100_000_000u64 {
        kick(&mut balls, &response, half);
        balls.iter_mut().for_each(|b| b.x += b.v * dt as f32);
        response = Response::default();
        let time = (step as f64 - before) * dt;
        if let Some(surface) = surface(&balls) {
            kernels.iter_mut().for_each(|k| k.surfaces_intersect(&call, &surface, &mut response));
            seen.peak = seen.peak.max(response.fn_.into());
        } else if time > dt {
            (seen.duration, seen.parted) = (time, true);
        }
        kick(&mut balls, &response, half);
        if seen.parted || !balls[0].x.x.is_finite() {
            break;
        }
    }
    let bodies = [balls[0].wide(&i), balls[1].wide(&j)];
    Some(Outcome {
        peak: seen.peak,
        duration: seen.duration,
        parted: seen.parted,
        ..collision.judge(&bodies)
    })
}

fn kick(balls: &mut [Ball; 2], response: &Response<f32>, half: f32) {
    balls[0].kick(half, &response.force, &response.torque_i);
    balls[1].kick(half, &-response.force, &response.torque_j);
}

/// The surface model for two spheres, if they overlap.
fn surface([i, j]: &[Ball; 2]) -> Option<Surface<f32>> {
    let delta = i.x - j.x;
    let radii = (i.radius, j.radius);
    let surface = Surface::between(&delta, dot(&delta, &delta), radii, &(i.v - j.v), (&i.omega, &j.omega));
    (surface.deltan >= 0.0).then_some(surface)
}
