//! The stiffest modes that a contact of two bodies reaches, which limit the time step.
use super::collision::Collision;
use super::matter::Matter;
use granlaw::chain::Chain;
use granlaw::model::Mode;
use granlaw::model::{Call, ClosePair, Contact, Kind, Observation, Size, Surface};
use granlaw::pair::run_while;
use std::f64::consts::PI;

/// The stiffest modes that a contact reaches.
#[derive(Clone, Copy, Debug)]
pub struct Modes {
    /// Along the normal.
    pub normal: Mode,
    /// Along the surface, the turning of the spheres included; without stiffness if there is no shear spring.
    pub tangential: Mode,
    /// Half a period of the softest loading \[s\]: how long a contact lasts, to within a factor of two.
    pub period: f64,
}

/// Steps per half period of the first loading with which a contact is followed.
const FINE: f64 = 4000.0;

/// Moves the bodies under `chain` from first touch to last, and asks `observer`, of the same laws, for stiffnesses on the way. Of
/// bodies that rest on a wall only the first state counts.
pub fn reached(chain: &mut Chain, observer: &mut Chain, collision: &Collision) -> Modes {
    let meff = collision.meff();
    let (mut normal, mut tangential) =
        (Mode { mass: meff, ..Mode::default() }, Mode { mass: turning(collision), ..Mode::default() });
    let mut soft = f64::INFINITY;
    let first = loading(observer, collision);
    let dt = PI * (meff / first).sqrt() / FINE;
    let start = collision.start(dt, 0.0, if collision.rest.is_some() { 2 } else { 6 * FINE as u64 });
    let shear = chain.laws().find(|m| m.kind == Kind::Tangential).map(|m| !m.slots.is_empty());
    let kinds: Vec<Kind> = chain.laws().map(|m| m.kind).collect();
    let mut touched = false;
    run_while(chain, &start, |s| {
        if !s.touching {
            return !touched;
        }
        touched = true;
        let t = along_normal(&kinds, &observer.observe(collision.types, &s.contact, &s.history));
        if t.0 > normal.stiffness {
            (normal.stiffness, normal.damping) = t;
        }
        if t.0 > 0.0 {
            soft = soft.min(t.0);
        }
        let spring = if shear == Some(true) { s.response.kt } else { 0.0 };
        if shear.is_some() && spring >= tangential.stiffness {
            (tangential.stiffness, tangential.damping) = (spring, s.response.gammat.max(tangential.damping));
        }
        true
    });
    // A Hertz contact begins without stiffness; for its period the stiffness at some depth is used.
    let soft = soft.max(0.3 * normal.stiffness.min(first));
    Modes { normal, tangential, period: PI * (meff / soft).sqrt() }
}

/// Loading stiffness \[N/m\] at an overlap of a hundredth of the radius of i.
pub fn loading(chain: &mut Chain, collision: &Collision) -> f64 {
    let [i, j] = collision.bodies();
    let call = Call { is_wall: collision.wall, ..Call::default() };
    let gap = ClosePair { call, i, j, meff: collision.meff(), ..ClosePair::default() };
    let surface = Surface { deltan: 0.01 * collision.radius, ..Surface::default() };
    let row = vec![0.0; chain.row()];
    let kinds: Vec<Kind> = chain.laws().map(|m| m.kind).collect();
    along_normal(&kinds, &chain.observe(collision.types, &Contact { close: gap, surface }, &row)).0
}

/// The same for laws and numbers that are known to be sound \[N/m\].
///
/// # Panics
/// If a law refuses them.
pub fn stiffness(matter: &Matter, collision: &Collision) -> f64 {
    loading(&mut matter.chain().expect("a sound case"), collision)
}

/// Stiffness \[N/m\] and damping \[N s/m\] along the normal, of all laws that act there.
fn along_normal(kinds: &[Kind], terms: &[Observation]) -> (f64, f64) {
    let normal = kinds.iter().zip(terms).filter(|(k, _)| matches!(k, Kind::Normal | Kind::Cohesion));
    normal.fold((0.0, 0.0), |(k, g), (_, t)| (k + t.stiffness, g + t.damping))
}

/// The mass that a force along the surface moves \[kg\].
fn turning(collision: &Collision) -> f64 {
    let [i, j] = collision.bodies();
    let (radi, radj, massi, massj) = (i.radius, j.radius, i.mass, j.mass);
    let size = Size {
        radi,
        radj,
        massi,
        massj,
        frozen: [false; 2],
        meff: collision.meff(),
        is_wall: collision.wall,
    };
    let (ti, tj) = size.mobilities();
    1.0 / (1.0 / size.meff + radi * radi * ti + radj * radj * tj)
}
