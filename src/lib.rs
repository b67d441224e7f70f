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
//! let options = PrintOptions { tolerance: 0.01, ..PrintOptions::default() };
//! let printed = to_path_d(&path.curves[0], &options)?;
//! assert!(printed.d.contains('A'), "the rounded corner is still an arc");
//! assert!(printed.deviation <= 0.01, "within the tolerance");
//! # Ok::<(), expline::Error>(())
//! ```
//!
//! Noisy points become the curve with the fewest knots, pictures their outlines; every answer says how far it is off:
//!
//! ```
//! use expline::fit::{Ask, FitStatus, Options, fit};
//! use expline::numerics::Point;
//! use expline::trace::{Gray, TraceOptions, trace};
//!
//! let stroke: Vec<Point> = (0..200)
//!     .map(|i| f64::from(i))
//!     .map(|x| Point::new(x, 40.0 * (x / 30.0).sin() + 0.3 * (97.0 * x).sin()))
//!     .collect();
//! let options = Options { closed: Some(false), ..Options::default() };
//! let fitted = fit(&stroke, Ask::Tolerance(1.0), &options)?;
//! assert!(fitted.status == FitStatus::Converged && fitted.max_error <= 1.0, "no point is farther away");
//! assert!(fitted.curve.points().len() < 20, "of 200 points");
//!
//! // A black disc of radius 10.5 in the middle of 32 × 32 pixels, with grey pixels round its edge.
//! let from_middle = |i: usize| ((i % 32) as f64 - 15.5).hypot((i / 32) as f64 - 15.5);
//! let shades: Vec<u8> = (0..1024).map(|i| (255.0 * (from_middle(i) - 10.0).clamp(0.0, 1.0)) as u8).collect();
//! let traced = trace(Gray::from_bytes(32, 32, &shades)?, &TraceOptions::default())?;
//! let round = traced.contours[0].curve.as_ellipse(0.05).expect("a disc has a round edge");
//! assert!((round.radii.x - 10.5).abs() < 0.05, "to a twentieth of a pixel");
//! # Ok::<(), expline::Error>(())
//! ```
//!
//! # Where things are
//!
//! | module | what it has |
//! |---|---|
//! | crate root | curves, [`TensorSurface`], the trait [`Curve`] that has the measures, [`Error`] |
//! | [`svg`] | path data in and out |
//! | [`fit`] | noisy points → curves: [`fit::fit`], and [`fit::Fitter`] in steps that can be stopped |
//! | [`trace`] | pictures → curves, also edges, centre lines and flat colours: [`trace::trace`], [`trace::Tracer`] |
//! | [`surface`] | nets, meshes and what an edit touches |
//! | [`curve`], [`generator`], [`refine`] | what curves are made of: segments, bases, filters and masks |
//! | [`numerics`] | points and vectors, which are [nalgebra]'s, and mathematics that knows no splines |
//!
//! [nalgebra]: https://docs.rs/nalgebra
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
//! Later versions may know more: results have fields and states that you need not name (they are `#[non_exhaustive]`),
//! and options that you do not name are what `..Options::default()` says.
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
