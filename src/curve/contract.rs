//! Everything that every curve can do, whatever it is made from.

use super::HermiteCurve;
use super::convert;
use super::measures::area;
use super::measures::bounds::{self, Bounds};
use super::measures::by_length::LengthTable;
use super::measures::cubics::{self, Cubics};
use super::measures::curvature;
use super::measures::flatten;
use super::measures::length;
use super::measures::nearest::{Nearest, NearestFinder};
use super::measures::nearest_in_space::{self, SpaceNearest};
use super::measures::tolerance::check_tolerance;
use super::pieces::Pieces;
use super::spline_curve::{Generator, SplineCurve};
use crate::error::Result;
use crate::limits::{MOST_OUTPUT_POINTS, filled, too_many, with_room};
use crate::numerics::Point;
use crate::numerics::lists::steps;

/// What can be asked of a curve of any kind, with one implementation for all of them.
///
/// # Example
///
/// ```
/// use expline::numerics::{Point, Vector};
/// use expline::{Curve, HermiteCurve};
///
/// fn roundness(curve: &dyn Curve) -> expline::Result<f64> {
///     let length = curve.length(1e-9)?;
///     Ok(4.0 * core::f64::consts::PI * curve.area()? / (length * length))
/// }
/// let circle = HermiteCurve::ellipse(Point::zeros(), Vector::new(2.0, 2.0), 0.0, 3)?;
/// assert!((roundness(&circle)? - 1.0).abs() < 1e-8);
/// # Ok::<(), expline::Error>(())
/// ```
pub trait Curve: Pieces {
    /// The curve as its pieces.
    #[doc(hidden)]
    fn as_pieces(&self) -> &dyn Pieces;

    /// The points or their derivatives at every parameter, all coordinates in turn, into `out`.
    ///
    /// # Errors
    ///
    /// A parameter that is not finite or, on an open curve, outside the domain; a derivative above the second (of
    /// spline curves above n₀ − 1 and the second); more than 4 million parameters; `out` of another length than
    /// [`Curve::dimension`] times that of `t`. `out` is untouched then.
    fn evaluate_into(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.values(t, derivative, out)
    }

    /// The point at t, or a derivative, one number for each coordinate; at a knot the limit from the right.
    ///
    /// # Errors
    ///
    /// As for [`Curve::evaluate_into`].
    fn evaluate(&self, t: f64, derivative: usize) -> Result<Vec<f64>> {
        let mut point = vec![0.0; self.dimension()];
        self.values(&[t], derivative, &mut point)?;
        Ok(point)
    }

    /// `count` points that lie uniformly in the parameter, all coordinates in turn: at i/count of the domain of a
    /// closed curve, at i/(count − 1) of an open one. Each kind of curve has a `sample` of its own, which is quicker.
    ///
    /// # Errors
    ///
    /// More than 4 million points.
    fn sample(&self, count: usize) -> Result<Vec<f64>> {
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        let (start, end) = self.domain();
        let steps = steps(count, self.closed()) as f64;
        let mut parameters = with_room(count)?;
        parameters.extend((0..count).map(|i| (start + (end - start) * (i as f64 / steps)).min(end)));
        let mut points = filled(0.0, count * self.dimension())?;
        self.values(&parameters, 0, &mut points)?;
        Ok(points)
    }

    /// First and last parameter. A closed curve takes any other as well, and begins anew there.
    fn domain(&self) -> (f64, f64) {
        (self.knot(0), self.knot(self.piece_count()))
    }

    /// Whether the end is joined to the start.
    fn is_closed(&self) -> bool {
        self.closed()
    }

    /// How many coordinates a point has: 2 or 3.
    fn dimension(&self) -> usize {
        self.coordinate_count()
    }

    /// The length of the curve.
    ///
    /// Gauss–Legendre sums of the speed, with as many nodes as a proved bound of their error asks for. Where a cusp or
    /// a near-cusp leaves no room the interval is halved.
    ///
    /// # Accuracy
    ///
    /// `tolerance`, absolute, but not below 1e-15 of a segment's size for each.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite, or not positive.
    ///
    /// # Cost
    ///
    /// 4 to 24 speeds per segment, about a thousand at a cusp. No allocation for Hermite curves.
    fn length(&self, tolerance: f64) -> Result<f64> {
        length::length(self.as_pieces(), tolerance)
    }

