//! Surfaces: a net of points times a generator in each direction.
//!
//! [`TensorSurface`] goes through its net where both directions have points on the surface, and near it where a direction
//! was refined to B-spline form. Spheres, tori and other quadrics are exact with a handful of points ([`TensorSurface::sphere`]
//! and its kin). [`TensorSurface::mesh_into`] gives triangles for a screen, [`TensorSurface::touched`] what part of them an
//! edit changes, [`TensorSurface::refine_at`] makes room for detail where it is wanted. Trimmed surfaces and surfaces that are
//! no grid of patches are not here.

mod axis;
mod character;
mod layer;
mod mesh;
mod normal;
mod patch;
mod poles;
mod reduce;
mod refine;
mod shapes;
mod tensor;
mod touched;

pub use axis::Direction;
pub use mesh::{Grid, Region};
pub use normal::Curvature;
pub use tensor::TensorSurface;
