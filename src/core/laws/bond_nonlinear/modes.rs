//! How fast a bond swings, by mode: what limits the time step.
//!
//! Each mode is taken on its stiffest branch, unloading, and with damping that sets on the wrong way: K → (1 + η) K. The bond is
//! as long as one can begin, as shear turns the bodies the faster the longer their levers are.
//!
//! √δ has no stiffest tangent. Compression is taken where a blow at `speed` ends, at `δ = (3 m* v²/(4 A k1))^(2/3)`; gentler
//! ones are stiffer, and what a step is too long for there is no more than a few times `δ* = (A ku1 Δt²/(8 m*))²`.
//!
//! Shear pulls at levers, so where the two bodies differ it swings together with bending:
//! `ω² = ½(a + b ± √((a−b)² + 4 d² Ks Kb))`, a and b the ω² of each alone, `d = r_ci/Ii − r_cj/Ij`.
use super::Params;
use crate::model::{Mode, NamedMode, Size};

/// All modes that have a stiffness.
pub fn of(p: &Params, size: &Size, speed: f64) -> Vec<NamedMode> {
    let (c, m) = (&p.c, size.meff);
    let shift = |name, stiffness, mass| {
        let mode = Mode { stiffness, mass, damping: 0.0 };
        NamedMode { name, rotational: false, mode }
    };
    let turn = |name, stiffness, mass| NamedMode { rotational: true, ..shift(name, stiffness, mass) };
    let mut all = Vec::new();
    let per = if c.upstream { 1.0 } else { p.area };
    if c.on.normal && p.area > 0.0 {
        let deepest = (0.75 * m * speed * speed / (per * c.compression.k)).powf(2.0 / 3.0);
        let steep = 0.5 * per * c.compression.ku / deepest.sqrt();
        all.push(shift("compression", (1.0 + c.eta.normal) * steep, m));
    }
    if c.on_tension {
        all.push(shift("tension", (1.0 + c.eta.normal) * p.area * c.tension.ku, m));
    }
    let (ti, tj) = size.mobilities();
    if c.on.twist {
        all.push(turn("twist", (1.0 + c.eta.twist) * p.polar * c.twist.ku, 1.0 / (ti + tj)));
    }
    let shear = if c.on.shear { (1.0 + c.eta.shear) * p.area * c.shear } else { 0.0 };
    let bend = if c.on.bend { (1.0 + c.eta.bend) * p.bending * c.bend.ku } else { 0.0 };
    let [ms, mb] = sideways(p, size, shear, bend);
    all.extend([shift("shear", shear, ms), turn("bending", bend, mb)]);
    all.retain(|s| s.mode.stiffness > 0.0 && s.mode.stiffness.is_finite());
    all
}

/// What shear and bending move, each with the other \[kg, kg m²\].
fn sideways(p: &Params, size: &Size, shear: f64, bend: f64) -> [f64; 2] {
    let r = if size.is_wall { 0.5 * p.c.near } else { p.c.near };
    let (ti, tj) = size.mobilities();
    let [ci, cj] = p.arms.map(|a| a * r);
    // The header moves the surface of a wall bond by half the spin.
    let seen = if p.c.upstream && size.is_wall { 0.5 } else { 1.0 };
    let light = [1.0 / size.meff + seen * (ci * ci * ti + cj * cj * tj), ti + tj];
    let [a, b] = [shear * light[0], bend * light[1]];
    let d = ci * ti - cj * tj;
    let apart = ((a - b).powi(2) + 4.0 * seen * d * d * shear * bend).sqrt();
    let [fast, slow] = [0.5 * (a + b + apart), 0.5 * (a + b - apart)];
    let [a, b] = if a >= b { [fast, slow] } else { [slow, fast] };
    // Alone, whatever the other has no stiffness for.
    [if bend > 0.0 { shear / a } else { 1.0 / light[0] }, if shear > 0.0 { bend / b } else { 1.0 / light[1] }]
}