    /// The parameter at which the curve has the length `length` behind it.
    ///
    /// # Accuracy
    ///
    /// The length up to the parameter that is returned is within `tolerance` of `length`, as for [`Curve::length`].
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive, `length` not finite, negative or beyond the length of the curve.
    fn parameter_at_length(&self, length: f64, tolerance: f64) -> Result<f64> {
        length::parameter_at_length(self.as_pieces(), length, tolerance)
    }

    /// The parameters of `count` points that are equally far apart along the curve.
    ///
    /// An open curve gets both ends; a closed one starts at its start and the last point is one step before the end.
    ///
    /// # Accuracy
    ///
    /// Every point is within `tolerance` of its place along the curve (checked at three places of every
    /// cell, with a factor 8 to spare; the error of the polynomials is largest in the middle).
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    ///
    /// # Cost
    ///
    /// About 4 µs for each segment and 20 ns for each point; in space 5 µs for each point.
    fn sample_by_length(&self, count: usize, tolerance: f64) -> Result<Vec<f64>> {
        let curve = self.as_pieces();
        LengthTable::of(curve, tolerance)?.parameters_of(curve, count)
    }

    /// The points at those parameters, all coordinates in turn: quicker than looking for the parameters again. For many
    /// samplings of one curve prepare a [`LengthTable`].
    ///
    /// # Errors
    ///
    /// As for [`Curve::sample_by_length`].
    fn points_by_length(&self, count: usize, tolerance: f64) -> Result<Vec<f64>> {
        let curve = self.as_pieces();
        LengthTable::of(curve, tolerance)?.points_of(curve, count)
    }

    /// The signed area that a closed curve of the plane encloses.
    ///
    /// ```text
    /// A = ½ ∮ (x dy − y dx)
    /// ```
    ///
    /// Positive for a curve that turns from the x axis towards the y axis: counter-clockwise in a y-up world, clockwise
    /// on a screen whose y points down. A curve that goes round twice counts twice, a figure of eight the difference.
    ///
    /// # Accuracy
    ///
    /// A few roundings of the extent squared: Gauss–Legendre sums of 24 nodes, whose remainder is below 1e-17 for every
    /// piece.
    ///
    /// # Errors
    ///
    /// `Degenerate` for an open curve, which encloses nothing, and for one in space.
    fn area(&self) -> Result<f64> {
        area::area(self.as_pieces())
    }

    /// The centre of mass of what a closed curve of the plane encloses.
    ///
    /// ```text
    /// c = ∮ r (r × dr) / 3A,   A = ½ ∮ r × dr
    /// ```
    ///
    /// # Accuracy
    ///
    /// A few roundings of the extent cubed, divided by the area.
    ///
    /// # Errors
    ///
    /// `Degenerate` as for [`Curve::area`], and for a curve that encloses no area: a double line, or a figure of eight
    /// whose halves cancel.
    fn centroid(&self) -> Result<Point> {
        area::centroid(self.as_pieces())
    }

    /// The smallest upright box that holds the curve: the exact extrema, not those of a control polygon.
    ///
    /// A piece whose hull lies in the box of what was already seen is passed over. Of the others every zero of each
    /// coordinate's derivative is found: where bounds of the higher derivatives prove that it is monotone, by Newton's
    /// method in a bracket.
    ///
    /// # Accuracy
    ///
    /// A few roundings of the largest coordinate; extrema are insensitive to errors of their parameter.
    ///
    /// # Cost
    ///
    /// O(segments), no allocation for Hermite curves.
    fn bounds(&self) -> Bounds {
        bounds::bounds(self.as_pieces())
    }

    /// The point of a plane curve that is nearest to `place`.
    ///
    /// Of several equally near ones (to 1e-13 of the curve's size) the one with the smallest t. For many questions to
    /// one curve prepare a [`NearestFinder`].
    ///
    /// # Accuracy
    ///
    /// The distance is at most 2e-13 of the curve's size larger than the least one, and never a local minimum only
    /// (`tests/curve/nearest.rs`, against dense sampling). From a `place` that is not finite, or beyond 1e154, nothing
    /// is at a finite distance: the answer is t = 0 with the place itself and the distance ∞. A curve in space counts
    /// as its projection.
    fn nearest(&self, place: Point) -> Nearest {
        NearestFinder::of(self.as_pieces()).nearest(place)
    }

