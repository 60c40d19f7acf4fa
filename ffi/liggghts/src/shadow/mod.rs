//! Holds what the C++ half sees of all chains against the Rust laws. The structs are those of `cpp/boundary.h`.
use crate::boundary::{granlaw_recorded_call, granlaw_recorded_chain, granlaw_text};
use crate::recorder::{fill, header, text};
use granlaw_capi::abi::granlaw_status;
use granlaw_capi::convert::slice;
use granlaw_capi::status::{boundary, Failure};
use granlaw_lanes::Width;
use granlaw_tools::shadow::{Session, Shadow};
use granlaw_tools::trace::Row;
use lanes::Lanes;
use std::ffi::c_char;

mod lanes;

/// What this rank has seen; empty once it is packed.
pub struct Shadowing {
    session: Option<Session>,
    chains: Vec<Chain>,
    /// How many contacts of a pair style go side by side; `None` for one after the other.
    width: Option<Width>,
    row: Row,
}

#[derive(Default)]
struct Chain {
    slots: usize,
    /// Where pairs go through the batched pass.
    lanes: Option<Lanes>,
}

fn over() -> Failure {
    Failure::misuse("the shadow is packed already")
}

/// Pairs go through the batched pass, as they do in a run on the Rust laws, unless `contact` says one after the other.
#[no_mangle]
unsafe extern "C" fn granlaw_shadow_new(
    lanes: *const c_char,
    contact: bool,
    out: *mut *mut Shadowing,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives a C string and a valid pointer.
        let (lanes, out) = unsafe { (text(lanes), &mut *out) };
        let width = Width::named(&lanes).map_err(Failure::refused)?;
        let (session, chains, width) = (Some(Session::default()), Vec::new(), (!contact).then_some(width));
        *out = Box::into_raw(Box::new(Shadowing { session, chains, width, row: Row::default() }));
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_chain(
    s: *mut Shadowing,
    c: *const granlaw_recorded_chain,
    out: *mut usize,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, header, out) = unsafe { (&mut *s, header(&*c)?, &mut *out) };
        s.flush()?;
        let (slots, width) = (header.slots.len(), s.width.filter(|_| header.who == "pair"));
        let lanes = match width {
            Some(w) => Lanes::new(&header, w).map_err(|e| Failure::refused(e.to_string()))?,
            None => None,
        };
        let session = s.session.as_mut().ok_or_else(over)?;
        *out = session.chain(header);
        if let (Some(w), true) = (width, lanes.is_some()) {
            session.side_by_side(*out, w.name());
        }
        s.chains.resize_with(s.chains.len().max(*out + 1), Chain::default);
        s.chains[*out] = Chain { slots, lanes };
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_call(
    s: *mut Shadowing,
    chain: usize,
    c: *const granlaw_recorded_call,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, c) = unsafe { (&mut *s, &*c) };
        let own = s.chains.get_mut(chain).ok_or(Failure::misuse("no such chain"))?;
        // SAFETY: as above; before and after have one number per slot.
        let (pass, contact) = unsafe {
            fill(c, own.slots, &mut s.row);
            (&*c.pass, &*c.contact)
        };
        let session = s.session.as_mut().ok_or_else(over)?;
        let close = &contact.close;
        match &mut own.lanes {
            // As in a run on the Rust laws, queries go one after the other.
            Some(lanes) if s.row.touch && close.computeflag != 0 && session.compares(chain) => {
                // SAFETY: i and j are places in LIGGGHTS's arrays.
                let mask = |k: i32| if pass.frozen == 0 { 0 } else { unsafe { *pass.mask.add(k as usize) } };
                let (mass, mask) = ([contact.mi, contact.mj], [mask(close.i), mask(close.j)]);
                lanes.push(session, chain, &mut s.row, mass, mask, pass.frozen);
            }
            _ => session.call(chain, &s.row, if close.is_wall { close.area_ratio } else { 1.0 }),
        }
        Ok(())
    })
}

impl Shadowing {
    /// What still waits for its pass.
    fn flush(&mut self) -> Result<(), Failure> {
        let session = self.session.as_mut().ok_or_else(over)?;
        for (at, chain) in self.chains.iter_mut().enumerate() {
            if let Some(lanes) = &mut chain.lanes {
                lanes.flush(session, at);
            }
        }
        Ok(())
    }
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_pack(s: *mut Shadowing, out: *mut granlaw_text) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers.
        let (s, out) = unsafe { (&mut *s, &mut *out) };
        s.flush()?;
        let session = s.session.take().ok_or_else(over)?;
        *out = granlaw_text::json(&session.finish())?;
        Ok(())
    })
}

#[no_mangle]
unsafe extern "C" fn granlaw_shadow_tell(
    ranks: *const granlaw_text,
    n: usize,
    tolerance: f64,
    words: *mut granlaw_text,
    status: *mut i32,
) -> granlaw_status {
    boundary(|| {
        // SAFETY: the C++ half gives valid pointers and as many texts as ranks.
        let (texts, words, status) = unsafe { (slice(ranks, n), &mut *words, &mut *status) };
        // SAFETY: as above.
        let whole: Shadow = unsafe { granlaw_text::merged(texts, Shadow::merge) }?;
        *words = granlaw_text::kept(whole.text(tolerance).into_bytes());
        *status = whole.verdict(tolerance).exit_code().into();
        Ok(())
    })
}
