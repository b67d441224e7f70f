//! A few pieces of a curve, fitted anew between knots at which it stays what it was.

use super::{Change, Link, NONE, Sweep, speed};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::combine::{blossom, expressed, onto};
use crate::fit::knots::free_knots::Located;
use crate::fit::knots::look::Piece;
use crate::fit::knots::space::{Polynomial, Space};
use crate::fit::knots::spline::{Spline, derivative_of};
use crate::fit::knots::stray::Leash;
use crate::numerics::Point;

/// Steps of the fit, in the last of which few points gain anything.
const STEPS: usize = 12;
/// From so many times the tolerance after two steps, or after six, it does not come down to it.
const FAR: [(usize, f64); 2] = [(1, 4.0), (5, 1.5)];
/// What a point costs in a step and what a coefficient, in units of a pass over a point.
const WORK: [f64; 2] = [8.0, 8.0];
/// The share of a piece's largest speed that it has at its ends, at least.
const SLOWEST: f64 = 1e-5;
/// A point's weight grows or falls by this much at a step where it is on the curve, or as far off as any.
const ON: f64 = 0.4;
/// The least weight; the largest is the inverse.
const LEAST_WEIGHT: f64 = 1e-3;

/// An open curve with a knot changed.
pub(super) struct Stretch {
    /// The pieces of the whole curve that it was made of, and how many of them lie before the one that ends at the
    /// knot.
    pub(super) pieces: Vec<usize>,
    pub(super) inside: usize,
    pub(super) spline: Spline,
    /// Coefficients that hold its ends: which they are, and what.
    held: Vec<(usize, [f64; 2])>,
    data: Located,
    /// The numbers of its points.
    numbers: Vec<usize>,
    /// The points next to it on either side, and where these would be on it.
    around: Vec<(Point, f64)>,
    /// How many steps it was fitted in.
    steps: usize,
}

impl Stretch {
    /// The pieces around a knot, with a change made to it; nothing where that leaves nothing to move, where there are
    /// no points, or where the pieces are all of a closed curve.
    #[inline(never)]
    pub(super) fn around(
        sweep: &Sweep,
        knot: usize,
        beside: usize,
        change: Change,
        points: &Located,
    ) -> Option<Self> {
        let (pieces, inside) = pieces_around(sweep, knot, beside)?;
        let edges = edges(sweep, &pieces);
        let breaks = changed(breaks_between(sweep, &pieces, &edges), inside, change)?;
        let old: Vec<&Piece> = pieces.iter().map(|&s| &sweep.links[s].polynomial).collect();
        let by_piece = |s: usize, middle: f64, half: f64| {
            let [from, to] = [edges[s], edges[s + 1]];
            onto(old[s], [0.5 * (from + to), 0.5 * (to - from)], [middle, half])
        };
        let inner = &edges[1..pieces.len()];
        let spline = expressed(Space::new(breaks), &|middle, half| {
            by_piece(inner.partition_point(|&edge| edge <= middle), middle, half)
        });
        let held = held(sweep, &pieces, &spline.space, &by_piece)?;
        let (data, numbers) = gathered(sweep, &pieces, &edges, points);
        let around = points_beside(sweep, &pieces, edges[pieces.len()], points);
        (!numbers.is_empty()).then_some(Self {
            pieces,
            inside,
            spline,
            held,
            data,
            numbers,
            around,
            steps: 0,
        })
    }

    /// What was done to fit it.
    pub(super) fn work(&self) -> f64 {
        let [points, coefficients] = [self.numbers.len(), self.spline.space.count].map(|count| count as f64);
        self.steps as f64 * (WORK[0] * points + WORK[1] * coefficients)
    }

    /// Moves what is not held until all points are within the tolerance, far points weighing more from step to step;
    /// answers whether they are, and the curve keeps to the way of its points.
    #[inline(never)]
    pub(super) fn fit(&mut self, tolerance: f64, leash: Leash) -> bool {
        let (spline, data) = (&mut self.spline, &mut self.data);
        let mut nearest = f64::INFINITY;
        for step in 0..STEPS {
            self.steps += 1;
            spline.tighten_between(data, &self.held);
            let largest = spline.project(data, 2).largest;
            if largest <= tolerance {
                return self.keeps_to(leash);
            }
            nearest = nearest.min(largest);
            if FAR.iter().any(|&(at, times)| step == at && nearest > times * tolerance)
                || !largest.is_finite()
            {
                break;
            }
            if step > 0 {
                let distances = spline.distances(data);
                for (weight, far) in data.weights.iter_mut().zip(distances) {
                    let share = far / largest;
                    *weight = (*weight * (ON + share * share)).clamp(LEAST_WEIGHT, 1.0 / LEAST_WEIGHT);
                }
            }
        }
        false
    }

    /// Whether it keeps to the way of its points, and to that from the last one before it and to the next one.
    #[inline(never)]
    fn keeps_to(&self, leash: Leash) -> bool {
        let mut way = self.data.clone();
        for &(point, t) in &self.around {
            way.points.push(point);
            way.parameters.push(t);
        }
        self.spline.strays(&way, leash).is_none()
    }

    /// Whether it is nowhere faster by its parameter than this, and stops at no knot, where directions have no digits.
    #[inline(never)]
    pub(super) fn is_steady(&self, fastest: f64) -> bool {
        let (spline, degree) = (&self.spline, self.spline.space.breaks.degree);
        spline.pieces().iter().zip(&spline.space.spans).all(|(piece, span)| {
            let most = speed(piece, span.half);
            let ends = [-1.0, 1.0].map(|u| derivative_of(piece, degree, u, span.half, 1).norm());
            most <= fastest && ends[0] >= SLOWEST * most && ends[1] >= SLOWEST * most
        })
    }

