//! What a law sees of a contact, and what it answers. SI units.
use super::ContactFlag;
use crate::lane::{cross, dot, zero, Lane};
use nalgebra::Vector3;

/// The circumstances of one evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Call {
    /// Time step \[s\].
    pub dt: f64,
    /// Number of the step.
    pub step: i64,
    /// Whether history may be written (LIGGGHTS: `computeflag && shearupdate`).
    pub update: bool,
    /// Whether what begins, lasts or ends in it is counted: not in queries, and only by one of the ranks that see it.
    pub counts: bool,
    /// Whether j is a wall.
    pub is_wall: bool,
}

/// One partner of a contact. A wall has radius 0, mass 0, no spin and a negative tag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The particle's number, the same on every rank.
    pub tag: i64,
    /// Radius \[m\].
    pub radius: f64,
    /// Its own mass \[kg\].
    pub mass: f64,
    /// Whether it is held in place, so that contacts find it infinitely heavy.
    pub frozen: bool,
    /// Position \[m\]; of a wall, the contact point.
    pub x: Vector3<f64>,
    /// Velocity \[m/s\].
    pub v: Vector3<f64>,
    /// Spin \[rad/s\].
    pub omega: Vector3<f64>,
    /// What the deck gives each atom, by [`AtomProp::place`](super::AtomProp::place); −∞ where it gives nothing.
    pub given: [f64; ATOM_PROPS],
}

/// How many properties of single atoms there are room for.
pub const ATOM_PROPS: usize = 1;

/// How many numbers laws may add to single atoms.
pub const ATOM_OUTPUTS: usize = 1;

impl Body {
    /// The mass that a contact finds \[kg\]: infinite for a particle that is held in place.
    pub fn felt_mass(&self) -> f64 {
        if self.frozen {
            f64::INFINITY
        } else {
            self.mass
        }
    }
}

impl Default for Body {
    fn default() -> Body {
        let given = [f64::NEG_INFINITY; ATOM_PROPS];
        Body { tag: 0, radius: 0.0, mass: 0.0, frozen: false, x: zero(), v: zero(), omega: zero(), given }
    }
}

/// Two bodies near each other, whether or not they touch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClosePair {
    /// The circumstances.
    pub call: Call,
    /// The particle that the force is reported for.
    pub i: Body,
    /// Its partner.
    pub j: Body,
    /// From j to i \[m\]; from the wall's contact point to i.
    pub delta: Vector3<f64>,
    /// `|delta|²` \[m²\].
    pub rsq: f64,
    /// Effective mass m* \[kg\]; a frozen partner or a wall counts as infinitely heavy.
    pub meff: f64,
}

impl ClosePair {
    /// The same with the effective mass of its bodies, as LIGGGHTS takes it.
    pub fn weighed(self) -> ClosePair {
        let (i, j) = (self.i.mass, self.j.mass);
        let meff = match () {
            _ if self.call.is_wall || self.j.frozen => self.i.felt_mass(),
            _ if self.i.frozen => j,
            _ => i * j / (i + j),
        };
        ClosePair { meff, ..self }
    }

    /// The sizes and masses.
    pub fn size(&self) -> Size {
        let ClosePair { call, i, j, meff, .. } = self;
        let (radi, radj, massi, massj) = (i.radius, j.radius, i.mass, j.mass);
        Size { radi, radj, massi, massj, frozen: [i.frozen, j.frozen], meff: *meff, is_wall: call.is_wall }
    }
}

/// What the surface model makes of two overlapping spheres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<L = f64> {
    /// Distance of the centres, or of the centre of i from a wall \[m\].
    pub r: L,
    /// Overlap δ \[m\], not negative.
    pub deltan: L,
    /// Normal relative velocity \[m/s\], negative while approaching.
    pub vn: L,
    /// Unit normal, from j to i.
    pub en: Vector3<L>,
    /// Tangential relative velocity at the contact \[m/s\].
    pub vtr: Vector3<L>,
    /// What rolls \[rad/s\]: ω_i − ω_j of a pair; of a wall, LIGGGHTS's `wr`, which is ω_i times (R − δ/2)/r.
    pub roll: Vector3<L>,
    /// Distance from the centre of i to the contact \[m\].
    pub cri: L,
    /// Distance from the centre of j to the contact \[m\]; 0 for a wall.
    pub crj: L,
}

