//! Text between the halves: what a rank has to say at its end. The struct is that of `cpp/boundary.h`.
use crate::boundary::granlaw_text;
use granlaw_capi::convert::slice;
use granlaw_capi::status::Failure;
use serde::de::DeserializeOwned;
use serde::Serialize;

impl granlaw_text {
    /// The process is about to end, so it is never freed.
    pub fn kept(text: Vec<u8>) -> granlaw_text {
        let text: &'static [u8] = text.leak();
        granlaw_text { bytes: text.as_ptr().cast(), length: text.len() }
    }

    pub fn json<T: Serialize>(what: &T) -> Result<granlaw_text, Failure> {
        let text = serde_json::to_vec(what);
        text.map(granlaw_text::kept).map_err(|e| Failure::refused(format!("what this rank saw: {e}")))
    }

    /// What all ranks saw, as one.
    ///
    /// # Safety
    /// The texts lead to as many bytes as they say.
    pub unsafe fn merged<T: DeserializeOwned>(
        ranks: &[granlaw_text],
        merge: fn(&mut T, T),
    ) -> Result<T, Failure> {
        let mut whole: Option<T> = None;
        for t in ranks {
            // SAFETY: as the caller promises.
            let part: T = serde_json::from_slice(unsafe { slice(t.bytes.cast(), t.length) })
                .map_err(|e| Failure::refused(format!("what a rank saw: {e}")))?;
            match &mut whole {
                Some(w) => merge(w, part),
                None => whole = Some(part),
            }
        }
        whole.ok_or_else(|| Failure::misuse("no rank"))
    }
}
