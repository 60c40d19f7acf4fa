//! The C interface: every `extern "C"` of `granlaw.h`. Each body checks its pointers, stops panics and calls one safe
//! function; the layouts in `abi` are bindgen's view of the header.
#![warn(clippy::undocumented_unsafe_blocks)]
#![allow(clippy::missing_safety_doc)] // The contract stands in granlaw.h.
#![allow(non_camel_case_types)] // C names.

#[allow(non_snake_case, missing_docs, dead_code)]
#[rustfmt::skip]
pub mod abi;
pub mod convert;
mod descriptor;
pub mod status;

use abi::*;
use granlaw::chain::{Bonds, Chain, ChainEffects, Wall};
use granlaw::laws::LAWS;
use granlaw::model::{Call, Contact, Response};
use status::{boundary, Failure};
use std::ffi::{c_char, CString};
use std::ptr::{null, null_mut};

/// A prepared chain with what holds for the present pass.
pub struct granlaw_chain {
    chain: Chain,
    pass: granlaw_pass,
    remarks: Vec<CString>,
}

const NO_PASS: granlaw_pass = granlaw_pass {
    dt: 0.0,
    step: 0,
    x: null(),
    tag: null(),
    mask: null(),
    frozen: 0,
    n_local: 0,
    given: [null(); GRANLAW_ATOM_PROPS as usize],
    outputs: [null_mut(); GRANLAW_ATOM_OUTPUTS as usize],
};

#[no_mangle]
pub extern "C" fn granlaw_abi_version() -> u32 {
    GRANLAW_ABI_VERSION
}

#[no_mangle]
pub extern "C" fn granlaw_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

#[no_mangle]
pub extern "C" fn granlaw_law_count() -> usize {
    LAWS.len()
}

#[no_mangle]
pub extern "C" fn granlaw_law_at(law: usize) -> *const granlaw_law {
    descriptor::table().get(law).map_or(std::ptr::null(), |l| l)
}

