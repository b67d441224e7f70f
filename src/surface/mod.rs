//! Surfaces: a net of points times a generator in each direction.
//!
//! [`TensorSurface`] goes through its net where both directions have points on the surface, and near it where a
//! direction was refined to B-spline form. Spheres, tori and other quadrics are exact with a handful of points
//! ([`TensorSurface::sphere`] and its kin). [`TensorSurface::mesh_into`] gives triangles for a screen,
//! [`TensorSurface::touched`] what part of them an edit changes, [`TensorSurface::refine_at`] makes room for detail
//! where it is wanted. Trimmed surfaces and surfaces that are no grid of patches are not here.
//!
//! ```
//! use expline::TensorSurface;
//!
//! let torus = TensorSurface::torus(3.0, 1.0, [8, 6])?; // 48 points, all of them on it
//! for k in 0..50 {
//!     let point = torus.evaluate(0.16 * f64::from(k), 0.12 * f64::from(k), 0, 0)?;
//!     let ring = (point.x * point.x + point.y * point.y).sqrt() - 3.0;
//!     assert!((ring * ring + point.z * point.z - 1.0).abs() < 1e-13, "on the torus");
//! }
//! # Ok::<(), expline::Error>(())
//! ```

mod axis;
mod character;
mod combined;
mod curvature;
mod extent;
mod layer;
mod mesh;
mod normal;
mod part;
mod patch;
mod poles;
mod reduce;
mod refine;
mod shapes;
mod tensor;
mod touched;
mod weights;

pub use axis::Direction;
pub use curvature::Curvature;
pub use mesh::{Grid, Region};
pub use tensor::TensorSurface;
