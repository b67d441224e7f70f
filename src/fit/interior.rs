//! The interior point on the knots in play, from its start to exact knots, the way off the grid, and ADMM beside it to
//! be compared with.

mod active_set;
pub mod admm;
mod balance;
mod cold;
mod compress;
mod cone;
mod dual;
mod extreme;
mod fixed_knots;
mod free;
pub mod gridless;
mod iterate;
mod play;
mod polish;
mod reduced;
mod run;
pub(super) mod settings;
pub mod solver;
mod warm;
