//! What interpolating curves and B-spline curves have in common: points that weigh the shifts of one function.

pub(super) mod b_spline;
mod fall;
pub(super) mod interpolating;
pub(super) mod lattice;
pub(super) mod local;
mod local_pieces;
mod reduce;
pub(super) mod spline_sampler;
mod taylor;

use core::fmt::Debug;
use std::borrow::Cow;
use std::sync::Arc;

use self::lattice::{Grid, Lattice, Shape};
use self::spline_sampler::SplineSampler;
use crate::error::{Error, Result};
use crate::generator::Roots;
use crate::limits::{LARGEST_COORDINATE, check, settle};
use crate::numerics::affine::Affine;

/// What the points of a curve weigh: the roots of an exponential B-spline, or an interpolator.
pub trait Generator: Clone + Debug {
    /// The roots, per unit of the parameter.
    #[doc(hidden)]
    fn list(&self) -> &Roots;

    /// All points that act on a cell, and which of them is the first to act on the first cell.
    #[doc(hidden)]
    fn acting<'a>(
        &self,
        points: &'a [f64],
        dimension: usize,
        closed: bool,
    ) -> Result<(Cow<'a, [f64]>, usize)>;
}

/// A curve on a uniform grid, in 2-D or 3-D: an [`InterpolatingCurve`](super::InterpolatingCurve) or a
/// [`BSplineCurve`](super::BSplineCurve). Curves are equal that have the same numbers.
#[derive(Clone, Debug)]
#[must_use = "an edited curve is a new one: this one stays as it was"]
pub struct SplineCurve<G> {
    pub(super) points: Vec<f64>,
    pub(super) generator: G,
    pub(super) lattice: Lattice,
}

impl<G: PartialEq> PartialEq for SplineCurve<G> {
    fn eq(&self, other: &Self) -> bool {
        self.points == other.points
            && self.generator == other.generator
            && self.lattice.lies_as(&other.lattice)
    }
}

impl<G: Generator> SplineCurve<G> {
    /// The curve on a grid.
    pub(super) fn lay(
        points: Vec<f64>,
        generator: G,
        shape: Arc<Shape>,
        dimension: usize,
        closed: bool,
        grid: Grid,
    ) -> Result<Self> {
        let (all, first) = generator.acting(&points, dimension, closed)?;
        let lattice = Lattice::new(shape, &all, dimension, closed, first, grid)?;
        Ok(Self { points, generator, lattice })
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

    /// The roots, per unit of the parameter.
    pub fn roots(&self) -> &Roots {
        self.generator.list()
    }

    /// First and last parameter.
    pub fn domain(&self) -> (f64, f64) {
        self.lattice.domain()
    }

    /// The curve with point i elsewhere: it changes on the cells on which the point acts, n₀ of a B-spline curve and
    /// n₀ − 1 to each side of a point of an interpolating one.
    ///
    /// # Errors
    ///
    /// i beyond the last point; a point of another dimension, or with a number that is not finite or not within ±1e9.
    pub fn with_point(&self, i: usize, point: &[f64]) -> Result<Self> {
        let mut points = self.points.clone();
        place(&mut points, self.dimension(), i, point)?;
        self.with_points(points)
    }

    /// The image under an affine map: in the plane x′ = a·x + c·y + e, y′ = b·x + d·y + f with the `matrix` a b c d e f
    /// of SVG, in space that of a 4 × 4 matrix, 16 numbers column by column.
    ///
    /// Exact to rounding where 0 is a root, as it is in all lists that [`Roots`] makes: the curve is then a sum of its
    /// points whose weights add to 1. Without it, linear maps are exact and translations are refused.
    ///
    /// # Errors
    ///
    /// `matrix`: another length; an entry that is not finite; a last row that is not 0, 0, 0, 1 to 1e-6; a translation
    /// where 0 is no root; an image that leaves ±1e9.
    pub fn transformed(&self, matrix: &[f64]) -> Result<Self> {
        let mut points = self.points.clone();
        self.affine(matrix)?.map_points(&mut points)?;
        self.with_points(points)
    }

    /// The map of a matrix, if it takes curves of these roots to others.
    fn affine<'a>(&self, matrix: &'a [f64]) -> Result<Affine<'a>> {
        Affine::new(matrix, self.dimension(), self.lattice.shape.constants)
    }

    /// The curve of other points on the same grid.
    pub(super) fn with_points(&self, points: Vec<f64>) -> Result<Self> {
        let Lattice { dimension, closed, .. } = self.lattice;
        let (shape, grid) = (self.lattice.shape.clone(), self.lattice.grid());
        Self::lay(points, self.generator.clone(), shape, dimension, closed, grid)
    }

    /// The point at t, or a derivative of an order to n₀ − 1, at least to 2; where that jumps, the limit from the
    /// right.
    ///
    /// # Errors
    ///
    /// t not finite or, on an open curve, outside the domain; a derivative above n₀ − 1 and above 2.
    pub fn evaluate(&self, t: f64, derivative: usize) -> Result<Vec<f64>> {
        let mut point = vec![0.0; self.dimension()];
        self.evaluate_into(&[t], derivative, &mut point).map_err(Error::of_one)?;
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

    /// `count` points that lie uniformly in the parameter, or their derivatives, interleaved; see [`SplineSampler`],
    /// which remembers its tables.
    ///
    /// # Errors
    ///
    /// More than 4 million points; a derivative above n₀ − 1 and above 2.
    pub fn sample(&self, count: usize, derivative: usize) -> Result<Vec<f64>> {
        SplineSampler::all(&self.lattice, count, derivative)
    }

    /// How many polynomial pieces there are: one for each step of a B-spline curve, two for each segment of an
    /// interpolating one.
    pub fn piece_count(&self) -> usize {
        self.lattice.piece_count()
    }

    /// The parameter where piece i starts; that of the end for i = [`Self::piece_count`] and beyond.
    pub fn knot(&self, i: usize) -> f64 {
        self.lattice.knot(i)
    }

    /// Coefficients of ascending powers of y on piece i, all coordinates of each in turn; y goes from −1/2 to 1/2.
    ///
    /// # Accuracy
    ///
    /// That of the curve: what is not a polynomial is one to rounding.
    ///
    /// # Errors
    ///
    /// i beyond the last piece: `coefficients` is as it was then.
    pub fn piece_into(&self, i: usize, coefficients: &mut Vec<f64>) -> Result<()> {
        check("i", None, i as f64, 0.0, self.piece_count() as f64 - 1.0)?;
        self.lattice.piece_into(i, coefficients);
        Ok(())
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
            settle(old);
            Ok(())
        }
        None => Err(Error::out_of_range("i", None, i as f64, 0.0, count as f64 - 1.0)),
    }
}
