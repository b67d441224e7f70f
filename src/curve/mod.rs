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

mod any_roots;
mod contract;
mod convert;
mod hermite;
pub(crate) mod measures;
mod piece;
mod pieces;
mod prepared;
mod segment;
mod space_piece;
mod speed;
mod spline_curve;

pub use contract::Curve;
pub use hermite::recognise::EllipseArc;
pub use hermite::sampler::Sampler;
pub use hermite::subdivide::Scheme;
pub use hermite::{HermiteCurve, HermiteOptions, Side};
pub use measures::bounds::Bounds;
pub use measures::by_length::LengthTable;
pub use measures::cubics::Cubics;
pub use measures::nearest::{Nearest, NearestFinder};
pub use measures::nearest_in_space::SpaceNearest;
pub use segment::Segment;
pub use spline_curve::SplineCurve;
pub use spline_curve::b_spline::BSplineCurve;
pub use spline_curve::interpolating::InterpolatingCurve;
pub use spline_curve::local::LocalCurve;
pub use spline_curve::spline_sampler::SplineSampler;

pub(crate) use convert::to_hermite;
pub(crate) use measures::bounds::frame;
pub(crate) use measures::cubics::segment_cubics;
pub(crate) use pieces::Pieces;
#[cfg(all(target_arch = "wasm32", any(feature = "wasm", feature = "wasm-spline")))]
pub(crate) use {hermite::sample::check_parameters, pieces::in_space};
