//! What fits depend on, as it was at the last pass: as long as nothing of it changes, fits are kept.
use crate::arrays::Particles;
use crate::unit::Unit;
use granlaw::model::Size;

/// The particles as fits know them.
#[derive(Default)]
pub(crate) struct Seen {
    /// The one size and atom type, from 0, where all are alike. Then nothing is copied.
    alike: Option<(Size, usize)>,
    /// How many there are.
    all: usize,
    radius: Vec<f64>,
    mass: Vec<f64>,
    rigid: Vec<f64>,
    kind: Vec<i32>,
    mask: Vec<i32>,
    frozen: i32,
}

/// What there is to know of the present particles.
pub(crate) struct News {
    /// Something is different from the last pass.
    pub changed: bool,
    /// An atom type is none of the chain's.
    pub strange: bool,
}

impl Seen {
    /// Compare with the last pass, and remember.
    pub fn look<L: Unit>(&mut self, p: &Particles<'_>, types: usize) -> News {
        let same = match &self.alike {
            Some((size, kind)) => L::run(
                #[inline(always)]
                || self.all == p.x.len() && are_all(p, size, *kind),
            ),
            None => self.are_these(p),
        };
        if same {
            return News { changed: false, strange: false };
        }
        self.all = p.x.len();
        self.alike = alike(p);
        self.frozen = p.frozen;
        let none = self.alike.is_some();
        renew(&mut self.radius, p.radius, none);
        renew(&mut self.mass, p.mass, none);
        renew(&mut self.rigid, p.rigid, none);
        renew(&mut self.kind, p.kind, none);
        renew(&mut self.mask, p.mask, none);
        let strange = p.kind.iter().any(|t| *t < 1 || *t as usize > types);
        News { changed: true, strange }
    }

    fn are_these(&self, p: &Particles<'_>) -> bool {
        bits(&self.radius) == bits(p.radius)
            && bits(&self.mass) == bits(p.mass)
            && bits(&self.rigid) == bits(p.rigid)
            && self.kind == p.kind
            && self.mask == p.mask
            && self.frozen == p.frozen
    }

    /// The one size and the one atom type, from 0, where all particles are alike.
    pub fn alike(&self) -> Option<(Size, usize)> {
        self.alike
    }

    pub fn bytes(&self) -> usize {
        8 * (self.radius.capacity() + self.mass.capacity() + self.rigid.capacity())
            + 4 * (self.kind.capacity() + self.mask.capacity())
    }
}

/// The size and atom type that all particles have.
fn alike(p: &Particles<'_>) -> Option<(Size, usize)> {
    let (r, m, t) = (*p.radius.first()?, *p.mass.first()?, *p.kind.first()?);
    let size = Size {
        radi: r,
        radj: r,
        massi: m,
        massj: m,
        frozen: [false; 2],
        meff: m * m / (m + m),
        is_wall: false,
    };
    let kind = usize::try_from(t - 1).ok()?;
    (size.meff.is_finite() && are_all(p, &size, kind)).then_some((size, kind))
}

/// Whether all particles have this size and atom type, and none is held or part of a body. One sweep without a branch.
#[inline(always)]
fn are_all(p: &Particles<'_>, size: &Size, kind: usize) -> bool {
    let (r, m, t) = (size.radi.to_bits(), size.massi.to_bits(), kind as i32 + 1);
    let (mut other, mut odd) = (0, 0);
    for k in 0..p.radius.len() {
        other |= p.radius[k].to_bits() ^ r;
    }
    for k in 0..p.mass.len() {
        other |= p.mass[k].to_bits() ^ m;
    }
    for k in 0..p.kind.len() {
        odd |= p.kind[k] ^ t;
    }
    for k in 0..p.mask.len() {
        odd |= p.mask[k] & p.frozen;
    }
    p.rigid.is_empty() && other == 0 && odd == 0
}

/// Compared as bits this is one quick sweep, and NaN is no news every time.
fn bits(x: &[f64]) -> &[u64] {
    bytemuck::cast_slice(x)
}

fn renew<T: Copy>(old: &mut Vec<T>, new: &[T], none: bool) {
    old.clear();
    old.extend_from_slice(if none { &[] } else { new });
}

/// Sizes of particles i and j as LIGGGHTS has them: the mass of a rigid body stands for that of its parts, and a partner
/// that is held is infinitely heavy.
pub(crate) fn size(p: &Particles<'_>, i: usize, j: usize) -> Size {
    let mass = |k: usize| match p.rigid.get(k) {
        Some(body) if *body > 0.0 => *body,
        _ => p.mass[k],
    };
    let held = |k: usize| p.mask[k] & p.frozen != 0;
    let (mi, mj) = (mass(i), mass(j));
    let meff = match (held(i), held(j)) {
        (_, true) => mi,
        (true, false) => mj,
        (false, false) => mi * mj / (mi + mj),
    };
    let frozen = [held(i), held(j)];
    Size { radi: p.radius[i], radj: p.radius[j], massi: mi, massj: mj, frozen, meff, is_wall: false }
}
