//! Clamped knot lists and the B-splines on them, of one low degree.

use crate::error::{Error, Result};
use crate::limits::{LARGEST_COORDINATE, LEAST_LENGTH, check, with_room};

/// The highest degree of a quasi-interpolant.
pub const MOST_DEGREE: usize = 9;
/// The most interior knots of a quasi-interpolant.
pub const MOST_INTERIOR: usize = 1_000_000;

/// The values of the degree + 1 B-splines that do not vanish at a place; the rest is 0.
pub(super) type Values = [f64; MOST_DEGREE + 1];

/// A (p+1)-regular knot list: both ends p + 1 times, evenly spaced knots between them.
///
/// # Source
///
/// \[RB21, sections 2 and 3.3\].
#[derive(Clone, Debug, PartialEq)]
pub struct Knots {
    degree: usize,
    knots: Vec<f64>,
}

impl Knots {
    /// `interior` evenly spaced knots between `start` and `end`; `degree` from 1 to 9.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, `end` not beyond `start`, a degree or a number of knots out of range.
    pub fn even(start: f64, end: f64, interior: usize, degree: usize) -> Result<Self> {
        check("start", None, start, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
        check("end", None, end, start + LEAST_LENGTH, LARGEST_COORDINATE)?;
        check("degree", None, degree as f64, 1.0, MOST_DEGREE as f64)?;
        check("interior", None, interior as f64, 0.0, MOST_INTERIOR as f64)?;
        let mut knots = with_room(interior + 2 * (degree + 1))?;
        knots.resize(degree, start);
        let pieces = (interior + 1) as f64;
        knots.extend((0..=interior).map(|i| start + (end - start) * i as f64 / pieces));
        knots.resize(knots.len() + degree + 1, end);
        Ok(Self { degree, knots })
    }

    /// Knots as they are given: they do not fall, and both ends are there `degree` + 1 times, any other at most that
    /// often.
    ///
    /// # Errors
    ///
    /// Another list, a degree out of range.
    pub fn new(knots: &[f64], degree: usize) -> Result<Self> {
        check("degree", None, degree as f64, 1.0, MOST_DEGREE as f64)?;
        let order = degree + 1;
        if knots.len() < 2 * order {
            return Err(Error::wrong_length("knots", knots.len(), 2 * order));
        }
        check("knots", None, knots.len() as f64, 0.0, (MOST_INTERIOR + 2 * order) as f64)?;
        for (i, &knot) in knots.iter().enumerate() {
            check("knots", Some(i), knot, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
            if i > 0 && knot < knots[i - 1] {
                return Err(Error::degenerate("knots", Some(i), "they must not fall"));
            }
            // One more of the same would be a B-spline without support.
            if i >= order && i < knots.len() - 1 && knot - knots[i - order] < LEAST_LENGTH {
                return Err(Error::degenerate("knots", Some(i), "so many of them are the same"));
            }
        }
        let last = knots.len() - order;
        let ends = [(knots[0], knots[degree]), (knots[last], knots[knots.len() - 1])];
        if ends.iter().any(|(a, b)| a != b) || knots[last] - knots[degree] < LEAST_LENGTH {
            return Err(Error::degenerate("knots", None, "both ends must be there degree + 1 times"));
        }
        Ok(Self { degree, knots: knots.to_vec() })
    }

    /// The degree p.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// All knots, n + p + 1 of them.
    pub fn as_slice(&self) -> &[f64] {
        &self.knots
    }

    /// The number n of B-splines.
    pub fn count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The number of polynomial pieces.
    pub fn piece_count(&self) -> usize {
        self.count() - self.degree
    }

    /// The abscissa of coefficient q: the mean of the p knots inside its B-spline's support. Beyond the last it is the
    /// last one's.
    pub fn greville(&self, q: usize) -> f64 {
        self.abscissa(q.min(self.count() - 1))
    }

    /// The abscissa of one of the coefficients.
    pub(in crate::trace) fn abscissa(&self, q: usize) -> f64 {
        self.inner(q).iter().sum::<f64>() / self.degree as f64
    }

    /// The knots whose blossom value is coefficient q.
    pub(super) fn inner(&self, q: usize) -> &[f64] {
        &self.knots[q + 1..=q + self.degree]
    }

    /// The piece that x lies in; the ends belong to the first and the last.
    pub(super) fn piece(&self, x: f64) -> usize {
        let inside = &self.knots[self.degree + 1..self.count()];
        inside.partition_point(|&knot| knot <= x)
    }

    /// The ends of a piece.
    pub(in crate::trace) fn ends(&self, piece: usize) -> (f64, f64) {
        (self.knots[piece + self.degree], self.knots[piece + self.degree + 1])
    }

    /// The first B-spline that does not vanish at x, and the values from there on, by the recurrence of Cox and de
    /// Boor.
    pub(super) fn values(&self, x: f64) -> (usize, Values) {
        let first = self.piece(x);
        let span = first + self.degree;
        let mut values = [0.0; MOST_DEGREE + 1];
        values[0] = 1.0;
        for order in 1..=self.degree {
            let mut carried = 0.0;
            for (r, value) in values[..order].iter_mut().enumerate() {
                let (left, right) = (self.knots[span + 1 + r - order], self.knots[span + 1 + r]);
                let share = *value / (right - left);
                *value = carried + (right - x) * share;
                carried = (x - left) * share;
            }
            values[order] = carried;
        }
        (first, values)
    }

    /// The blossom of a spline's piece at `places`, one per degree, by the algorithm of de Boor.
    pub(in crate::trace) fn blossom(&self, coefficients: &[f64], piece: usize, places: &[f64]) -> f64 {
        let mut values = [0.0; MOST_DEGREE + 1];
        let local = coefficients[piece..].iter().take(self.degree + 1);
        values.iter_mut().zip(local).for_each(|(value, &c)| *value = c);
        for (step, &x) in places.iter().enumerate() {
            for r in 0..self.degree - step {
                let left = self.knots[piece + r + step + 1];
                let right = self.knots[piece + r + self.degree + 1];
                let share = (x - left) / (right - left);
                values[r] = (1.0 - share) * values[r] + share * values[r + 1];
            }
        }
        values[0]
    }
}