    /// The point of a curve in space that is nearest to `place`, as surely as [`Curve::nearest`].
    ///
    /// # Cost
    ///
    /// O(pieces).
    fn nearest_in_space(&self, place: [f64; 3]) -> SpaceNearest {
        nearest_in_space::nearest_in_space(self.as_pieces(), place)
    }

    /// A polyline within `tolerance` of the curve, and the bound of its distance that was proved.
    ///
    /// The points are on the curve, every end of a piece is one of them, and their coordinates come in turn. A closed
    /// curve's first point is not repeated at the end: the last edge of the polyline closes it.
    ///
    /// # Accuracy
    ///
    /// Both ways: no point of the curve is farther than the bound from the polyline, and no point of the polyline
    /// farther from the curve. A tolerance below 1e-9 of the extent or 1e-15 of the largest coordinate is raised to
    /// that; the bound says so.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    ///
    /// # Cost
    ///
    /// 20 to 50 ns for each point of a Hermite curve; 200 or more at cusps, where a hyperbolic frequency is above 4,
    /// and of curves of any roots.
    fn flatten(&self, tolerance: f64) -> Result<(Vec<f64>, f64)> {
        flatten::flatten(self.as_pieces(), tolerance)
    }

    /// Cubic Bézier curves within `tolerance` of the curve, as few as can be; ends of segments stay ends.
    ///
    /// Cubic segments and straight lines are converted exactly. An arc gets the cubics that share the ends and tangents
    /// and cross it twice each, error of the sixth order, or around inflections come as near as they can; the ends
    /// between them are moved until their errors are even.
    /// In space the cubics share ends and derivatives, error of the fourth order.
    ///
    /// # Accuracy
    ///
    /// `deviation` is a proved bound of the distance both ways, everywhere: see the module `cubic_proof`. A quarter of
    /// a circle is off by 1.96e-4 of the radius and proved to be within 2.0e-4. A tolerance below 1e-9 of the extent or
    /// 1e-15 of the largest coordinate is raised to that; the deviation says so.
    ///
    /// # Errors
    ///
    /// `tolerance` not finite or not positive; more than 4 000 000 points.
    ///
    /// # Cost
    ///
    /// 20 ns for a cubic segment, 3 to 15 µs for each cubic of another one.
    fn to_cubics(&self, tolerance: f64) -> Result<Cubics> {
        cubics::to_cubics(self.as_pieces(), tolerance)
    }

    /// The same plane curve with points and tangents, and the deviation: 0 where its functions are those of a Hermite
    /// curve (roots 0 up to twice and one pair ±iω or ±k, or 0 up to four times), else that of cubics, which is proved.
    ///
    /// The parameter starts at 0 and stays: everywhere where the deviation is 0; of cubics at the ends of the curve's
    /// own segments, between which places lie at other parameters than before. Where a tangent would be beyond ±1e9 or
    /// a segment shorter than 1e-12 it runs slower, by a power of 2.
    ///
    /// # Errors
    ///
    /// A curve in space; as for [`Curve::to_cubics`].
    fn to_hermite(&self, tolerance: f64) -> Result<(HermiteCurve, f64)> {
        check_tolerance(tolerance)?;
        convert::to_hermite(self.as_pieces(), tolerance)
    }

    /// The signed curvature at t; `None` where the speed is zero and the curve has no direction.
    ///
    /// ```text
    /// κ = (r′ × r″) / |r′|³
    /// ```
    ///
    /// Positive where the curve turns from the x axis towards the y axis: to the left in a y-up world, clockwise on
    /// a screen whose y points down. In space it has no sign. At a point where two segments meet it is that of the
    /// segment that leaves.
    ///
    /// # Accuracy
    ///
    /// A few roundings where the speed is of the size of the tangents, 1/speed³ times that near a cusp. A speed below
    /// 1e-15 of the segment's tangents and chord cannot be told from zero and counts as zero.
    ///
    /// # Errors
    ///
    /// `t` not finite, or outside the domain of an open curve.
    fn curvature(&self, t: f64) -> Result<Option<f64>> {
        curvature::curvature(self.as_pieces(), t)
    }
}

impl<G: Generator> Curve for SplineCurve<G> {
    fn as_pieces(&self) -> &dyn Pieces {
        self
    }
}

impl Curve for HermiteCurve {
    fn as_pieces(&self) -> &dyn Pieces {
        self
    }
}
