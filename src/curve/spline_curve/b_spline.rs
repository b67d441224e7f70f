//! B-spline curves of any roots on uniform grids: control points near the curve, as many as wanted.

use core::f64::consts::PI;
use std::borrow::Cow;
use std::sync::Arc;

use super::lattice::{Grid, Lattice, Shape, check_points};
use super::{Generator, SplineCurve};
use crate::error::{Error, Result};
use crate::generator::{ExponentialBSpline, Root, Roots, too_fast};
use crate::limits::{LARGEST_COORDINATE, LARGEST_FACTOR, LARGEST_ROOT_RE, LEAST_LENGTH, check, settle};
use crate::refine::finer;

/// What forty refinements, as many as there are from the largest step to the least, may round off a parameter.
const ROUNDED: f64 = 1e-12;

/// A curve r(t) = Σ P\[l\] b((t − offset)/step − l) with the exponential B-spline b, divided by its integral, in 2-D or
/// 3-D.
///
/// The control points lie near the curve, at distances that fall with the square of the step. Where 0 is a root they
/// sum convexly: the curve is in the hull of any n₀ neighbours.
///
/// # Domain
///
/// A closed curve of L points takes any real t and has period L·step. An open one has the L − n₀ + 1 cells on which
/// n₀ points act.
///
/// # Accuracy
///
/// 1e-14 of the points' size (`tests/curve/interpolating.rs`).
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
        Self::with_roots(points, dimension, closed, roots, Grid { start, step, end: None })
    }

    /// The same curve with the domain from `start` to `end`, which differs from what step and offset say by roundings:
    /// with it a curve that was refined can be made again from its numbers.
    ///
    /// # Errors
    ///
    /// `domain` where an end differs by more than 1e-12 of the larger one.
    pub fn with_domain(self, start: f64, end: f64) -> Result<Self> {
        let (own_start, own_end) = self.domain();
        let slack = ROUNDED * own_start.abs().max(own_end.abs());
        check("domain", Some(0), start, own_start - slack, own_start + slack)?;
        check("domain", Some(1), end, (own_end - slack).max(start), own_end + slack)?;
        let Lattice { dimension, closed, step, .. } = self.lattice;
        let grid = Grid { start, step, end: Some(end) };
        let shape = self.lattice.shape.clone();
        Self::lay(self.points, self.generator, shape, dimension, closed, grid)
    }

    /// The curve on a grid.
    pub(super) fn with_roots(
        points: Vec<f64>,
        dimension: usize,
        closed: bool,
        roots: Roots,
        grid: Grid,
    ) -> Result<Self> {
        let local = roots.divided(1.0 / grid.step);
        for (i, (root, local)) in roots.as_slice().iter().zip(local.as_slice()).enumerate() {
            if local.im.abs() >= PI {
                return Err(too_fast(i, root.im, PI / grid.step));
            }
            let most = LARGEST_ROOT_RE / grid.step;
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
        // Within the limits of `new` but for roundings.
        self.offset_with(self.step()).clamp(-LARGEST_COORDINATE, LARGEST_COORDINATE)
    }

    /// The parameter of control point 0 on a grid with the same first knot.
    fn offset_with(&self, step: f64) -> f64 {
        self.lattice.start + to_first(self.roots().order(), self.is_closed()) * step
    }

    /// Refuses a factor that leads to a grid without curves, and says which is the largest that does not.
    ///
    /// `step` is that of the grid for a factor; factors above one that does not fit do not fit either, and 1 does.
    pub(super) fn check_factor(&self, m: usize, step: &dyn Fn(f64) -> f64) -> Result<()> {
        let fits = |m: usize| {
            let step = step(m as f64);
            let near = |root: &Root| root.im.abs() * step < PI && root.re.abs() * step <= LARGEST_ROOT_RE;
            (LEAST_LENGTH..=LARGEST_COORDINATE).contains(&step)
                && self.offset_with(step).abs() <= LARGEST_COORDINATE * (1.0 + ROUNDED)
                && self.roots().as_slice().iter().all(near)
        };
        if m == 1 || fits(m) {
            return Ok(());
        }
        let (mut most, mut beyond) = (1, m);
        while most + 1 < beyond {
            let middle = usize::midpoint(most, beyond);
            if fits(middle) {
                most = middle;
            } else {
                beyond = middle;
            }
        }
        Err(Error::out_of_range("m", None, m as f64, 1.0, most as f64))
    }

    /// The same curve with m times the points.
    ///
    /// # Errors
    ///
    /// m not from 1 to 1024, or so large that the step would be below 1e-12 or the offset not within ±1e9; more than 4
    /// million points; points that would not be within ±1e9.
    ///
    /// # Source
    ///
    /// [SFBGU17, eq. 20], see [`finer`].
    pub fn refine(&self, m: usize) -> Result<Self> {
        check("m", None, m as f64, 1.0, LARGEST_FACTOR as f64)?;
        self.check_factor(m, &|m| self.step() / m)?;
        let (dimension, closed) = (self.dimension(), self.is_closed());
        let points = finer(&self.points, dimension, closed, &self.lattice.shape.roots, m)?;
        check_points(&points, dimension, 1)?;
        let grid = Grid { step: self.step() / m as f64, ..self.lattice.grid() };
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
