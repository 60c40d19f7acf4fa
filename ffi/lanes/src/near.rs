//! The neighbours that can touch before anything has gone far: between two selections no others are looked at.
use crate::arrays::Particles;
use crate::list::List;
use crate::unit::Unit;

/// Passes that a selection must serve to pay for itself.
const PRICE: u32 = 3;

/// The part of the skin within which neighbours are selected. A wider one lasts longer and holds more; for lists that live
/// for some 10 to 1000 steps an eighth is close to the best.
const PART: f64 = 0.125;

/// A selection from the list, or all of it where that is as good.
pub(crate) struct Near {
    /// Particles i and j, and their number in the list, in the order of the list.
    pub pairs: Vec<[u32; 3]>,
    /// Where the particles were when they were selected \[m\].
    x: Vec<[f64; 3]>,
    /// The square of the way by which two may have come closer since \[m²\]; infinite where nothing was left out.
    limit: f64,
    /// Passes that have not yet gone into the price of a selection; no more are kept than two cost.
    saved: u32,
}

impl Near {
    pub fn new() -> Near {
        Near { pairs: Vec::new(), x: Vec::new(), limit: f64::INFINITY, saved: PRICE }
    }

    /// One more pass; whether two particles can have come so much closer that others than those selected touch. What all
    /// do together does not count: along each axis the way of the first less that of the last is the most by which two can
    /// have come closer.
    #[inline(always)]
    pub fn outrun<L: Unit>(&mut self, x: &[[f64; 3]]) -> bool {
        self.saved = (self.saved + 1).min(2 * PRICE);
        if self.limit == f64::INFINITY {
            return false;
        }
        if x.len() != self.x.len() {
            return true;
        }
        let (now, then) = (x.as_flattened(), self.x.as_flattened());
        // Three registers hold whole particles.
        let (mut least, mut most) = ([L::splat(f64::INFINITY); 3], [L::splat(-f64::INFINITY); 3]);
        let mut k = 0;
        while k + 3 * L::WIDTH <= now.len() {
            for r in 0..3 {
                // SAFETY: both arrays reach beyond what is read here.
                let way = unsafe {
                    let at = k + r * L::WIDTH;
                    L::load(now.as_ptr().add(at)) - L::load(then.as_ptr().add(at))
                };
                (least[r], most[r]) = (smaller(least[r], way), larger(most[r], way));
            }
            k += 3 * L::WIDTH;
        }
        let mut ways = [[f64::INFINITY, -f64::INFINITY]; 3];
        let mut take = |k: usize, [a, b]: [f64; 2]| {
            ways[k % 3] = [smaller(ways[k % 3][0], a), larger(ways[k % 3][1], b)]
        };
        for k in 0..3 * L::WIDTH {
            take(k, [least[k / L::WIDTH].lane(k % L::WIDTH), most[k / L::WIDTH].lane(k % L::WIDTH)]);
        }
        for k in k..now.len() {
            take(k, [now[k] - then[k]; 2]);
        }
        let apart = ways.map(|[a, b]| b - a);
        apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2] > self.limit
    }

    /// No neighbour is known, nor is a selection due.
    pub fn forget(&mut self) {
        self.pairs.clear();
        self.limit = f64::INFINITY;
    }

    /// Begin a selection of neighbours whose surfaces are up to some distance apart: the answer \[m\]. `None` where it
    /// would not pay, or a particle is nowhere; then all of the list is taken up.
    pub fn begin(&mut self, list: &List, p: &Particles<'_>, skin: f64) -> Option<f64> {
        let largest = p.radius.iter().fold(0.0, |a: f64, b| a.max(*b));
        let somewhere = || p.x.as_flattened().iter().all(|x| x.is_finite());
        // In a much thinner skin rounding would count.
        if self.saved < PRICE || skin.is_nan() || skin <= 1e-9 * largest || !somewhere() {
            self.all(list);
            return None;
        }
        self.saved -= PRICE;
        self.pairs.clear();
        self.x.clear();
        self.x.extend_from_slice(p.x);
        let apart = PART * skin;
        // Less what rounding might do.
        self.limit = (0.999 * apart) * (0.999 * apart);
        Some(apart)
    }

    /// Neighbour `slot` of the list belongs to the selection.
    #[inline(always)]
    pub fn add(&mut self, list: &List, slot: u32) {
        let [i, j] = list.pairs[slot as usize];
        self.pairs.push([i, j, slot]);
    }

    /// The selection is complete; nearly all is as much as all, which need not be selected again.
    pub fn end(&mut self, list: &List) {
        if 4 * self.pairs.len() > 3 * list.pairs.len() {
            self.all(list);
        }
    }

    fn all(&mut self, list: &List) {
        self.pairs.clear();
        self.pairs.extend(list.pairs.iter().zip(0..).map(|([i, j], slot)| [*i, *j, slot]));
        self.limit = f64::INFINITY;
    }

    /// Bytes in use.
    pub fn bytes(&self) -> usize {
        12 * self.pairs.capacity() + 24 * self.x.capacity()
    }
}

/// The smaller one; the first where the other is NaN: what is nowhere touches nothing.
#[inline(always)]
fn smaller<L: Unit>(a: L, b: L) -> L {
    L::select(a.gt(b), b, a)
}

/// The larger one, likewise.
#[inline(always)]
fn larger<L: Unit>(a: L, b: L) -> L {
    L::select(b.gt(a), b, a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use granlaw::lane::Pack;

    /// A selection among particles at rest whose surfaces may come closer by 1.
    fn chosen(n: usize) -> Near {
        Near { x: vec![[7.0; 3]; n], limit: 1.0, ..Near::new() }
    }

    fn outrun(n: usize, moved: &[(usize, [f64; 3])]) -> bool {
        let mut x = vec![[7.0; 3]; n];
        moved.iter().for_each(|(k, by)| (0..3).for_each(|c| x[*k][c] += by[c]));
        let [one, four, eight] =
            [chosen(n).outrun::<f64>(&x), chosen(n).outrun::<Pack<4>>(&x), chosen(n).outrun::<Pack<8>>(&x)];
        assert_eq!([one, one], [four, eight]);
        one
    }

    #[test]
    fn two_that_could_meet_end_a_selection_wherever_they_stand() {
        for n in [2, 5, 8, 23] {
            for k in 0..n {
                let other = (k + 1) % n;
                for c in 0..3 {
                    let way = |w: f64| std::array::from_fn(|d| if c == d { w } else { 0.0 });
                    assert!(!outrun(n, &[(k, way(0.49)), (other, way(-0.49))]), "{k} of {n}, axis {c}");
                    assert!(outrun(n, &[(k, way(0.51)), (other, way(-0.51))]), "{k} of {n}, axis {c}");
                }
                assert!(outrun(n, &[(k, [0.6, 0.6, 0.6])]) && !outrun(n, &[(k, [0.5, 0.5, 0.5])]));
            }
        }
    }

    #[test]
    fn what_all_do_together_does_not_count() {
        let all: Vec<_> = (0..9).map(|k| (k, [3.0, -4.0, 5.0])).collect();
        assert!(!outrun(9, &all));
    }

    #[test]
    fn other_particles_end_a_selection_and_one_that_is_nowhere_does_not() {
        assert!(chosen(4).outrun::<f64>(&[[7.0; 3]; 5]));
        assert!(!outrun(9, &[(4, [f64::NAN; 3])]));
        assert!(outrun(9, &[(4, [f64::NAN; 3]), (5, [2.0, 0.0, 0.0])]));
    }
}
