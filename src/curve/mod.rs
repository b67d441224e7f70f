//! Parametric curves.

mod area;
mod bounds;
mod cubics;
mod curvature;
mod edit;
mod ellipse;
mod flatten;
mod hermite;
mod length;
mod nearest;
mod piece;
mod refine;
mod sample;
mod segment;

use crate::limits;

pub use bounds::Bounds;
pub use cubics::{Cubics, segment_cubics};
pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use nearest::{Nearest, NearestFinder};
pub use segment::Segment;
