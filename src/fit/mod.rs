//! The sparsest curve through points: total-variation splines with a certificate of optimality.
//!
//! [`fit`] does it at once, [`Fitter`] in steps that can be stopped, and again and again for a slider. What is wanted
//! is an [`Ask`]: a price for each jump, a strength without a unit, the largest distance, or nothing, where the noise
//! of the points decides. [`Options`] say of which degrees the spline is, and what becomes of the optimum of the convex
//! problem.
//!
//! ```
//! use expline::fit::{Ask, Options, fit};
//! use expline::numerics::Point;
//!
//! // A square with sides of 100, 25 points on each.
//! let points: Vec<Point> = (0..100)
//!     .map(|i| {
//!         let along = 4.0 * f64::from(i % 25);
//!         match i / 25 {
//!             0 => Point::new(along, 0.0),
//!             1 => Point::new(100.0, along),
//!             2 => Point::new(100.0 - along, 100.0),
//!             _ => Point::new(0.0, 100.0 - along),
//!         }
//!     })
//!     .collect();
//! let fitted = fit(&points, Ask::Tolerance(0.5), &Options::default())?;
//! assert_eq!(fitted.knots.len(), 4, "its corners and nothing else");
//! assert!(fitted.max_error <= 0.5, "no point is farther from the curve");
//! # Ok::<(), expline::Error>(())
//! ```

mod convex;
mod corners;
mod fitter;
mod interior;
mod knots;
mod noise;
mod options;
mod outcome;
mod outline;
mod parametrise;
mod report;
mod samples;
mod smooth;

pub use convex::price::{
    detail_of_lambda, detail_of_smoothing, lambda_max, lambda_of_detail, smoothing_of_detail,
};
pub use convex::problem::{Component, Norm, Problem, uniform_grid};
pub use convex::solution::{Solution, Spline, Status};
pub use convex::{certificate, price, problem, solution};
pub use fitter::{Fitter, Progress, fit, fit_all};
pub use interior::settings::Settings;
pub use interior::solver;
pub use interior::solver::Solver;
pub use noise::{is_regular, noise};
pub use options::{Ask, Finish, Options};
pub use outcome::{Changed, Fit, FitStatus, Knot, Part};
pub use parametrise::{Parametrisation, given, parametrise};
pub use samples::{MOST_SAMPLES, Samples};

/// What solvers are made of, for the crate's own tests, examples and benches. These trust their arguments: they are no
/// part of the interface, whose promise is that nothing panics.
#[doc(hidden)]
pub use {
    convex::{interval::Local, spline_space, spline_space::KnotSpace},
    interior::{admm, gridless},
    knots::{
        breaks::Breaks,
        free_knots::{FreeKnots, Located},
    },
};
