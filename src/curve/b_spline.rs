//! B-spline curves of any roots on uniform grids: control points near the curve, as many as wanted.

use core::f64::consts::PI;
use std::sync::Arc;

use super::interpolating::place;
use super::lattice::{Lattice, Shape, check_points};
use super::spline_sampler::SplineSampler;
use crate::error::{Error, Result};
use crate::generator::{ExponentialBSpline, Roots};
use crate::limits::{LARGEST_COORDINATE, LARGEST_ROOT_RE, LEAST_LENGTH, check};
use crate::refine::finer;

/// A curve r(t) = Σ P\[l\] b((t − offset)/step − l) with the exponential B-spline b, divided by its integral, in 2-D or 3-D.
///
/// The control points lie near the curve, at distances that fall with the square of the step. Where 0 is a root they sum
/// convexly: the curve is in the hull of any n₀ neighbours.
///
/// # Domain
///
/// A closed curve of L points takes any real t and has period L·step. An open one has the L − n₀ + 1 cells on which
/// n₀ points act.
///
/// # Accuracy
///
/// 1e-14 of the points' size (`tests/interpolating_curves.rs`).
///
/// # Source
///
/// [SFBGU17, eq. 19], divided by the integral (D 9.7).
#[derive(Clone, Debug)]
pub struct BSplineCurve {
    points: Vec<f64>,
    /// Per unit of the parameter.
    roots: Roots,
    lattice: Lattice,
}

