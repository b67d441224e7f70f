//! Parametric curves.

mod edit;
mod ellipse;
mod hermite;
pub(crate) mod limits;
mod refine;
mod sample;
mod segment;

pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use segment::Segment;
