//! Parametric curves.

mod hermite;
mod segment;

pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use segment::Segment;
