//! Parametric curves.

mod area;
mod b_spline;
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
mod fall;
mod flatten;
mod grid;
mod heal;
mod hermite;
mod interpolating;
mod lattice;
mod length;
mod local;
mod local_pieces;
mod nearest;
mod piece;
mod pieces;
mod recognise;
mod reduce;
mod refine;
mod sample;
mod sampler;
mod search;
mod segment;
mod spatial;
mod speed;
mod spline_curve;
mod spline_sampler;
mod subdivide;
mod taylor;
mod through;

use crate::limits;

pub use b_spline::BSplineCurve;
pub use bounds::Bounds;
pub use by_length::LengthTable;
pub use contract::Curve;
pub use cubics::{Cubics, segment_cubics};
pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use interpolating::InterpolatingCurve;
pub use local::LocalCurve;
pub use nearest::{Nearest, NearestFinder};
pub use recognise::EllipseArc;
pub use sampler::Sampler;
pub use segment::Segment;
pub use spatial::SpaceNearest;
pub use spline_curve::SplineCurve;
pub use spline_sampler::SplineSampler;
pub use subdivide::Scheme;

#[cfg(all(target_arch = "wasm32", any(feature = "wasm", feature = "wasm-spline")))]
pub(crate) use sample::check_parameters;

/// The measures themselves, for callers that hold a curve by its pieces.
#[cfg(all(target_arch = "wasm32", any(feature = "wasm", feature = "wasm-spline")))]
pub(crate) mod measures {
    #[cfg(feature = "wasm-spline")]
    pub(crate) use super::convert::to_hermite;
    pub(crate) use super::{
        area::{area, centroid},
        bounds::bounds,
        cubics::to_cubics,
        curvature::curvature,
        flatten::flatten,
        length::{length, parameter_at_length},
        pieces::{Pieces, in_space},
        spatial::nearest as nearest_in_space,
    };
}
