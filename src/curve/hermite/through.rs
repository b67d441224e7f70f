//! The smoothest curve of a space through given points: tangents from the continuity of the second derivative.

use core::f64::consts::PI;

use super::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::generator::{HermiteGenerators, Space, Weights};
use crate::numerics::tridiagonal::{self, Row};
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// The curve through `points` whose second derivative is continuous, one parameter unit from point to point.
    ///
    /// Open curves end with a vanishing second derivative ("natural"). `omega` is as in
    /// [`HermiteCurve::new`] when `None`: a closed trigonometric curve then has ω = 2π/M and reproduces every
    /// ellipse that the points lie on evenly.
    ///
    /// Where no unique such curve exists, or hardly (which takes a trigonometric ω near π or above), tangents are
    /// central differences (Catmull–Rom) and only the first derivative is continuous; two points of a closed curve with
    /// ω = π give the circle on their diameter, from the first point towards the second axis.
    ///
    /// # Accuracy
    ///
    /// The jump of the second derivative is below 1e-12 of its size (`tests/curve/data.rs`).
    ///
    /// # Errors
    ///
    /// As [`HermiteCurve::new`].
    ///
    /// # Cost
    ///
    /// O(M).
    pub fn through(points: Vec<Point>, closed: bool, omega: Option<f64>, space: Space) -> Result<Self> {
        if let Some(omega) = omega {
            // Refused here it is one number; a curve has a list of them.
            HermiteGenerators::new(omega, space)?;
        }
        // Any tangents will do until the right ones are known.
        let tangents = points.clone();
        let omega = omega.into_iter().collect();
        let options =
            HermiteOptions { points, tangents, closed, space: Some(space), omega, ..Default::default() };
        let curve = Self::new(options)?;
        let mut rows = curve.continuity();
        if tridiagonal::solve(&mut rows).is_none() {
            curve.differences(&mut rows);
        }
        curve.with_tangents(&|i| rows[i].right)
    }

    /// (D 7.6) Row i says: the second derivative that arrives at point i is the one that leaves it, or 0 at open ends.
    fn continuity(&self) -> Vec<Row> {
        let mut rows = vec![Row::default(); self.points().len()];
        for (i, segment) in self.segments().enumerate() {
            let chord = (segment.end - segment.start) / segment.length;
            add(&mut rows[i], &segment.basis.weights(0.0, 2), -1.0 / segment.length, chord);
            add(&mut rows[self.next(i)], &segment.basis.weights(1.0, 2), 1.0 / segment.length, chord);
        }
        rows
    }

    /// Leaves central differences in the rows' right-hand sides, at open ends those of one side.
    fn differences(&self, rows: &mut [Row]) {
        for row in rows.iter_mut() {
            row.right = Vector::zeros();
        }
        for (i, segment) in self.segments().enumerate() {
            let half = (segment.end - segment.start) * 0.5;
            rows[i].right += half;
            rows[self.next(i)].right += half;
        }
        if let ([first, .., last], false) = (&mut *rows, self.is_closed()) {
            first.right *= 2.0;
            last.right *= 2.0;
        }
        if let ([first, last], true) = (rows, self.is_closed()) {
            let radius = (self.points()[0] - self.points()[1]) * 0.5;
            first.right = Vector::new(-radius.y, radius.x) * PI;
            last.right = -first.right;
        }
    }
}

/// Adds a segment's second derivative to the row of its start (negative scale) or of its end.
#[inline(never)]
fn add(row: &mut Row, weights: &Weights, scale: f64, chord: Vector) {
    let (leaving, arriving) = (weights.leaving * scale, weights.arriving * scale);
    row.right -= chord * (weights.chord * scale);
    if scale < 0.0 {
        row.center += leaving;
        row.after += arriving;
    } else {
        row.before += leaving;
        row.center += arriving;
    }
}