    /// The number of each point, the piece that its foot is on, and how far behind its start.
    pub(super) fn feet(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let space = &self.spline.space;
        self.numbers.iter().zip(space.places(&self.data.parameters)).map(|(&m, (s, t))| {
            let span = &space.spans[s];
            (m, s, t - (span.middle - span.half))
        })
    }
}

/// The two pieces at a knot with so many beside them on either side, as far as there are any, and how many lie before.
#[inline(never)]
fn pieces_around(sweep: &Sweep, knot: usize, beside: usize) -> Option<(Vec<usize>, usize)> {
    let (mut first, mut inside) = (sweep.links[knot].before, 0);
    while inside < beside && sweep.links[first].before != NONE {
        first = sweep.links[first].before;
        inside += 1;
    }
    let most = inside + 2 + beside;
    if sweep.bare.closed && most >= sweep.count {
        return None;
    }
    let mut pieces = vec![first];
    while pieces.len() < most {
        match sweep.links[pieces[pieces.len() - 1]].after {
            NONE => break,
            after => pieces.push(after),
        }
    }
    Some((pieces, inside))
}

/// Where pieces start, counted from the first one, and where the last one ends.
fn edges(sweep: &Sweep, pieces: &[usize]) -> Vec<f64> {
    let mut edges = vec![0.0];
    for &s in pieces {
        edges.push(edges[edges.len() - 1] + sweep.links[s].width);
    }
    edges
}

/// The knots between some pieces.
#[inline(never)]
fn breaks_between(sweep: &Sweep, pieces: &[usize], edges: &[f64]) -> Breaks {
    let mut breaks = Breaks { closed: false, end: edges[pieces.len()], ..sweep.bare.bare() };
    for (&s, &t) in pieces[1..].iter().zip(&edges[1..]) {
        breaks.insert(breaks.len(), t, sweep.links[s].multiplicity);
    }
    breaks
}

/// The knots with a change made to knot k; nothing where there is none to join it with.
#[inline(never)]
fn changed(mut breaks: Breaks, k: usize, change: Change) -> Option<Breaks> {
    match change {
        Change::Gone => breaks.remove(k),
        Change::Counts(multiplicity) => breaks.multiplicity[k] = multiplicity,
        Change::Joined => {
            let next = *breaks.at.get(k + 1)?;
            breaks.at[k + 1] = 0.5 * (breaks.at[k] + next);
            breaks.multiplicity[k + 1] = breaks.multiplicity[k + 1].max(breaks.multiplicity[k]);
            breaks.remove(k);
        }
    }
    Some(breaks)
}

/// The coefficients that hold the ends of a stretch, which is open; nothing where they are all that there are. The
/// derivatives at an end that must not jump are those of the old piece there, whatever knots follow.
#[inline(never)]
fn held(
    sweep: &Sweep,
    pieces: &[usize],
    space: &Space,
    by_piece: &dyn Fn(usize, f64, f64) -> (Polynomial, Polynomial),
) -> Option<Vec<(usize, [f64; 2])>> {
    let degree = space.breaks.degree;
    let free = |knot: &Link| degree + 1 - knot.multiplicity;
    let (first, end) = (&sweep.links[pieces[0]], pieces.len() - 1);
    let ahead = if first.before == NONE { 0 } else { free(first) };
    let behind = sweep.links.get(sweep.links[pieces[end]].after).map_or(0, free);
    let hold = |s: usize, i: usize, old: usize| {
        let span = &space.spans[s];
        let (x, y) = by_piece(old, span.middle, span.half);
        let knots = space.inner_knots(s, i);
        (space.index(s, i), [x, y].map(|p| blossom(&p, degree, &knots, span.middle, span.half)))
    };
    let last = space.spans.len() - 1;
    let at_end = (0..behind).map(|i| hold(last, degree - i, end));
    (ahead + behind < space.count).then(|| (0..ahead).map(|i| hold(0, i, 0)).chain(at_end).collect())
}

/// The last point before some pieces and the first one after them, and where they would be on the stretch.
#[inline(never)]
fn points_beside(sweep: &Sweep, pieces: &[usize], end: f64, points: &Located) -> Vec<(Point, f64)> {
    let place =
        |at: f64, point: Option<&(usize, f64)>| point.map(|&(m, behind)| (points.points[m], at + behind));
    let pick = |mut link: usize, mut at: f64, ahead: bool| {
        for _ in 0..sweep.count {
            let Link { width, points: own, before, after, .. } = sweep.links.get(link)?;
            let start = if ahead { at - width } else { at };
            if let Some(found) = place(start, if ahead { own.last() } else { own.first() }) {
                return Some(found);
            }
            (link, at) = if ahead { (*before, start) } else { (*after, at + width) };
        }
        None
    };
    let [first, last] = [pieces[0], pieces[pieces.len() - 1]].map(|s| &sweep.links[s]);
    pick(first.before, 0.0, true).into_iter().chain(pick(last.after, end, false)).collect()
}

/// The points of some pieces in the order of their numbers there, all weighing the same.
#[inline(never)]
fn gathered(sweep: &Sweep, pieces: &[usize], edges: &[f64], points: &Located) -> (Located, Vec<usize>) {
    let (mut data, mut numbers) = (Located::default(), Vec::new());
    for (&s, edge) in pieces.iter().zip(edges) {
        for &(m, behind) in &sweep.links[s].points {
            data.points.push(points.points[m]);
            data.parameters.push(edge + behind);
            numbers.push(m);
        }
    }
    data.weights = vec![1.0; numbers.len()];
    (data, numbers)
}
