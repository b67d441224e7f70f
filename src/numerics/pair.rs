//! Two numbers side by side, which wasm adds and multiplies at once.
//!
//! Compilers make pairs of loops over lists. Sums that are to stay in registers are no lists, so they say it
//! themselves. Each number has the bits that it would have alone.

use super::Point;
use core::ops::{Add, AddAssign, Div, Mul, Sub};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use core::arch::wasm32 as vector;

/// The operations of vectors where there are none.
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
mod vector {
    #![allow(non_camel_case_types, reason = "it stands for the vector of wasm")]

    pub(super) type v128 = [f64; 2];

    pub(super) const fn f64x2(a: f64, b: f64) -> v128 {
        [a, b]
    }

    pub(super) const fn f64x2_splat(a: f64) -> v128 {
        [a, a]
    }

    pub(super) fn f64x2_add([a, b]: v128, [c, d]: v128) -> v128 {
        [a + c, b + d]
    }

    pub(super) fn f64x2_sub([a, b]: v128, [c, d]: v128) -> v128 {
        [a - c, b - d]
    }

    pub(super) fn f64x2_mul([a, b]: v128, [c, d]: v128) -> v128 {
        [a * c, b * d]
    }

    pub(super) fn f64x2_div([a, b]: v128, [c, d]: v128) -> v128 {
        [a / c, b / d]
    }

    pub(super) fn f64x2_sqrt([a, b]: v128) -> v128 {
        [a.sqrt(), b.sqrt()]
    }

    pub(super) const fn f64x2_extract_lane<const N: usize>(a: v128) -> f64 {
        a[N]
    }
}

/// Two numbers; each operation is done on both.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair(vector::v128);

impl Pair {
    #[inline(always)]
    pub(crate) fn new(first: f64, second: f64) -> Self {
        Self(vector::f64x2(first, second))
    }

    /// The coordinates of two points.
    #[inline(always)]
    pub(crate) fn of(p: Point, q: Point) -> [Self; 2] {
        [Self::new(p.x, q.x), Self::new(p.y, q.y)]
    }

    /// The same number twice.
    #[inline(always)]
    pub(crate) fn twice(number: f64) -> Self {
        Self(vector::f64x2_splat(number))
    }

    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        Self(vector::f64x2_sqrt(self.0))
    }

    #[inline(always)]
    pub(crate) fn first(self) -> f64 {
        vector::f64x2_extract_lane::<0>(self.0)
    }

    #[inline(always)]
    pub(crate) fn second(self) -> f64 {
        vector::f64x2_extract_lane::<1>(self.0)
    }
}

impl AddAssign for Pair {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.0 = vector::f64x2_add(self.0, other.0);
    }
}

impl Add for Pair {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(vector::f64x2_add(self.0, other.0))
    }
}

impl Sub for Pair {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(vector::f64x2_sub(self.0, other.0))
    }
}

impl Mul for Pair {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(vector::f64x2_mul(self.0, other.0))
    }
}

impl Div for Pair {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(vector::f64x2_div(self.0, other.0))
    }
}
