//! A bond between two spheres, or a sphere and a wall, that carries tension, compression, shear, twist and bending.
//!
//! It acts across a gap, remembers damage (loading, unloading and reloading follow different lines), and breaks at a
//! distance or at a stress. While it holds, its force and torque stand in place of those of the normal law.
//!
//! | symbol | unit | |
//! |---|---|---|
//! | r, r0, δ = r0 − r | m | distance, distance when the bond began, overlap (positive: compression) |
//! | n, D | 1, m | unit normal and vector from j (or from the anchor on a wall) to i |
//! | λ, r_b, A, J, I | 1, m, m², m⁴, m⁴ | radius multiplier, bond radius, area, polar and bending moment of area |
//! | k, ku, kc | see below | stiffness of first loading, of unloading and reloading, of the line through zero |
//! | θn, θt | rad | twist about n; bending, a vector in the tangent plane |
//! | η | 1 | damping ratios: normal, shear, twist, bend |
//!
//! Equation numbers are those of the formula sheet for `cohesion_model_bond_nonlinear.h` (Open DEM Japan, 2025):
//! - (1) δ, (2) `r_b = λ min(Ri, Rj)`, on a wall `λ Ri`, (3) `A = π r_b²`, `J = A r_b²/2`, `I = J/2`: here
//! - (4)–(6) normal force: [`normal`]; (7), (8) shear: [`documented`]; (9) twist: [`twist`]; (10) bending: [`bend`]
//! - (11), (12) damping: [`damping`]; (13) reaction: [`documented`]; (14), (15) failure: [`failure`]
//!
//! Stiffnesses are per area: `k1` family \[N/m^2.5\] (compression, √δ), `k2` family and `kt` \[N/m³\], twist and bend
//! \[N/m³\], to be multiplied by J or I and an angle.
//!
//! `bondConvention` must be chosen. `documented` is the sheet, corrected where it contradicts mechanics. `upstream`
//! gives the numbers of the header in the fork LIGGGHTS-INL, with its faults; see [`upstream`].
//!
//! Departures of `documented` from the sheet:
//! - (7) as printed shears a pair that turns as a rigid body; the spins enter with the sign `−(r_ci ω_i + r_cj ω_j) × n`.
//! - (13) as printed, `T_j = −T_i`, loses the orbital couple; the torque on j is `r_cj F_t×n − T_n − T_t`.
//! - F_t and θ_t turn with the bond (the sheet projects), twist is a scalar, and the visited region of bending is a disc,
//!   as extremes per component would depend on the axes.
//! - Twist and bending are linear in the angle in both senses; a √ on one side would make twist chiral.
//! - sgn of a vector is its direction, not the signs of its components.
//!
//! Limits: sgn damping chatters at rest with |v| ≈ ½ η g Δt; √δ has infinite stiffness at δ = 0; branch switches pump
//! energy in resonance bands, so take 0.1 of the stable step undamped, 0.5 with η ≥ 0.1. With
//! `ratioTensionCompressionBond on` the strength jumps at δ = 0. A wall bond must not cross a periodic boundary.
//! A bond that turns by a right angle or more in one step breaks (`documented`), as how it turned cannot be told.
mod bend;
mod coeffs;
mod creation;
mod damping;
mod documented;
mod failure;
mod loads;
mod modes;
mod normal;
mod props;
mod twist;
mod upstream;

use crate::model::*;
use coeffs::Coeffs;
use std::f64::consts::PI;

/// The law.
pub struct BondNonlinear;

/// What two sizes decide.
#[derive(Clone, Copy, Debug)]
pub struct Params {
    c: Coeffs,
    /// r_b \[m\].
    radius: f64,
    /// A \[m²\].
    area: f64,
    /// J \[m⁴\].
    polar: f64,
    /// I \[m⁴\].
    bending: f64,
    /// Lever arms over r: Ri/(Ri+Rj) and Rj/(Ri+Rj); 1 and 0 at a wall.
    arms: [f64; 2],
}

