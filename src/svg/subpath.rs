//! The segments of one subpath while it is read.

use crate::curve::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::generator::Space;
use crate::numerics::{Point, Vector};

/// A closed subpath's end counts as its start when the gap is below this many ulp of the largest coordinate, for
/// every segment: each relative command rounds once.
const CLOSING_ULPS: f64 = 4.0;

/// Points and derivatives, collected segment by segment.
#[derive(Debug, Default)]
pub(super) struct Subpath {
    points: Vec<Point>,
    leaving: Vec<Vector>,
    /// By point, like the others: the first is known when the last segment is.
    arriving: Vec<Vector>,
    omega: Vec<f64>,
    curved: bool,
    /// The largest coordinate of the points.
    largest: f64,
    /// Of the last command, whether it drew or not.
    control: Point,
    degree: f64,
    /// Of the last segment.
    drawn: (Point, f64),
}

impl Subpath {
    /// Adds a segment of parameter length 1 from the last point (`start`) to `end`.
    pub(super) fn push(&mut self, start: Point, end: Point, leaving: Vector, arriving: Vector, omega: f64) {
        if self.points.is_empty() {
            self.points.push(start);
            self.largest = start.amax();
            self.arriving.push(leaving);
        }
        self.points.push(end);
        self.largest = self.largest.max(end.amax());
        self.leaving.push(leaving);
        self.arriving.push(arriving);
        self.omega.push(omega);
        self.curved |= omega != 0.0;
    }

    /// The last command has this control point next to its end: the derivative that arrives is
    /// (end − control)·degree. Degree 0 where it is no Bézier curve. `drew`: whether it added a segment.
    pub(super) fn set_control(&mut self, control: Point, degree: f64, drew: bool) {
        (self.control, self.degree) = (control, degree);
        if drew {
            self.drawn = (control, degree);
        }
    }

    /// What [`Subpath::set_control`] was given last in this subpath.
    pub(super) fn last_control(&self) -> (Point, f64) {
        (self.control, self.degree)
    }

    /// The curve of all segments, if there are any; empty afterwards.
    pub(super) fn take(&mut self, closed: bool) -> Result<Option<HermiteCurve>> {
        if closed {
            self.close();
        }
        let Self { points, mut leaving, arriving, mut omega, curved, .. } = core::mem::take(self);
        if points.is_empty() {
            return Ok(None);
        }
        if let (false, Some(&last)) = (closed, arriving.last()) {
            leaving.push(last);
        }
        if !curved {
            // All are 0: one stands for them.
            omega.truncate(1);
        }
        HermiteCurve::new(HermiteOptions {
            points,
            tangents: leaving,
            tangents_in: arriving,
            closed,
            space: Some(Space::Trigonometric),
            omega,
            lengths: Vec::new(),
        })
        .map(Some)
    }

    /// Leads back to the first point: by the last segment where it ends there, else by a line.
    fn close(&mut self) {
        let (Some(&first), Some(&last)) = (self.points.first(), self.points.last()) else { return };
        let gap = first - last;
        let (control, degree) = self.drawn;
        if gap.amax() > CLOSING_ULPS * f64::EPSILON * self.largest * self.omega.len() as f64 {
            self.push(last, first, gap, gap, 0.0);
        } else if degree > 0.0 {
            // The end moves by a rounding, its control point stays: so what is written from this is read as this.
            let arriving = (first - control) * degree;
            if let (Some(slot), Some(leaving)) = (self.arriving.last_mut(), self.leaving.last_mut()) {
                *slot = arriving;
                if degree == 1.0 {
                    *leaving = arriving;
                }
            }
        }
        self.points.pop();
        if let (Some(last), Some(slot)) = (self.arriving.pop(), self.arriving.first_mut()) {
            *slot = last;
        }
        if self.points.len() == 1 {
            self.halve();
        }
    }

    /// A loop of one segment becomes two: a curve has two points or more.
    fn halve(&mut self) {
        let (p, d0, d1) = (self.points[0], self.leaving[0], self.arriving[0]);
        // A single segment that ends where it starts is a cubic: an arc that does so is left out, or has two. The
        // halves are computed by their control points, so that what is written from them is read as they are.
        let middle = p + (d0 - d1) * 0.125;
        let (first, second, last) = (p + d0 / 6.0, middle + (d0 + d1) / 24.0, p - d1 / 6.0);
        let tangent = (middle - second) * 3.0;
        (self.leaving[0], self.arriving[0]) = ((first - p) * 3.0, (p - last) * 3.0);
        (self.omega[0], self.curved) = (0.0, false);
        self.push(p, middle, tangent, tangent, 0.0);
    }
}
