//! Fits of every kind of points: clicks, strokes, outlines, coasts, and what noise leaves of them.

#[path = "../support/mod.rs"]
mod support;

mod clicks;
mod outlines;
mod pen;
mod rough;
mod straight;
mod uneven;
