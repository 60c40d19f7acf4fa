//! The vector units of this machine, and which of them is used.
use crate::pass::Pass;
use crate::Batch;
use granlaw::lane::{Lane, Pack};
use granlaw::law::{LawError, Setup};

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;

/// A lane with the instructions that it needs.
pub(crate) trait Unit: Lane {
    /// Run `work`, compiled for the unit. Everything in it that handles lanes must be inlined into it.
    fn run<R>(work: impl FnOnce() -> R) -> R {
        work()
    }
}

impl Unit for f64 {}
impl<const N: usize> Unit for Pack<N> {}

/// How many contacts go side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// One at a time.
    One,
    /// Four: AVX2, or plain code where the processor lacks it.
    Four,
    /// Eight: AVX-512, or plain code where the processor lacks it.
    Eight,
}

impl Width {
    /// As many as this processor has registers for.
    pub fn widest() -> Width {
        match () {
            _ if has_avx512() => Width::Eight,
            _ if has_avx2() => Width::Four,
            _ => Width::One,
        }
    }

    /// The width that `GRANLAW_LANES` names; the widest where it is empty.
    ///
    /// # Errors
    /// It names none.
    pub fn named(lanes: &str) -> Result<Width, String> {
        match lanes {
            "" => Ok(Width::widest()),
            "1" => Ok(Width::One),
            "4" => Ok(Width::Four),
            "8" => Ok(Width::Eight),
            _ => Err(format!("GRANLAW_LANES={lanes} must be 1, 4 or 8")),
        }
    }

    /// What people call it.
    pub fn name(self) -> &'static str {
        match self {
            Width::One => "one contact at a time",
            Width::Four if has_avx2() => "4 contacts at a time, AVX2",
            Width::Four => "4 contacts at a time, plain code",
            Width::Eight if has_avx512() => "8 contacts at a time, AVX-512",
            Width::Eight => "8 contacts at a time, plain code",
        }
    }
}

#[cfg(target_arch = "x86_64")]
fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2")
}
#[cfg(target_arch = "x86_64")]
fn has_avx512() -> bool {
    is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx2")
}
#[cfg(not(target_arch = "x86_64"))]
fn has_avx2() -> bool {
    false
}
#[cfg(not(target_arch = "x86_64"))]
fn has_avx512() -> bool {
    false
}

/// See [`crate::batch`]. The only place that chooses a unit, after asking the processor for it.
pub(crate) fn batch(
    setups: &[Setup],
    offsets: &[usize],
    width: Width,
) -> Result<Option<Box<dyn Batch>>, LawError> {
    match width {
        Width::One => Pass::<f64>::boxed(setups, offsets),
        #[cfg(target_arch = "x86_64")]
        Width::Four if has_avx2() => Pass::<avx2::Avx2>::boxed(setups, offsets),
        #[cfg(target_arch = "x86_64")]
        Width::Eight if has_avx512() => Pass::<avx512::Avx512>::boxed(setups, offsets),
        Width::Four => Pass::<Pack<4>>::boxed(setups, offsets),
        Width::Eight => Pass::<Pack<8>>::boxed(setups, offsets),
    }
}

/// The operators of a unit from its instructions.
#[cfg(target_arch = "x86_64")]
macro_rules! operators {
    ($unit:ident, $($op:ident $f:ident $assign:ident $g:ident $instruction:ident),+) => {
        $(
            impl std::ops::$op for $unit {
                type Output = Self;
                #[inline(always)]
                fn $f(self, o: Self) -> Self {
                    // SAFETY: a unit is only chosen where the processor has it.
                    unsafe { $unit($instruction(self.0, o.0)) }
                }
            }
            impl std::ops::$assign for $unit {
                #[inline(always)]
                fn $g(&mut self, o: Self) {
                    *self = std::ops::$op::$f(*self, o);
                }
            }
        )+
    };
}
#[cfg(target_arch = "x86_64")]
use operators;
