//! A polyline with its corners rounded off: near the points, and smooth wherever corners may not be. (D 13.17)

use super::breaks::{Breaks, HIGHEST};
use super::combine::expressed;
use super::free_knots::Located;
use super::polyline::share_of;
use super::space::{Polynomial, Space};
use super::spline::Spline;
use crate::error::Result;
use crate::limits;
use crate::numerics::{Point, Vector};

/// A round takes this share of an edge at each end of it, at most.
const SHARE: f64 = 0.45;
/// Rounds shorter than this part of the curve are corners to numbers.
const SHORTEST: f64 = 1e-10;

/// What a polyline may have at its vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounds {
    /// How far a round may be from its vertex.
    pub(super) depth: f64,
    /// The cosine of the least angle of a corner that stays; below −1 where none may.
    pub(super) cosine: f64,
}

/// A vertex: its number among the points, where along the polyline it is, the way there and the way on, and how far on
/// either side the round reaches; 0 for corners and ends.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    point: usize,
    place: Point,
    along: f64,
    ways: [Vector; 2],
    reach: f64,
}

/// The vertices of the polyline through these points, and its length; those that stand where the one before does are
/// left out.
#[inline(never)]
fn walked(vertices: &[usize], points: &[Point], closed: bool, rounds: Rounds) -> Result<(Vec<Vertex>, f64)> {
    let mut walk: Vec<Vertex> = limits::with_room(vertices.len())?;
    let mut length = 0.0;
    for &point in vertices {
        let place = points[point];
        let step = walk.last().map_or(0.0, |last| (place - last.place).norm());
        if step > 0.0 || walk.is_empty() {
            length += step;
            walk.push(Vertex { point, place, along: length, ways: [Vector::zeros(); 2], reach: 0.0 });
        }
    }
    while closed && walk.len() > 1 && walk.last().map(|last| last.place) == walk.first().map(|v| v.place) {
        walk.pop();
        length = walk.last().map_or(0.0, |last| last.along);
    }
    let count = walk.len();
    let edge = |k: usize| {
        let way = walk[(k + 1) % count].place - walk[k % count].place;
        (way, way.norm())
    };
    let edges: Vec<(Vector, f64)> = (0..count).map(edge).collect();
    if closed {
        length += edges[count - 1].1;
    }
    for k in if closed { 0..count } else { 1..count.max(1) - 1 } {
        let ((before, long), (after, wide)) = (edges[(k + count - 1) % count], edges[k]);
        let ways = [before / long, after / wide];
        let turn = (ways[1] - ways[0]).norm();
        let stays = ways[0].dot(&ways[1]) <= rounds.cosine;
        // Halfway along a round is a quarter of this turn from the vertex.
        let most = 4.0 * rounds.depth / turn.max(f64::MIN_POSITIVE);
        walk[k].ways = ways;
        walk[k].reach = if stays { 0.0 } else { (SHARE * long.min(wide)).min(most) };
    }
    Ok((walk, length))
}

/// The polyline through these points with rounds of parabolas, as smooth as knots that count once less than a corner
/// allow, and all points beside their feet; nothing where a round would be too short.
///
/// # Errors
///
/// `OutOfMemory`.
#[inline(never)]
pub(super) fn rounded(
    vertices: &[usize],
    located: &Located,
    like: &Breaks,
    rounds: Rounds,
) -> Result<Option<(Spline, Located)>> {
    let (closed, degree) = (like.closed, like.degree);
    let (walk, length) = walked(vertices, &located.points, closed, rounds)?;
    let inner = if closed { &walk[..] } else { &walk[1..walk.len().max(2) - 1] };
    let short = |v: &Vertex| v.reach > 0.0 && v.reach < SHORTEST * length;
    if length <= 0.0 || closed && inner.len() < 2 || inner.iter().any(short) {
        return Ok(None);
    }
    let rate = like.end / length;
    let mut breaks = Breaks { sharpest: degree, ..like.bare() };
    for v in inner {
        let round = v.reach > 0.0;
        let places = [v.along - v.reach, v.along + v.reach];
        for along in &places[..1 + usize::from(round)] {
            // What begins before the first vertex is at the end.
            breaks.at.push(if *along < 0.0 { along + length } else { *along } * rate);
            breaks.multiplicity.push(if round { degree - 1 } else { degree });
        }
    }
    // A single edge has none.
    if breaks.at.first() > breaks.at.last() {
        breaks.at.rotate_left(1);
        breaks.multiplicity.rotate_left(1);
    }
    limits::probe(breaks.pieces().saturating_mul(super::polyline::PER_PIECE))?;
    let spline = expressed(Space::new(breaks), &|middle, half| on(&walk, length, middle / rate, half / rate));
    Ok(Some((spline, feet(&walk, located, closed, length, like.end)?)))
}

/// The polynomials on middle ± half, by length: a round, or an edge between two.
fn on(walk: &[Vertex], length: f64, middle: f64, half: f64) -> (Polynomial, Polynomial) {
    let middle = if middle > length { middle - length } else { middle };
    let k = walk.partition_point(|v| v.along <= middle).max(1) - 1;
    let next = (k + 1) % walk.len();
    let end = if next == 0 { length } else { walk[next].along };
    let around = if middle - walk[k].along < end - middle { walk[k] } else { walk[next] };
    let from = if middle - walk[k].along < end - middle { middle - walk[k].along } else { end - middle };
    let sum = if from < 0.5 * around.reach {
        let turn = (around.ways[1] - around.ways[0]) * (0.25 * around.reach);
        let along = (around.ways[0] + around.ways[1]) * (0.5 * around.reach);
        [around.place + turn, along, turn]
    } else {
        let way = (walk[next].place - walk[k].place) / (end - walk[k].along);
        [walk[k].place + way * (middle - walk[k].along), way * half, Vector::zeros()]
    };
    let (mut x, mut y) = ([0.0; HIGHEST + 1], [0.0; HIGHEST + 1]);
    for (i, c) in sum.iter().enumerate() {
        (x[i], y[i]) = (c.x, c.y);
    }
    (x, y)
}

/// All points at their feet on the edges that pass them.
fn feet(walk: &[Vertex], located: &Located, closed: bool, length: f64, end: f64) -> Result<Located> {
    let (mut feet, all, count) = (located.copied()?, located.points.len(), walk.len());
    for k in 0..if closed { count } else { count - 1 } {
        let (from, to) = (&walk[k], &walk[(k + 1) % count]);
        let (way, passed) = if k + 1 < count {
            (to.along - from.along, to.point - from.point)
        } else {
            (length - from.along, to.point + all - from.point)
        };
        let last = !closed && k + 2 == count;
        // Points beyond the last vertex stand where it does.
        let until = if last { all - 1 } else { from.point + passed };
        for m in (from.point..=until).map(|m| m % all) {
            let along = from.along + way * share_of([from.place, to.place], located.points[m]);
            let t = along / length * end;
            feet.parameters[m] = if closed && t >= end { 0.0 } else { t.min(end) };
        }
    }
    Ok(feet)
}
