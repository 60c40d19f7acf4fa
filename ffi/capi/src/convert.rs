//! Between the structs of `granlaw.h` and those of the core.
use crate::abi::*;
use crate::call;
use crate::status::Failure;
use granlaw::chain::ChainEffects;
use granlaw::laws::LAWS;
use granlaw::model::{Body, ClosePair, Contact, Meta, Response, Settings, Setup, Surface, Values};
use nalgebra::Vector3;
use std::slice::from_raw_parts;

/// # Safety
/// `p` is NULL or leads to `n` values.
pub unsafe fn slice<'a, T>(p: *const T, n: usize) -> &'a [T] {
    if p.is_null() || n == 0 {
        return &[];
    }
    // SAFETY: as the caller promises.
    unsafe { from_raw_parts(p, n) }
}

/// The settings of a law from option indices.
///
/// # Safety
/// `options` is NULL or leads to one index per setting of the law.
pub unsafe fn settings(law: usize, taken_over: bool, options: *const i32) -> Result<Settings, Failure> {
    let law = LAWS.get(law).ok_or(Failure::misuse("no law has that index"))?;
    let mut settings = Settings::new(law, taken_over);
    // SAFETY: as the caller promises.
    for (setting, k) in law.settings().zip(unsafe { slice(options, law.settings().count()) }) {
        if *k >= 0 {
            let option =
                setting.options.get(*k as usize).ok_or(Failure::misuse("no option has that index"))?;
            settings.set(setting.name, option).map_err(|e| Failure::refused(e.to_string()))?;
        }
    }
    Ok(settings)
}

/// All laws of a chain, and where the slots of their histories lie in a row.
///
/// # Safety
/// The arrays have the lengths that `granlaw.h` states.
pub unsafe fn setups(from: &granlaw_setup) -> Result<(Vec<Setup>, Vec<Vec<usize>>), Failure> {
    let types = from.n_types;
    if types == 0 || from.n_laws == 0 || from.laws.is_null() {
        return Err(Failure::misuse("n_types is 0 or there are no laws"));
    }
    let (mut setups, mut places) = (Vec::new(), Vec::new());
    // SAFETY: as the caller promises, here and in the loop.
    for choice in unsafe { slice(from.laws, from.n_laws) } {
        // SAFETY: as above.
        let settings = unsafe { settings(choice.law, choice.taken_over, choice.options) }?;
        let law = &LAWS[choice.law];
        // SAFETY: as above.
        let given = unsafe { slice(choice.values, law.meta.props.len()) };
        let values = law.meta.props.iter().enumerate().map(|(k, prop)| match given.get(k) {
            // SAFETY: a property has as many values as its shape says.
            Some(p) => unsafe { slice(*p, prop.shape.len(types)) }.to_vec(),
            None => Vec::new(),
        });
        let values = Values { types, of: values.collect() };
        let setup = Setup { law, settings, values, nktv2p: from.nktv2p };
        // SAFETY: as above.
        places.push(unsafe { places_of(&setup, choice) }?);
        setups.push(setup);
    }
    in_order(&setups)?;
    apart(&places)?;
    Ok((setups, places))
}

/// # Safety
/// `history_places` is NULL or leads to one place per slot of the law.
unsafe fn places_of(setup: &Setup, choice: &granlaw_choice) -> Result<Vec<usize>, Failure> {
    let slots = setup.law.meta.slots;
    if choice.history_places.is_null() {
        let end = choice.history_offset.checked_add(setup.slots().count());
        let end = end.ok_or(Failure::misuse("history_offset is too large"))?;
        return Ok((choice.history_offset..end).collect());
    }
    // SAFETY: as the caller promises.
    let given = unsafe { slice(choice.history_places, slots.len()) };
    let wanted = slots.iter().zip(given).filter(|(s, _)| setup.settings.need(s.need));
    let place = |(_, at): (_, &i32)| usize::try_from(*at).ok();
    wanted
        .map(place)
        .collect::<Option<_>>()
        .ok_or(Failure::misuse("history_places: a slot that the settings call for has no place"))
}

