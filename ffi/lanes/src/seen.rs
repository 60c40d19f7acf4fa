//! What fits depend on, as it was at the last pass: as long as nothing of it changes, fits are kept.
use crate::arrays::Particles;
use granlaw::law::Size;

/// Copies of the arrays that fits depend on.
#[derive(Default)]
pub(crate) struct Seen {
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
    pub fn look(&mut self, p: &Particles<'_>, types: usize) -> News {
        let same = bits(&self.radius) == bits(p.radius)
            && bits(&self.mass) == bits(p.mass)
            && bits(&self.rigid) == bits(p.rigid)
            && self.kind == p.kind
            && self.mask == p.mask
            && self.frozen == p.frozen;
        if same {
            return News { changed: false, strange: false };
        }
        renew(&mut self.radius, p.radius);
        renew(&mut self.mass, p.mass);
        renew(&mut self.rigid, p.rigid);
        renew(&mut self.kind, p.kind);
        renew(&mut self.mask, p.mask);
        self.frozen = p.frozen;
        let strange = p.kind.iter().any(|t| *t < 1 || *t as usize > types);
        News { changed: true, strange }
    }

    /// The one size and the one atom type, from 0, where all particles are alike.
    pub fn alike(&self) -> Option<(Size, usize)> {
        let (r, m, t) = (*self.radius.first()?, *self.mass.first()?, *self.kind.first()?);
        let alike = self.rigid.is_empty()
            && self.radius.iter().all(|x| *x == r)
            && self.mass.iter().all(|x| *x == m)
            && self.kind.iter().all(|x| *x == t)
            && self.mask.iter().all(|x| x & self.frozen == 0);
        let size = Size { radi: r, radj: r, massi: m, massj: m, meff: m * m / (m + m), is_wall: false };
        (alike && size.meff.is_finite()).then_some((size, t as usize - 1))
    }

    pub fn bytes(&self) -> usize {
        8 * (self.radius.capacity() + self.mass.capacity() + self.rigid.capacity())
            + 4 * (self.kind.capacity() + self.mask.capacity())
    }
}

/// Compared as bits this is one quick sweep, and NaN is no news every time.
fn bits(x: &[f64]) -> &[u64] {
    bytemuck::cast_slice(x)
}

fn renew<T: Copy>(old: &mut Vec<T>, new: &[T]) {
    old.clear();
    old.extend_from_slice(new);
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
    let heavy = |k: usize, m: f64| if held(k) { f64::INFINITY } else { m };
    let (massi, massj) = (heavy(i, mi), heavy(j, mj));
    Size { radi: p.radius[i], radj: p.radius[j], massi, massj, meff, is_wall: false }
}
