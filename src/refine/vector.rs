//! The vector scheme: points with derivatives become more points with derivatives, all of them on the curve.

use core::f64::consts::TAU;

use super::check_levels;
use crate::error::{Error, Result};
use crate::generator::{Basis, Space};
use crate::limits::{
    LARGEST_COORDINATE, LARGEST_FREQUENCY, MOST_OUTPUT_POINTS, POLE_MARGIN, check, with_room,
};
use crate::numerics::lists::steps;
use crate::numerics::{Point, Vector};

/// Points on a curve with the derivatives that leave and arrive there.
///
/// Where a curve is smooth the two are equal. Segment i goes from point i to the next and has frequency
/// `omega[i]` and parameter length `lengths[i]`; a closed curve has as many segments as points, an open one
/// fewer by one.
#[derive(Clone, Debug, PartialEq)]
pub struct HermiteData {
    /// The space that every segment is in.
    pub space: Space,
    /// Whether the last point is joined to the first.
    pub closed: bool,
    /// Points on the curve.
    pub points: Vec<Point>,
    /// dr/dt leaving each point.
    pub leaving: Vec<Vector>,
    /// dr/dt arriving at each point.
    pub arriving: Vec<Vector>,
    /// ω of every segment, in radians per unit of t.
    pub omega: Vec<f64>,
    /// Parameter length of every segment.
    pub lengths: Vec<f64>,
}

impl HermiteData {
    pub(super) fn check(&self) -> Result<()> {
        let count = self.points.len();
        if count < 2 {
            return Err(Error::too_few("points", count, 2));
        }
        let segments = steps(count, self.closed);
        for (argument, got, needed) in [
            ("tangents", self.leaving.len(), count),
            ("tangentsIn", self.arriving.len(), count),
            ("omega", self.omega.len(), segments),
            ("lengths", self.lengths.len(), segments),
        ] {
            if got != needed {
                return Err(Error::wrong_length(argument, got, needed));
            }
        }
        for (argument, list) in
            [("points", &self.points), ("tangents", &self.leaving), ("tangentsIn", &self.arriving)]
        {
            for (i, &value) in list.iter().flatten().enumerate() {
                check(argument, Some(i), value, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
            }
        }
        let mut segments = self.omega.iter().zip(&self.lengths).enumerate();
        segments.try_for_each(|(i, (&omega, &length))| check_segment(Some(i), self.space, omega, length))
    }

    fn with_room(space: Space, closed: bool, segments: usize) -> Result<Self> {
        let count = if closed { segments } else { segments + 1 };
        Ok(Self {
            space,
            closed,
            points: with_room(count)?,
            leaving: with_room(count)?,
            arriving: with_room(count)?,
            omega: with_room(segments)?,
            lengths: with_room(segments)?,
        })
    }

    fn push(&mut self, point: Point, leaving: Vector, arriving: Vector) {
        self.points.push(point);
        self.leaving.push(leaving);
        self.arriving.push(arriving);
    }

    /// Every segment with its end points and end derivatives.
    fn segments(&self) -> impl Iterator<Item = (Point, Vector, Point, Vector, f64, f64)> {
        let next = (1..self.points.len()).chain(core::iter::once(0));
        self.points.iter().zip(&self.leaving).zip(next).zip(self.omega.iter().zip(&self.lengths)).map(
            |(((&start, &leaving), next), (&omega, &length))| {
                (start, leaving, self.points[next], self.arriving[next], omega, length)
            },
        )
    }
}

/// Refuses lengths and frequencies that no segment can have.
pub(super) fn check_segment(index: Option<usize>, space: Space, omega: f64, length: f64) -> Result<()> {
    check("lengths", index, length, f64::MIN_POSITIVE, LARGEST_COORDINATE)?;
    let most = if space == Space::Trigonometric { TAU - POLE_MARGIN } else { LARGEST_FREQUENCY };
    check("omega", index, omega, -most / length, most / length)
}

/// The matrix mask of one refinement of one segment: how the places k/arity between its ends take their value
/// and derivative from it.
///
/// # Source
///
/// [CRU15, eq. 33–35], in difference form, so that a translation of the curve is a translation of the result.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixMask {
    space: Space,
    omega: f64,
    length: f64,
    arity: usize,
    /// For every place the matrices that act on the start and on the end.
    taps: Vec<[[f64; 4]; 2]>,
}

