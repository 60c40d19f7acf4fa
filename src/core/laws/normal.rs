//! What the normal laws share: switches, and what becomes of a spring and a dashpot.
use super::timing::{Onset, Timing};
use crate::lane::Lane;
use crate::model::{Call, Pair, Response, Surface};

/// The settings of all normal laws.
#[derive(Clone, Copy, Debug)]
pub struct Switches {
    tangential_damping: bool,
    limit_force: bool,
    timing: Timing,
}

/// A spring and a dashpot along the normal, and what they hand on.
#[derive(Clone, Copy, Debug)]
pub struct Normal<L> {
    /// Force of the spring \[N\].
    pub spring: L,
    /// Stiffnesses kn, kt \[N/m\].
    pub stiffness: (L, L),
    /// Dampings γn, γt \[N s/m\].
    pub damping: (L, L),
    /// Effective mass m* \[kg\].
    pub meff: L,
    /// How the dashpot begins.
    pub onset: Onset,
}

impl Switches {
    /// As the deck has them.
    pub fn new(p: &Pair<'_>) -> Switches {
        Switches {
            tangential_damping: p.on("tangential_damping"),
            limit_force: p.on("limitForce"),
            timing: Timing::new(p),
        }
    }

    /// γt \[N s/m\]: what it would be, or 0 with `tangential_damping off`.
    #[inline(always)]
    pub fn tangential<L: Lane>(&self, gammat: impl FnOnce() -> L) -> L {
        if self.tangential_damping {
            gammat()
        } else {
            L::splat(0.0)
        }
    }

    /// Add the normal force, `Fn = spring − γn v_n`, to what is handed along; `limitForce on`: never below zero.
    #[inline(always)]
    pub fn push<L: Lane>(&self, n: &Normal<L>, call: &Call, x: &Surface<L>, s: &mut Response<L>) {
        let (gamman, zero) = (n.damping.0, L::splat(0.0));
        let mut now = n.spring + -gamman * x.vn;
        // What acts over the step, where that is not the force at its end.
        let mut acts = now;
        if self.timing.acts(call) {
            (now, acts) = self.timing.normal(call, x, n.meff, n.spring, gamman, n.onset);
        }
        if self.limit_force {
            let attracts = zero.gt(now);
            acts = L::select(attracts | zero.gt(acts), zero, acts);
            now = L::select(attracts, zero, now);
        }
        (s.fn_, (s.kn, s.kt), (s.gamman, s.gammat)) = (now, n.stiffness, n.damping);
        s.force += x.en * acts;
    }
}
