//! Curves: what they are, how they are edited, and every question that they answer.

#[path = "../support/mod.rs"]
mod support;

mod affine;
mod cubics;
mod data;
mod dense_sums;
mod editing;
mod ellipses;
mod equality;
mod healing;
mod interpolating;
mod kept_promises;
mod laws;
mod measures;
mod nearest;
mod polylines;
mod sampling;
mod spline_grids;
mod spline_measures;
mod spline_sampling;
mod symmetry;