impl MatrixMask {
    /// The mask for a segment of frequency `omega` and parameter length `length`, cut into `arity` pieces.
    ///
    /// # Errors
    ///
    /// A `length` that is not positive or above 1e9; `omega·length` beyond ±2π in the trigonometric space, ±1e4 in
    /// others; an arity of 0 or above 4 million.
    pub fn new(space: Space, omega: f64, length: f64, arity: usize) -> Result<Self> {
        check_segment(None, space, omega, length)?;
        check("arity", None, arity as f64, 1.0, MOST_OUTPUT_POINTS as f64)?;
        let mut mask = Self { space, omega, length, arity, taps: with_room(arity)? };
        mask.fill();
        Ok(mask)
    }

    /// The same mask for another segment; what is there already is kept.
    fn retarget(&mut self, omega: f64, length: f64) {
        if (self.omega, self.length) != (omega, length) {
            (self.omega, self.length) = (omega, length);
            self.fill();
        }
    }

    fn fill(&mut self) {
        let basis = Basis::new(self.space, self.omega * self.length);
        self.taps.clear();
        for k in 1..self.arity {
            self.taps.push(basis.taps(self.length, k as f64 / self.arity as f64));
        }
    }

    /// The matrix `H[n]`, row by row, that acts on the column (value, derivative) at the end of the segment that is n
    /// fine steps to the left of the new place; zero for |n| ≥ arity.
    pub fn matrix(&self, n: isize) -> [f64; 4] {
        if n == 0 {
            return [1.0, 0.0, 0.0, 1.0];
        }
        let place = if n > 0 { n.unsigned_abs() } else { self.arity.wrapping_sub(n.unsigned_abs()) };
        let taps = place.checked_sub(1).and_then(|k| self.taps.get(k));
        taps.map_or([0.0; 4], |[start, end]| if n > 0 { *start } else { *end })
    }

    /// The new points and derivatives inside a segment from its ends.
    fn places(
        &self,
        start: Point,
        leaving: Vector,
        end: Point,
        arriving: Vector,
    ) -> impl Iterator<Item = (Point, Vector)> {
        let chord = end - start;
        self.taps.iter().map(move |[from_start, from_end]| {
            let point = start + chord * from_end[0] + leaving * from_start[1] + arriving * from_end[1];
            let derivative = chord * from_end[2] + leaving * from_start[3] + arriving * from_end[3];
            (point, derivative)
        })
    }

    /// Refines all segments once.
    fn apply(&mut self, data: &HermiteData) -> Result<HermiteData> {
        let mut finer =
            HermiteData::with_room(data.space, data.closed, data.lengths.len().saturating_mul(self.arity))?;
        let arriving = data.arriving.iter();
        for ((start, leaving, end, before_end, omega, length), &arriving) in data.segments().zip(arriving) {
            self.retarget(omega, length);
            finer.push(start, leaving, arriving);
            for (point, derivative) in self.places(start, leaving, end, before_end) {
                finer.push(point, derivative, derivative);
            }
            for _ in 0..self.arity {
                finer.omega.push(omega);
                finer.lengths.push(length / self.arity as f64);
            }
        }
        if let (false, Some(&point), Some(&leaving), Some(&arriving)) =
            (data.closed, data.points.last(), data.leaving.last(), data.arriving.last())
        {
            finer.push(point, leaving, arriving);
        }
        Ok(finer)
    }
}

/// The vector scheme: `levels` refinements by `arity`. Every new point lies on the curve, every derivative is the
/// curve's own.
///
/// Segments may differ in frequency and in parameter length; ω stays what it is, so that a segment's mask
/// changes from level to level with ω times the step, as it must.
///
/// # Accuracy
///
/// Points to 2e-15 of the data's size however many levels; derivatives to 1e-15·arity^levels, for a derivative is a
/// difference of points divided by the step (`tests/refine/hermite.rs`).
///
/// # Errors
///
/// Lengths that do not match; numbers that are not finite or that no curve may have; an arity of 0; more than 24
/// levels; more than 4 million points.
///
/// # Source
///
/// [CRU15, eq. 34] with the index corrected (docs/SOURCES.md).
pub fn subdivide_hermite(data: &HermiteData, arity: usize, levels: usize) -> Result<HermiteData> {
    data.check()?;
    check_levels(data.lengths.len(), arity, levels)?;
    let mut mask = MatrixMask::new(data.space, data.omega[0], data.lengths[0], arity)?;
    let mut result = data.clone();
    for _ in 0..levels {
        result = mask.apply(&result)?;
    }
    Ok(result)
}
