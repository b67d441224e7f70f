//! Few points whose corners are known: what is between two corners is searched for on its own.

use super::{Aim, Found, Phase, Plan, Sparsest};
use crate::error::Result;
use crate::fit::corners::Corner;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::combine::{expressed, sum_on};
use crate::fit::knots::free_knots::Located;
use crate::fit::knots::space::{Polynomial, Space};
use crate::fit::knots::spline::Spline;
use crate::numerics::{Point, Vector};

/// A smooth part of the curve, from where on it is in the whole, and what brings its ends to the corners.
struct Run {
    spline: Spline,
    start: f64,
    shift: [Vector; 2],
}

impl Run {
    /// The polynomials on middle ± half of the whole.
    fn on(&self, middle: f64, half: f64) -> (Polynomial, Polynomial) {
        let end = self.spline.space.breaks.end;
        let inner = middle - self.start;
        let (mut x, mut y) = sum_on(core::slice::from_ref(&self.spline), inner, half, end);
        let [from, to] = self.shift;
        let (shift, slope) = (from + (to - from) * (inner / end), (to - from) * (half / end));
        x[0] += shift.x;
        y[0] += shift.y;
        x[1] += slope.x;
        y[1] += slope.y;
        (x, y)
    }
}

impl Sparsest {
    /// A search that has ended: smooth from one of these corners to the next. The points' parameters are those by
    /// length.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    #[inline(never)]
    pub(in crate::fit) fn between_corners(
        full: Located,
        plan: Plan,
        aim: Aim,
        noise: f64,
        corners: &[Corner],
    ) -> Result<Self> {
        let mut breaks = Breaks::simple(plan.degree, false, plan.end, Vec::new());
        let mut located = full.copied()?;
        let mut runs: Vec<Run> = Vec::new();
        let (mut first, mut from, mut start) = (0, None, 0.0);
        for corner in corners.iter().map(Some).chain([None]) {
            let last = corner.map_or(full.points.len() - 1, |corner| corner.last);
            let to = corner.map(|corner| corner.place);
            let (spline, feet) = run(&full.points[first..=last], [from, to], plan, aim, noise)?;
            let end = spline.space.breaks.end;
            // A corner at a point is the end of one run and the beginning of the next.
            let inner = feet.parameters.iter().skip(usize::from(from.is_some()));
            let next = corner.map_or(full.points.len(), |corner| corner.next);
            for (own, t) in located.parameters[first..next].iter_mut().zip(inner) {
                *own = start + t;
            }
            let ends = [spline.on(0, 0.0, 0), spline.on(spline.space.spans.len() - 1, end, 0)];
            let shift = [0, 1].map(|i| [from, to][i].map_or(Vector::zeros(), |place: Point| place - ends[i]));
            breaks.at.extend(spline.space.breaks.at.iter().map(|t| start + t));
            breaks.multiplicity.extend(&spline.space.breaks.multiplicity);
            runs.push(Run { spline, start, shift });
            start += end;
            if let Some(corner) = corner {
                breaks.at.push(start);
                breaks.multiplicity.push(plan.degree);
                (first, from) = (corner.next, to);
            }
        }
        breaks.end = start;
        let of = |middle: f64| &runs[runs.partition_point(|run| run.start <= middle).max(1) - 1];
        let spline = expressed(Space::new(breaks), &|middle, half| of(middle).on(middle, half));
        let distances = spline.project(&mut located, 2);
        let mut search = Self::new(full, Plan { end: start, ..plan }, aim, noise);
        search.at_first = spline.space.breaks.len();
        search.found = Some(Found { spline, located, distances, wild: None });
        (search.phase, search.straightened) = (Phase::Done, true);
        Ok(search)
    }
}

/// The smooth curve from end to end of some points, and of corners before and after them.
#[inline(never)]
fn run(
    points: &[Point],
    corners: [Option<Point>; 2],
    plan: Plan,
    aim: Aim,
    noise: f64,
) -> Result<(Spline, Located)> {
    let [from, to] = corners;
    let points: Vec<Point> = from.iter().chain(points).chain(&to).copied().collect();
    let mut parameters = vec![0.0];
    for pair in points.windows(2) {
        parameters.push(parameters[parameters.len() - 1] + (pair[1] - pair[0]).norm());
    }
    let last = parameters.len() - 1;
    let (length, end) = (parameters[last], last as f64);
    parameters.iter_mut().for_each(|t| *t *= end / length);
    parameters[last] = end;
    let located = Located { points, parameters, weights: Vec::new() };
    let mut search = Sparsest::new(located, Plan { end, ..plan }, aim, noise);
    while !search.is_done() {
        search.step();
    }
    let found = search.finish();
    Ok(found.spline.trimmed(&found.located)?.unwrap_or((found.spline, found.located)))
}
