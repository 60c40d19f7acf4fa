//! The batched pass behind C. The structs are those of `cpp/batch.hpp`, field by field.
use granlaw::law::{Body, Contact, Gap, Meta, Surface};
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

/// What a chain did so far, and what it needs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Account {
    passes: u64,
    contacts: u64,
    neighbours: u64,
    bytes: u64,
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
pub unsafe extern "C" fn granlaw_batch_account(b: *const Batched) -> Account {
    // SAFETY: as the caller promises.
    let b = unsafe { &*b };
    let (neighbours, bytes) = (b.batch.neighbours() as u64, b.batch.bytes() as u64);
    Account { passes: b.passes, contacts: b.batch.contacts(), neighbours, bytes }
}

/// # Safety
/// `b` came from `granlaw_batch_new`; the arrays are LIGGGHTS's own and have the lengths that [`Arrays`] states.
#[no_mangle]
pub unsafe extern "C" fn granlaw_batch_pass(b: *mut Batched, arrays: *const Arrays) -> granlaw_status {
    boundary(|| {
        // SAFETY: as the caller promises.
        let (b, a) = unsafe { (&mut *b, &*arrays) };
        b.passes += 1;
        // SAFETY: as the caller promises.
        match unsafe { b.batch.pass(a) } {
            Ok(()) => Ok(()),
            Err(Trouble::Arrays(what)) => Err(Failure::misuse(what)),
            Err(Trouble::NonFinite(at)) => {
                // SAFETY: the pass found the indices in the arrays.
                let contact = unsafe { contact(a, &at) };
                Err(non_finite(b.laws.iter().copied(), &contact))
            }
        }
    })
}

/// What the message about a contact needs of it.
///
/// # Safety
/// The indices are those of particles.
unsafe fn contact(a: &Arrays, at: &NonFinite) -> Contact {
    // SAFETY: as the caller promises.
    let body = |k: usize| Body { tag: i64::from(unsafe { *a.tag.add(k) }), ..Body::default() };
    let mut gap = Gap { i: body(at.i), j: body(at.j), ..Gap::default() };
    gap.call.step = a.step;
    Contact { gap, surface: Surface { deltan: at.deltan, vn: at.vn, ..Surface::default() } }
}
