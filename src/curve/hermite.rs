//! Hermite exponential curves: points on the curve, with the derivatives that arrive and leave.

mod cut;
mod deviation;
mod edit;
mod ellipse;
mod heal;
mod places;
pub(super) mod recognise;
pub(super) mod refine;
pub(super) mod sample;
pub(super) mod sampler;
pub(super) mod subdivide;
mod through;

use core::f64::consts::TAU;

use super::Segment;
use crate::error::{Error, Result};
use crate::generator::{Basis, Space};
use crate::limits::{
    LARGEST_COORDINATE, LARGEST_FREQUENCY, LARGEST_TANGENT, LEAST_LENGTH, MOST_POINTS, POLE_MARGIN, check,
    filled, settle, too_many, with_room,
};
use crate::numerics::angle::wrapped;
use crate::numerics::lists::steps;
use crate::numerics::plane::enlarge;
use crate::numerics::{Point, Vector};

/// Which side of a control point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// The derivative that arrives at the point.
    In,
    /// The derivative that leaves the point.
    Out,
    /// Both at once.
    Both,
}

/// What a [`HermiteCurve`] is made from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HermiteOptions {
    /// Points on the curve; by default none, which makes no curve.
    pub points: Vec<Point>,
    /// dr/dt leaving each point, one per point; empty by default, which fits no points.
    pub tangents: Vec<Vector>,
    /// dr/dt arriving at each point; empty where it is the same as leaving.
    pub tangents_in: Vec<Vector>,
    /// Closed, or open, which is the default here; the npm package closes curves by default.
    pub closed: bool,
    /// The space; `None`, the default, is trigonometric.
    pub space: Option<Space>,
    /// ω in radians per unit of t: empty for the default (2π/M for a closed trigonometric curve of M ≥ 2 points,
    /// else 0), one for all segments, or one per segment.
    pub omega: Vec<f64>,
    /// Parameter length of every segment; empty for 1 each.
    pub lengths: Vec<f64>,
}

/// A curve through its points, with the derivatives there, exact for ellipses, cubics and lines alike.
///
/// Curves are equal that have the same numbers; one that was refined is another, though of the same shape.
#[derive(Clone, Debug)]
#[must_use = "an edited curve is a new one: this one stays as it was"]
pub struct HermiteCurve {
    // Behind a pointer: curves are handed around a lot, and are a dozen words.
    inner: Box<Inner>,
}

#[derive(Clone, Debug)]
struct Inner {
    /// Complete: every list has its full length.
    data: HermiteOptions,
    space: Space,
    knots: Vec<f64>,
    /// The last of them.
    end: f64,
    bases: Vec<Basis>,
    basis_of: Vec<u32>,
    /// Whether all lengths are one.
    even: bool,
}

impl PartialEq for HermiteCurve {
    fn eq(&self, other: &Self) -> bool {
        // The lists are complete: what was left out when a curve was made is there as well. All else follows from them.
        let (mine, theirs) = (&self.inner.data, &other.inner.data);
        (mine.closed, self.space()) == (theirs.closed, other.space())
            && (&mine.points, &mine.omega, &mine.lengths) == (&theirs.points, &theirs.omega, &theirs.lengths)
            && (&mine.tangents, &mine.tangents_in) == (&theirs.tangents, &theirs.tangents_in)
    }
}

impl HermiteCurve {
    /// A curve from points and tangents.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong: too few points (2 are needed), lengths that do not match, a number that is
    /// not finite or not within ±1e9 (tangents ±8e9), a segment length that is not positive, ω·length outside its
    /// range.
    pub fn new(options: HermiteOptions) -> Result<Self> {
        let (knots, bases, basis_of) = (Vec::new(), Vec::new(), Vec::new());
        let space = options.space.unwrap_or(Space::Trigonometric);
        let inner = Inner { data: options, space, knots, end: 0.0, bases, basis_of, even: true };
        let mut curve = Self { inner: Box::new(inner) };
        let implied = curve.inner.complete()?;
        curve.inner.check(implied)?;
        curve.inner.prepare()?;
        Ok(curve)
    }

    /// The points.
    pub fn points(&self) -> &[Point] {
        &self.inner.data.points
    }

    /// dr/dt leaving each point.
    pub fn tangents(&self) -> &[Vector] {
        &self.inner.data.tangents
    }

    /// dr/dt arriving at each point.
    pub fn tangents_in(&self) -> &[Vector] {
        &self.inner.data.tangents_in
    }

    /// ω of every segment, in radians per unit of t.
    pub fn omega(&self) -> &[f64] {
        &self.inner.data.omega
    }

