//! From pixels to piecewise splines.
//!
//! Coordinates: x to the right, y down; pixel (column, row) covers [column, column + 1] × [row, row + 1].

mod chain;
mod cloud;
mod contour;
mod corners;
mod coverage;
mod cubic;
mod division;
mod drawing;
mod ellipse;
mod gray;
mod knots;
mod local;
mod metrics;
mod outline;
mod quasi_interpolant;
mod refine;
mod samples;
mod selection;
mod simplify;
mod skyline;
mod unknowns;

pub use chain::{Chain, ChainPlace, Joint, Tube, TubeFit, fit_tube};
pub use cloud::Cloud;
pub use contour::{Contour, contours};
pub use drawing::{Drawing, DrawingOptions, MOST_CONTOURS, TracedContour, trace_drawing};
pub use gray::{Gray, MOST_PIXELS, MOST_SIDE, Tones};
pub use knots::{Knots, MOST_DEGREE, MOST_INTERIOR};
pub use metrics::{Jaccard, diameter, directed_hausdorff, jaccard, mean_absolute, root_mean_square};
pub use quasi_interpolant::{End, Estimator, QuasiInterpolant};
pub use selection::{Choice, Rule, Score, choose, generalised_cross_validation, leave_one_out};
