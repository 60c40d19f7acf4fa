//! Numbers that a law's hot function is written in: one `f64`, or several side by side.
//!
//! A law written once over [`Lane`] is the same expression tree for every width, so the scalar and the batched
//! answers agree to the last bit: no operation here may be fused, reordered or approximated.
//!
//! Whatever is written over lanes is inlined to the last: a vector unit's instructions can only be used inside a
//! function that was compiled for it. Hence [`cross`] and [`each`], which nalgebra's own need not be.
use nalgebra::Vector3;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// One number per contact, for as many contacts as the lane is wide.
pub trait Lane:
    Copy
    + Debug
    + PartialEq
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// One truth value per contact.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// Number of lanes.
    const WIDTH: usize;

    /// The same number in every lane.
    fn splat(x: f64) -> Self;
    /// A number for each lane.
    fn from_fn(number: impl Fn(usize) -> f64) -> Self;
    /// The number in lane `k`, which must be below [`Lane::WIDTH`], read where it lies.
    fn lane(&self, k: usize) -> f64;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// `self` to the power `e`, lane by lane with the system's `pow`, so that the bits are those of C.
    #[inline(always)]
    fn powf(self, e: f64) -> Self {
        Self::from_fn(
            #[inline(always)]
            |k| self.lane(k).powf(e),
        )
    }
    /// `self > other`, false where either is NaN.
    fn gt(self, other: Self) -> Self::Mask;
    /// `self >= other`, false where either is NaN.
    fn ge(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Whether the mask holds anywhere.
    fn any(mask: Self::Mask) -> bool;
}

impl Lane for f64 {
    type Mask = bool;
    const WIDTH: usize = 1;
    #[inline(always)]
    fn splat(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> f64) -> f64 {
        number(0)
    }
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline(always)]
    fn gt(self, other: f64) -> bool {
        self > other
    }
    #[inline(always)]
    fn ge(self, other: f64) -> bool {
        self >= other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask {
            yes
        } else {
            no
        }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
}

/// Numbers of one contact that can be put side by side, one set per lane. `#[derive(Lanes)]` writes it for a struct of
/// numbers, switches and other such structs; switches come from the first lane, as they are the same in a chain.
pub trait Lanes: Copy {
    /// The same with a lane in place of each number.
    type Of<L: Lane>: Copy;
    /// The numbers of all lanes, from those of contact `k` for each lane `k`.
    fn side_by_side<L: Lane>(of: impl Fn(usize) -> Self) -> Self::Of<L>;
}

pub use granlaw_derive::Lanes;

impl Lanes for () {
    type Of<L: Lane> = ();
    #[inline(always)]
    fn side_by_side<L: Lane>(_: impl Fn(usize)) {}
}

impl<const N: usize> Lanes for [f64; N] {
    type Of<L: Lane> = [L; N];
    #[inline(always)]
    fn side_by_side<L: Lane>(of: impl Fn(usize) -> Self) -> [L; N] {
        let mut all = [L::splat(0.0); N];
        // Adaptors of iterators are not inlined into code for a vector unit.
        let mut n = 0;
        while n < N {
            all[n] = L::from_fn(
                #[inline(always)]
                |k| of(k)[n],
            );
            n += 1;
        }
        all
    }
}

