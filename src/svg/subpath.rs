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
    arriving: Vec<Vector>,
    omega: Vec<f64>,
    /// Of the last segment: the arriving derivative is (end − control)·degree; degree 0 for arcs.
    control: Point,
    degree: f64,
}

impl Subpath {
    /// Adds an arc of parameter length 1 from the last point (`start`) to `end`.
    pub(super) fn push(&mut self, start: Point, end: Point, leaving: Vector, arriving: Vector, omega: f64) {
        if self.points.is_empty() {
            self.points.push(start);
        }
        self.points.push(end);
        self.leaving.push(leaving);
        self.arriving.push(arriving);
        self.omega.push(omega);
        self.degree = 0.0;
    }

    /// Adds a line (degree 1), parabola (2) or cubic (3) whose last control point but the end is `control`.
    pub(super) fn push_bezier(
        &mut self,
        start: Point,
        leaving: Vector,
        control: Point,
        end: Point,
        degree: f64,
    ) {
        self.push(start, end, leaving, (end - control) * degree, 0.0);
        (self.control, self.degree) = (control, degree);
    }

    /// The curve of all segments, if there are any; empty afterwards.
    pub(super) fn take(&mut self, closed: bool) -> Result<Option<HermiteCurve>> {
        if self.points.is_empty() {
            return Ok(None);
        }
        if closed {
            self.close();
        }
        let Self { points, mut leaving, mut arriving, omega, .. } = core::mem::take(self);
        // Arriving tangents are collected by segment; a curve wants them by point.
        if closed {
            arriving.rotate_right(1);
        } else {
            let (first, last) = (leaving.first().copied(), arriving.last().copied());
            arriving.insert(0, first.unwrap_or_default());
            leaving.push(last.unwrap_or_default());
        }
        let omega = if omega.iter().all(|&w| w == 0.0) { vec![0.0] } else { omega };
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
        let largest = self.points.iter().fold(0.0_f64, |most, p| most.max(p.amax()));
        let rounding = CLOSING_ULPS * f64::EPSILON * largest * self.omega.len() as f64;
        let gap = first - last;
        if gap.amax() > rounding {
            self.push_bezier(last, gap, last, first, 1.0);
        } else if self.degree > 0.0
            && let Some(arriving) = self.arriving.last_mut()
        {
            // The end moves by a rounding, its control point stays: so what is written from this is read as this.
            *arriving = (first - self.control) * self.degree;
            if self.degree == 1.0
                && let Some(leaving) = self.leaving.last_mut()
            {
                *leaving = *arriving;
            }
        }
        self.points.pop();
        if self.points.len() == 1 {
            self.halve();
        }
    }

    /// A loop of one segment becomes two: a curve has two points or more.
    fn halve(&mut self) {
        let (Some(&p), Some(&d0), Some(&d1)) =
            (self.points.first(), self.leaving.first(), self.arriving.first())
        else {
            return;
        };
        // A single segment that ends where it starts is a cubic: an arc that does so is left out, or has two. The
        // halves are computed by their control points, so that what is written from them is read as they are.
        let middle = p + (d0 - d1) * 0.125;
        let (first, second, last) = (p + d0 / 6.0, middle + (d0 + d1) / 24.0, p - d1 / 6.0);
        let tangent = (middle - second) * 3.0;
        self.points.push(middle);
        self.leaving = vec![(first - p) * 3.0, tangent];
        self.arriving = vec![tangent, (p - last) * 3.0];
        self.omega = vec![0.0; 2];
    }
}
