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
#[inline(never)]
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
#[inline(never)]
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
    (point - a - (b - a) * share_of([a, b], point)).norm_squared()
}

/// The share of an edge at which a point's foot is.
fn share_of([a, b]: [Point; 2], point: Point) -> f64 {
    let chord = b - a;
    let square = chord.norm_squared();
    if square > 0.0 { ((point - a).dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 }
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

/// The polyline through these points as a spline with those corners, and all points at their feet on the edges that pass
/// them. From elsewhere a way to the foot need not lead there: where noise turns back, it goes round a vertex to another edge.
pub(super) fn through(vertices: &[usize], located: &Located, breaks: Breaks) -> (Spline, Located) {
    let (count, all) = (vertices.len(), located.points.len());
    let edges = if breaks.closed { count } else { count - 1 };
    let (mut dense, mut feet) = (Located::default(), located.clone());
    for edge in 0..edges {
        let (from, to) = (vertices[edge], vertices[(edge + 1) % count]);
        let ends = [located.points[from], located.points[to]];
        let start = located.parameters[from];
        // The last edge of a closed one goes on beyond the first point.
        let (way, passed) = if to > from {
            (located.parameters[to] - start, to - from)
        } else {
            (located.parameters[to] + breaks.end - start, to + all - from)
        };
        let at = |share: f64| {
            let t = start + way * share;
            if breaks.closed && t >= breaks.end { t - breaks.end } else { t }
        };
        for m in (from..from + passed).map(|m| m % all) {
            feet.parameters[m] = at(share_of(ends, located.points[m]));
        }
        let steps = 2 * breaks.degree;
        for step in 0..=steps {
            // Strictly inside: the ends belong to two edges.
            let share = (step as f64 / steps as f64).clamp(1e-3, 1.0 - 1e-3);
            dense.points.push(ends[0] + (ends[1] - ends[0]) * share);
            dense.parameters.push(at(share));
        }
    }
    (Spline::of(&FreeKnots::new(breaks, &dense)), feet)
}
