//! Parametric curves: what they are made of, what can be asked of them, how they are edited.
//!
//! [`HermiteCurve`] has points with tangents that arrive and leave: lines, cubics and arcs of ellipses side by side.
//! [`InterpolatingCurve`] has control points that lie on it, [`BSplineCurve`] some near it, [`LocalCurve`] finer ones
//! where they are wanted; what these three reproduce exactly is said by their [`Roots`](crate::generator::Roots).
//! [`Curve`] is what all of them answer: lengths, areas, bounds, nearest points, polylines, cubic Béziers.
//!
//! ```
//! use expline::numerics::{Point, Vector};
//! use expline::{Curve, HermiteCurve, InterpolatingCurve};
//!
//! let oval = HermiteCurve::ellipse(Point::new(0.0, 0.0), Vector::new(3.0, 2.0), 0.0, 4)?;
//! assert!((oval.area()? - 6.0 * core::f64::consts::PI).abs() < 1e-13, "its area is πab");
//! assert!((oval.nearest(Point::new(5.0, 0.0)).distance - 2.0).abs() < 1e-13, "its vertex is at (3, 0)");
//! let (polyline, deviation) = oval.flatten(0.01)?;
//! assert!(deviation <= 0.01 && polyline.len() < 100, "proved, with as few points as that takes");
//!
//! // Four points of a circle: the default roots keep ellipses exact, and every point lies on the curve.
//! let circle = InterpolatingCurve::new(vec![1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0], 2, true, None)?;
//! assert!((circle.length(1e-12)? - core::f64::consts::TAU).abs() < 1e-12, "a circle");
//! # Ok::<(), expline::Error>(())
//! ```

mod area;
mod b_spline;
mod bounds;
mod by_length;
mod chords;
mod contract;
mod convert;
mod cubic_chords;
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
