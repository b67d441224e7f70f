//! Both sides of a place, of as many places each, in pairs: every sum is done for both at once.

use crate::numerics::pair::Pair;
use crate::numerics::plane::{dot, norm};
use crate::numerics::{Point, Vector};
use crate::trace::samples::{principal_axis, unit};

/// The places before a place, and those after it.
pub(super) struct Sides<'a> {
    before: &'a [Point],
    after: &'a [Point],
    /// The middle of each side.
    x: Pair,
    y: Pair,
    /// The second moments about it: of x, of both, of y.
    moments: [Pair; 3],
}

impl<'a> Sides<'a> {
    #[inline]
    pub(super) fn new(before: &'a [Point], after: &'a [Point]) -> Self {
        let first = Pair::of(before[0], after[0]);
        let zero = Pair::twice(0.0);
        let (mut sums, mut moments) = ([zero; 2], [zero; 3]);
        for (&p, &q) in before.iter().zip(after) {
            let [x, y] = Pair::of(p, q);
            let (x, y) = (x - first[0], y - first[1]);
            sums[0] += x;
            sums[1] += y;
            moments[0] += x * x;
            moments[1] += x * y;
            moments[2] += y * y;
        }
        let count = Pair::twice(before.len() as f64);
        let [x, y] = [sums[0] / count, sums[1] / count];
        let [xx, xy, yy] = moments;
        let moments = [xx - sums[0] * x, xy - sums[0] * y, yy - sums[1] * y];
        Self { before, after, x: first[0] + x, y: first[1] + y, moments }
    }

    /// The directions of the lines that are nearest to both in the mean square.
    #[inline]
    pub(super) fn directions(&self) -> [Vector; 2] {
        let [xx, xy, yy] = self.moments;
        let (a, b) = (xx - yy, Pair::twice(2.0) * xy);
        let length = (a * a + b * b).sqrt();
        let along = |side: &[Point]| side[side.len() - 1] - side[0];
        [
            principal_axis(a.first(), b.first(), length.first(), along(self.before)),
            principal_axis(a.second(), b.second(), length.second(), along(self.after)),
        ]
    }

    /// The tangents at the place that both sides lead to, each by a parabola over its side's own axis, the line through
    /// it.
    #[inline]
    pub(super) fn end_tangents(&self, lines: [Vector; 2], here: Point) -> [Vector; 2] {
        let [u, v] = Pair::of(lines[0], lines[1]);
        // Least squares of y = a + bx + cx² about the middle, where Σx = 0, and along the axis, where Σy and Σxy are 0.
        let zero = Pair::twice(0.0);
        let (mut x2, mut x3, mut x4, mut y2) = (zero, zero, zero, zero);
        for (&p, &q) in self.before.iter().zip(self.after) {
            let [x, y] = Pair::of(p, q);
            let (dx, dy) = (x - self.x, y - self.y);
            let (along, across) = (dx * u + dy * v, dy * u - dx * v);
            let square = along * along;
            x2 += square;
            x3 += square * along;
            x4 += square * square;
            y2 += square * across;
        }
        // From a = −c·x2/n: [x2 x3; x3 x4 − x2²/n]·(b, c) = (0, y2).
        let determinant = x2 * (x4 - x2 * x2 / Pair::twice(self.before.len() as f64)) - x3 * x3;
        let share = y2 / determinant;
        let end = |side: &[Point],
                   middle: Point,
                   direction: Vector,
                   sign: f64,
                   [x2, x3, share, determinant]: [f64; 4]| {
            if determinant.abs() < 1e-9 {
                return direction;
            }
            // Extrapolated to the place, which is no farther than the side is long.
            let reach = norm(side[side.len() - 1] - side[0]);
            let x = sign * (sign * dot(here - middle, direction)).max(0.0).min(1.2 * reach);
            unit(direction + Vector::new(-direction.y, direction.x) * (share * (2.0 * x2 * x - x3)))
        };
        let first = [x2, x3, share, determinant].map(Pair::first);
        let second = [x2, x3, share, determinant].map(Pair::second);
        [
            end(self.before, Point::new(self.x.first(), self.y.first()), lines[0], 1.0, first),
            end(self.after, Point::new(self.x.second(), self.y.second()), lines[1], -1.0, second),
        ]
    }
}
