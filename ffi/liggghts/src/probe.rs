//! Counts what the C++ half sees of all chains. The structs are those of `cpp/boundary.h`.
use crate::boundary::{
    granlaw_recorded_call, granlaw_recorded_chain, granlaw_recorded_particles, granlaw_text,
};
use crate::recorder::{header, text};
use granlaw_capi::abi::{granlaw_pass, granlaw_status, granlaw_surfaces_close_data};
use granlaw_capi::convert::{contact, parted, slice};
use granlaw_capi::status::{boundary, Failure};
use granlaw_tools::probe::{Call, Particles, Probe, Session};
use granlaw_tools::trace::Handed;
use std::ffi::c_char;
use std::path::Path;

/// What this rank has seen; empty once it is packed.
#[derive(Default)]
pub struct Probing {
    session: Option<Session>,
    /// The number of history slots of each chain.
    slots: Vec<usize>,
}

fn over() -> Failure {
    Failure::misuse("the probe is packed already")
}

#[no_mangle]
extern "C" fn granlaw_probe_new(all: bool) -> *mut Probing {
    let session = if all { Session::closely() } else { Session::default() };
    Box::into_raw(Box::new(Probing { session: Some(session), ..Probing::default() }))
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_chain(
    p: *mut Probing,
    c: *const granlaw_recorded_chain,
    out: *mut usize,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (p, header, out) = unsafe { (&mut *p, header(&*c)?, &mut *out) };
        let slots = header.slots.len();
        *out = p.session.as_mut().ok_or_else(over)?.chain(header);
        p.slots.resize(p.slots.len().max(*out + 1), 0);
        p.slots[*out] = slots;
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_unseen(p: *mut Probing, who: *const c_char) {
    // SAFETY: the C++ half gives valid pointers.
    let (p, who) = unsafe { (&mut *p, text(who)) };
    if let Some(session) = &mut p.session {
        session.unseen(&who);
    }
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_tick(p: *mut Probing, pass: *const granlaw_pass, listed: bool) -> bool {
    // SAFETY: the C++ half gives valid pointers.
    let (p, pass) = unsafe { (&mut *p, &*pass) };
    p.session.as_mut().is_some_and(|s| s.tick(pass.step, pass.dt, listed))
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_sample(
    p: *mut Probing,
    step: i64,
    of: *const granlaw_recorded_particles,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers; the arrays have n particles.
        let (p, of) = unsafe { (&mut *p, &*of) };
        // SAFETY: as above.
        let particles = unsafe {
            let n = of.n;
            Particles {
                kind: slice(of.type_, n),
                mass: slice(of.mass, n),
                radius: slice(of.radius, n),
                x: slice(of.x, 3 * n),
                v: slice(of.v, 3 * n),
                omega: slice(of.omega, 3 * n),
            }
        };
        p.session.as_mut().ok_or_else(over)?.sample(step, &particles);
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_sees(
    p: *mut Probing,
    chain: usize,
    pass: *const granlaw_pass,
    s: *const granlaw_surfaces_close_data,
) -> bool {
    // SAFETY: the C++ half gives valid pointers.
    let (p, pass, s) = unsafe { (&mut *p, &*pass, &*s) };
    // SAFETY: i and j are places in LIGGGHTS's arrays; a wall has none.
    let tag = |k: i32| unsafe { i64::from(*pass.tag.add(k as usize)) };
    let tags = (tag(s.i), if s.is_wall { -1 - i64::from(s.j.max(0)) } else { tag(s.j) });
    p.session.as_mut().is_some_and(|session| session.follower(chain).sees(tags))
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_call(
    p: *mut Probing,
    chain: usize,
    c: *const granlaw_recorded_call,
    place: usize,
    followed: bool,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (p, c) = unsafe { (&mut *p, &*c) };
        // SAFETY: as above.
        let (pass, s, fi, fj) = unsafe { (&*c.pass, &*c.contact, &*c.i_forces, &*c.j_forces) };
        let close = &s.close;
        let follower = p.session.as_mut().ok_or_else(over)?.follower(chain);
        let force = fi.delta_F.into();
        let update = close.computeflag != 0 && close.shearupdate != 0;
        if close.is_wall && update {
            follower.pushed(&force, pass.dt);
        }
        if !followed || !update {
            return Ok(());
        }
        // SAFETY: the contact is LIGGGHTS's own and matches the pass; the history has as many numbers as slots.
        let (x, before) = unsafe { (contact(pass, s), slice(c.before, p.slots[chain])) };
        follower.touched(&Call {
            types: (close.itype as usize - 1, close.jtype as usize - 1),
            contact: &x,
            place,
            share: if close.is_wall { close.area_ratio } else { 1.0 },
            before,
            handed: Handed { fn_: s.Fn, kn: s.kn, kt: s.kt, gamman: s.gamman, gammat: s.gammat },
            force,
            torque_i: fi.delta_torque.into(),
            torque_j: fj.delta_torque.into(),
        });
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_across(
    p: *mut Probing,
    chain: usize,
    c: *const granlaw_recorded_call,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (p, c) = unsafe { (&mut *p, &*c) };
        // SAFETY: as above; of a gap the part that is common to gaps and contacts is set.
        let (pass, s) = unsafe { (&*c.pass, &(*c.contact).close) };
        let follower = p.session.as_mut().ok_or_else(over)?.follower(chain);
        if s.computeflag == 0 || s.shearupdate == 0 {
            return Ok(());
        }
        // SAFETY: the gap is LIGGGHTS's own and matches the pass; the history has as many numbers as slots.
        let (gap, before) = unsafe { (parted(pass, s, [c.mi, c.mj]), slice(c.before, p.slots[chain])) };
        follower.across((s.itype as usize - 1, s.jtype as usize - 1), &gap, before);
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_alarm(p: *mut Probing, chain: usize, out: *mut granlaw_text) -> bool {
    // SAFETY: the C++ half gives valid pointers.
    let (p, out) = unsafe { (&mut *p, &mut *out) };
    let Some(alarm) = p.session.as_mut().and_then(|s| s.follower(chain).alarm()) else { return false };
    *out = granlaw_text::kept(alarm.into_bytes());
    true
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_bonds_alarm(p: *mut Probing, out: *mut granlaw_text) -> bool {
    // SAFETY: the C++ half gives valid pointers.
    let (p, out) = unsafe { (&mut *p, &mut *out) };
    let Some(alarm) = p.session.as_mut().and_then(|s| s.bonds_alarm()) else { return false };
    *out = granlaw_text::kept(alarm.into_bytes());
    true
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_pack(p: *mut Probing, out: *mut granlaw_text) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (p, out) = unsafe { (&mut *p, &mut *out) };
        *out = granlaw_text::json(&p.session.take().ok_or_else(over)?.finish())?;
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_probe_write(
    path: *const c_char,
    ranks: *const granlaw_text,
    n: usize,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives a C string and as many texts as ranks.
        let (path, texts) = unsafe { (text(path), slice(ranks, n)) };
        // SAFETY: as above.
        let whole: Probe = unsafe { granlaw_text::merged(texts, Probe::merge) }?;
        whole.write(Path::new(&path)).map_err(|e| Failure::refused(e.to_string()))
    })
}
