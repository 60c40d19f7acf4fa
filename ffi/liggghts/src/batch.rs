//! The batched pass behind C. The structs are those of `cpp/boundary.h`.
use crate::boundary::{granlaw_account, granlaw_arrays};
use granlaw::model::{Body, ClosePair, Contact, Meta, Surface};
use granlaw_capi::abi::{granlaw_setup, granlaw_status};
use granlaw_capi::convert::{non_finite, setups};
use granlaw_capi::status::{boundary, Failure};
use granlaw_lanes::{batch, fitting, Arrays, Batch, NonFinite, Trouble, Width};
use std::ffi::{c_char, CStr, CString};

/// A chain for whole passes.
pub struct Batched {
    batch: Box<dyn Batch>,
    laws: Vec<&'static Meta>,
    name: CString,
    passes: u64,
}

/// # Safety
/// `setup` holds what granlaw.h states, `lanes` is a C string, `out` is valid.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_new(
    setup: *const granlaw_setup,
    lanes: *const c_char,
    out: *mut *mut Batched,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: as the caller promises, here and below.
        let (setup, out) = unsafe { (&*setup, &mut *out) };
        *out = std::ptr::null_mut();
        // SAFETY: as above.
        let lanes = unsafe { CStr::from_ptr(lanes) }.to_string_lossy();
        let width = Width::named(&lanes).map_err(Failure::refused)?;
        // SAFETY: as above.
        let (setups, places) = unsafe { setups(setup) }?;
        let laws = setups.iter().map(|s| s.law.meta).collect();
        let (made, name) = match &*lanes {
            "" if width != Width::One => (fitting(&setups, &places), format!("up to {}", width.name())),
            _ => (batch(&setups, &places, width), width.name().into()),
        };
        let made = made.map_err(|e| Failure::refused(e.to_string()))?;
        if let Some(batch) = made {
            let name = CString::new(name).expect("a name without NUL");
            *out = Box::into_raw(Box::new(Batched { batch, laws, name, passes: 0 }));
        }
        Ok(())
    })
}

/// # Safety
/// `b` came from `granlaw_batch_new` or is NULL, and is not used again.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_free(b: *mut Batched) {
    if !b.is_null() {
        boundary(|| {
            // SAFETY: as the caller promises.
            drop(unsafe { Box::from_raw(b) });
            Ok(())
        });
    }
}

/// # Safety
/// `b` came from `granlaw_batch_new`.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_name(b: *const Batched) -> *const c_char {
    // SAFETY: as the caller promises.
    unsafe { (*b).name.as_ptr() }
}

/// # Safety
/// `b` came from `granlaw_batch_new`.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_account(b: *const Batched) -> granlaw_account {
    // SAFETY: as the caller promises.
    let b = unsafe { &*b };
    let (neighbours, bytes) = (b.batch.neighbours() as u64, b.batch.bytes() as u64);
    granlaw_account { passes: b.passes, contacts: b.batch.contacts(), neighbours, bytes }
}

/// # Safety
/// `b` came from `granlaw_batch_new`; the arrays are LIGGGHTS's own and have the lengths that [`Arrays`] states.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_pass(
    b: *mut Batched,
    arrays: *const granlaw_arrays,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: as the caller promises.
        let (b, a) = unsafe { (&mut *b, handed(&*arrays)) };
        b.passes += 1;
        // SAFETY: as the caller promises.
        match unsafe { b.batch.pass(&a) } {
            Ok(()) => Ok(()),
            Err(Trouble::Arrays(what)) => Err(Failure::misuse(what)),
            Err(Trouble::NonFinite(at)) => {
                // SAFETY: the pass found the indices in the arrays.
                let contact = unsafe { contact(&a, &at) };
                Err(non_finite(b.laws.iter().copied(), &contact))
            }
        }
    })
}

/// The arrays as the pass takes them: positions and the like three by three.
fn handed(a: &granlaw_arrays) -> Arrays {
    Arrays {
        x: a.x.cast(),
        v: a.v.cast(),
        omega: a.omega.cast(),
        f: a.f.cast(),
        torque: a.torque.cast(),
        radius: a.radius,
        mass: a.mass,
        rigid: a.rigid,
        kind: a.type_,
        mask: a.mask,
        tag: a.tag,
        ilist: a.ilist,
        numneigh: a.numneigh,
        neighbours: a.neighbours,
        flags: a.flags,
        history: a.history,
        rows: a.rows,
        all: a.all,
        forced: a.forced,
        row: a.row,
        skin: a.skin,
        dt: a.dt,
        step: a.step,
        frozen: a.frozen,
        update: a.update,
        rebuilt: a.rebuilt,
    }
}

/// What the message about a contact needs of it.
///
/// # Safety
/// The indices are those of particles.
unsafe fn contact(a: &Arrays, at: &NonFinite) -> Contact {
    // SAFETY: as the caller promises.
    let body = |k: usize| Body { tag: i64::from(unsafe { *a.tag.add(k) }), ..Body::default() };
    let mut gap = ClosePair { i: body(at.i), j: body(at.j), ..ClosePair::default() };
    gap.call.step = a.step;
    Contact { close: gap, surface: Surface { deltan: at.deltan, vn: at.vn, ..Surface::default() } }
}