impl<L: Lane> Default for Surface<L> {
    #[inline(always)]
    fn default() -> Surface<L> {
        let o = L::splat(0.0);
        Surface { r: o, deltan: o, vn: o, en: zero(), vtr: zero(), roll: zero(), cri: o, crj: o }
    }
}

impl<L: Lane> Surface<L> {
    /// Two spheres by LIGGGHTS's default surface model, with its operations in its order. `delta` leads from j to i
    /// \[m\], `rsq` is the square of its length, `v` is the velocity of i less that of j \[m/s\].
    #[inline(always)]
    pub fn between(
        delta: &Vector3<L>,
        rsq: L,
        radius: (L, L),
        v: &Vector3<L>,
        omega: (&Vector3<L>, &Vector3<L>),
    ) -> Surface<L> {
        let r = rsq.sqrt();
        let rinv = L::splat(1.0) / r;
        let deltan = radius.0 + radius.1 - r;
        let half = L::splat(0.5) * deltan;
        let (cri, crj) = (radius.0 - half, radius.1 - half);
        let spin = (omega.0 * cri + omega.1 * crj) * rinv;
        let roll = omega.0 - omega.1;
        Surface { r, deltan, cri, crj, roll, ..Surface::default() }.seen(delta, rinv, v, &spin)
    }

    /// A sphere on a wall by the same model. `delta` leads from the wall to i \[m\], `deltan` is the overlap that the wall
    /// found \[m\], `v` is the velocity of i less that of the wall \[m/s\], `omega` the spin of i \[rad/s\].
    #[inline(always)]
    pub fn at_wall(
        delta: &Vector3<L>,
        deltan: L,
        radius: L,
        v: &Vector3<L>,
        omega: &Vector3<L>,
    ) -> Surface<L> {
        let r = radius - deltan;
        let rinv = L::splat(1.0) / r;
        let cri = radius - L::splat(0.5) * deltan;
        let spin = omega * cri * rinv;
        Surface { r, deltan: radius - r, cri, roll: spin, ..Surface::default() }.seen(delta, rinv, v, &spin)
    }

    /// The motion of surfaces that turn with `spin` \[rad/s\].
    #[inline(always)]
    fn seen(mut self, delta: &Vector3<L>, rinv: L, v: &Vector3<L>, spin: &Vector3<L>) -> Surface<L> {
        self.en = delta * rinv;
        self.vn = dot(v, &self.en);
        self.vtr = (v - self.en * self.vn) - cross(spin, delta);
        self
    }
}

/// Two bodies in contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// The bodies.
    pub close: ClosePair,
    /// Their surfaces.
    pub surface: Surface,
}

impl Contact {
    /// Two spheres, by [`Surface::between`].
    pub fn pair(gap: ClosePair) -> Contact {
        let (i, j) = (&gap.i, &gap.j);
        let surface =
            Surface::between(&gap.delta, gap.rsq, (i.radius, j.radius), &(i.v - j.v), (&i.omega, &j.omega));
        Contact { close: gap, surface }
    }

    /// A sphere on a wall, by [`Surface::at_wall`]; `deltan` is the overlap that the wall found \[m\].
    pub fn wall(gap: ClosePair, deltan: f64) -> Contact {
        let (i, j) = (&gap.i, &gap.j);
        let surface = Surface::at_wall(&gap.delta, deltan, i.radius, &(i.v - j.v), &i.omega);
        Contact { close: gap, surface }
    }
}

/// What sizes and masses are, which is all that a law may prepare from before it sees the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Radius of i \[m\].
    pub radi: f64,
    /// Radius of j \[m\]; ignored for a wall.
    pub radj: f64,
    /// Own mass of i \[kg\].
    pub massi: f64,
    /// Own mass of j \[kg\]; ignored for a wall.
    pub massj: f64,
    /// Whether i and j are held in place.
    pub frozen: [bool; 2],
    /// Effective mass m* \[kg\].
    pub meff: f64,
    /// Whether j is a wall.
    pub is_wall: bool,
}

impl Size {
    /// Effective radius R* \[m\]; a wall is flat.
    pub fn reff(&self) -> f64 {
        if self.is_wall {
            self.radi
        } else {
            self.radi * self.radj / (self.radi + self.radj)
        }
    }

