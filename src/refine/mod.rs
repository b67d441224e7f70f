//! One curve, many resolutions.
//!
//! The two-scale relation: a curve that is piecewise in a space on a grid is piecewise in the same space on any
//! finer grid, because the space depends on ω and not on the step. The *vector scheme* turns points and
//! derivatives into more points and derivatives on the same curve; the *scalar scheme* turns control points
//! into more control points, which close in on it. Both masks change from level to level: what counts is ω
//! times the step.
//!
//! For curves of any roots there are filters: [`from_points`] goes from points on the curve to control points of
//! B-splines, [`finer`] from those to more of them.

mod exponential;
mod least_squares;
mod scalar;
mod vector;

pub(crate) use exponential::Target;
pub use exponential::{extended, finer, from_points};
pub(crate) use least_squares::least_squares;
pub use scalar::{ScalarMask, control_polygon, subdivide_scalar};
pub use vector::{HermiteData, MatrixMask, subdivide_hermite};

use crate::error::Result;
use crate::limits::{MOST_LEVELS, MOST_OUTPUT_POINTS, check, too_many};

/// The number of segments after `levels` refinements by `arity`, if all that is within the limits.
fn check_levels(segments: usize, arity: usize, levels: usize) -> Result<()> {
    check("arity", None, arity as f64, 1.0, f64::MAX)?;
    check("levels", None, levels as f64, 0.0, MOST_LEVELS as f64)?;
    let needed = (0..levels).fold(segments, |count, _| count.saturating_mul(arity));
    if levels > 0 && needed > MOST_OUTPUT_POINTS {
        return Err(too_many("levels", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
    }
    Ok(())
}
