//! From pixels to piecewise splines.
//!
//! Coordinates: x to the right, y down; pixel (column, row) covers [column, column + 1] × [row, row + 1].

mod cloud;
mod knots;
mod local;
mod metrics;
mod quasi_interpolant;
mod selection;

pub use cloud::Cloud;
pub use knots::{Knots, MOST_DEGREE, MOST_INTERIOR};
pub use metrics::{Jaccard, diameter, directed_hausdorff, jaccard, mean_absolute, root_mean_square};
pub use quasi_interpolant::{End, Estimator, QuasiInterpolant};
pub use selection::{Choice, Rule, Score, choose, generalised_cross_validation, leave_one_out};
