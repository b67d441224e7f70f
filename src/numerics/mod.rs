//! Mathematics that has never heard of splines.

pub(crate) mod affine;
pub mod angle;
pub(crate) mod banded;
pub(crate) mod dense;
pub mod enclosing_circle;
pub mod entire;
pub(crate) mod lists;
pub(crate) mod order;
pub(crate) mod pair;
pub(crate) mod plane;
pub(crate) mod quadrature;
pub(crate) mod roots;
pub mod tridiagonal;
pub mod twofold;

/// A point of the plane.
pub type Point = nalgebra::Vector2<f64>;
/// A displacement or a derivative in the plane.
pub type Vector = nalgebra::Vector2<f64>;
/// A point of space, a displacement or a derivative there.
pub type Vector3 = nalgebra::Vector3<f64>;
