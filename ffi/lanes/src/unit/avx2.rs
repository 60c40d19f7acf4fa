//! Four numbers in a register of AVX2.
use super::{operators, Unit};
use granlaw::lane::Lane;
use nalgebra::Vector3;
use std::arch::x86_64::*;
use std::ops::{BitAnd, BitOr, Neg, Not};

/// Four numbers. Only [`super::batch`] may let it be used, after asking the processor for AVX2.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(pub(super) __m256d);

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

    #[inline(always)]
    unsafe fn load(from: *const f64) -> Avx2 {
        // SAFETY: as the caller promises; a unit is only chosen where the processor has it.
        unsafe { Avx2(_mm256_loadu_pd(from)) }
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: as above.
        unsafe { _mm256_storeu_pd(to, self.0) }
    }

    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> *const [f64; 3]) -> Vector3<Avx2> {
        // SAFETY: as above.
        unsafe { turned([row(at(0)), row(at(1)), row(at(2)), row(at(3))]) }
    }

    #[inline(always)]
    unsafe fn differences(
        of: impl Fn(usize) -> *const [f64; 3],
        less: impl Fn(usize) -> *const [f64; 3],
    ) -> Vector3<Avx2> {
        // SAFETY: as above.
        unsafe {
            let d = |k: usize| _mm256_sub_pd(row(of(k)), row(less(k)));
            turned([d(0), d(1), d(2), d(3)])
        }
    }

    #[inline(always)]
    unsafe fn scatter(v: &Vector3<Avx2>, to: impl Fn(usize) -> *mut [f64; 3]) {
        // SAFETY: as above.
        unsafe {
            let (even, odd) = (_mm256_unpacklo_pd(v.x.0, v.y.0), _mm256_unpackhi_pd(v.x.0, v.y.0));
            let (low, high) = (_mm256_castpd256_pd128(v.z.0), _mm256_extractf128_pd::<1>(v.z.0));
            let at = |k: usize| to(k).cast::<f64>();
            _mm_storeu_pd(at(0), _mm256_castpd256_pd128(even));
            _mm_storel_pd(at(0).add(2), low);
            _mm_storeu_pd(at(1), _mm256_castpd256_pd128(odd));
            _mm_storeh_pd(at(1).add(2), low);
            _mm_storeu_pd(at(2), _mm256_extractf128_pd::<1>(even));
            _mm_storel_pd(at(2).add(2), high);
            _mm_storeu_pd(at(3), _mm256_extractf128_pd::<1>(odd));
            _mm_storeh_pd(at(3).add(2), high);
        }
    }

    #[inline(always)]
    fn bits(mask: Mask) -> u32 {
        // SAFETY: a unit is only chosen where the processor has it.
        unsafe { _mm256_movemask_pd(mask.0) as u32 }
    }

    #[inline(always)]
    fn first(self, bits: u32) -> Avx2 {
        // SAFETY: as above; the table has a row for each of the 16 sets of four bits.
        unsafe {
            let order = _mm256_load_si256(FIRST.0.as_ptr().add((bits & 15) as usize).cast());
            Avx2(_mm256_castsi256_pd(_mm256_permutevar8x32_epi32(_mm256_castpd_si256(self.0), order)))
        }
    }
}

/// For each set of lanes the order that brings them to the front, in halves of lanes.
static FIRST: First = First(first());

#[repr(align(32))]
struct First([[u32; 8]; 16]);

const fn first() -> [[u32; 8]; 16] {
    let mut table = [[0; 8]; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut n, mut k) = (0, 0);
        while k < 4 {
            if bits >> k & 1 == 1 {
                table[bits][2 * n] = 2 * k;
                table[bits][2 * n + 1] = 2 * k + 1;
                n += 1;
            }
            k += 1;
        }
        bits += 1;
    }
    table
}

/// Three numbers; the fourth is not touched.
///
/// # Safety
/// They can be read, and the processor has AVX2.
#[inline(always)]
unsafe fn row(from: *const [f64; 3]) -> __m256d {
    // SAFETY: as the caller promises.
    unsafe { _mm256_maskload_pd(from.cast(), _mm256_setr_epi64x(-1, -1, -1, 0)) }
}

/// Rows turned into columns.
///
/// # Safety
/// The processor has AVX2.
#[inline(always)]
unsafe fn turned([a, b, c, d]: [__m256d; 4]) -> Vector3<Avx2> {
    // SAFETY: as the caller promises.
    unsafe {
        let (ab, cd) = (_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d));
        let y = (_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d));
        Vector3::new(
            Avx2(_mm256_permute2f128_pd::<0x20>(ab, cd)),
            Avx2(_mm256_permute2f128_pd::<0x20>(y.0, y.1)),
            Avx2(_mm256_permute2f128_pd::<0x31>(ab, cd)),
        )
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
