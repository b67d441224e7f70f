//! The convex problem: what is minimised, over which splines, what its solution is, what λ means at any scale, and the
//! certificate.
//!
//! Nothing here knows a solver, so the certificate shares nothing with what it judges.

pub mod certificate;
pub(super) mod interval;
pub mod price;
pub mod problem;
pub(super) mod scaled;
pub mod solution;
pub mod spline_space;
