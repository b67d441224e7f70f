//! Four numbers of single precision side by side, which wasm adds and multiplies at once.
//!
//! Where a loop keeps sums in registers beside what it loads and stores, compilers pack some of it by twos; this says what belongs together.
//! Each number has the bits that it would have alone.

use core::ops::{Add, Mul, Sub};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use core::arch::wasm32 as vector;

/// The operations of vectors where there are none.
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
mod vector {
    #![allow(non_camel_case_types, reason = "it stands for the vector of wasm")]

    pub(super) type v128 = [f32; 4];

    pub(super) const fn f32x4(a: f32, b: f32, c: f32, d: f32) -> v128 {
        [a, b, c, d]
    }

    pub(super) fn f32x4_add(a: v128, b: v128) -> v128 {
        [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
    }

    pub(super) fn f32x4_sub(a: v128, b: v128) -> v128 {
        [a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]]
    }

    pub(super) fn f32x4_mul(a: v128, b: v128) -> v128 {
        [a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]]
    }

    pub(super) const fn f32x4_extract_lane<const N: usize>(a: v128) -> f32 {
        a[N]
    }
}

/// Four numbers; each operation is done on all of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Four(vector::v128);

impl Four {
    #[inline(always)]
    pub(crate) fn new([a, b, c, d]: [f32; 4]) -> Self {
        Self(vector::f32x4(a, b, c, d))
    }

    /// The same number four times.
    #[inline(always)]
    pub(crate) fn equal(number: f32) -> Self {
        Self::new([number; 4])
    }

    #[inline(always)]
    pub(crate) fn each(self) -> [f32; 4] {
        [
            vector::f32x4_extract_lane::<0>(self.0),
            vector::f32x4_extract_lane::<1>(self.0),
            vector::f32x4_extract_lane::<2>(self.0),
            vector::f32x4_extract_lane::<3>(self.0),
        ]
    }
}

impl Add for Four {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(vector::f32x4_add(self.0, other.0))
    }
}

impl Sub for Four {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(vector::f32x4_sub(self.0, other.0))
    }
}

impl Mul for Four {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(vector::f32x4_mul(self.0, other.0))
    }
}
