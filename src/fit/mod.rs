//! The sparsest curve through points: total-variation splines with a certificate of optimality.

mod cone;
mod dual;
mod interval;
mod polish;
pub mod problem;
mod reduced;
mod scaled;
pub mod solution;
pub mod solver;
pub mod spline_space;

pub use interval::Local;
pub use problem::{Component, Norm, Problem, uniform_grid};
pub use solution::{Solution, Spline};
pub use solver::{Settings, Solver, Status};
pub use spline_space::KnotSpace;
