//! The points' own corners: a polyline that no point is far from, as a spline whose knots are all corners.

use super::breaks::Breaks;
use super::free_knots::Located;
use super::space::Space;
use super::spline::Spline;
use crate::error::Result;
use crate::limits;
use crate::numerics::Point;
use crate::numerics::order::sort_in_place;

/// An edge of the fewest vertices passes at most so many points.
pub(super) const REACH: usize = 64;
/// What a piece of a polyline takes in all, as a spline and in the lists that are made of it: 340 bytes of the space,
/// 50 of coefficients, 100 of polynomials.
pub(super) const PER_PIECE: usize = 600;

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

/// The search for the fewest vertices of such a polyline, among those that have one every `REACH` points at least. A
/// larger tolerance never takes more of them. O(M·REACH²) at worst, and a round O(REACH²) for each of its points.
#[derive(Clone, Debug)]
pub(super) struct Fewest {
    tolerance: f64,
    /// Where the way begins, and how long it is.
    first: usize,
    last: usize,
    /// With how many edges every point is reached, and from where.
    reached: Vec<(u32, u32)>,
    /// Points from which edges were drawn.
    done: usize,
}

/// The fewest vertices at once.
#[inline(never)]
pub(super) fn fewest(points: &[Point], closed: bool, tolerance: f64) -> Result<Vec<usize>> {
    let mut search = Fewest::new(points, closed, tolerance)?;
    search.round(points, points.len());
    search.vertices(points.len(), closed)
}

impl Fewest {
    #[inline(never)]
    pub(super) fn new(points: &[Point], closed: bool, tolerance: f64) -> Result<Self> {
        let count = points.len();
        let (first, last) = if closed { (farthest(points, 0), count) } else { (0, count - 1) };
        let mut reached = Vec::new();
        limits::refill(&mut reached, (u32::MAX, 0_u32), last + 1)?;
        reached[0] = (0, 0);
        Ok(Self { tolerance, first, last, reached, done: 0 })
    }

    /// Draws edges from so many points more; answers whether those were all.
    #[inline(never)]
    pub(super) fn round(&mut self, points: &[Point], most: usize) -> bool {
        let (count, last, square) = (points.len(), self.last, self.tolerance * self.tolerance);
        let at = |m: usize| points[(self.first + m) % count];
        let reached = &mut self.reached;
        let until = (self.done + most).min(last);
        for from in self.done..until {
            let edges = reached[from].0 + 1;
            let mut far_before = from;
            for to in (1..=REACH.min(last - from)).map(|points| from + points) {
                let is_far = |m: &usize| beside([at(from), at(to)], at(*m)) > square;
                // What was too far from the last edge most often is from this one.
                if far_before > from && is_far(&far_before) {
                    continue;
                }
                match (from + 1..to).find(is_far) {
                    Some(far) => far_before = far,
                    None if edges < reached[to].0 => reached[to] = (edges, from as u32),
                    None => {}
                }
            }
        }
        self.done = until;
        until == last
    }

    /// The vertices, once edges were drawn from all points.
    #[inline(never)]
    pub(super) fn vertices(&self, count: usize, closed: bool) -> Result<Vec<usize>> {
        let mut kept = limits::with_room(self.reached[self.last].0 as usize + 1)?;
        if !closed {
            kept.push(self.last);
        }
        let mut m = self.last;
        while m > 0 {
            m = self.reached[m].1 as usize;
            kept.push((self.first + m) % count);
        }
        sort_in_place(&mut kept);
        Ok(kept)
    }
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
pub(super) fn share_of([a, b]: [Point; 2], point: Point) -> f64 {
    let chord = b - a;
    let square = chord.norm_squared();
    if square > 0.0 { ((point - a).dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 }
}

/// Corners at these points; on open curves the ends are none.
pub(super) fn corners(vertices: &[usize], located: &Located, like: &Breaks) -> Result<Breaks> {
    let mut breaks = Breaks { at: limits::with_room(vertices.len())?, ..like.bare() };
    for m in inner(vertices, located, like) {
        breaks.at.push(located.parameters[m]);
    }
    limits::refill(&mut breaks.multiplicity, breaks.sharpest, breaks.at.len())?;
    Ok(breaks)
}

/// The vertices that are knots: each has a parameter of its own, inside the domain.
fn inner<'a>(vertices: &'a [usize], located: &'a Located, like: &Breaks) -> impl Iterator<Item = usize> + 'a {
    let (closed, end) = (like.closed, like.end);
    let mut last = if closed { -1.0 } else { 0.0 };
    vertices.iter().copied().filter(move |&m| {
        let t = located.parameters[m];
        let is_knot = t > last && t < end && (closed || t > 0.0);
        if is_knot {
            last = t;
        }
        is_knot
    })
}

/// The polyline through these points as a spline with those corners, and all points at their feet on the edges that
/// pass them. From elsewhere a way to the foot need not lead there: where noise turns back, it goes round a vertex to
/// another edge.
///
/// # Errors
///
/// `OutOfMemory`: nearly all of many points may be vertices.
pub(super) fn through(vertices: &[usize], located: &Located, breaks: Breaks) -> Result<(Spline, Located)> {
    limits::probe(breaks.pieces().saturating_mul(PER_PIECE))?;
    let (count, all) = (vertices.len(), located.points.len());
    let edges = if breaks.closed { count } else { count - 1 };
    let mut feet = located.copied()?;
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
        for m in (from..from + passed).map(|m| m % all) {
            let t = start + way * share_of(ends, located.points[m]);
            feet.parameters[m] = breaks.wrapped(t);
        }
    }
    Ok((joined(vertices, located, breaks)?, feet))
}

/// The spline that is straight between its corners: on every piece its coefficients are evenly spread from end to end.
fn joined(vertices: &[usize], located: &Located, mut breaks: Breaks) -> Result<Spline> {
    let degree = breaks.degree;
    breaks.multiplicity.fill(degree);
    let mut places: Vec<Point> = limits::with_room(breaks.len() + 2)?;
    let knots = inner(vertices, located, &breaks).map(|m| located.points[m]);
    if breaks.closed {
        places.extend(knots);
        places.extend(places.first().copied());
    } else {
        let end = |m: Option<&usize>| m.map(|&m| located.points[m]);
        places.extend(end(vertices.first()));
        places.extend(knots);
        places.extend(end(vertices.last()));
    }
    let space = Space::new(breaks);
    let (mut x, mut y) = (limits::filled(0.0, space.count)?, limits::filled(0.0, space.count)?);
    for (s, ends) in places.windows(2).enumerate() {
        for i in 0..=degree {
            let (place, at) = (ends[0] + (ends[1] - ends[0]) * (i as f64 / degree as f64), space.index(s, i));
            (x[at], y[at]) = (place.x, place.y);
        }
    }
    Ok(Spline { space, x, y })
}
