//! Knots to begin a search with, more of them than anyone needs, and knots where points are too far from the curve.

use super::breaks::Breaks;
use super::free_knots::{FreeKnots, Located};
use super::spline::Spline;

/// Points per number of a curve at first.
const SPARE: usize = 6;
/// The most knots to start with.
const MOST_KNOTS: usize = 1500;

/// Evenly spread knots that count `smoothest` times.
pub(super) fn even(degree: usize, closed: bool, end: f64, points: usize, smoothest: usize) -> Breaks {
    let count = (points / SPARE / smoothest).clamp(if closed { degree + 2 } else { 1 }, MOST_KNOTS / 2);
    let mut breaks = Breaks::even(degree, closed, end, count.min(points.saturating_sub(1).max(2)));
    breaks.smoothest = smoothest;
    breaks.multiplicity.fill(smoothest);
    breaks
}

/// Adds knots where the points lie farther from the curve than noise would have them, or `None` where they nowhere
/// do. `square` is the mean square that is allowed; a piece may exceed it by chance.
pub(super) fn denser(fitted: &FreeKnots, data: &Located, square: f64) -> Option<FreeKnots> {
    let mut breaks = fitted.breaks().clone();
    let mut added = Vec::new();
    for (s, sums) in fitted.moments.iter().enumerate() {
        let count = sums.count as f64;
        // Four standard deviations of a sum of squares of 2·count normal numbers.
        let allowed = square * (count + 4.0 * count.sqrt());
        if sums.count >= 3 && fitted.left(s) > allowed {
            added.push(fitted.space.spans[s].middle);
        }
    }
    if added.is_empty() || breaks.len() + added.len() > MOST_KNOTS {
        return None;
    }
    breaks.add(&added);
    Some(FreeKnots::new(breaks, data))
}

/// Adds knots at the farthest point of every piece that goes too far from its points; where there is a knot already,
/// it becomes sharper. `None` where nothing can be added.
pub(super) fn closer(spline: &Spline, data: &Located, tolerance: f64) -> Option<Breaks> {
    let mut breaks = spline.space.breaks.clone();
    let mut worst = vec![(tolerance, f64::NAN); spline.space.spans.len()];
    let mut counts = vec![0_usize; spline.space.spans.len()];
    for (point, (s, t)) in data.points.iter().zip(spline.space.places(&data.parameters)) {
        counts[s] += 1;
        let distance = (spline.on(s, t, 0) - point).norm();
        if distance > worst[s].0 {
            worst[s] = (distance, t);
        }
    }
    let mut added = Vec::new();
    let mut sharper = Vec::new();
    let mean = breaks.end / data.points.len() as f64;
    for (s, (_, t)) in worst.iter().enumerate().filter(|(_, (_, t))| t.is_finite()) {
        let span = &spline.space.spans[s];
        // By length points of a narrow bend may be far closer than they are on average.
        let step = mean.min(2.0 * span.half / counts[s].saturating_sub(1).max(1) as f64);
        // Neither two knots between two points nor two on one.
        let margin = 0.75 * step;
        if 2.0 * span.half > 3.0 * step {
            added.push(t.max(span.middle - span.half + margin).min(span.middle + span.half - margin));
        } else {
            sharper.push(s);
        }
    }
    let mut changed = false;
    for s in sharper {
        let knots =
            if breaks.closed { [Some(s), Some((s + 1) % breaks.len())] } else { [s.checked_sub(1), Some(s)] };
        for k in knots.into_iter().flatten() {
            let sharpest = breaks.sharpest;
            if let Some(m) = breaks.multiplicity.get_mut(k).filter(|m| **m < sharpest) {
                *m += 1;
                changed = true;
            }
        }
    }
    if breaks.len() + added.len() > MOST_KNOTS.max(2 * data.points.len()) {
        return None;
    }
    changed |= !added.is_empty();
    breaks.add(&added);
    changed.then_some(breaks)
}