#[no_mangle]
pub extern "C" fn granlaw_last_error() -> *const c_char {
    status::last_error()
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_needs_property(
    law: usize,
    taken_over: bool,
    options: *const i32,
    prop: usize,
) -> bool {
    let mut needed = false;
    boundary(|| {
        // SAFETY: the caller gives one option per setting of that law, or NULL.
        let settings = unsafe { convert::settings(law, taken_over, options) }?;
        let prop =
            LAWS[law].meta.props.get(prop).ok_or(Failure::misuse("prop is not a property of that law"))?;
        needed = settings.need(prop.need);
        Ok(())
    });
    needed
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_check_settings(
    law: usize,
    taken_over: bool,
    options: *const i32,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives one option per setting of that law, or NULL.
        let settings = unsafe { convert::settings(law, taken_over, options) }?;
        settings.check().map_err(|e| Failure::refused(e.to_string()))
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_needs_slot(
    law: usize,
    taken_over: bool,
    options: *const i32,
    slot: usize,
) -> bool {
    let mut needed = false;
    boundary(|| {
        // SAFETY: the caller gives one option per setting of that law, or NULL.
        let settings = unsafe { convert::settings(law, taken_over, options) }?;
        let slot = LAWS[law].meta.slots.get(slot).ok_or(Failure::misuse("slot is not one of that law"))?;
        needed = settings.need(slot.need);
        Ok(())
    });
    needed
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_prepare(
    setup: *const granlaw_setup,
    out: *mut *mut granlaw_chain,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid pointers or NULL, which is refused here.
        let (setup, out) = unsafe { (setup.as_ref(), out.as_mut()) };
        let (Some(setup), Some(out)) = (setup, out) else {
            return Err(Failure::misuse("setup or out is NULL"));
        };
        *out = std::ptr::null_mut();
        // SAFETY: the arrays in `setup` have the lengths that granlaw.h states.
        let (setups, places) = unsafe { convert::setups(setup) }?;
        let chain = Chain::new(&setups, &places).map_err(|e| Failure::refused(e.to_string()))?;
        let remarks = chain.remarks().map(c_string).collect();
        *out = Box::into_raw(Box::new(granlaw_chain { chain, pass: NO_PASS, remarks }));
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_free(chain: *mut granlaw_chain) {
    if !chain.is_null() {
        boundary(|| {
            // SAFETY: the pointer came from granlaw_prepare and is not used again.
            drop(unsafe { Box::from_raw(chain) });
            Ok(())
        });
    }
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_remark(chain: *const granlaw_chain, k: usize) -> *const c_char {
    // SAFETY: the caller gives a valid pointer or NULL.
    let chain = unsafe { chain.as_ref() };
    chain.and_then(|c| c.remarks.get(k)).map_or(null(), |r| r.as_ptr())
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_contact_distance_factor(
    chain: *const granlaw_chain,
    rmin: f64,
    out: *mut f64,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid pointers or NULL, which is refused here.
        let (Some(c), Some(out)) = (unsafe { (chain.as_ref(), out.as_mut()) }) else {
            return Err(Failure::misuse("chain or out is NULL"));
        };
        *out = c.chain.contact_distance_factor(rmin).map_err(|e| Failure::refused(e.to_string()))?;
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_check_wall(
    chain: *const granlaw_chain,
    wall: *const granlaw_wall,
    rmin: f64,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid pointers or NULL, which is refused here.
        let (Some(c), Some(wall)) = (unsafe { (chain.as_ref(), wall.as_ref()) }) else {
            return Err(Failure::misuse("chain or wall is NULL"));
        };
        let wall = Wall { skin: Some(wall.skin).filter(|s| s.is_finite()), turns: wall.turns };
        c.chain.check_wall(&wall, rmin).map_err(|e| Failure::refused(e.to_string()))
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_count_bonds(
    chain: *const granlaw_chain,
    out: *mut granlaw_bonds,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid pointers or NULL, which is refused here.
        let (Some(c), Some(out)) = (unsafe { (chain.as_ref(), out.as_mut()) }) else {
            return Err(Failure::misuse("chain or out is NULL"));
        };
        let Bonds { begun, ended, there, step } = c.chain.bonds();
        *out = granlaw_bonds { begun, ended, there, step };
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_begin_pass(
    chain: *mut granlaw_chain,
    pass: *const granlaw_pass,
) -> granlaw_status {
    // SAFETY: the caller gives valid pointers or NULL.
    match unsafe { (chain.as_mut(), pass.as_ref()) } {
        (Some(chain), Some(pass)) => {
            chain.pass = *pass;
            GRANLAW_OK as granlaw_status
        }
        _ => status::fail(Failure::misuse("chain or pass is NULL")),
    }
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_surfaces_intersect(
    chain: *mut granlaw_chain,
    contact: *mut granlaw_surfaces_intersect_data,
    i_forces: *mut granlaw_force_data,
    j_forces: *mut granlaw_force_data,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid, distinct pointers or NULL.
        let args = unsafe { (chain.as_mut(), contact.as_mut(), i_forces.as_mut(), j_forces.as_mut()) };
        let (Some(c), Some(s), Some(fi), Some(fj)) = args else {
            return Err(Failure::misuse("a pointer is NULL"));
        };
        let types = convert::types(&s.close, c.chain.types())?;
        // SAFETY: the contact's pointers and indices are LIGGGHTS's own and match the arrays of the pass.
        let x = unsafe { convert::contact(&c.pass, s) };
        if !convert::finite(&x) {
            return Err(convert::non_finite(c.chain.laws(), &x));
        }
        let mut response = convert::response(&s.close, fi, fj);
        (response.fn_, response.kn, response.kt, response.gamman, response.gammat) =
            (s.Fn, s.kn, s.kt, s.gamman, s.gammat);
        // SAFETY: contact_history is NULL or as long as the chain's row.
        let row = unsafe { convert::history(s.close.contact_history, c.chain.row()) }?;
        let done = c.chain.surfaces_intersect(types, &x, row, &mut response);
        (s.Fn, s.kn, s.kt, s.gamman, s.gammat) =
            (response.fn_, response.kn, response.kt, response.gamman, response.gammat);
        // SAFETY: contact_flags is NULL or valid.
        unsafe { mark(s.close.contact_flags, &done) };
        // SAFETY: the arrays of the pass reach as far as its indices.
        unsafe { convert::add_outputs(&c.pass, &s.close, &done) };
        convert::hand_out(&response, &done, &s.close, fi, fj);
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_surfaces_close(
    chain: *mut granlaw_chain,
    gap: *mut granlaw_surfaces_close_data,
    mi: f64,
    mj: f64,
    i_forces: *mut granlaw_force_data,
    j_forces: *mut granlaw_force_data,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the caller gives valid, distinct pointers or NULL.
        let args = unsafe { (chain.as_mut(), gap.as_mut(), i_forces.as_mut(), j_forces.as_mut()) };
        let (Some(c), Some(s), Some(fi), Some(fj)) = args else {
            return Err(Failure::misuse("a pointer is NULL"));
        };
        let types = convert::types(s, c.chain.types())?;
        // SAFETY: the gap's pointers and indices are LIGGGHTS's own and match the arrays of the pass.
        let x = unsafe { convert::parted(&c.pass, s, [mi, mj]) };
        if !convert::finite_apart(&x) {
            return Err(convert::non_finite(c.chain.laws(), &Contact { close: x, ..Contact::default() }));
        }
        let mut response = convert::response(s, fi, fj);
        // SAFETY: contact_history is NULL or as long as the chain's row.
        let row = unsafe { convert::history(s.contact_history, c.chain.row()) }?;
        let done = c.chain.surfaces_close(types, &x, row, &mut response);
        // SAFETY: contact_flags is NULL or valid.
        unsafe { mark(s.contact_flags, &done) };
        // SAFETY: the arrays of the pass reach as far as its indices.
        unsafe { convert::add_outputs(&c.pass, s, &done) };
        s.has_force_update |= done.acts || response.force != Response::<f64>::default().force;
        convert::hand_out(&response, &done, s, fi, fj);
        Ok(())
    })
}

#[no_mangle]
pub unsafe extern "C" fn granlaw_end_pass(chain: *mut granlaw_chain) -> granlaw_status {
    if chain.is_null() {
        return status::fail(Failure::misuse("chain is NULL"));
    }
    GRANLAW_OK as granlaw_status
}

/// # Safety
/// `flags` is NULL or valid for reading and writing.
unsafe fn mark(flags: *mut i32, done: &ChainEffects) {
    // SAFETY: as the caller promises.
    if let Some(flags) = unsafe { flags.as_mut() } {
        *flags = (*flags | done.set) & !done.clear;
    }
}

fn call(pass: &granlaw_pass, s: &granlaw_surfaces_close_data, tag_i: i64, tag_j: i64) -> Call {
    let update = s.computeflag != 0 && s.shearupdate != 0;
    // A pair that two ranks see is counted by the owner of the lower tag, as traces are written.
    let counts = s.computeflag != 0 && (s.is_wall || s.j < pass.n_local || tag_i < tag_j);
    Call { dt: pass.dt, step: pass.step, update, counts, is_wall: s.is_wall }
}

fn c_string(text: &str) -> CString {
    CString::new(text.replace('\0', " ")).expect("no NUL is left")
}
