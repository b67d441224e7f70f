//! B-spline curves of any roots on uniform grids: control points near the curve, as many as wanted.

use core::f64::consts::PI;
use std::borrow::Cow;
use std::sync::Arc;

use super::lattice::{Shape, check_points};
use super::{Generator, SplineCurve};
use crate::error::{Error, Result};
use crate::generator::{ExponentialBSpline, Roots};
use crate::limits::{LARGEST_COORDINATE, LARGEST_ROOT_RE, LEAST_LENGTH, check, settle};
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
pub type BSplineCurve = SplineCurve<Roots>;

impl BSplineCurve {
    /// The curve of control points that lie at the parameters offset, offset + step, …; `roots` are per unit of the
    /// parameter.
    ///
    /// # Errors
    ///
    /// A dimension other than 2 and 3; fewer than 3 points of a closed curve or n₀ of an open one; a number that is not
    /// finite or not within ±1e9; a step below 1e-12; a list of roots that is not symmetric, or with |im|·step ≥ π.
    pub fn new(
        mut points: Vec<f64>,
        dimension: usize,
        closed: bool,
        roots: Roots,
        step: f64,
        offset: f64,
    ) -> Result<Self> {
        check("step", None, step, LEAST_LENGTH, LARGEST_COORDINATE)?;
        check("offset", None, offset, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        check_points(&points, dimension, if closed { 3 } else { roots.order() })?;
        settle(&mut points);
        if !roots.is_symmetric() {
            return Err(Error::degenerate("roots", None, "an opposite is missing"));
        }
        let start = offset - to_first(roots.order(), closed) * step;
        Self::with_roots(points, dimension, closed, roots, (start, step))
    }

    /// The curve whose first knot is at `grid.0`, with cells of the length `grid.1`.
    pub(super) fn with_roots(
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
        Self::lay(points, roots, shape, dimension, closed, grid)
    }

    /// The parameter from one control point to the next.
    pub fn step(&self) -> f64 {
        self.lattice.step
    }

    /// The parameter of control point 0.
    pub fn offset(&self) -> f64 {
        self.lattice.start + to_first(self.roots().order(), self.is_closed()) * self.lattice.step
    }

    /// The same curve with m times the points.
    ///
    /// # Errors
    ///
    /// m not from 1 to 1024; more than 4 million points; points that would not be within ±1e9.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 20], see [`finer`].
    pub fn refine(&self, m: usize) -> Result<Self> {
        let (dimension, closed) = (self.dimension(), self.is_closed());
        let points = finer(&self.points, dimension, closed, &self.lattice.shape.roots, m)?;
        check_points(&points, dimension, 1)?;
        let grid = (self.lattice.start, self.lattice.step / m as f64);
        Self::with_roots(points, dimension, closed, self.roots().clone(), grid)
    }
}

/// From the first knot to control point 0, in steps (D 9.8).
fn to_first(order: usize, closed: bool) -> f64 {
    if closed { 0.5 * (order % 2) as f64 } else { 1.0 - 0.5 * order as f64 }
}

impl Generator for Roots {
    fn list(&self) -> &Roots {
        self
    }

    fn acting<'a>(
        &self,
        points: &'a [f64],
        dimension: usize,
        closed: bool,
    ) -> Result<(Cow<'a, [f64]>, usize)> {
        let count = points.len() / dimension;
        // Of the points that act on the first cell, the first lies (n₀ − 1)/2 or n₀/2 − 1 places before point 0.
        let before = (self.order() - 1) / 2 % count;
        Ok((Cow::Borrowed(points), if closed { count - before } else { 0 }))
    }
}
