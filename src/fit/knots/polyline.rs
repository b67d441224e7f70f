//! The points' own corners: a polyline that no point is far from, as a spline whose knots are all corners.

use super::breaks::Breaks;
use super::foot_points::Spline;
use super::free_knots::{FreeKnots, Located};
use crate::numerics::Point;
use crate::numerics::order::sort_in_place;

/// Numbers of the points that a polyline goes through so that no point is farther from it than `tolerance`: Ramer's and
/// Douglas and Peucker's way, without recursion. O(M log M) on drawings, O(M²) at worst for `most` vertices; `None`
/// where they do not suffice.
pub(super) fn vertices(points: &[Point], closed: bool, tolerance: f64, most: usize) -> Option<Vec<usize>> {
    let count = points.len();
    let far = |from: usize| {
        let distance = |m: &usize| (points[*m] - points[from]).norm_squared();
        (0..count).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    };
    // Two points far from one another are on the hull, and so good places to begin on a closed way.
    let (first, second) = if closed { (far(0), far(far(0))) } else { (0, count - 1) };
    let (low, high) = (first.min(second), first.max(second));
    let mut kept = vec![low, high];
    let mut open = vec![(low, high)];
    if closed {
        open.push((high, low + count));
    }
    while let Some((from, to)) = open.pop() {
        let (a, b) = (points[from % count], points[to % count]);
        let chord = b - a;
        let square = chord.norm_squared();
        let mut worst = (tolerance * tolerance, from);
        for m in from + 1..to {
            let way = points[m % count] - a;
            let along = if square > 0.0 { (way.dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 };
            let distance = (way - chord * along).norm_squared();
            if distance > worst.0 {
                worst = (distance, m);
            }
        }
        if worst.1 > from {
            kept.push(worst.1 % count);
            open.push((from, worst.1));
            open.push((worst.1, to));
            if kept.len() > most {
                return None;
            }
        }
    }
    sort_in_place(&mut kept);
    kept.dedup();
    Some(kept)
}

/// Corners at these points; on open curves the ends are none.
pub(super) fn corners(vertices: &[usize], located: &Located, like: &Breaks) -> Breaks {
    let mut breaks = like.clone();
    breaks.at.clear();
    breaks.straight.clear();
    let least = if breaks.closed { -1.0 } else { 0.0 };
    let mut last = least;
    for &m in vertices {
        let t = located.parameters[m];
        if t > last && t < breaks.end && (breaks.closed || t > 0.0) {
            breaks.at.push(t);
            last = t;
        }
    }
    breaks.multiplicity = vec![breaks.sharpest; breaks.at.len()];
    breaks
}

/// The polyline through these points as a spline with those corners.
pub(super) fn through(vertices: &[usize], located: &Located, breaks: Breaks) -> Spline {
    let count = vertices.len();
    let edges = if breaks.closed { count } else { count - 1 };
    let mut dense = Located::default();
    for edge in 0..edges {
        let (a, b) = (vertices[edge], vertices[(edge + 1) % count]);
        let start = located.parameters[a];
        let end = if b > a { located.parameters[b] } else { located.parameters[b] + breaks.end };
        let steps = 2 * breaks.degree;
        for step in 0..=steps {
            let share = step as f64 / steps as f64;
            // Strictly inside: the ends belong to two edges.
            let share = share.clamp(1e-3, 1.0 - 1e-3);
            let t = start + (end - start) * share;
            dense.points.push(located.points[a] + (located.points[b] - located.points[a]) * share);
            dense.parameters.push(if breaks.closed && t >= breaks.end { t - breaks.end } else { t });
        }
    }
    Spline::of(&FreeKnots::new(breaks, &dense))
}
