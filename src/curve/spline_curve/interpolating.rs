//! Curves through their points, smooth to any order, with points that act locally.

use std::borrow::Cow;
use std::sync::Arc;

use super::b_spline::BSplineCurve;
use super::lattice::{Grid, Shape, check_points};
use super::{Generator, SplineCurve};
use crate::error::Result;
use crate::generator::{Interpolator, Roots};
use crate::limits::{MOST_LEVELS, MOST_OUTPUT_POINTS, check, settle, too_many};
use crate::refine::{extended, from_points};

/// A curve through its points: r(t) = Σ P\[k\] φ(t − k) with the interpolator φ of a list of roots, in 2-D or 3-D.
///
/// Point k is at t = k. The curve has n₀ − 2 continuous derivatives and keeps exactly what the roots stand for. A point
/// acts on n₀ − 1 segments to each side and on nothing else.
///
/// # Domain
///
/// A closed curve of M ≥ 3 points has any real t and period M; an open one of N ≥ 2 points has [0, N − 1]. Beyond its
/// ends an open curve's points are continued by the roots' own recurrence ([`extended`]).
///
/// # Accuracy
///
/// 1e-14·(1 + Σ|λ|) of the points' size; at the points exact. Where 0 and real roots are mixed the points beyond an
/// open curve's ends grow and cancel again: on the first and last n₀ − 2 segments 1e-16·e^{(n₀ − 3)a} more with the
/// largest real part a, which is 2e-11 for 0, 0, ±12, and 1e-14·e^{(n₀ − 3)a} for what [`Self::refine`] makes of it
/// (`tests/curve/interpolating.rs`).
///
/// # Source
///
/// [SFBGU17, eq. 5, Definition 3].
///
/// # Example
///
/// ```
/// use expline::InterpolatingCurve;
///
/// // Five points of a circle are the circle.
/// let angles = (0..5).map(|k| core::f64::consts::TAU / 5.0 * f64::from(k));
/// let points: Vec<f64> = angles.flat_map(|angle| [angle.cos(), angle.sin()]).collect();
/// let circle = InterpolatingCurve::new(points, 2, true, None)?;
/// let [x, y] = circle.evaluate(0.37, 0)?[..] else { unreachable!() };
/// assert!((x.hypot(y) - 1.0).abs() < 1e-14);
/// # Ok::<(), expline::Error>(())
/// ```
pub type InterpolatingCurve = SplineCurve<Arc<Interpolator>>;

impl InterpolatingCurve {
    /// The curve through `points`, interleaved by `dimension`.
    ///
    /// Without roots, a closed curve of M points gets (0, ±2πi/M), which keep ellipses, and an open one (0, 0, 0, 0),
    /// which keep cubics and bend continuously: an open curve has no natural frequency.
    ///
    /// # Errors
    ///
    /// A dimension other than 2 and 3; fewer than 3 points of a closed curve or 2 of an open one; a number that is not
    /// finite or not within ±1e9; roots that have no interpolator.
    pub fn new(points: Vec<f64>, dimension: usize, closed: bool, roots: Option<Roots>) -> Result<Self> {
        let count = check_points(&points, dimension, if closed { 3 } else { 2 })?;
        let roots = match roots {
            Some(roots) => roots,
            None if closed => Roots::ellipse(count)?,
            None => Roots::polynomials(3)?,
        };
        Self::with_interpolator(points, dimension, closed, Arc::new(Interpolator::new(&roots)?))
    }

    /// The curve through `points` with an interpolator that is there already, such as one that
    /// [`Interpolator::beyond_pi`] made.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn with_interpolator(
        mut points: Vec<f64>,
        dimension: usize,
        closed: bool,
        interpolator: Arc<Interpolator>,
    ) -> Result<Self> {
        check_points(&points, dimension, if closed { 3 } else { 2 })?;
        settle(&mut points);
        let shape = Arc::new(Shape::of_interpolator(&interpolator));
        let grid = Grid { start: 0.0, step: 1.0, end: None };
        Self::lay(points, interpolator, shape, dimension, closed, grid)
    }

    /// The function whose shifts weigh the points.
    pub fn interpolator(&self) -> &Arc<Interpolator> {
        &self.generator
    }

    /// The same curve as B-spline control points on the grid 1/(m₀·m^(levels − 1)).
    ///
    /// # Errors
    ///
    /// `levels` not from 1 to 24, m₀ not even, a factor above 1024, more than 4 million points, points that would not
    /// be within ±1e9.
    ///
    /// # Accuracy
    ///
    /// The curve changes by at most 1e-12 of its size at level 6 (`tests/curve/interpolating.rs`), an open one of
    /// large real roots by what [`InterpolatingCurve`] says of it.
    ///
    /// # Source
    ///
    /// [SFBGU17, sec. 3.4], see [`from_points`].
    pub fn refine(&self, levels: usize, m0: usize, m: usize) -> Result<BSplineCurve> {
        check("levels", None, levels as f64, 1.0, MOST_LEVELS as f64)?;
        let (dimension, closed) = (self.dimension(), self.is_closed());
        // Before anything is computed: the last level alone is too large, the others are not.
        let intervals = self.points.len() / dimension - usize::from(!closed);
        let needed = (1..levels).fold(intervals.saturating_mul(m0), |count, _| count.saturating_mul(m));
        if needed > MOST_OUTPUT_POINTS {
            return Err(too_many("levels", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
        }
        let (points, _) = self.generator.acting(&self.points, dimension, closed)?;
        let fine = from_points(&points, dimension, closed, &self.generator, m0)?;
        check_points(&fine, dimension, 1)?;
        let grid = Grid { step: 1.0 / m0 as f64, ..self.lattice.grid() };
        let mut curve = BSplineCurve::with_roots(fine, dimension, closed, self.roots().clone(), grid)?;
        for _ in 1..levels {
            curve = curve.refine(m)?;
        }
        Ok(curve)
    }
}

impl Generator for Arc<Interpolator> {
    fn list(&self) -> &Roots {
        self.roots()
    }

    fn acting<'a>(
        &self,
        points: &'a [f64],
        dimension: usize,
        closed: bool,
    ) -> Result<(Cow<'a, [f64]>, usize)> {
        if !closed {
            return Ok((Cow::Owned(extended(points, dimension, self.roots())?), 0));
        }
        // The window of the first cell starts n₀ − 2 points before point 0.
        let count = points.len() / dimension;
        let before = (self.order() - 2) % count;
        Ok((Cow::Borrowed(points), count - before))
    }
}
