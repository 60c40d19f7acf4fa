//! Holds what the C++ half sees of all chains against the Rust laws. The structs are those of `cpp/recorder.hpp` and
//! `cpp/shadow.hpp`.
use crate::recorder::{fill, header, RecordedCall, RecordedChain};
use crate::text::Text;
use granlaw::shadow::{Session, Shadow};
use granlaw::trace::Row;
use granlaw_capi::abi::granlaw_status;
use granlaw_capi::convert::slice;
use granlaw_capi::status::{boundary, Failure};

/// What this rank has seen; empty once it is packed.
#[derive(Default)]
pub struct Shadowing {
    session: Option<Session>,
    /// The number of history slots of each chain.
    slots: Vec<usize>,
    row: Row,
}

impl Shadowing {
    fn session(&mut self) -> Result<&mut Session, Failure> {
        self.session.as_mut().ok_or(Failure::misuse("the shadow is packed already"))
    }
}

#[no_mangle]
extern "C" fn granlaw_shadow_new() -> *mut Shadowing {
    Box::into_raw(Box::new(Shadowing { session: Some(Session::default()), ..Shadowing::default() }))
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_chain(
    s: *mut Shadowing,
    c: *const RecordedChain,
    out: *mut usize,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, header, out) = unsafe { (&mut *s, header(&*c)?, &mut *out) };
        let slots = header.slots.len();
        *out = s.session()?.chain(header);
        s.slots.resize(s.slots.len().max(*out + 1), 0);
        s.slots[*out] = slots;
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_call(
    s: *mut Shadowing,
    chain: usize,
    c: *const RecordedCall,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, c) = unsafe { (&mut *s, &*c) };
        // SAFETY: as above; before and after have one number per slot.
        let close = unsafe {
            fill(c, s.slots[chain], &mut s.row);
            &(*c.contact).close
        };
        let share = if close.is_wall { close.area_ratio } else { 1.0 };
        let session = s.session.as_mut().ok_or(Failure::misuse("the shadow is packed already"))?;
        session.call(chain, &s.row, share);
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_pack(s: *mut Shadowing, out: *mut Text) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, out) = unsafe { (&mut *s, &mut *out) };
        let session = s.session.take().ok_or(Failure::misuse("the shadow is packed already"))?;
        *out = Text::json(&session.finish())?;
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_tell(
    ranks: *const Text,
    n: usize,
    tolerance: f64,
    words: *mut Text,
    status: *mut i32,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers and as many texts as ranks.
        let (texts, words, status) = unsafe { (slice(ranks, n), &mut *words, &mut *status) };
        // SAFETY: as above.
        let whole: Shadow = unsafe { Text::merged(texts, Shadow::merge) }?;
        *words = Text::kept(whole.text(tolerance).into_bytes());
        *status = whole.verdict(tolerance).exit_code().into();
        Ok(())
    })
}
