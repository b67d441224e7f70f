//! What every way of tracing has in common: how far it is, and what it finds.

use super::metrics::Metrics;
use super::picture::tones::Tones;
use crate::curve::HermiteCurve;
use crate::error::Result;
use crate::numerics::Point;

/// What is being done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// The picture is looked at: tones, noise, edges.
    Edges,
    /// Contours are followed.
    Contours,
    /// Corners are looked for.
    Corners,
    /// Contours become splines.
    Splines,
    /// Splines are moved until they explain the picture.
    Refinement,
}

/// How far the work is. Stages come in their order, and in a stage `completed` never falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Progress {
    /// Whether the result is there.
    pub done: bool,
    /// What is being done.
    pub stage: Stage,
    /// How much of the stage is done.
    pub completed: usize,
    /// Of how much.
    pub total: usize,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TracedContour {
    /// The curve; closed outlines of ink have a positive area, holes a negative one.
    pub curve: HermiteCurve,
    /// Whether its end is its start.
    pub closed: bool,
    /// Whether it bounds a hole.
    pub hole: bool,
    /// Corners, where the tangent jumps.
    pub cusps: Vec<Point>,
    /// How far it is from the sub-pixel contour.
    pub metrics: Metrics,
}

/// What was found in a picture.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Trace {
    /// All curves; outlines of ink in the order of their first points, row by row.
    pub contours: Vec<TracedContour>,
    /// Ink, paper and noise.
    pub tones: Tones,
    /// The root mean square difference between the picture and the coverage of the curves near them; 0 without
    /// refinement.
    pub residual: f64,
}

/// Work that is done bit by bit, in whatever thread. Every source is one.
pub(super) trait Work: Send + Sync {
    /// Does a bit, of a millisecond or so; how long it took, in about microseconds.
    fn step(&mut self) -> Result<f64>;

    /// How far it is.
    fn progress(&self) -> Progress;

    /// What was found, once it is done.
    fn trace(&self) -> Option<&Trace>;

    /// After a refusal for too many contours: the speckle that would leave as many as are allowed.
    fn offer(&self) -> Option<f64> {
        None
    }
}
