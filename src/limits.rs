//! The bounds that every curve and every bulk result keeps, checked before anything is allocated.

use crate::error::{Error, Result};

/// The largest coordinate or parameter length that is accepted: a double keeps 1e-7 units there.
pub(crate) const LARGEST_COORDINATE: f64 = 1e9;
/// The largest component of a tangent: Béziers whose control points are coordinates have up to six times as much.
pub(crate) const LARGEST_TANGENT: f64 = 8e9;
/// What is smaller counts as 0: lengths and distances are compared by fourth powers, which would vanish.
pub(crate) const LEAST_COORDINATE: f64 = 1e-50;
/// What one point of a fit may count for, where an ordinary one counts 1.
pub(crate) const LEAST_WEIGHT: f64 = 1e-6;
pub(crate) const LARGEST_WEIGHT: f64 = 1e6;
/// The least parameter length of a segment: knots closer than this count as one.
pub(crate) const LEAST_LENGTH: f64 = 1e-12;
/// Trigonometric segments need ω·length below 2π by at least this much: the basis has a pole there.
pub(crate) const POLE_MARGIN: f64 = 1e-6;
/// The largest ω·length of a hyperbolic segment.
pub(crate) const LARGEST_FREQUENCY: f64 = 1e4;
/// The most points that one curve may have.
pub(crate) const MOST_POINTS: usize = 16_777_216;
/// The most points of a surface's net: 96 MB.
pub(crate) const MOST_SURFACE_POINTS: usize = 4_194_304;
/// The most parameters of one bulk evaluation.
pub(crate) const MOST_EVALUATIONS: usize = 4_000_000;
/// The most points that one call may give back.
pub(crate) const MOST_OUTPUT_POINTS: usize = 4_000_000;
/// The most roots of one exponential spline: the interpolator's cancellation doubles with each.
pub(crate) const MOST_ROOTS: usize = 16;
/// The largest growth per unit of a root: a factor of e²⁰ from point to point.
pub(crate) const LARGEST_ROOT_RE: f64 = 20.0;
/// The largest frequency of a root; interpolators want less than π.
pub(crate) const LARGEST_ROOT_IM: f64 = 10.0;
/// The largest factor between two grids of an exponential spline.
pub(crate) const LARGEST_FACTOR: usize = 1024;
/// The most levels of one subdivision: 2 points become 33 million there, more than may be given back.
pub(crate) const MOST_LEVELS: usize = 24;

/// The most points of one fit, and the most places for its knots.
pub(crate) const MOST_FIT_POINTS: usize = 500_000;
/// The largest price of a jump: half a million points within the largest coordinates need no more.
pub(crate) const LARGEST_LAMBDA: f64 = 1e60;

pub(crate) fn too_many(
    argument: &'static str,
    limit: &'static str,
    most: usize,
    needed: usize,
) -> Box<Error> {
    Error::limit(argument, limit, most, needed as f64)
}

/// Checks that a number is finite and within its range.
pub(crate) fn check(
    argument: &'static str,
    index: Option<usize>,
    value: f64,
    least: f64,
    most: f64,
) -> Result<()> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(Error::unfit(argument, index, value, least, most))
    }
}

/// Makes coordinates 0 that are too small to be computed with.
#[inline]
pub(crate) fn settle(coordinates: &mut [f64]) {
    for x in coordinates {
        if x.abs() < LEAST_COORDINATE {
            *x = 0.0;
        }
    }
}

/// An empty vector with room for `count` values, or an error where the allocator says no.
pub(crate) fn with_room<T>(count: usize) -> Result<Vec<T>> {
    let mut values = Vec::new();
    match values.try_reserve_exact(count) {
        Ok(()) => Ok(values),
        Err(_) => Err(Error::memory(count.saturating_mul(size_of::<T>()))),
    }
}

/// Whether there is room for so many bytes in one piece, or an error: before work whose many lists cannot fail one by
/// one.
pub(crate) fn probe(bytes: usize) -> Result<()> {
    let room: Vec<u8> = with_room(bytes)?;
    // What is not looked at may be left out altogether.
    let _ = core::hint::black_box(&room);
    Ok(())
}

/// Makes a vector one of equal values, or an error where the allocator says no.
pub(crate) fn refill<T: Copy>(values: &mut Vec<T>, value: T, count: usize) -> Result<()> {
    values.clear();
    if values.try_reserve(count).is_err() {
        return Err(Error::memory(count.saturating_mul(size_of::<T>())));
    }
    values.resize(count, value);
    Ok(())
}

/// A vector of equal values, or an error where the allocator says no.
pub(crate) fn filled(value: f64, count: usize) -> Result<Vec<f64>> {
    let mut values = with_room(count)?;
    values.resize(count, value);
    Ok(values)
}
