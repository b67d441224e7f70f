//! The points' own corners: a polyline that no point is far from, as a spline whose knots are all corners.

use super::breaks::Breaks;
use super::foot_points::Spline;
use super::free_knots::{FreeKnots, Located};
use crate::numerics::Point;
use crate::numerics::order::sort_in_place;

/// An edge of the fewest vertices passes at most so many points.
const REACH: usize = 64;

/// Numbers of the points that a polyline goes through so that no point is farther from it than `tolerance`: Ramer's and
/// Douglas and Peucker's way, without recursion. O(M log M) on drawings, O(M²) at worst for `most` vertices; `None`
/// where they do not suffice.
pub(super) fn vertices(points: &[Point], closed: bool, tolerance: f64, most: usize) -> Option<Vec<usize>> {
    let count = points.len();
    // Two points far from one another are on the hull, and so good places to begin on a closed way.
    let first = farthest(points, 0);
    let (first, second) = if closed { (first, farthest(points, first)) } else { (0, count - 1) };
    let (low, high) = (first.min(second), first.max(second));
    let mut kept = vec![low, high];
    let mut open = vec![(low, high)];
    if closed {
        open.push((high, low + count));
    }
    while let Some((from, to)) = open.pop() {
        let ends = [points[from % count], points[to % count]];
        let mut worst = (tolerance * tolerance, from);
        for m in from + 1..to {
            let distance = beside(ends, points[m % count]);
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

/// The fewest vertices of such a polyline, among those that have one every `REACH` points at least. A larger tolerance
/// never takes more of them. O(M·REACH²) at worst.
pub(super) fn fewest(points: &[Point], closed: bool, tolerance: f64) -> Vec<usize> {
    let count = points.len();
    let (first, last) = if closed { (farthest(points, 0), count) } else { (0, count - 1) };
    let at = |m: usize| points[(first + m) % count];
    // With how many edges every point is reached, and from where.
    let mut reached = vec![(usize::MAX, 0); last + 1];
    reached[0] = (0, 0);
    for from in 0..last {
        let edges = reached[from].0 + 1;
        let mut far_before = from;
        for to in (1..=REACH.min(last - from)).map(|points| from + points) {
            let is_far = |m: &usize| beside([at(from), at(to)], at(*m)) > tolerance * tolerance;
            // What was too far from the last edge most often is from this one.
            if far_before > from && is_far(&far_before) {
                continue;
            }
            match (from + 1..to).find(is_far) {
                Some(far) => far_before = far,
                None if edges < reached[to].0 => reached[to] = (edges, from),
                None => {}
            }
        }
    }
    let mut kept = if closed { Vec::new() } else { vec![last] };
    let mut m = last;
    while m > 0 {
        m = reached[m].1;
        kept.push((first + m) % count);
    }
    sort_in_place(&mut kept);
    kept
}

/// The point that is farthest from one of them.
fn farthest(points: &[Point], from: usize) -> usize {
    let distance = |m: &usize| (points[*m] - points[from]).norm_squared();
    (0..points.len()).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// The square of a point's distance from an edge.
fn beside([a, b]: [Point; 2], point: Point) -> f64 {
    let (way, chord) = (point - a, b - a);
    let square = chord.norm_squared();
    let along = if square > 0.0 { (way.dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 };
    (way - chord * along).norm_squared()
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
