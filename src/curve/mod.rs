//! Parametric curves.

mod area;
mod bounds;
mod by_length;
mod chords;
mod contract;
mod convert;
mod cubic_fit;
mod cubics;
mod curvature;
mod cut;
mod deviation;
mod edit;
mod ellipse;
mod flatten;
mod grid;
mod heal;
mod hermite;
mod length;
mod nearest;
mod piece;
mod pieces;
mod recognise;
mod refine;
mod sample;
mod sampler;
mod search;
mod segment;
mod spatial;
mod speed;
mod subdivide;
mod through;

use crate::limits;

pub use bounds::Bounds;
pub use by_length::LengthTable;
pub use contract::Curve;
pub use cubics::{Cubics, segment_cubics};
pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use nearest::{Nearest, NearestFinder};
pub use recognise::EllipseArc;
pub use sampler::Sampler;
pub use segment::Segment;
pub use spatial::SpaceNearest;
pub use subdivide::Scheme;
