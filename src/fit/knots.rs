//! The fewest knots within an asked error: splines with knots anywhere, what their points say of each knot, and the
//! search.

mod adding;
mod bins;
pub(super) mod breaks;
pub(super) mod combine;
pub(super) mod envelope;
mod even;
mod feet;
pub(super) mod free_knots;
mod look;
mod polyline;
mod rounded;
mod search;
pub(super) mod space;
pub(super) mod sparsest;
pub(super) mod spline;
mod straight;
mod stray;
mod sweep;
mod trim;
mod window;
