//! Fits the properties that describe an effect rather than a material, so that another law does on these contacts what the present one
//! does.
use super::change::FITTED;
use super::errors::Errors;
use super::group::Group;
use super::scene::Scene;
use crate::trace::{Header, HeaderError};
use granlaw::laws::prop;

/// Steps of the fit, as a multiple of those of the truth. They may be longer, as a fit runs many times.
const COARSER: f64 = 2.0;
/// Narrowings of a golden section; each leaves 0.618 of the interval.
const NARROW: u32 = 16;

/// Sets the fitted properties to the values with the least error; they have the same value in all chains.
///
/// # Errors
/// A law refuses every value.
pub(super) fn fit(scene: &Scene, chains: &mut [Header]) -> Result<(), HeaderError> {
    let dt = COARSER * scene.fine();
    let has = |chains: &[Header], name| {
        chains.iter().flat_map(|h| &h.laws).any(|l| l.properties.iter().any(|p| p.name == name))
    };
    let [restitution, velocity] = FITTED;
    // The contact time hardly depends on the damping, and the restitution hardly on the stiffness, so two rounds are enough.
    for _ in 0..2 {
        if has(chains, velocity) {
            let all = |_: &Group| true;
            let time = |e: &Errors| e.time;
            let found = least((-4.0, 2.0), |x| {
                set(chains, velocity, None, 10f64.powf(x));
                worst(scene, chains, dt, all, time)
            })?;
            set(chains, velocity, None, round(10f64.powf(found)));
        }
        if has(chains, restitution) {
            let mut types: Vec<_> = scene.groups.iter().map(|g| g.types).collect();
            types.sort_unstable();
            types.dedup();
            for t in types {
                let range = prop::RESTITUTION.range;
                let found = least((range.lo + 1e-3, range.hi), |x| {
                    set(chains, restitution, Some(t), x);
                    worst(scene, chains, dt, |g| g.types == t, |e| e.restitution)
                })?;
                set(chains, restitution, Some(t), round(found));
            }
        }
    }
    Ok(())
}

/// Where a function that has a single minimum is least.
fn least(
    (mut low, mut high): (f64, f64),
    mut f: impl FnMut(f64) -> Result<f64, HeaderError>,
) -> Result<f64, HeaderError> {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut at = [f(inner[0])?, f(inner[1])?];
    for _ in 0..NARROW {
        if at[0] <= at[1] {
            high = inner[1];
            (inner[1], at[1]) = (inner[0], at[0]);
            inner[0] = high - GOLDEN * (high - low);
            at[0] = f(inner[0])?;
        } else {
            low = inner[0];
            (inner[0], at[0]) = (inner[1], at[1]);
            inner[1] = low + GOLDEN * (high - low);
            at[1] = f(inner[1])?;
        }
    }
    Ok(0.5 * (low + high))
}

/// Sets a property in every chain that has it, for one pair of atom types or all.
fn set(chains: &mut [Header], name: &str, types: Option<[usize; 2]>, x: f64) {
    for h in chains {
        let n = h.types;
        for p in h.laws.iter_mut().flat_map(|l| &mut l.properties).filter(|p| p.name == name) {
            match types {
                Some([a, b]) => [(a, b), (b, a)].iter().for_each(|(i, j)| p.values[(i - 1) * n + j - 1] = x),
                None => p.values.fill(x),
            }
        }
    }
}

/// The largest error of the given groups.
fn worst(
    scene: &Scene,
    chains: &[Header],
    dt: f64,
    of: impl Fn(&Group) -> bool,
    error: impl Fn(&Errors) -> f64,
) -> Result<f64, HeaderError> {
    let some = scene.only(of);
    let (errors, _) = some.try_out(chains, dt, None, |_| 1.0)?;
    Ok(errors.iter().map(error).fold(0.0, f64::max))
}

/// Rounds to four digits, which is what the deck will hold.
fn round(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}