    /// How easily i and j turn \[1/(kg m²)\]: one over 2/5 m R² of a solid sphere; 0 for a wall and for what is held.
    pub fn mobilities(&self) -> (f64, f64) {
        let of = |held: bool, mass: f64, radius: f64| {
            if held {
                0.0
            } else {
                1.0 / (0.4 * mass * radius * radius)
            }
        };
        let [i, j] = self.frozen;
        (of(i, self.massi, self.radi), of(j || self.is_wall, self.massj, self.radj))
    }
}

/// A degree of freedom as a linear oscillator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mode {
    /// Stiffness \[N/m\].
    pub stiffness: f64,
    /// Damping \[N s/m\].
    pub damping: f64,
    /// Mass \[kg\].
    pub mass: f64,
}

/// One mode of two bodies under a law that acts whether or not surfaces overlap, at its largest stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedMode {
    /// Which, a fixed word of the law.
    pub name: &'static str,
    /// Whether the bodies rotate about each other: then stiffness is in N m/rad and mass in kg m².
    pub rotational: bool,
    /// The oscillator.
    pub mode: Mode,
}

/// What becomes of a bond that a law keeps between two bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BondEvent {
    /// There is none.
    #[default]
    None,
    /// It begins in this evaluation.
    Begins,
    /// It was there before and remains.
    Lasts,
    /// It ends in this evaluation.
    Ends,
}

/// What is handed along the chain: each law reads what the ones before it left, and adds its share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<L = f64> {
    /// Normal force \[N\], positive when it pushes apart.
    pub fn_: L,
    /// Normal stiffness kn \[N/m\].
    pub kn: L,
    /// Tangential stiffness kt \[N/m\].
    pub kt: L,
    /// Normal damping γn \[N s/m\].
    pub gamman: L,
    /// Tangential damping γt \[N s/m\].
    pub gammat: L,
    /// See [`Channel::Kc`](super::Channel::Kc).
    pub kc: L,
    /// See [`Channel::Fo`](super::Channel::Fo).
    pub fo: L,
    /// Force on i so far \[N\]; j gets the opposite.
    pub force: Vector3<L>,
    /// Torque on i so far \[N m\].
    pub torque_i: Vector3<L>,
    /// Torque on j so far \[N m\].
    pub torque_j: Vector3<L>,
}

impl<L: Lane> Default for Response<L> {
    #[inline(always)]
    fn default() -> Response<L> {
        let o = L::splat(0.0);
        let (force, torque_i, torque_j) = (zero(), zero(), zero());
        let (fn_, kn, kt, gamman, gammat, kc, fo) = (o, o, o, o, o, o, o);
        Response { fn_, kn, kt, gamman, gammat, kc, fo, force, torque_i, torque_j }
    }
}

/// What a law does besides forces and history.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effects {
    /// What it does to the contact flag.
    pub contact_flag: ContactFlag,
    /// What becomes of its bond.
    pub bond_event: BondEvent,
    /// Whether there is a force although surfaces do not overlap.
    pub acts: bool,
    /// Whether force and torques stand in place of those that LIGGGHTS's laws before this chain gave.
    pub replaces: bool,
    /// What the laws of a chain give to i and to j, by [`AtomProp::place`](super::AtomProp::place); each adds to it.
    pub outputs: [[f64; ATOM_OUTPUTS]; 2],
}

impl Effects {
    /// Force on i and torques on both in place of whatever the laws before gave; the laws that follow add to them.
    pub fn replace(
        &mut self,
        s: &mut Response,
        force: Vector3<f64>,
        torque_i: Vector3<f64>,
        torque_j: Vector3<f64>,
    ) {
        (s.force, s.torque_i, s.torque_j) = (force, torque_i, torque_j);
        (self.acts, self.replaces) = (true, true);
    }
}

/// What a law can tell a study about one contact, so that no study describes a law a second time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Observation {
    /// The branch that holds, a fixed word of the law.
    pub branch: &'static str,
    /// Tangent stiffness of the degree of freedom that the law acts on \[N/m\]; \[N m/rad\] for a rolling law.
    pub stiffness: f64,
    /// Its damping \[N s/m\] or \[N m s/rad\].
    pub damping: f64,
    /// Energy that the law could give back \[J\].
    pub stored: f64,
    /// Power that it takes out of the motion now \[W\].
    pub dissipated: f64,
    /// How far the law's own limit is used, for instance δmax/δlim or the stress of a bond over its strength; 0 where
    /// it has none.
    pub load: f64,
}
