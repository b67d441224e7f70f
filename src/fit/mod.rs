//! The sparsest curve through points: total-variation splines with a certificate of optimality.

pub(crate) mod interval;
pub mod spline_space;

pub use interval::Local;
pub use spline_space::KnotSpace;
