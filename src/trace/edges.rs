//! Edges of photographs and centre lines of thin strokes, as chains of points.

mod beyond;
pub(super) mod canny;
mod centering;
pub(super) mod centre;
mod graph;
pub(super) mod maxima;
pub(super) mod strands;
