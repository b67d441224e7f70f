//! Curves through their points, smooth to any order, with points that act locally.

use std::sync::Arc;

use super::b_spline::BSplineCurve;
use super::lattice::{Lattice, Shape, check_points};
use super::spline_sampler::SplineSampler;
use crate::error::{Error, Result};
use crate::generator::{Interpolator, Roots};
use crate::limits::{LARGEST_COORDINATE, MOST_LEVELS, check};
use crate::refine::{extended, from_points};

/// A curve through its points: r(t) = Σ P\[k\] φ(t − k) with the interpolator φ of a list of roots, in 2-D or 3-D.
///
/// Point k is at t = k. The curve has n₀ − 2 continuous derivatives and keeps exactly what the roots stand for. A point acts on
/// n₀ − 1 segments to each side and on nothing else.
///
/// # Domain
///
/// A closed curve of M ≥ 3 points has any real t and period M; an open one of N ≥ 2 points has [0, N − 1]. Beyond its ends an open
/// curve's points are continued by the roots' own recurrence ([`extended`]).
///
/// # Accuracy
///
/// 1e-14·(1 + Σ|λ|) of the points' size; at the points exact (`tests/interpolating_curves.rs`).
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
/// let points: Vec<f64> = (0..5).flat_map(|k| { let (s, c) = (1.256_637_061_435_917_3 * f64::from(k)).sin_cos(); [c, s] }).collect();
/// let circle = InterpolatingCurve::new(points, 2, true, None)?;
/// let [x, y] = circle.evaluate(0.37, 0)?[..] else { unreachable!() };
/// assert!((x.hypot(y) - 1.0).abs() < 1e-14);
/// # Ok::<(), expline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct InterpolatingCurve {
    points: Vec<f64>,
    interpolator: Arc<Interpolator>,
    lattice: Lattice,
}

impl InterpolatingCurve {
    /// The curve through `points`, interleaved by `dimension`.
    ///
    /// Without roots, a closed curve of M points gets (0, ±2πi/M), which keep ellipses, and an open one (0, 0, 0, 0), which keep
    /// cubics and bend continuously: an open curve has no natural frequency.
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
        points: Vec<f64>,
        dimension: usize,
        closed: bool,
        interpolator: Arc<Interpolator>,
    ) -> Result<Self> {
        check_points(&points, dimension, if closed { 3 } else { 2 })?;
        let shape = Arc::new(Shape::of_interpolator(&interpolator));
        let lattice = lay(shape, &points, dimension, closed, &interpolator)?;
        Ok(Self { points, interpolator, lattice })
    }

    /// The points, interleaved.
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

    /// The roots.
    pub fn roots(&self) -> &Roots {
        self.interpolator.roots()
    }

    /// The function whose shifts weigh the points.
    pub fn interpolator(&self) -> &Arc<Interpolator> {
        &self.interpolator
    }

    /// First and last parameter.
    pub fn domain(&self) -> (f64, f64) {
        self.lattice.domain()
    }

    /// The curve with point i elsewhere.
    ///
    /// # Errors
    ///
    /// i beyond the last point; a point of another dimension, or with a number that is not finite or not within ±1e9.
    pub fn with_point(&self, i: usize, point: &[f64]) -> Result<Self> {
        let mut points = self.points.clone();
        place(&mut points, self.dimension(), i, point)?;
        let shape = self.lattice.shape.clone();
        let lattice = lay(shape, &points, self.dimension(), self.is_closed(), &self.interpolator)?;
        Ok(Self { points, interpolator: self.interpolator.clone(), lattice })
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

    /// How many polynomial pieces there are: two for each segment.
    pub fn piece_count(&self) -> usize {
        self.lattice.piece_count()
    }

    /// The parameter where piece i starts; that of the end for i = [`Self::piece_count`].
    pub fn knot(&self, i: usize) -> f64 {
        self.lattice.knot(i)
    }

    /// Coefficients of ascending powers of y on piece i, all coordinates of each in turn; y goes from −1/2 to 1/2.
    ///
    /// # Accuracy
    ///
    /// That of the curve: what is not a polynomial is one to rounding.
    pub fn piece_into(&self, i: usize, coefficients: &mut Vec<f64>) {
        self.lattice.piece_into(i, coefficients);
    }

    /// The same curve as B-spline control points on the grid 1/(m₀·m^(levels − 1)).
    ///
    /// # Errors
    ///
    /// `levels` not from 1 to 24, m₀ not even, a factor above 1024, more than 4 million points.
    ///
    /// # Accuracy
    ///
    /// The curve changes by at most 1e-12 of its size at level 6 (`tests/interpolating_curves.rs`).
    ///
    /// # Source
    ///
    /// [SFBGU17, sec. 3.4], see [`from_points`].
    pub fn refine(&self, levels: usize, m0: usize, m: usize) -> Result<BSplineCurve> {
        check("levels", None, levels as f64, 1.0, MOST_LEVELS as f64)?;
        let (dimension, closed) = (self.dimension(), self.is_closed());
        let continued;
        let points = if closed {
            &self.points
        } else {
            continued = extended(&self.points, dimension, self.roots())?;
            &continued
        };
        let fine = from_points(points, dimension, closed, &self.interpolator, m0)?;
        let mut curve =
            BSplineCurve::on_grid(fine, dimension, closed, self.roots().clone(), (0.0, m0 as f64))?;
        for _ in 1..levels {
            curve = curve.refine(m)?;
        }
        Ok(curve)
    }

    pub(super) fn lattice(&self) -> &Lattice {
        &self.lattice
    }
}

fn lay(
    shape: Arc<Shape>,
    points: &[f64],
    dimension: usize,
    closed: bool,
    interpolator: &Interpolator,
) -> Result<Lattice> {
    if closed {
        // The window of the first cell starts n₀ − 2 points before point 0.
        let count = points.len() / dimension;
        let before = (interpolator.order() - 2) % count;
        Lattice::new(shape, points, dimension, closed, count - before, (0.0, 1.0))
    } else {
        let all = extended(points, dimension, interpolator.roots())?;
        Lattice::new(shape, &all, dimension, closed, 0, (0.0, 1.0))
    }
}

/// Puts a point into an interleaved list.
pub(super) fn place(points: &mut [f64], dimension: usize, i: usize, point: &[f64]) -> Result<()> {
    if point.len() != dimension {
        return Err(Error::wrong_length("point", point.len(), dimension));
    }
    for (k, &value) in point.iter().enumerate() {
        check("point", Some(k), value, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
    }
    let count = points.len() / dimension;
    match points.chunks_exact_mut(dimension).nth(i) {
        Some(old) => {
            old.copy_from_slice(point);
            Ok(())
        }
        None => Err(Error::out_of_range("i", None, i as f64, 0.0, count as f64 - 1.0)),
    }
}