    /// Parameter length of every segment.
    pub fn lengths(&self) -> &[f64] {
        &self.inner.data.lengths
    }

    /// The parameters at the points, one more than there are segments.
    pub fn knots(&self) -> &[f64] {
        &self.inner.knots
    }

    /// The space.
    pub fn space(&self) -> Space {
        self.inner.space
    }

    /// Whether the last point is joined to the first.
    pub fn is_closed(&self) -> bool {
        self.inner.data.closed
    }

    /// How many segments there are.
    pub fn segment_count(&self) -> usize {
        self.inner.data.lengths.len()
    }

    /// First and last parameter.
    pub fn domain(&self) -> (f64, f64) {
        (0.0, self.inner.end)
    }

    /// Segment i, from point i to the next.
    ///
    /// # Errors
    ///
    /// i beyond the last segment.
    pub fn segment(&self, i: usize) -> Result<Segment<'_>> {
        check("i", None, i as f64, 0.0, self.segment_count() as f64 - 1.0)?;
        Ok(self.nth_segment(i))
    }

    /// [`Self::segment`] for an i that is there.
    #[inline(never)]
    pub(crate) fn nth_segment(&self, i: usize) -> Segment<'_> {
        let (data, next) = (&self.inner.data, self.next(i));
        Segment {
            start: data.points[i],
            end: data.points[next],
            leaving: data.tangents[i],
            arriving: data.tangents_in[next],
            length: data.lengths[i],
            basis: &self.inner.bases[self.inner.basis_of[i] as usize],
        }
    }

    /// Whether all segments have one parameter length.
    pub(super) fn is_even(&self) -> bool {
        self.inner.even
    }

    /// The index of the point after point i, the first after the last.
    pub(super) fn next(&self, i: usize) -> usize {
        if i + 1 == self.inner.data.points.len() { 0 } else { i + 1 }
    }

    /// The curve with other tangents, the same on both sides of every point.
    pub(super) fn with_tangents(mut self, tangent: &dyn Fn(usize) -> Vector) -> Result<Self> {
        let data = &mut self.inner.data;
        for (i, (leaving, arriving)) in data.tangents.iter_mut().zip(&mut data.tangents_in).enumerate() {
            *leaving = tangent(i);
            *arriving = *leaving;
        }
        self.inner.check(false)?;
        Ok(self)
    }

    /// Makes the curve so many times as wide and as high, and moves it back by a vector.
    pub(crate) fn enlarge(&mut self, times: Vector, back: Vector) {
        let data = &mut self.inner.data;
        enlarge(&mut data.points, times, back);
        enlarge(&mut data.tangents, times, Vector::zeros());
        enlarge(&mut data.tangents_in, times, Vector::zeros());
    }

    /// Everything that the curve is made from; [`HermiteCurve::new`] gives it back to the last bit.
    pub fn to_options(&self) -> HermiteOptions {
        HermiteOptions { space: Some(self.inner.space), ..self.inner.data.clone() }
    }

    /// All segments in order.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment<'_>> {
        (0..self.segment_count()).map(|i| self.nth_segment(i))
    }

    /// The segment that t lies in and the local x in [0, 1].
    ///
    /// # Errors
    ///
    /// A t that is not finite; outside its domain for an open curve. A closed one takes any other.
    pub fn locate(&self, t: f64) -> Result<(usize, f64)> {
        let (start, end) = if self.inner.data.closed { (f64::MIN, f64::MAX) } else { self.domain() };
        check("t", None, t, start, end)?;
        Ok(self.place(t, 0))
    }

    /// [`HermiteCurve::locate`] for a t that is allowed, quick if it lies in segment `guess`.
    pub(super) fn place(&self, t: f64, guess: usize) -> (usize, f64) {
        let (_, end) = self.domain();
        let t = if self.inner.data.closed && !(0.0..end).contains(&t) { wrapped(t, end) } else { t };
        let i = match self.inner.knots.get(guess..guess + 2) {
            Some([first, last]) if (*first..*last).contains(&t) => guess,
            _ => {
                let after = self.inner.knots.partition_point(|&knot| knot <= t);
                after.saturating_sub(1).min(self.segment_count() - 1)
            }
        };
        (i, ((t - self.inner.knots[i]) / self.inner.data.lengths[i]).clamp(0.0, 1.0))
    }

    /// The point at t, or the first or second derivative; at a knot the limit from the right.
    ///
    /// # Errors
    ///
    /// Those of [`Self::locate`]; a derivative above the second.
    pub fn evaluate(&self, t: f64, derivative: usize) -> Result<Vector> {
        let (i, x) = self.locate(t)?;
        let segment = self.nth_segment(i);
        check_derivative(derivative)?;
        Ok(segment.derivative(x, derivative))
    }
}

