//! Sine and cosine, with nothing but multiplications and additions: the same bits in every engine; and what is periodic
//! otherwise.

use super::entire::series;
use core::f64::consts::FRAC_2_PI;

/// π/2 in four parts. The first three have 23 bits, so that their products with up to 2³⁰ quarter turns are exact.
const QUARTER: [f64; 4] = [
    1.570_796_251_296_997,
    7.549_789_415_861_596e-08,
    5.390_302_529_957_765e-15,
    3.282_003_542_873_500_5e-22,
];

/// The largest angle whose quarter turns are counted exactly.
const LARGEST: f64 = 1.6e9;

/// t less as many whole periods as leave it from 0 up to, but not including, `period`; 0 where rounding leaves none of
/// it.
///
/// The remainder of the standard library has no error at all, and is two kilobytes of wasm.
pub(crate) fn wrapped(t: f64, period: f64) -> f64 {
    let rest = t - period * (t / period).floor();
    if rest >= 0.0 && rest < period { rest } else { 0.0 }
}

/// Sine and cosine of an angle in radians.
///
/// # Domain
///
/// |angle| ≤ 1.6e9, where neighbouring doubles are 2e-7 apart. Beyond that, and for NaN, an angle counts as 0.
///
/// # Accuracy
///
/// One unit in the last place, also next to multiples of π/2 (`tests/generator/exactness.rs`).
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let angle = if angle.abs() <= LARGEST { angle } else { 0.0 };
    let quarters = (angle * FRAC_2_PI).round_ties_even();
    let rest = QUARTER.iter().fold(angle, |rest, part| rest - quarters * part);
    let u = rest * rest;
    let (c2, c3) = series(u);
    let (cos, sin) = quarter_turned(quarters, (1.0 - u * c2, rest - rest * u * c3));
    (sin, cos)
}

/// (cos, sin) of an angle that has so many quarter turns more, exact as those are.
#[inline]
pub(crate) fn quarter_turned(quarters: f64, (cos, sin): (f64, f64)) -> (f64, f64) {
    match quarters as i64 & 3 {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}
