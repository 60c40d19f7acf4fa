//! The vector units of this machine, and which of them is used.
use granlaw::lane::{Lane, Pack};
use nalgebra::Vector3;

#[cfg(target_arch = "x86_64")]
pub(crate) mod avx2;
#[cfg(target_arch = "x86_64")]
pub(crate) mod avx512;
#[cfg(test)]
mod tests;

/// A lane with the instructions that it needs.
pub(crate) trait Unit: Lane {
    /// Run `work`, compiled for the unit. Everything in it that handles lanes must be inlined into it.
    fn run<R>(work: impl FnOnce() -> R) -> R {
        work()
    }

    /// The numbers from here on, one per lane.
    ///
    /// # Safety
    /// They can be read.
    #[inline(always)]
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: as the caller promises.
        Self::from_fn(|k| unsafe { *from.add(k) })
    }

    /// Write the lanes from here on.
    ///
    /// # Safety
    /// They can be written.
    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        for k in 0..Self::WIDTH {
            // SAFETY: as the caller promises.
            unsafe { *to.add(k) = self.lane(k) };
        }
    }

    /// Three numbers per lane, side by side.
    ///
    /// # Safety
    /// All places can be read.
    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> *const [f64; 3]) -> Vector3<Self> {
        // SAFETY: as the caller promises.
        let number = |k: usize, c: usize| unsafe { (*at(k))[c] };
        let side_by_side = |c: usize| Self::from_fn(|k| number(k, c));
        Vector3::new(side_by_side(0), side_by_side(1), side_by_side(2))
    }

    /// The numbers at one place less those at another.
    ///
    /// # Safety
    /// All places can be read.
    #[inline(always)]
    unsafe fn differences(
        of: impl Fn(usize) -> *const [f64; 3],
        less: impl Fn(usize) -> *const [f64; 3],
    ) -> Vector3<Self> {
        // SAFETY: as the caller promises.
        unsafe { Self::gather(of) - Self::gather(less) }
    }

    /// Write three numbers of each lane.
    ///
    /// # Safety
    /// All places can be written.
    #[inline(always)]
    unsafe fn scatter(v: &Vector3<Self>, to: impl Fn(usize) -> *mut [f64; 3]) {
        for k in 0..Self::WIDTH {
            // SAFETY: as the caller promises.
            unsafe { *to(k) = [v.x.lane(k), v.y.lane(k), v.z.lane(k)] };
        }
    }

    /// A bit per lane.
    #[inline(always)]
    fn bits(mask: Self::Mask) -> u32 {
        let ones = Self::select(mask, Self::splat(1.0), Self::splat(0.0));
        (0..Self::WIDTH).fold(0, |bits, k| bits | u32::from(ones.lane(k) > 0.0) << k)
    }

    /// The lanes whose bits are set, moved to the front; what follows them means nothing.
    #[inline(always)]
    fn first(self, bits: u32) -> Self {
        let mut numbers = [0.0; 8];
        let mut n = 0;
        for k in 0..Self::WIDTH {
            numbers[n] = self.lane(k);
            n += (bits >> k & 1) as usize;
        }
        Self::from_fn(|k| numbers[k])
    }
}

impl Unit for f64 {
    #[inline(always)]
    fn bits(mask: bool) -> u32 {
        mask.into()
    }
    #[inline(always)]
    fn first(self, _: u32) -> f64 {
        self
    }
}
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
            "" | "widest" => Ok(Width::widest()),
            "1" => Ok(Width::One),
            "4" => Ok(Width::Four),
            "8" => Ok(Width::Eight),
            _ => Err(format!("GRANLAW_LANES={lanes} must be 1, 4, 8 or widest")),
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
pub(crate) fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2")
}
#[cfg(target_arch = "x86_64")]
pub(crate) fn has_avx512() -> bool {
    is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx2")
}
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn has_avx2() -> bool {
    false
}
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn has_avx512() -> bool {
    false
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
