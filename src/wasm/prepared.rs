//! A generator with its tables, kept for the next question about it.

use crate::generator::{ExponentialBSpline, Interpolator};

/// The generator of the last call, with what it was made from: asking again costs no second preparation.
pub(super) struct Prepared {
    pub(super) kind: u32,
    pub(super) roots: Vec<f64>,
    pub(super) generator: Generator,
}

pub(super) enum Generator {
    Spline(ExponentialBSpline),
    Interpolator(Interpolator),
}
