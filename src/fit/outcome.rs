//! What a fit gives back.

use super::knots::spline::{Spline, derivative_of};
use crate::curve::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::generator::Space as Kind;
use crate::limits::LARGEST_COORDINATE;
use crate::numerics::plane::larger;
use crate::numerics::{Point, Vector};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FitStatus {
    /// It is going on; the curve is the best so far.
    Running,
    /// What was asked for was reached: the gap, the tolerance, or knots that are all worth their price.
    Converged,
    /// The limit on iterations was reached first.
    MostIterations,
    /// No step helped any more, though the gap or the tolerance was not reached; or knots that were joined or slid off
    /// the grid are farther than the gap from the optimum over all knots.
    Stalled,
}

/// A knot of the fitted curve.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Knot {
    /// Its parameter on the curve.
    pub t: f64,
    /// Its place.
    pub point: Point,
    /// The lowest derivative that jumps there: 1 is a corner.
    pub degree: usize,
    /// How much it jumps.
    pub jump: Vector,
}

/// One spline of the sum that was fitted.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Part {
    /// Its degree.
    pub degree: usize,
    /// The spline itself, as a curve.
    pub curve: HermiteCurve,
    /// Coefficients of its B-splines, about the middle of the points' box.
    pub coefficients: Vec<Vector>,
}

/// What one step after the convex problem changed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Changed {
    /// The step: `extreme`, `merge`, `slide`, `debias`, `prune` or `search`.
    pub step: &'static str,
    /// Knots before and after.
    pub knots: (usize, usize),
    /// Mean square of the points' distances at their parameters, before and after.
    pub qfe: (f64, f64),
    /// The relative duality gap to the problem without a grid, where the step certified one.
    pub gap: Option<f64>,
}

/// A fitted curve and what is known of it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// The curve: exactly the spline for degrees up to 3; splines of degree 4 and 5 are cut into cubics, up to 64 a
    /// piece, until they are within 1e-9 of the drawing's size.
    pub curve: HermiteCurve,
    /// How far the curve may be from the spline: 0 for degrees up to 3, above that proved by the fourth derivative
    /// (D 13.7); and how far it was moved back to the largest coordinate, where it went beyond.
    pub deviation: f64,
    /// The splines whose sum the curve is; the last one carries the place on the plane, others are about the origin. Of
    /// a closed pair each begins at its own first knot: its parameter is less by the `t` of the first of `knots` with
    /// its degree. Of degrees 4 and 5 large summands that nearly cancel, as uneven parameters or weights make them, are
    /// off by more as cubics than their sum, which `deviation` is about: `coefficients` are exact.
    pub parts: Vec<Part>,
    /// The knots, by parameter.
    pub knots: Vec<Knot>,
    /// The parameter of each given point's place on the curve: nowhere around it is nearer, but for a step where a gap
    /// of 1e-3 or more was enough; where the curve comes back to itself another part may be.
    pub parameters: Vec<f64>,
    /// Sum of squares + λ·jumps; infinite where no λ was involved, as are the gap and the regulariser.
    pub objective: f64,
    /// The weighted sum of squares at the points' parameters: of the optimum, where one was made shorter afterwards.
    /// Points put on long sides are among them where λ was involved.
    pub data_term: f64,
    /// λ·jumps.
    pub regularizer: f64,
    /// The relative duality gap that was certified: of the optimum, before it was made shorter; where knots only slid
    /// off the grid, to the problem without one.
    pub gap: f64,
    /// The curve's own sum of squares at the parameters that points were fitted at, by the sum of weights; the places
    /// at `parameters` may be nearer, of which `rms` tells.
    pub qfe: f64,
    /// No given point is farther from the curve than this, four roundings of the largest coordinate and two of the
    /// parameter included.
    pub max_error: f64,
    /// Root of the weighted mean square of the distances between the points and their places.
    pub rms: f64,
    /// Iterations of the solver, or rounds of the search.
    pub iterations: usize,
    /// λ for every degree; empty where none was involved.
    pub lambda: Vec<f64>,
    /// The smoothing that these λ are, where there is one.
    pub smoothing: Option<f64>,
    /// The noise that was estimated or given.
    pub noise: f64,
    /// Points whose distance cannot be noise (with [`super::Options::robust`]).
    pub outliers: Vec<usize>,
    /// How the run ended.
    pub status: FitStatus,
    /// What came after the convex problem.
    pub changes: Vec<Changed>,
}

/// Joints that are less than this apart in the parameter are one for a curve.
const CLOSEST: f64 = 1e-12;

/// The places where polynomial pieces of a curve meet: value and both first derivatives.
#[derive(Clone, Debug, Default)]
pub(super) struct Joints {
    pub(super) at: Vec<f64>,
    pub(super) points: Vec<Point>,
    pub(super) arriving: Vec<Vector>,
    pub(super) leaving: Vec<Vector>,
}

impl Joints {
    /// Puts joints back that are beyond the largest coordinate by no more than `slack`; answers by how much the
    /// farthest was: a curve that is as near to points at the limit may be beyond it.
    pub(super) fn bound(&mut self, slack: f64) -> f64 {
        let mut farthest = 0.0_f64;
        for v in self.points.iter_mut().flat_map(Point::iter_mut) {
            let beyond = v.abs() - LARGEST_COORDINATE;
            if beyond > 0.0 && beyond <= slack {
                *v = LARGEST_COORDINATE.copysign(*v);
                farthest = farthest.max(core::f64::consts::SQRT_2 * beyond);
            }
        }
        farthest
    }

