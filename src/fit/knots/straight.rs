//! Which pieces of a curve are as straight as their points can tell.

use super::free_knots::Located;
use super::spline::Spline;
use crate::numerics::order::sort_by_number;

/// This part of a piece is looked at, however short it is.
const INNER: f64 = 0.7;
/// So many steps between points a corner may be beside where it belongs: points beyond it are far from the line.
const BESIDE: f64 = 2.0;

/// Sums over the points of a piece.
#[derive(Clone, Copy, Debug, Default)]
struct Scatter {
    weight: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
    /// Of the squares of their distances from the curve.
    near: f64,
}

impl Scatter {
    /// The least sum of squares of the distances from a line: the smaller eigenvalue of the matrix of second moments.
    fn least(&self) -> f64 {
        if self.weight <= 0.0 {
            return 0.0;
        }
        let (x, y) = (self.x / self.weight, self.y / self.weight);
        let (xx, xy, yy) = (self.xx - self.x * x, self.xy - self.x * y, self.yy - self.y * y);
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        (mean - (half * half + xy * xy).sqrt()).max(0.0)
    }
}

/// The pieces of which the best line is farther from their points than the curve is by less than `worth`, in squares;
/// the one that bends least first. O(M).
pub(super) fn bends(spline: &Spline, located: &Located, worth: f64) -> Vec<usize> {
    let space = &spline.space;
    let mut sums = vec![Scatter::default(); space.spans.len()];
    let margin = BESIDE * space.breaks.end / located.points.len() as f64;
    let distances = spline.distances(located);
    for (m, (point, (s, t))) in located.points.iter().zip(space.places(&located.parameters)).enumerate() {
        let span = &space.spans[s];
        if (t - span.middle).abs() > (span.half - margin).max(INNER * span.half) {
            continue;
        }
        let (sum, w) = (&mut sums[s], located.weight(m));
        sum.weight += w;
        sum.x += w * point.x;
        sum.y += w * point.y;
        sum.xx += w * point.x * point.x;
        sum.xy += w * point.x * point.y;
        sum.yy += w * point.y * point.y;
        sum.near += w * distances[m] * distances[m];
    }
    let growth = |s: usize| sums[s].least() - sums[s].near;
    let bent = |s: &usize| !space.breaks.is_straight(*s);
    let mut order: Vec<usize> = (0..sums.len()).filter(bent).filter(|&s| growth(s) <= worth).collect();
    sort_by_number(&mut order, &|&s| growth(s));
    order
}