impl Inner {
    /// Fills in what may be left out, and checks that all fits together. Says whether ω was left out.
    fn complete(&mut self) -> Result<bool> {
        let data = &mut self.data;
        let count = data.points.len();
        if count < 2 {
            return Err(Error::too_few("points", count, 2));
        }
        if count > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, count));
        }
        let segments = steps(count, data.closed);
        if data.tangents_in.is_empty() {
            data.tangents_in = data.tangents.clone();
        }
        if data.lengths.is_empty() {
            data.lengths = filled(1.0, segments)?;
        }
        let implied = data.omega.is_empty();
        if data.omega.len() < 2 {
            let round = data.closed && self.space == Space::Trigonometric;
            let usual = if round { TAU / count as f64 } else { 0.0 };
            data.omega = filled(data.omega.first().copied().unwrap_or(usual), segments)?;
        }
        for (argument, got, needed) in [
            ("tangents", data.tangents.len(), count),
            ("tangentsIn", data.tangents_in.len(), count),
            ("lengths", data.lengths.len(), segments),
            ("omega", data.omega.len(), segments),
        ] {
            if got != needed {
                return Err(Error::wrong_length(argument, got, needed));
            }
        }
        Ok(implied)
    }

    /// Checks every number; where ω is `implied`, a segment that is too long for it is at fault.
    fn check(&mut self, implied: bool) -> Result<()> {
        let data = &mut self.data;
        check_vectors("points", &mut data.points, LARGEST_COORDINATE)?;
        check_vectors("tangents", &mut data.tangents, LARGEST_TANGENT)?;
        check_vectors("tangentsIn", &mut data.tangents_in, LARGEST_TANGENT)?;
        for (i, (&w, &length)) in data.omega.iter().zip(&data.lengths).enumerate() {
            if (0.0..LEAST_LENGTH).contains(&length) {
                let (index, reason) = (Some(i), "knots closer than 1e-12");
                return Err(Error::degenerate("lengths", index, reason));
            }
            check("lengths", Some(i), length, LEAST_LENGTH, LARGEST_COORDINATE)?;
            let fastest =
                if self.space == Space::Trigonometric { TAU - POLE_MARGIN } else { LARGEST_FREQUENCY };
            if implied && w > fastest / length {
                return Err(Error::out_of_range("lengths", Some(i), length, LEAST_LENGTH, fastest / w));
            }
            check("omega", Some(i), w, 0.0, fastest / length)?;
        }
        Ok(())
    }

    /// Knots, and one basis for every run of equal ω·length, so that a uniform curve holds just one.
    fn prepare(&mut self) -> Result<()> {
        let Self { data, space, knots, end, bases, basis_of, even } = self;
        *knots = with_room(data.lengths.len() + 1)?;
        *basis_of = with_room(data.lengths.len())?;
        // Compensated sums: a hundred equal pieces of a segment end where the segment did.
        let (mut sum, mut lost) = (0.0, 0.0);
        knots.push(0.0);
        for (&w, &length) in data.omega.iter().zip(&data.lengths) {
            let next = sum + length;
            // Lengths are positive: the larger of the two numbers kept its digits.
            lost += if sum >= length { (sum - next) + length } else { (length - next) + sum };
            sum = next;
            *end = sum + lost;
            knots.push(*end);
            *even &= length == data.lengths[0];
            let frequency = if *space == Space::Polynomial { 0.0 } else { w * length };
            if bases.last().is_none_or(|basis| basis.frequency() != frequency) {
                bases.push(Basis::new(*space, frequency));
            }
            basis_of.push(bases.len() as u32 - 1);
        }
        Ok(())
    }
}

#[inline(never)]
fn check_vectors(argument: &'static str, vectors: &mut [Vector], most: f64) -> Result<()> {
    // Nearly always all are in range, and a loop that calls nothing sees that. NaN is in none.
    let mut fit = true;
    for v in vectors.iter_mut() {
        fit &= v.x.abs() <= most && v.y.abs() <= most;
        settle(v.as_mut_slice());
    }
    if fit {
        return Ok(());
    }
    for (i, &value) in vectors.iter().flatten().enumerate() {
        check(argument, Some(i), value, -most, most)?;
    }
    Ok(())
}

pub(super) fn check_derivative(derivative: usize) -> Result<()> {
    check("derivative", None, derivative as f64, 0.0, 2.0)
}