    /// How far the curve goes while its parameter is rounded twice: places on it are that of the parameter's rounding,
    /// and so are the ends of its pieces; where a long piece follows a short one, that of the long one's parameters.
    pub(super) fn slip(&self, end: f64) -> f64 {
        let speeds = self.leaving.iter().zip(&self.arriving).map(|(out, into)| out.norm() + into.norm());
        let next = self.at.iter().skip(1).copied().chain([self.at[0] + end]);
        f64::EPSILON * next.zip(speeds).map(|(t, speed)| t * speed).fold(0.0, larger)
    }

    /// Makes one joint of those that a curve does not tell apart; answers by how much that moves it at most.
    pub(super) fn tell_apart(&mut self, closed: bool, end: f64) -> f64 {
        let (mut kept, mut farthest) = (0, 0.0_f64);
        for i in 1..self.at.len() {
            let around = if closed { self.at[0] + end - self.at[i] } else { f64::INFINITY };
            let (to, lost) = if self.at[i] - self.at[kept] < CLOSEST {
                self.leaving[kept] = self.leaving[i];
                (kept, i)
            } else if around < CLOSEST && kept > 0 {
                self.arriving[0] = self.arriving[i];
                (0, i)
            } else {
                kept += 1;
                self.at[kept] = self.at[i];
                self.points[kept] = self.points[i];
                self.arriving[kept] = self.arriving[i];
                self.leaving[kept] = self.leaving[i];
                continue;
            };
            // The end of a piece moves, and where it ends.
            farthest = farthest.max(2.0 * (self.points[to] - self.points[lost]).norm());
        }
        self.at.truncate(kept + 1);
        for list in [&mut self.points, &mut self.arriving, &mut self.leaving] {
            list.truncate(kept + 1);
        }
        farthest
    }

    /// The curve on [first joint, last joint], or round to the first one again after `end`.
    pub(super) fn curve(self, closed: bool, end: f64) -> Result<HermiteCurve> {
        let mut lengths: Vec<f64> = self.at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        if closed {
            lengths.push(self.at[0] + end - self.at[self.at.len() - 1]);
        }
        HermiteCurve::new(HermiteOptions {
            points: self.points,
            tangents: self.leaving,
            tangents_in: self.arriving,
            closed,
            space: Some(Kind::Polynomial),
            omega: Vec::new(),
            lengths,
        })
    }
}

impl Spline {
    /// The spline as a curve: exact up to degree 3, every piece cut into `cuts` above. The curve's parameter 0 is the
    /// first knot of closed splines.
    pub(super) fn joints(&self, center: Point, scale: f64, unit: f64, cuts: usize) -> Joints {
        let breaks = &self.space.breaks;
        let (degree, closed) = (breaks.degree, breaks.closed);
        let spans = self.space.spans.len();
        let mut joints = Joints::default();
        let mut before: Option<Vector> = None;
        // One knot or none makes a closed curve of one piece; it is cut in two, for a curve has two points. An open
        // piece has its ends.
        let cuts = if closed && spans == 1 { cuts.max(2) } else { cuts };
        for (s, (span, piece)) in self.space.spans.iter().zip(self.pieces()).enumerate() {
            let at = |u: f64, order: usize| {
                let rate = if order == 1 { scale / unit } else { scale };
                derivative_of(&piece, degree, u, span.half, order) * rate
            };
            for cut in 0..cuts {
                let u = 2.0 * cut as f64 / cuts as f64 - 1.0;
                let leaving = at(u, 1);
                // A knot is where it is: a long piece's middle and half would round it by more than a short one bears.
                let start =
                    if closed { breaks.at[s] } else { s.checked_sub(1).map_or(0.0, |k| breaks.at[k]) };
                joints.at.push(if cut == 0 { start } else { span.middle + u * span.half } * unit);
                joints.points.push(center + at(u, 0));
                joints.leaving.push(leaving);
                joints.arriving.push(if cut == 0 { before.unwrap_or(leaving) } else { leaving });
            }
            before = Some(at(1.0, 1));
            if s + 1 == spans {
                if closed {
                    joints.arriving[0] = at(1.0, 1);
                } else {
                    joints.at.push(breaks.end * unit);
                    joints.points.push(center + at(1.0, 0));
                    joints.leaving.push(at(1.0, 1));
                    joints.arriving.push(at(1.0, 1));
                }
            }
        }
        joints
    }

    /// The knots, with the lowest jumping derivative of each; parameters count from the first one on closed splines.
    pub(super) fn knots(&self, center: Point, scale: f64) -> Vec<Knot> {
        let breaks = &self.space.breaks;
        let shift = if breaks.closed && !breaks.is_empty() { breaks.at[0] } else { 0.0 };
        let pieces = self.pieces();
        (0..breaks.len())
            .map(|k| {
                let degree = breaks.degree + 1 - breaks.multiplicity[k];
                let (before, after) = self.space.sides(k);
                let side = |s: usize, u: f64, order: usize| {
                    derivative_of(&pieces[s], breaks.degree, u, self.space.spans[s].half, order)
                };
                let jump = side(after, -1.0, degree) - side(before, 1.0, degree);
                let point = center + side(after, -1.0, 0) * scale;
                Knot { t: breaks.at[k] - shift, point, degree, jump: jump * scale }
            })
            .collect()
    }
}
