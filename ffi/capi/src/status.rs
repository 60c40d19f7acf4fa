//! One status, one message per thread, and no panic beyond this point.
use crate::abi::*;
use crate::c_string;
use std::cell::RefCell;
use std::ffi::{c_char, CString};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// Why a call failed.
pub struct Failure {
    status: u32,
    message: String,
}

impl Failure {
    pub fn misuse(what: &str) -> Failure {
        Failure { status: GRANLAW_MISUSE, message: format!("granlaw: misuse of the C interface: {what}") }
    }
    pub fn refused(message: String) -> Failure {
        Failure { status: GRANLAW_REFUSED, message }
    }
    pub fn non_finite(message: String) -> Failure {
        Failure { status: GRANLAW_NON_FINITE, message }
    }
}

thread_local!(static LAST: RefCell<CString> = RefCell::new(CString::default()));

/// The message of the last failure of this thread.
pub fn last_error() -> *const c_char {
    LAST.with(|l| l.borrow().as_ptr())
}

/// Keep the message, return the status.
#[cold]
pub fn fail(f: Failure) -> granlaw_status {
    LAST.with(|l| *l.borrow_mut() = c_string(&f.message));
    f.status as granlaw_status
}

/// Run a body; a panic becomes GRANLAW_BUG.
#[inline]
pub fn boundary(body: impl FnOnce() -> Result<(), Failure>) -> granlaw_status {
    // A half-changed chain is not used again: LIGGGHTS stops on any status but GRANLAW_OK.
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => GRANLAW_OK as granlaw_status,
        Ok(Err(f)) => fail(f),
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            let text = text.or(panic.downcast_ref::<&str>().copied()).unwrap_or("no message");
            let message = format!("granlaw: internal error: {text}; please report it with the deck");
            fail(Failure { status: GRANLAW_BUG, message })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ffi::CStr;

    #[test]
    fn a_panic_becomes_a_status_with_its_text() {
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(|_| {}));
        let status = boundary(|| panic!("slot {}", 3));
        std::panic::set_hook(hook);
        assert_eq!(status as u32, GRANLAW_BUG);
        // SAFETY: last_error points to this thread's message.
        assert!(unsafe { CStr::from_ptr(last_error()) }.to_str().unwrap().contains("slot 3"));
    }
}
