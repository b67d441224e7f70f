//! Hermite exponential curves: points on the curve, with the derivatives that arrive and leave.

use super::Segment;
use super::limits::{
    LARGEST_COORDINATE, LARGEST_FREQUENCY, LEAST_LENGTH, MOST_POINTS, POLE_MARGIN, too_many,
};
use crate::error::{Error, Result};
use crate::generator::{Basis, Space};
use crate::numerics::{Point, Vector};

/// Which side of a control point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The derivative that arrives at the point.
    In,
    /// The derivative that leaves the point.
    Out,
    /// Both at once.
    Both,
}

/// What a [`HermiteCurve`] is made from.
#[derive(Clone, Debug, Default)]
pub struct HermiteOptions {
    /// Points on the curve.
    pub points: Vec<Point>,
    /// dr/dt leaving each point.
    pub tangents: Vec<Vector>,
    /// dr/dt arriving at each point; empty where it is the same as leaving.
    pub tangents_in: Vec<Vector>,
    /// Closed or open.
    pub closed: bool,
    /// The space; `None` is trigonometric.
    pub space: Option<Space>,
    /// ω in radians per unit of t: empty for the default (2π/M for a closed trigonometric curve of M ≥ 2 points,
    /// else 0), one for all segments, or one per segment.
    pub omega: Vec<f64>,
    /// Parameter length of every segment; empty for 1 each.
    pub lengths: Vec<f64>,
}

/// A curve through its points, with the derivatives there, exact for ellipses, cubics and lines alike.
#[derive(Clone, Debug)]
pub struct HermiteCurve {
    points: Vec<Point>,
    tangents: Vec<Vector>,
    tangents_in: Vec<Vector>,
    omega: Vec<f64>,
    lengths: Vec<f64>,
    knots: Vec<f64>,
    bases: Vec<Basis>,
    basis_of: Vec<u32>,
    space: Space,
    closed: bool,
    /// Whether all lengths are one.
    even: bool,
}

impl HermiteCurve {
    /// A curve from points and tangents.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong: too few points (2 are needed), lengths that do not match, a number that is
    /// not finite or not within ±1e9, a segment length that is not positive, ω·length outside its range.
    pub fn new(options: HermiteOptions) -> Result<Self> {
        let HermiteOptions { points, tangents, tangents_in, closed, space, omega, lengths } = options;
        let space = space.unwrap_or(Space::Trigonometric);
        let count = points.len();
        if count < 2 {
            return Err(Error::TooFewPoints { argument: "points", got: count, needed: 2 });
        }
        if count > MOST_POINTS {
            return Err(too_many("points", "maxPoints", MOST_POINTS, count));
        }
        check_vectors("points", &points)?;
        check_count("tangents", tangents.len(), count)?;
        check_vectors("tangents", &tangents)?;
        let tangents_in = if tangents_in.is_empty() { tangents.clone() } else { tangents_in };
        check_count("tangentsIn", tangents_in.len(), count)?;
        check_vectors("tangentsIn", &tangents_in)?;
        let segments = if closed { count } else { count - 1 };
        let lengths = if lengths.is_empty() { vec![1.0; segments] } else { lengths };
        check_count("lengths", lengths.len(), segments)?;
        let omega = match omega.len() {
            0 if closed && space == Space::Trigonometric => {
                vec![core::f64::consts::TAU / count as f64; segments]
            }
            0 => vec![0.0; segments],
            1 => vec![omega[0]; segments],
            _ => omega,
        };
        check_count("omega", omega.len(), segments)?;
        let (bases, basis_of) = bases(space, &omega, &lengths)?;
        let knots = running_sums(&lengths);
        let even = lengths.iter().all(|length| *length == lengths[0]);
        Ok(Self {
            points,
            tangents,
            tangents_in,
            omega,
            lengths,
            knots,
            bases,
            basis_of,
            space,
            closed,
            even,
        })
    }

    /// The points.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// dr/dt leaving each point.
    pub fn tangents(&self) -> &[Vector] {
        &self.tangents
    }

    /// dr/dt arriving at each point.
    pub fn tangents_in(&self) -> &[Vector] {
        &self.tangents_in
    }

    /// ω of every segment, in radians per unit of t.
    pub fn omega(&self) -> &[f64] {
        &self.omega
    }

    /// Parameter length of every segment.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// The parameters at the points, one more than there are segments.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The space.
    pub fn space(&self) -> Space {
        self.space
    }

    /// Whether the last point is joined to the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// How many segments there are.
    pub fn segment_count(&self) -> usize {
        self.lengths.len()
    }

    /// First and last parameter.
    pub fn domain(&self) -> (f64, f64) {
        (0.0, self.knots[self.knots.len() - 1])
    }

