//! Eight numbers in a register of AVX-512.
use super::{operators, Unit};
use granlaw::lane::Lane;
use std::arch::x86_64::*;
use std::ops::Neg;

/// Eight numbers. Only [`super::batch`] may let it be used, after asking the processor for AVX-512.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(__m512d);

operators!(Avx512,
    Add add AddAssign add_assign _mm512_add_pd,
    Sub sub SubAssign sub_assign _mm512_sub_pd,
    Mul mul MulAssign mul_assign _mm512_mul_pd,
    Div div DivAssign div_assign _mm512_div_pd);

impl Unit for Avx512 {
    #[inline(always)]
    fn run<R>(work: impl FnOnce() -> R) -> R {
        #[target_feature(enable = "avx512f,avx2")]
        fn with<R>(work: impl FnOnce() -> R) -> R {
            work()
        }
        // SAFETY: the unit is only chosen where the processor has AVX-512.
        unsafe { with(work) }
    }
}

impl Avx512 {
    #[inline(always)]
    fn numbers(&self) -> &[f64; 8] {
        // SAFETY: a register is its eight numbers, side by side.
        unsafe { &*std::ptr::from_ref(&self.0).cast() }
    }
}

impl PartialEq for Avx512 {
    fn eq(&self, o: &Self) -> bool {
        self.numbers() == o.numbers()
    }
}

impl Neg for Avx512 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe {
            let sign = _mm512_set1_epi64(i64::MIN);
            Avx512(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), sign)))
        }
    }
}

impl Lane for Avx512 {
    /// One bit per lane.
    type Mask = __mmask8;
    const WIDTH: usize = 8;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_set1_pd(x)) }
    }
    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> f64) -> Self {
        let [a, b, c, d, e, f, g, h]: [f64; 8] =
            [number(0), number(1), number(2), number(3), number(4), number(5), number(6), number(7)];
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_setr_pd(a, b, c, d, e, f, g, h)) }
    }
    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        self.numbers()[k]
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_sqrt_pd(self.0)) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_abs_pd(self.0)) }
    }
    #[inline(always)]
    fn gt(self, o: Self) -> __mmask8 {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, o.0) }
    }
    #[inline(always)]
    fn ge(self, o: Self) -> __mmask8 {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { _mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, o.0) }
    }
    #[inline(always)]
    fn select(mask: __mmask8, yes: Self, no: Self) -> Self {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_mask_blend_pd(mask, no.0, yes.0)) }
    }
    #[inline(always)]
    fn any(mask: __mmask8) -> bool {
        mask != 0
    }
}
