//! Exact circles, on-curve editing, kept corners: splines for web vector editors.
//!
//! A [`HermiteCurve`] goes through its points with the tangents that you give it, arriving and leaving. In the
//! trigonometric space two points are an exact circle; lines, cubics, arcs of ellipses, sine waves, cycloids and,
//! in the hyperbolic space, hyperbolas are segments of the same kind of curve.
//!
//! ```
//! use expline::HermiteCurve;
//! use expline::numerics::{Point, Vector};
//!
//! let circle = HermiteCurve::ellipse(Point::new(0.0, 0.0), Vector::new(5.0, 5.0), 0.0, 2)?;
//! let finer = circle.insert(0.3)?; // one more point, the same curve
//! for i in 0..100 {
//!     let point = finer.evaluate(0.02 * f64::from(i), 0)?;
//!     assert!((point.norm() - 5.0).abs() < 1e-14, "every point is on the circle");
//! }
//! # Ok::<(), expline::Error>(())
//! ```
//!
//! An SVG path goes in exactly and comes out within a tolerance that is proved, with the deviation that was measured:
//!
//! ```
//! use expline::svg::{PrintOptions, parse_path, to_path_d};
//!
//! let path = parse_path("M10 10h80v40a20 20 0 0 1-20 20H10z")?;
//! let options = PrintOptions { tolerance: 0.01, decimals: None, arcs: true, relative: false };
//! let printed = to_path_d(&path.curves[0], &options)?;
//! assert!(printed.d.contains('A'), "the rounded corner is still an arc");
//! assert!(printed.deviation <= 0.01, "within the tolerance");
//! # Ok::<(), expline::Error>(())
//! ```
//!
//! # Vocabulary
//!
//! | word | meaning |
//! |---|---|
//! | point | a point on the curve; `points[i]` is the curve at knot i |
//! | tangent | dr/dt at a point, arriving or leaving; a corner has two |
//! | parameter t | counts segments: a curve of M segments of length 1 lives on \[0, M\] |
//! | knot | the parameter of a point |
//! | omega | ω, the frequency of a segment in radians per unit of t; 0 is the cubic |
//! | generator | φ₁, φ₂, the functions that weight points and tangents ([`generator::HermiteGenerators`]) |
//! | mask | the numbers of the two-scale relation ([`refine`]) |
//! | tolerance, deviation | the distance that is asked for, and the one that was measured |
//!
//! # Errors and limits
//!
//! Everything that can be wrong with a call is an [`Error`] that names the argument, the value and the limit; nothing
//! panics. Coordinates are finite and at most 1e9 in size; below 1e-50 they count as 0.
//!
//! # In WebAssembly
//!
//! The crate compiles for wasm32 as it is, and gives the same bits there. Its features are the bindings of the npm
//! package: a Rust program wants none of them.

pub mod curve;
pub mod error;
pub mod fit;
pub mod generator;
mod limits;
pub mod numerics;
pub mod refine;
pub mod surface;
pub mod svg;
pub mod trace;

#[cfg(all(target_arch = "wasm32", feature = "binding"))]
mod wasm;

pub use curve::{BSplineCurve, Curve, HermiteCurve, HermiteOptions, InterpolatingCurve, LocalCurve};
pub use error::{Error, Result};
pub use generator::Space;
pub use surface::TensorSurface;

/// The README's Rust example, compiled and run with the documentation's.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