/// One contact in single precision, for those who ask what it would do.
impl Lane for f32 {
    type Mask = bool;
    const WIDTH: usize = 1;
    #[inline(always)]
    fn splat(x: f64) -> f32 {
        x as f32
    }
    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> f64) -> f32 {
        number(0) as f32
    }
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        (*self).into()
    }
    #[inline(always)]
    fn sqrt(self) -> f32 {
        f32::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f32 {
        f32::abs(self)
    }
    #[inline(always)]
    fn gt(self, other: f32) -> bool {
        self > other
    }
    #[inline(always)]
    fn ge(self, other: f32) -> bool {
        self >= other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f32, no: f32) -> f32 {
        if mask {
            yes
        } else {
            no
        }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
}

/// The zero vector.
#[inline(always)]
pub fn zero<L: Lane>() -> Vector3<L> {
    Vector3::new(L::splat(0.0), L::splat(0.0), L::splat(0.0))
}

/// `a·b`, summed in the order x, y, z.
#[inline(always)]
pub fn dot<L: Lane>(a: &Vector3<L>, b: &Vector3<L>) -> L {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// `|a|`.
#[inline(always)]
pub fn norm<L: Lane>(a: &Vector3<L>) -> L {
    dot(a, a).sqrt()
}

/// `a × b`.
#[inline(always)]
pub fn cross<L: Lane>(a: &Vector3<L>, b: &Vector3<L>) -> Vector3<L> {
    Vector3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}

/// `f` of each component.
#[inline(always)]
pub fn each<L: Lane>(v: &Vector3<L>, f: impl Fn(L) -> L) -> Vector3<L> {
    Vector3::new(f(v.x), f(v.y), f(v.z))
}

/// Component by component, `yes` where the mask holds.
#[inline(always)]
pub fn select3<L: Lane>(mask: L::Mask, yes: Vector3<L>, no: Vector3<L>) -> Vector3<L> {
    let pick = |y, n| L::select(mask, y, n);
    Vector3::new(pick(yes.x, no.x), pick(yes.y, no.y), pick(yes.z, no.z))
}

/// `N` contacts side by side in plain Rust: the reference for the vector units, and their stand-in elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pack<const N: usize>(pub [f64; N]);

/// The truth values of a [`Pack`].
#[derive(Clone, Copy, Debug)]
pub struct PackMask<const N: usize>([bool; N]);

impl<const N: usize> Pack<N> {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Pack(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
    #[inline(always)]
    fn test(self, other: Self, f: impl Fn(f64, f64) -> bool) -> PackMask<N> {
        PackMask(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl<const N: usize> Add for Pack<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        self.with(o, |a, b| a + b)
    }
}
impl<const N: usize> Sub for Pack<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        self.with(o, |a, b| a - b)
    }
}
impl<const N: usize> Mul for Pack<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        self.with(o, |a, b| a * b)
    }
}
impl<const N: usize> Div for Pack<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, o: Self) -> Self {
        self.with(o, |a, b| a / b)
    }
}
impl<const N: usize> Neg for Pack<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Pack(self.0.map(|a| -a))
    }
}
impl<const N: usize> AddAssign for Pack<N> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<const N: usize> SubAssign for Pack<N> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
impl<const N: usize> MulAssign for Pack<N> {
    #[inline(always)]
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}
impl<const N: usize> DivAssign for Pack<N> {
    #[inline(always)]
    fn div_assign(&mut self, o: Self) {
        *self = *self / o;
    }
}
impl<const N: usize> BitAnd for PackMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, o: Self) -> Self {
        PackMask(std::array::from_fn(|k| self.0[k] & o.0[k]))
    }
}
impl<const N: usize> BitOr for PackMask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, o: Self) -> Self {
        PackMask(std::array::from_fn(|k| self.0[k] | o.0[k]))
    }
}
impl<const N: usize> Not for PackMask<N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        PackMask(self.0.map(|a| !a))
    }
}

impl<const N: usize> Lane for Pack<N> {
    type Mask = PackMask<N>;
    const WIDTH: usize = N;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Pack([x; N])
    }
    #[inline(always)]
    fn from_fn(number: impl Fn(usize) -> f64) -> Self {
        Pack(std::array::from_fn(number))
    }
    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        self.0[k]
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Pack(self.0.map(f64::sqrt))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Pack(self.0.map(f64::abs))
    }
    #[inline(always)]
    fn gt(self, other: Self) -> PackMask<N> {
        self.test(other, |a, b| a > b)
    }
    #[inline(always)]
    fn ge(self, other: Self) -> PackMask<N> {
        self.test(other, |a, b| a >= b)
    }
    #[inline(always)]
    fn select(mask: PackMask<N>, yes: Self, no: Self) -> Self {
        Pack(std::array::from_fn(|k| if mask.0[k] { yes.0[k] } else { no.0[k] }))
    }
    #[inline(always)]
    fn any(mask: PackMask<N>) -> bool {
        mask.0.iter().any(|m| *m)
    }
}
