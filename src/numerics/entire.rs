//! Four even entire functions, cos √u and what is left of cos and sin after their first terms.
//!
//! ```text
//! c₀(u) = cos √u               c₂(u) = (1 − cos √u) / u
//! c₁(u) = sin √u / √u          c₃(u) = (√u − sin √u) / √u³
//! ```
//!
//! They are Stumpff's functions \[Stu59\], cₙ(u) = Σₖ (−u)ᵏ/(2k+n)!. For u < 0 the same sums are hyperbolic,
//! at u = 0 they are 1, 1, 1/2, 1/6: one formulation for the trigonometric, the hyperbolic and the polynomial
//! space, in which nothing jumps and nothing is divided by a small number.

use super::angle::sin_cos;
use core::f64::consts::FRAC_PI_2;

/// The series are used for |u| up to (π/2)²: ten terms leave 2e-17 there, and nothing cancels.
pub const SERIES_LIMIT: f64 = FRAC_PI_2 * FRAC_PI_2;

/// 1/(2k+2)! for k = 0 … 9; every factorial here is an exact double.
const EVEN: [f64; 10] = [
    1.0 / 2.0,
    1.0 / 24.0,
    1.0 / 720.0,
    1.0 / 40_320.0,
    1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
    1.0 / 6_402_373_705_728_000.0,
    1.0 / 2_432_902_008_176_640_000.0,
];

/// 1/(2k+3)! for k = 0 … 9.
const ODD: [f64; 10] = [
    1.0 / 6.0,
    1.0 / 120.0,
    1.0 / 5_040.0,
    1.0 / 362_880.0,
    1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
    1.0 / 121_645_100_408_832_000.0,
    1.0 / 51_090_942_171_709_440_000.0,
];

/// The values c₀ … c₃ of Stumpff's functions at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stumpff {
    /// cos √u.
    pub c0: f64,
    /// sin √u / √u.
    pub c1: f64,
    /// (1 − cos √u) / u.
    pub c2: f64,
    /// (√u − sin √u) / √u³.
    pub c3: f64,
}

/// c₂(u) and c₃(u) for |u| ≤ [`SERIES_LIMIT`], from their series.
///
/// # Accuracy
///
/// 3e-16 relative (`tests/exactness.rs`, against 50 digits).
///
/// # Cost
///
/// Forty multiplications and additions, no branch: a loop over it becomes vector code.
#[inline]
pub fn series(u: f64) -> (f64, f64) {
    let m = -u;
    let m2 = m * m;
    let pair = |c: &[f64; 10], k: usize| c[2 * k] + m * c[2 * k + 1];
    let sum = |c: &[f64; 10]| {
        pair(c, 0) + m2 * (pair(c, 1) + m2 * (pair(c, 2) + m2 * (pair(c, 3) + m2 * pair(c, 4))))
    };
    (sum(&EVEN), sum(&ODD))
}

/// All four functions at u.
///
/// # Accuracy
///
/// A few 1e-16, relative for c₂ and c₃, and relative to 1 for c₀ and c₁ between 0 and (2π)². Below
/// u = −500 000 the hyperbolic functions overflow to infinity.
#[inline(never)]
pub fn stumpff(u: f64) -> Stumpff {
    if u.abs() <= SERIES_LIMIT {
        let (c2, c3) = series(u);
        return Stumpff { c0: 1.0 - u * c2, c1: 1.0 - u * c3, c2, c3 };
    }
    beyond_series(u)
}

#[cold]
#[inline(never)]
fn beyond_series(u: f64) -> Stumpff {
    let t = u.abs().sqrt();
    if u > 0.0 {
        let (sine, cosine) = sin_cos(t);
        let versine = if cosine < 0.5 {
            1.0 - cosine
        } else {
            // Around 2π the difference loses digits; the square of the half angle's sine does not.
            let half = sin_cos(0.5 * t).0;
            2.0 * half * half
        };
        Stumpff { c0: cosine, c1: sine / t, c2: versine / u, c3: (t - sine) / (u * t) }
    } else {
        let (up, down) = (0.5 * libm::exp(t), 0.5 * libm::exp(-t));
        let sine = up - down;
        Stumpff { c0: up + down, c1: sine / t, c2: (up + down - 1.0) / -u, c3: (sine - t) / (-u * t) }
    }
}