fn in_order(setups: &[Setup]) -> Result<(), Failure> {
    if setups.windows(2).all(|s| s[0].law.meta.kind < s[1].law.meta.kind) {
        return Ok(());
    }
    Err(Failure::misuse("the laws must come in the order of the kinds, at most one of each"))
}

fn apart(places: &[Vec<usize>]) -> Result<(), Failure> {
    let mut all: Vec<_> = places.iter().flatten().collect();
    all.sort_unstable();
    if all.windows(2).any(|p| p[0] == p[1]) {
        return Err(Failure::misuse("history_offset: two laws would write to the same slot"));
    }
    Ok(())
}

/// The types of a contact, counted from 0.
pub fn types(s: &granlaw_surfaces_close_data, n: usize) -> Result<(usize, usize), Failure> {
    let (i, j) = (s.itype.wrapping_sub(1) as usize, s.jtype.wrapping_sub(1) as usize);
    if i < n && j < n {
        Ok((i, j))
    } else {
        Err(Failure::misuse("itype or jtype is not an atom type of the chain"))
    }
}

/// # Safety
/// `history` is NULL or leads to `n` numbers that nothing else uses.
pub unsafe fn history<'a>(history: *mut f64, n: usize) -> Result<&'a mut [f64], Failure> {
    match (history.is_null(), n) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(Failure::misuse("contact_history is NULL but the chain has history")),
        // SAFETY: as the caller promises.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts_mut(history, n) }),
    }
}

/// # Safety
/// `p` is NULL or leads to three numbers.
unsafe fn vector(p: *const f64) -> Vector3<f64> {
    if p.is_null() {
        return Vector3::zeros();
    }
    // SAFETY: as the caller promises.
    unsafe { Vector3::new(*p, *p.add(1), *p.add(2)) }
}

/// All but the effective mass.
///
/// # Safety
/// The pointers and indices of `s` are valid for the arrays of the pass.
#[inline(always)]
unsafe fn gap(pass: &granlaw_pass, s: &granlaw_surfaces_close_data, mass: [f64; 2]) -> ClosePair {
    // SAFETY: as the caller promises, in this block; a wall has no place in the arrays.
    unsafe {
        let place =
            |k: i32| if pass.x.is_null() { Vector3::zeros() } else { vector(pass.x.add(3 * k as usize)) };
        let tag = |k: i32| if pass.tag.is_null() { 0 } else { i64::from(*pass.tag.add(k as usize)) };
        let frozen = |k: i32| {
            pass.frozen != 0 && !pass.mask.is_null() && *pass.mask.add(k as usize) & pass.frozen != 0
        };
        let given = |k: i32| {
            pass.given.map(|given| if given.is_null() { f64::NEG_INFINITY } else { *given.add(k as usize) })
        };
        let delta = Vector3::from(s.delta);
        let x = place(s.i);
        let i = Body {
            tag: tag(s.i),
            radius: s.radi,
            mass: mass[0],
            frozen: frozen(s.i),
            x,
            v: vector(s.v_i),
            omega: vector(s.omega_i),
            given: given(s.i),
        };
        let j = if s.is_wall {
            let tag = -1 - i64::from(s.j.max(0));
            Body { tag, x: x - delta, v: vector(s.v_j), ..Body::default() }
        } else {
            let (x, omega, frozen, mass) = (place(s.j), vector(s.omega_j), frozen(s.j), mass[1]);
            let (v, given) = (vector(s.v_j), given(s.j));
            Body { tag: tag(s.j), radius: s.radj, mass, frozen, x, v, omega, given }
        };
        ClosePair { call: call(pass, s, i.tag, j.tag), i, j, delta, rsq: s.rsq, meff: 0.0 }
    }
}

/// # Safety
/// As [`gap`].
pub unsafe fn parted(pass: &granlaw_pass, s: &granlaw_surfaces_close_data, mass: [f64; 2]) -> ClosePair {
    // SAFETY: as the caller promises.
    unsafe { gap(pass, s, mass) }.weighed()
}

