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
}

impl Subpath {
    /// Adds a segment of parameter length 1 from the last point (`start`) to `end`.
    pub(super) fn push(&mut self, start: Point, end: Point, leaving: Vector, arriving: Vector, omega: f64) {
        if self.points.is_empty() {
            self.points.push(start);
        }
        self.points.push(end);
        self.leaving.push(leaving);
        self.arriving.push(arriving);
        self.omega.push(omega);
    }

    /// The curve of all segments, if there are any; empty afterwards.
    pub(super) fn take(&mut self, closed: bool) -> Result<Option<HermiteCurve>> {
        if self.points.is_empty() {
            return Ok(None);
        }
        if closed {
            self.close();
        }
        let Self { points, mut leaving, mut arriving, omega } = core::mem::take(self);
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
            self.push(last, first, gap, gap, 0.0);
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
        // A single segment that ends where it starts is a cubic: an arc that does so is left out, or has two.
        let middle = p + (d0 - d1) * 0.125;
        let tangent = (d0 + d1) * -0.125;
        self.points.push(middle);
        self.leaving = vec![d0 * 0.5, tangent];
        self.arriving = vec![tangent, d1 * 0.5];
        self.omega = vec![0.0; 2];
    }
}
