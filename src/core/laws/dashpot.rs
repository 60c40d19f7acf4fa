//! What the dashpot of a linear spring goes by: a coefficient of restitution, or the Stokes number of the impact.
use super::formulas::{effective_young, hooke_stiffness};
use super::normal::Switches;
use crate::lane::{Lane, Lanes};
use crate::model::{Pair, Size};
use std::f64::consts::PI;

/// What a pair of types decides. Either the restitution or the other three are given.
#[derive(Clone, Copy, Debug)]
pub struct Coeffs {
    log_e: f64,
    fluid: f64,
    log_e_max: f64,
    stokes_critical: f64,
    abs: bool,
}

impl Coeffs {
    /// As the deck has them.
    pub fn new(pair: &Pair<'_>) -> Coeffs {
        let viscous = pair.on("viscous");
        let given = |wanted: bool, name| if wanted { pair.get(name) } else { 1.0 };
        Coeffs {
            log_e: given(!viscous, "coefficientRestitution").ln(),
            fluid: given(viscous, "FluidViscosity"),
            log_e_max: given(viscous, "MaximumRestitution").ln(),
            stokes_critical: given(viscous, "CriticalStokes"),
            abs: pair.on("viscousAbs"),
        }
    }
}

/// What a pair of types decides of a linear spring and its dashpot.
#[derive(Clone, Copy, Debug)]
pub struct Linear {
    yeff: f64,
    vc: f64,
    dashpot: Coeffs,
    /// The settings of all normal laws.
    pub switches: Switches,
    /// Conversion from pressure to force per area in the deck's units; 1 in SI.
    pub nktv2p: f64,
}

impl Linear {
    /// As the deck has them.
    pub fn new(p: &Pair<'_>) -> Linear {
        Linear {
            yeff: effective_young(p),
            vc: p.get("characteristicVelocity"),
            dashpot: Coeffs::new(p),
            switches: Switches::new(p),
            nktv2p: p.nktv2p(),
        }
    }

    /// kn before it is converted, see [`hooke_stiffness`], and the dashpot that goes with it.
    pub fn between<D: Dashpot>(&self, size: &Size, damping: impl Fn(f64, f64, f64) -> f64) -> (f64, D) {
        let kn = hooke_stiffness(self.yeff, size.reff(), size.meff, self.vc);
        (kn, D::new(&self.dashpot, size, kn, damping))
    }
}

/// One of the two kinds. `damping` is the law's own: γ \[N s/m\] from m* \[kg\], kn \[N/m\] and ln e.
pub trait Dashpot: Lanes<Of<f64> = Self> + Send + 'static {
    /// For a spring `kn` \[N/m\] between two sizes.
    fn new(c: &Coeffs, size: &Size, kn: f64, damping: impl Fn(f64, f64, f64) -> f64) -> Self;
    /// γn \[N s/m\] at a normal velocity \[m/s\].
    fn gamma<L: Lane>(d: &Self::Of<L>, vn: L, damping: impl Fn(L, L, L) -> L) -> L;
}

/// `viscous off`: γn is fixed.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Restitution<L = f64> {
    gamma: L,
}

impl Dashpot for Restitution {
    fn new(c: &Coeffs, size: &Size, kn: f64, damping: impl Fn(f64, f64, f64) -> f64) -> Restitution {
        Restitution { gamma: damping(size.meff, kn, c.log_e) }
    }
    #[inline(always)]
    fn gamma<L: Lane>(d: &Restitution<L>, _: L, _: impl Fn(L, L, L) -> L) -> L {
        d.gamma
    }
}

/// `viscous on`: `ln e = ln e_max + St_c/St` with `St = m* v_n/(6π μ_f R*²)` (Legendre et al. 2006, Schmeeckle et al. 2001).
/// Infinite at v_n = 0. St has the sign of v_n, as in LIGGGHTS, unless `viscousAbs on`.
#[derive(Clone, Copy, Debug, Lanes)]
pub struct Viscous<L = f64> {
    meff: L,
    kn: L,
    /// `6π μ_f R*²` \[N s\].
    drag: L,
    log_e_max: L,
    stokes_critical: L,
    abs: bool,
}

impl Dashpot for Viscous {
    fn new(c: &Coeffs, size: &Size, kn: f64, _: impl Fn(f64, f64, f64) -> f64) -> Viscous {
        let reff = size.reff();
        let Coeffs { fluid, log_e_max, stokes_critical, abs, .. } = *c;
        let drag = 6.0 * PI * fluid * reff * reff;
        Viscous { meff: size.meff, kn, drag, log_e_max, stokes_critical, abs }
    }
    #[inline(always)]
    fn gamma<L: Lane>(d: &Viscous<L>, vn: L, damping: impl Fn(L, L, L) -> L) -> L {
        let stokes = d.meff * vn / d.drag;
        let stokes = if d.abs { stokes.abs() } else { stokes };
        damping(d.meff, d.kn, d.log_e_max + d.stokes_critical / stokes)
    }
}
