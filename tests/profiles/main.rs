//! Profiles: chains of points and tubes around them, edges and centre lines, as curves.

#[path = "../support/mod.rs"]
mod support;

mod centre_lines;
mod chains;
mod curves;
mod disc_walk;
mod edges;
mod quasi_interpolation;
mod quasi_outlines;
