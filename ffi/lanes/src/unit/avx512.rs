//! Eight numbers in a register of AVX-512.
use super::avx2::Avx2;
use super::{operators, Unit};
use granlaw::lane::Lane;
use nalgebra::Vector3;
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

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Avx512 {
        // SAFETY: as the caller promises; a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_loadu_pd(from)) }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: as above.
        unsafe { _mm512_storeu_pd(to, self.0) }
    }

    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> *const [f64; 3]) -> Vector3<Avx512> {
        // SAFETY: as above; where the processor has AVX-512 it has AVX2.
        unsafe { joined(&Avx2::gather(&at), &Avx2::gather(|k| at(k + 4))) }
    }

    #[inline(always)]
    unsafe fn differences(
        of: impl Fn(usize) -> *const [f64; 3],
        less: impl Fn(usize) -> *const [f64; 3],
    ) -> Vector3<Avx512> {
        // SAFETY: as above.
        unsafe { joined(&Avx2::differences(&of, &less), &Avx2::differences(|k| of(k + 4), |k| less(k + 4))) }
    }

    #[inline(always)]
    unsafe fn scatter(v: &Vector3<Avx512>, to: impl Fn(usize) -> *mut [f64; 3]) {
        // SAFETY: as above.
        unsafe {
            let half = |x: Avx512| Avx2(_mm512_castpd512_pd256(x.0));
            Avx2::scatter(&Vector3::new(half(v.x), half(v.y), half(v.z)), &to);
            let half = |x: Avx512| Avx2(_mm512_extractf64x4_pd::<1>(x.0));
            Avx2::scatter(&Vector3::new(half(v.x), half(v.y), half(v.z)), |k| to(k + 4));
        }
    }

    #[inline(always)]
    fn bits(mask: __mmask8) -> u32 {
        mask.into()
    }

    #[inline(always)]
    fn first(self, bits: u32) -> Avx512 {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { Avx512(_mm512_maskz_compress_pd(bits as __mmask8, self.0)) }
    }
}

/// Two halves side by side.
///
/// # Safety
/// The processor has AVX-512.
#[inline(always)]
unsafe fn joined(a: &Vector3<Avx2>, b: &Vector3<Avx2>) -> Vector3<Avx512> {
    // SAFETY: as the caller promises.
    let join =
        |a: Avx2, b: Avx2| unsafe { Avx512(_mm512_insertf64x4::<1>(_mm512_castpd256_pd512(a.0), b.0)) };
    Vector3::new(join(a.x, b.x), join(a.y, b.y), join(a.z, b.z))
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
