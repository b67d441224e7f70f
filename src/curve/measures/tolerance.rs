//! Which tolerances can be asked for, and what one may take.

use super::bounds::{Bounds, bounds, hull};
use crate::curve::pieces::Pieces;
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, check, too_many};
use crate::numerics::plane::larger;

/// Tolerances below this share of the extent are raised to it.
pub(crate) const LEAST_TOLERANCE: f64 = 1e-9;
/// So are those below this share of the largest coordinate.
pub(crate) const LEAST_DIGITS: f64 = 1e-15;

/// An error where a tolerance is not a positive number.
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    // From the least number above 0 on.
    check("tolerance", None, tolerance, f64::from_bits(1), f64::MAX)
}

/// The tolerance, raised to 1e-9 of the extent, and to the digits that the coordinates have, where it is below that.
pub(super) fn least_tolerance(curve: &dyn Pieces, tolerance: f64) -> f64 {
    // A curve of one point has the extent of a rounding: within a share of that nothing can be proved.
    let least = |box_: Bounds| larger(LEAST_TOLERANCE * box_.extent(), LEAST_DIGITS * box_.largest());
    // The hull is quicker than the exact box, and ordinary tolerances are far above its share.
    if tolerance >= least(hull(curve)) {
        return tolerance;
    }
    tolerance.max(least(bounds(curve))).max(f64::MIN_POSITIVE)
}

/// The error of too many points.
pub(super) fn beyond(needed: usize) -> Box<Error> {
    too_many("tolerance", "maxOutputPoints", MOST_OUTPUT_POINTS, needed)
}