    /// Segment i, from point i to the next.
    pub fn segment(&self, i: usize) -> Segment<'_> {
        let next = self.next(i);
        Segment {
            start: self.points[i],
            end: self.points[next],
            leaving: self.tangents[i],
            arriving: self.tangents_in[next],
            length: self.lengths[i],
            basis: &self.bases[self.basis_of[i] as usize],
        }
    }

    /// Whether all segments have one parameter length.
    pub(super) fn is_even(&self) -> bool {
        self.even
    }

    /// The index of the point after point i, the first after the last.
    pub(super) fn next(&self, i: usize) -> usize {
        if i + 1 == self.points.len() { 0 } else { i + 1 }
    }

    /// Everything that the curve is made from; [`HermiteCurve::new`] gives it back to the last bit.
    pub fn to_options(&self) -> HermiteOptions {
        HermiteOptions {
            points: self.points.clone(),
            tangents: self.tangents.clone(),
            tangents_in: self.tangents_in.clone(),
            closed: self.closed,
            space: Some(self.space),
            omega: self.omega.clone(),
            lengths: self.lengths.clone(),
        }
    }

    /// All segments in order.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment<'_>> {
        (0..self.segment_count()).map(|i| self.segment(i))
    }

    /// The segment that t lies in and the local x in [0, 1].
    ///
    /// A closed curve takes any finite t; an open one refuses t outside its domain.
    pub fn locate(&self, t: f64) -> Result<(usize, f64)> {
        if !t.is_finite() {
            return Err(Error::NotFinite { argument: "t", index: None });
        }
        let (_, end) = self.domain();
        if !self.closed && !(0.0..=end).contains(&t) {
            return Err(Error::OutOfRange { argument: "t", index: None, value: t, least: 0.0, most: end });
        }
        Ok(self.place(t, 0))
    }

    /// [`HermiteCurve::locate`] for a t that is allowed, quick if it lies in segment `guess`.
    pub(super) fn place(&self, t: f64, guess: usize) -> (usize, f64) {
        let (_, end) = self.domain();
        let t = if self.closed && !(0.0..end).contains(&t) {
            let wrapped = t - end * (t / end).floor();
            if wrapped >= end || wrapped < 0.0 { 0.0 } else { wrapped }
        } else {
            t
        };
        let i = match self.knots.get(guess..guess + 2) {
            Some([first, last]) if (*first..*last).contains(&t) => guess,
            _ => {
                let after = self.knots.partition_point(|&knot| knot <= t);
                after.saturating_sub(1).min(self.segment_count() - 1)
            }
        };
        (i, ((t - self.knots[i]) / self.lengths[i]).clamp(0.0, 1.0))
    }

    /// The point at t, or the first or second derivative; at a knot the limit from the right.
    pub fn evaluate(&self, t: f64, derivative: usize) -> Result<Vector> {
        let (i, x) = self.locate(t)?;
        let segment = self.segment(i);
        check_derivative(derivative)?;
        Ok(segment.derivative(x, derivative))
    }
}

pub(super) fn check_derivative(derivative: usize) -> Result<()> {
    if derivative <= 2 {
        return Ok(());
    }
    let value = derivative as f64;
    Err(Error::OutOfRange { argument: "derivative", index: None, value, least: 0.0, most: 2.0 })
}

fn check_count(argument: &'static str, got: usize, needed: usize) -> Result<()> {
    if got == needed { Ok(()) } else { Err(Error::WrongLength { argument, got, needed }) }
}

fn check_vectors(argument: &'static str, vectors: &[Vector]) -> Result<()> {
    for (i, v) in vectors.iter().enumerate() {
        for (k, &value) in v.iter().enumerate() {
            let index = Some(2 * i + k);
            if !value.is_finite() {
                return Err(Error::NotFinite { argument, index });
            }
            if value.abs() > LARGEST_COORDINATE {
                let (least, most) = (-LARGEST_COORDINATE, LARGEST_COORDINATE);
                return Err(Error::OutOfRange { argument, index, value, least, most });
            }
        }
    }
    Ok(())
}

/// 0 and the sums of the first, first two, … lengths, compensated: a thousand equal pieces of a segment end where
/// the segment did.
fn running_sums(lengths: &[f64]) -> Vec<f64> {
    let mut sums = Vec::with_capacity(lengths.len() + 1);
    let (mut sum, mut lost) = (0.0, 0.0);
    sums.push(0.0);
    for &length in lengths {
        let next = sum + length;
        // Lengths are positive: the larger of the two numbers kept its digits.
        lost += if sum >= length { (sum - next) + length } else { (length - next) + sum };
        sum = next;
        sums.push(sum + lost);
    }
    sums
}

/// One basis for every run of equal ω·length, so that a uniform curve holds just one.
fn bases(space: Space, omega: &[f64], lengths: &[f64]) -> Result<(Vec<Basis>, Vec<u32>)> {
    let mut bases: Vec<Basis> = Vec::new();
    let mut basis_of = Vec::with_capacity(omega.len());
    for (i, (&w, &length)) in omega.iter().zip(lengths).enumerate() {
        let index = Some(i);
        if !length.is_finite() {
            return Err(Error::NotFinite { argument: "lengths", index });
        }
        if (0.0..LEAST_LENGTH).contains(&length) {
            let reason = "knots closer than 1e-12";
            return Err(Error::Degenerate { argument: "lengths", index, reason });
        }
        if !(LEAST_LENGTH..=LARGEST_COORDINATE).contains(&length) {
            let (least, most) = (LEAST_LENGTH, LARGEST_COORDINATE);
            return Err(Error::OutOfRange { argument: "lengths", index, value: length, least, most });
        }
        if !w.is_finite() {
            return Err(Error::NotFinite { argument: "omega", index });
        }
        let most = match space {
            Space::Trigonometric => (core::f64::consts::TAU - POLE_MARGIN) / length,
            _ => LARGEST_FREQUENCY / length,
        };
        if !(0.0..=most).contains(&w) {
            return Err(Error::OutOfRange { argument: "omega", index, value: w, least: 0.0, most });
        }
        let frequency = if space == Space::Polynomial { 0.0 } else { w * length };
        let known = bases.iter().rev().take(8).position(|b| b.frequency() == frequency);
        let k = match known {
            Some(back) => bases.len() - 1 - back,
            None => {
                bases.push(Basis::new(space, frequency));
                bases.len() - 1
            }
        };
        basis_of.push(k as u32);
    }
    Ok((bases, basis_of))
}