impl BSplineCurve {
    /// The curve of control points that lie at the parameters offset, offset + step, …; `roots` are per unit of the
    /// parameter.
    ///
    /// # Errors
    ///
    /// A dimension other than 2 and 3; fewer than 3 points of a closed curve or n₀ of an open one; a number that is not
    /// finite or not within ±1e9; a step below 1e-12; a list of roots that is not symmetric, or with |im|·step ≥ π.
    pub fn new(
        points: Vec<f64>,
        dimension: usize,
        closed: bool,
        roots: Roots,
        step: f64,
        offset: f64,
    ) -> Result<Self> {
        check("step", None, step, LEAST_LENGTH, LARGEST_COORDINATE)?;
        check("offset", None, offset, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        check_points(&points, dimension, if closed { 3 } else { roots.order() })?;
        if !roots.is_symmetric() {
            return Err(Error::degenerate("roots", None, "an opposite is missing"));
        }
        let start = offset - to_first(roots.order(), closed) * step;
        Self::lay(points, dimension, closed, roots, (start, step))
    }

    /// The curve whose first knot is at `grid.0`, with `grid.1` cells to a unit.
    pub(super) fn on_grid(
        points: Vec<f64>,
        dimension: usize,
        closed: bool,
        roots: Roots,
        grid: (f64, f64),
    ) -> Result<Self> {
        Self::lay(points, dimension, closed, roots, (grid.0, 1.0 / grid.1))
    }

    pub(super) fn lay(
        points: Vec<f64>,
        dimension: usize,
        closed: bool,
        roots: Roots,
        grid: (f64, f64),
    ) -> Result<Self> {
        let local = roots.scaled(1.0 / grid.1);
        for (i, (root, local)) in roots.as_slice().iter().zip(local.as_slice()).enumerate() {
            if local.im.abs() >= PI {
                return Err(Error::out_of_range("roots", Some(i), root.im, -PI / grid.1, PI / grid.1));
            }
            let most = LARGEST_ROOT_RE / grid.1;
            check("roots", Some(i), root.re, -most, most)?;
        }
        let shape = Arc::new(Shape::of_b_spline(&ExponentialBSpline::new(&local)?));
        let lattice = laid(shape, &points, dimension, closed, grid)?;
        Ok(Self { points, roots, lattice })
    }

    /// The control points, interleaved.
    pub fn points(&self) -> &[f64] {
        &self.points
    }

    /// 2 or 3.
    pub fn dimension(&self) -> usize {
        self.lattice.dimension
    }

    /// Whether the last point is joined to the first.
    pub fn is_closed(&self) -> bool {
        self.lattice.closed
    }

    /// The roots, per unit of the parameter.
    pub fn roots(&self) -> &Roots {
        &self.roots
    }

    /// The parameter from one control point to the next.
    pub fn step(&self) -> f64 {
        self.lattice.step
    }

    /// The parameter of control point 0.
    pub fn offset(&self) -> f64 {
        self.lattice.start + to_first(self.roots.order(), self.is_closed()) * self.lattice.step
    }

    /// First and last parameter.
    pub fn domain(&self) -> (f64, f64) {
        self.lattice.domain()
    }

    /// The curve with control point i elsewhere: it changes on n₀ cells.
    ///
    /// # Errors
    ///
    /// i beyond the last point; a point of another dimension, or with a number that is not finite or not within ±1e9.
    pub fn with_point(&self, i: usize, point: &[f64]) -> Result<Self> {
        let mut points = self.points.clone();
        place(&mut points, self.dimension(), i, point)?;
        self.with_points(points)
    }

    /// The curve of other control points on the same grid.
    pub(super) fn with_points(&self, points: Vec<f64>) -> Result<Self> {
        let lattice = &self.lattice;
        let grid = (lattice.start, lattice.step);
        let lattice = laid(lattice.shape.clone(), &points, lattice.dimension, lattice.closed, grid)?;
        Ok(Self { points, roots: self.roots.clone(), lattice })
    }

    /// The point at t, or a derivative of an order to n₀ − 1; where that jumps, the limit from the right.
    ///
    /// # Errors
    ///
    /// t not finite or, on an open curve, outside the domain; a derivative above n₀ − 1.
    pub fn evaluate(&self, t: f64, derivative: usize) -> Result<Vec<f64>> {
        let mut point = vec![0.0; self.dimension()];
        self.evaluate_into(&[t], derivative, &mut point)?;
        Ok(point)
    }

    /// Points or derivatives at every parameter, interleaved, into `out`.
    ///
    /// # Errors
    ///
    /// As [`Self::evaluate`]; `out` of the wrong length; more than 4 million parameters: `out` is untouched then.
    pub fn evaluate_into(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.lattice.evaluate_into(t, derivative, out)
    }

    /// `count` points that lie uniformly in the parameter, or their derivatives, interleaved; see [`SplineSampler`], which
    /// remembers its tables.
    ///
    /// # Errors
    ///
    /// More than 4 million points; a derivative above n₀ − 1.
    pub fn sample(&self, count: usize, derivative: usize) -> Result<Vec<f64>> {
        SplineSampler::all(&self.lattice, count, derivative)
    }

    /// How many polynomial pieces there are: one for each step.
    pub fn piece_count(&self) -> usize {
        self.lattice.piece_count()
    }

    /// The parameter where piece i starts; that of the end for i = [`Self::piece_count`].
    pub fn knot(&self, i: usize) -> f64 {
        self.lattice.knot(i)
    }

    /// Coefficients of ascending powers of y on piece i, all coordinates of each in turn; y goes from −1/2 to 1/2.
    pub fn piece_into(&self, i: usize, coefficients: &mut Vec<f64>) {
        self.lattice.piece_into(i, coefficients);
    }

    /// The same curve with m times the points.
    ///
    /// # Errors
    ///
    /// m not from 1 to 1024; more than 4 million points.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 20], see [`finer`].
    pub fn refine(&self, m: usize) -> Result<Self> {
        let (dimension, closed) = (self.dimension(), self.is_closed());
        let points = finer(&self.points, dimension, closed, &self.lattice.shape.roots, m)?;
        let grid = (self.lattice.start, self.lattice.step / m as f64);
        Self::lay(points, dimension, closed, self.roots.clone(), grid)
    }

    pub(super) fn lattice(&self) -> &Lattice {
        &self.lattice
    }
}

/// From the first knot to control point 0, in steps (D 9.8).
fn to_first(order: usize, closed: bool) -> f64 {
    if closed { 0.5 * (order % 2) as f64 } else { 1.0 - 0.5 * order as f64 }
}

fn laid(
    shape: Arc<Shape>,
    points: &[f64],
    dimension: usize,
    closed: bool,
    grid: (f64, f64),
) -> Result<Lattice> {
    let count = points.len() / dimension;
    // Of the points that act on the first cell, the first lies (n₀ − 1)/2 or n₀/2 − 1 places before point 0.
    let before = (shape.window - 1) / 2 % count;
    let first = if closed { count - before } else { 0 };
    Lattice::new(shape, points, dimension, closed, first, grid)
}
