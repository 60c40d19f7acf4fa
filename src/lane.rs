//! Numbers that a law's hot function is written in: one `f64`, or several side by side.
//!
//! A law written once over [`Lane`] is the same expression tree for every width, so the scalar and the batched
//! answers agree to the last bit: no operation here may be fused, reordered or approximated.
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
    /// The number in lane `k`, which must be below [`Lane::WIDTH`].
    fn lane(self, k: usize) -> f64;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
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
    fn splat(x: f64) -> f64 {
        x
    }
    fn from_fn(number: impl Fn(usize) -> f64) -> f64 {
        number(0)
    }
    fn lane(self, _: usize) -> f64 {
        self
    }
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    fn gt(self, other: f64) -> bool {
        self > other
    }
    fn ge(self, other: f64) -> bool {
        self >= other
    }
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask {
            yes
        } else {
            no
        }
    }
    fn any(mask: bool) -> bool {
        mask
    }
}

/// The zero vector.
pub fn zero<L: Lane>() -> Vector3<L> {
    Vector3::new(L::splat(0.0), L::splat(0.0), L::splat(0.0))
}

/// `a·b`, summed in the order x, y, z.
pub fn dot<L: Lane>(a: &Vector3<L>, b: &Vector3<L>) -> L {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// `|a|`.
pub fn norm<L: Lane>(a: &Vector3<L>) -> L {
    dot(a, a).sqrt()
}

/// Component by component, `yes` where the mask holds.
pub fn select3<L: Lane>(mask: L::Mask, yes: Vector3<L>, no: Vector3<L>) -> Vector3<L> {
    yes.zip_map(&no, |y, n| L::select(mask, y, n))
}

/// `N` contacts side by side in plain Rust: the reference for the vector units, and their stand-in elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pack<const N: usize>(pub [f64; N]);

/// The truth values of a [`Pack`].
#[derive(Clone, Copy, Debug)]
pub struct PackMask<const N: usize>([bool; N]);

impl<const N: usize> Pack<N> {
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Pack(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
    fn test(self, other: Self, f: impl Fn(f64, f64) -> bool) -> PackMask<N> {
        PackMask(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl<const N: usize> Add for Pack<N> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        self.with(o, |a, b| a + b)
    }
}
impl<const N: usize> Sub for Pack<N> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self.with(o, |a, b| a - b)
    }
}
impl<const N: usize> Mul for Pack<N> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        self.with(o, |a, b| a * b)
    }
}
impl<const N: usize> Div for Pack<N> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        self.with(o, |a, b| a / b)
    }
}
impl<const N: usize> Neg for Pack<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Pack(self.0.map(|a| -a))
    }
}
impl<const N: usize> AddAssign for Pack<N> {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<const N: usize> SubAssign for Pack<N> {
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
impl<const N: usize> MulAssign for Pack<N> {
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}
impl<const N: usize> DivAssign for Pack<N> {
    fn div_assign(&mut self, o: Self) {
        *self = *self / o;
    }
}
impl<const N: usize> BitAnd for PackMask<N> {
    type Output = Self;
    fn bitand(self, o: Self) -> Self {
        PackMask(std::array::from_fn(|k| self.0[k] & o.0[k]))
    }
}
impl<const N: usize> BitOr for PackMask<N> {
    type Output = Self;
    fn bitor(self, o: Self) -> Self {
        PackMask(std::array::from_fn(|k| self.0[k] | o.0[k]))
    }
}
impl<const N: usize> Not for PackMask<N> {
    type Output = Self;
    fn not(self) -> Self {
        PackMask(self.0.map(|a| !a))
    }
}

impl<const N: usize> Lane for Pack<N> {
    type Mask = PackMask<N>;
    const WIDTH: usize = N;
    fn splat(x: f64) -> Self {
        Pack([x; N])
    }
    fn from_fn(number: impl Fn(usize) -> f64) -> Self {
        Pack(std::array::from_fn(number))
    }
    fn lane(self, k: usize) -> f64 {
        self.0[k]
    }
    fn sqrt(self) -> Self {
        Pack(self.0.map(f64::sqrt))
    }
    fn abs(self) -> Self {
        Pack(self.0.map(f64::abs))
    }
    fn gt(self, other: Self) -> PackMask<N> {
        self.test(other, |a, b| a > b)
    }
    fn ge(self, other: Self) -> PackMask<N> {
        self.test(other, |a, b| a >= b)
    }
    fn select(mask: PackMask<N>, yes: Self, no: Self) -> Self {
        Pack(std::array::from_fn(|k| if mask.0[k] { yes.0[k] } else { no.0[k] }))
    }
    fn any(mask: PackMask<N>) -> bool {
        mask.0.iter().any(|m| *m)
    }
}