impl GapLaw for BondNonlinear {
    const META: Meta = Meta {
        props: props::PROPS,
        settings: props::SETTINGS,
        atoms: props::ATOMS,
        slots: props::SLOTS,
        reach: Reach::Beyond,
        anchors: true,
        bonds: Some("bonds"),
        references: &[
            "Open DEM Japan, formula sheet for cohesion_model_bond_nonlinear.h, 29 June 2025",
            "LIGGGHTS-INL, cohesion bond/nonlinear (Y. Xia, Y. Guo, Q. Chen): bondConvention upstream",
            "D.O. Potyondy, P.A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329",
        ],
        exceptions: &[
            Exception {
                rule: Rule::ApartClearsHistory,
                why: "a bond holds across a gap; it clears its history when it breaks",
            },
            Exception {
                rule: Rule::QueryLeavesHistory,
                why: "under bondConvention upstream, as the header writes extremes in every evaluation",
            },
            Exception {
                rule: Rule::PartnersSwap,
                why: "under bondConvention upstream, as the header's angles turn with i and j and their extremes do not",
            },
            Exception {
                rule: Rule::AngularMomentum,
                why: "under bondConvention upstream, as damping per axis of the box takes the normal force off the normal",
            },
            Exception {
                rule: Rule::FrameTurns,
                why:
                    "under bondConvention upstream, as the header keeps angles and signs per axis of the box",
            },
            Exception {
                rule: Rule::UnitsScale,
                why: "under bondConvention upstream, as the header leaves the area out of compression",
            },
        ],
        ..Meta::new(
            Kind::Cohesion,
            "bond/nonlinear",
            "breakable bond with six-branch normal force, shear, twist and bending",
        )
    };
    const LIGGGHTS: Binding = Binding::new(63, None);
    type History = [f64];
    type Coeffs = Coeffs;
    type Params = Params;

    fn coeffs(p: &Pair<'_>) -> Result<Coeffs, LawError> {
        Coeffs::new(p)
    }

    fn reach(c: &Coeffs, is_wall: bool) -> f64 {
        c.reach(is_wall)
    }

    fn remarks(p: &Pair<'_>) -> Vec<String> {
        coeffs::remarks(p)
    }

    fn params(c: &Coeffs, size: &Size) -> Params {
        let Size { radi, radj, is_wall, .. } = *size;
        let radius = c.lambda * if is_wall { radi } else { radi.min(radj) }; // (2)
        let area = PI * radius * radius; // (3)
        let polar = 0.5 * area * radius * radius;
        let arms = if is_wall { [1.0, 0.0] } else { [radi / (radi + radj), radj / (radi + radj)] };
        Params { c: *c, radius, area, polar, bending: 0.5 * polar, arms }
    }

    fn interact(p: &Params, x: &ClosePair, h: &mut [f64], s: &mut Response, e: &mut Effects) {
        // λ = 0 stands for no bond between these types.
        if p.area == 0.0 {
            return;
        }
        if p.c.upstream {
            upstream::interact(p, x, Memory::view(h), s, e);
        } else {
            documented::interact(p, x, Memory::view(h), s, e);
        }
    }

    fn modes(p: &Params, size: &Size, speed: f64) -> Vec<NamedMode> {
        modes::of(p, size, speed)
    }

    fn observe(p: &Params, x: &ClosePair, h: &[f64]) -> Observation {
        if h[0] == 0.0 || p.c.upstream {
            return Observation {
                branch: if h[0] == 0.0 { "unbonded" } else { "bonded" },
                ..Observation::default()
            };
        }
        documented::observe(p, x, Memory::see(h))
    }
}

/// What a distance is compared as when a bond begins or breaks \[m\]: from centre to centre, at a wall as if it were a
/// particle of the same size.
fn apart(x: &ClosePair, r: f64) -> f64 {
    if x.call.is_wall {
        2.0 * r
    } else {
        r
    }
}

/// +1 or −1: vectors are stored as seen by the particle with the lower tag, so that nothing depends on which is i.
fn seen_from(x: &ClosePair) -> f64 {
    if x.call.is_wall || x.i.tag < x.j.tag {
        1.0
    } else {
        -1.0
    }
}

#[cfg(test)]
mod tests;
