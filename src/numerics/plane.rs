//! Products and lengths of vectors of the plane.
//!
//! `f64::sqrt` is one correctly rounded instruction on every target, so lengths are the same bits everywhere.

use super::{Point, Vector};

/// The second number where it is larger than the first. `f64::max` has a rule for what is not a number, and in wasm is
/// a call.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The second number where it is smaller than the first.
#[inline(always)]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// Makes points so many times as wide and as high, and moves them back by a vector.
#[inline(never)]
pub(crate) fn enlarge(points: &mut [Point], times: Vector, back: Vector) {
    for p in points {
        *p = p.component_mul(&times) - back;
    }
}

/// x₁x₂ + y₁y₂.
#[inline]
pub(crate) fn dot(u: Vector, v: Vector) -> f64 {
    u.x * v.x + u.y * v.y
}

/// x₁y₂ − y₁x₂.
#[inline]
pub(crate) fn cross(u: Vector, v: Vector) -> f64 {
    u.x * v.y - u.y * v.x
}

/// The square of the length.
#[inline]
pub(crate) fn square(v: Vector) -> f64 {
    v.x * v.x + v.y * v.y
}

/// The length.
#[inline]
pub(crate) fn norm(v: Vector) -> f64 {
    square(v).sqrt()
}

/// |x| + |y|: at least the length, and at most √2 of it.
#[inline]
pub(crate) fn taxi(v: Vector) -> f64 {
    v.x.abs() + v.y.abs()
}

/// Adds a point to a list of numbers.
#[inline(never)]
pub(crate) fn append(values: &mut Vec<f64>, point: Point) {
    values.extend_from_slice(point.as_slice());
}
