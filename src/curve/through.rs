//! The smoothest curve of a space through given points: tangents from the continuity of the second derivative.

use core::f64::consts::PI;

use super::hermite::{HermiteCurve, HermiteOptions};
use crate::error::Result;
use crate::generator::Space;
use crate::numerics::tridiagonal::{self, Row};
use crate::numerics::{Point, Vector};

impl HermiteCurve {
    /// The curve through `points` whose second derivative is continuous, one parameter unit from point to point.
    ///
    /// Open curves end with a vanishing second derivative ("natural"). `omega` is as in
    /// [`HermiteCurve::new`] when `None`: a closed trigonometric curve then has ω = 2π/M and reproduces every
    /// ellipse that the points lie on evenly.
    ///
    /// Where no unique such curve exists (which takes a trigonometric ω ≥ π), tangents are central differences
    /// (Catmull–Rom) and only the first derivative is continuous; two points of a closed curve with ω = π give
    /// the circle on their diameter, from the first point towards the second axis.
    ///
    /// # Accuracy
    ///
    /// The jump of the second derivative is below 1e-12 of its size (`tests/curve.rs`).
    ///
    /// # Errors
    ///
    /// As [`HermiteCurve::new`].
    ///
    /// # Cost
    ///
    /// O(M).
    pub fn through(points: Vec<Point>, closed: bool, omega: Option<f64>, space: Space) -> Result<Self> {
        let tangents = vec![Vector::zeros(); points.len()];
        let omega = omega.into_iter().collect();
        let options =
            HermiteOptions { points, tangents, closed, space: Some(space), omega, ..Default::default() };
        let curve = Self::new(options)?;
        let tangents = match tridiagonal::solve(&curve.continuity()) {
            Some(tangents) => tangents,
            None => curve.differences(),
        };
        let mut options = curve.to_options();
        options.tangents_in = tangents.clone();
        options.tangents = tangents;
        Self::new(options)
    }

    /// (D 7.6) Row i says: the second derivative that arrives at point i is the one that leaves it, or 0 at open ends.
    fn continuity(&self) -> Vec<Row> {
        let mut rows = vec![Row::default(); self.points().len()];
        for (i, segment) in self.segments().enumerate() {
            let next = self.next(i);
            let chord = (segment.end - segment.start) / segment.length;
            let (leaves, arrives) = (segment.basis.weights(0.0, 2), segment.basis.weights(1.0, 2));
            let row = &mut rows[i];
            row.center -= leaves.leaving / segment.length;
            row.after -= leaves.arriving / segment.length;
            row.right += chord * (leaves.chord / segment.length);
            let row = &mut rows[next];
            row.before += arrives.leaving / segment.length;
            row.center += arrives.arriving / segment.length;
            row.right -= chord * (arrives.chord / segment.length);
        }
        rows
    }

    fn differences(&self) -> Vec<Vector> {
        let points = self.points();
        let n = points.len();
        if n == 2 && self.is_closed() {
            let radius = (points[0] - points[1]) * 0.5;
            let tangent = Vector::new(-radius.y, radius.x) * PI;
            return vec![tangent, -tangent];
        }
        let neighbours = |i: usize| match (self.is_closed(), i) {
            (true, _) => ((i + n - 1) % n, (i + 1) % n),
            (false, _) => (i.saturating_sub(1), (i + 1).min(n - 1)),
        };
        let difference = |(before, after): (usize, usize)| {
            let steps = if self.is_closed() || after - before == 2 { 2.0 } else { 1.0 };
            (points[after] - points[before]) / steps
        };
        (0..n).map(|i| difference(neighbours(i))).collect()
    }
}
