//! Four numbers in a register of AVX2.
use super::{operators, Unit};
use granlaw::lane::Lane;
use std::arch::x86_64::*;
use std::ops::{BitAnd, BitOr, Neg, Not};

/// Four numbers. Only [`super::batch`] may let it be used, after asking the processor for AVX2.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(__m256d);

/// Four truth values: all bits or none.
#[derive(Clone, Copy, Debug)]
pub struct Mask(__m256d);

operators!(Avx2,
    Add add AddAssign add_assign _mm256_add_pd,
    Sub sub SubAssign sub_assign _mm256_sub_pd,
    Mul mul MulAssign mul_assign _mm256_mul_pd,
    Div div DivAssign div_assign _mm256_div_pd);

impl Unit for Avx2 {
    #[inline(always)]
    fn run<R>(work: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx2")]
        fn with<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        // SAFETY: the unit is only chosen where the processor has AVX2.
        unsafe { with(work) }
    }
}

impl Avx2 {
    #[inline(always)]
    fn numbers(&self) -> &[f64; 4] {
        // SAFETY: a register is its four numbers, side by side.
        unsafe { &*std::ptr::from_ref(&self.0).cast() }
    }
}

impl PartialEq for Avx2 {
    fn eq(&self, o: &Self) -> bool {
        self.numbers() == o.numbers()
    }
}

impl Neg for Avx2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_xor_pd(self.0, _mm256_set1_pd(-0.0))) }
    }
}

impl BitAnd for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, o: Self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Mask(_mm256_and_pd(self.0, o.0)) }
    }
}

impl BitOr for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, o: Self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Mask(_mm256_or_pd(self.0, o.0)) }
    }
}

impl Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Mask(_mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))) }
    }
}

impl Lane for Avx2 {
    type Mask = Mask;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_set1_pd(x)) }
    }
    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> f64) -> Self {
        let (a, b, c, d) = (number(0), number(1), number(2), number(3));
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_setr_pd(a, b, c, d)) }
    }
    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        self.numbers()[k]
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_sqrt_pd(self.0)) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)) }
    }
    #[inline(always)]
    fn gt(self, o: Self) -> Mask {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Mask(_mm256_cmp_pd::<_CMP_GT_OQ>(self.0, o.0)) }
    }
    #[inline(always)]
    fn ge(self, o: Self) -> Mask {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Mask(_mm256_cmp_pd::<_CMP_GE_OQ>(self.0, o.0)) }
    }
    #[inline(always)]
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_blendv_pd(no.0, yes.0, mask.0)) }
    }
    #[inline(always)]
    fn any(mask: Mask) -> bool {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { _mm256_movemask_pd(mask.0) != 0 }
    }
}