/// # Safety
/// As [`gap`].
#[inline(always)]
pub unsafe fn contact(pass: &granlaw_pass, s: &granlaw_surfaces_intersect_data) -> Contact {
    // SAFETY: as the caller promises.
    let mut gap = unsafe { gap(pass, &s.close, [s.mi, s.mj]) };
    gap.meff = s.meff;
    let (roll, crj) = if s.close.is_wall {
        (Vector3::new(s.wr1, s.wr2, s.wr3), 0.0)
    } else {
        (gap.i.omega - gap.j.omega, s.crj)
    };
    let vtr = Vector3::new(s.vtr1, s.vtr2, s.vtr3);
    let surface = Surface { r: s.r, deltan: s.deltan, vn: s.vn, en: s.en.into(), vtr, roll, cri: s.cri, crj };
    Contact { close: gap, surface }
}

/// Whether nothing that the laws read of the motion is NaN or infinite.
#[inline]
pub fn finite(x: &Contact) -> bool {
    let s = &x.surface;
    // Any NaN or infinity survives the sum; finite numbers of a simulation do not overflow it.
    (s.deltan + s.vn + s.en.sum() + s.vtr.sum() + s.roll.sum() + s.cri + s.crj + x.close.meff).is_finite()
}

/// The same of two bodies that do not touch.
#[inline]
pub fn finite_apart(x: &ClosePair) -> bool {
    let moves = |b: &Body| b.x.sum() + b.v.sum() + b.omega.sum();
    (x.delta.sum() + moves(&x.i) + moves(&x.j)).is_finite()
}

/// What to say of it.
#[cold]
pub fn non_finite(laws: impl Iterator<Item = &'static Meta>, x: &Contact) -> Failure {
    let laws: Vec<_> = laws.map(|m| m.keyword).collect();
    let partner = if x.close.call.is_wall { "a wall".into() } else { format!("particle {}", x.close.j.tag) };
    Failure::non_finite(format!(
        "{}: the contact of particle {} with {partner} at step {} is not finite (overlap {:e} m, normal velocity {:e} m/s); reduce the time step or check the input",
        laws.join(" + "), x.close.i.tag, x.close.call.step, x.surface.deltan, x.surface.vn,
    ))
}

/// What the chain begins with: the torques that LIGGGHTS's laws before it have given to this contact.
#[inline]
pub fn response(
    s: &granlaw_surfaces_close_data,
    fi: &granlaw_force_data,
    fj: &granlaw_force_data,
) -> Response {
    let mut torque_i = Vector3::from(fi.delta_torque);
    if s.is_wall && s.area_ratio != 1.0 {
        whole(&mut torque_i, s.area_ratio);
    }
    Response { torque_i, torque_j: fj.delta_torque.into(), ..Response::default() }
}

/// The torque of a wall contact that counts only in part; one that does not count at all is zero.
#[cold]
fn whole(torque: &mut Vector3<f64>, share: f64) {
    if share != 0.0 {
        *torque /= share;
    }
}

/// Add what the laws give to single atoms: to i, and to j unless it is a wall.
///
/// # Safety
/// The arrays of the pass reach as far as the indices of `s`.
#[inline]
pub unsafe fn add_outputs(pass: &granlaw_pass, s: &granlaw_surfaces_close_data, done: &ChainEffects) {
    for (place, to) in pass.outputs.iter().enumerate().filter(|(_, to)| !to.is_null()) {
        // SAFETY: as the caller promises.
        unsafe {
            *to.add(s.i as usize) += done.outputs[0][place];
            if !s.is_wall {
                *to.add(s.j as usize) += done.outputs[1][place];
            }
        }
    }
}

/// Add the force, the opposite one to j and none to a wall; the torques hold what was there before.
#[inline]
pub fn hand_out(
    response: &Response,
    done: &ChainEffects,
    s: &granlaw_surfaces_close_data,
    fi: &mut granlaw_force_data,
    fj: &mut granlaw_force_data,
) {
    let share = if s.is_wall { s.area_ratio } else { 1.0 };
    if done.replaces {
        (fi.delta_F, fj.delta_F) = ([0.0; 3], [0.0; 3]);
    }
    for k in 0..3 {
        fi.delta_F[k] += response.force[k] * share;
        fi.delta_torque[k] = response.torque_i[k] * share;
        // LIGGGHTS's rolling laws turn a wall too, though nobody reads it.
        fj.delta_torque[k] = response.torque_j[k];
        if !s.is_wall {
            fj.delta_F[k] -= response.force[k];
        }
    }
}
