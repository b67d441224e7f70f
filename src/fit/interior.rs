//! The interior point on the knots in play, from its start to exact knots, the way off the grid, and ADMM beside it to be compared with.

pub mod admm;
mod balance;
mod cold;
mod compress;
mod cone;
mod descent;
mod dual;
mod extreme;
mod free;
pub mod gridless;
mod iterate;
mod play;
pub(super) mod polish;
mod reduced;
mod run;
pub mod solver;
mod warm;
