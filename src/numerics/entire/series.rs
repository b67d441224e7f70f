//! The power series of what is left of cosine and sine, on which all the rest stands.

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

/// c₂(u) and c₃(u) for |u| ≤ [`SERIES_LIMIT`], from their series.
///
/// # Accuracy
///
/// 3e-16 relative (`tests/generator/exactness.rs`, against 50 digits).
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
