//! Corners that change the speed more than the way: once every piece has a speed of its own they are smooth joints.

use super::last_knots::minimax;
use super::rounding::{SEEMING, slight_corners};
use super::{Aim, Found, MOST_WORK, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::CORNER;
use crate::fit::knots::space::Span;
use crate::fit::knots::spline::Spline;
use crate::numerics::order::sort_by_number;
use crate::numerics::plane::{larger, smaller};

/// Rounds of a curve whose points follow it.
const ROUNDS: usize = 12;
/// The most by which a corner makes the curve faster or slower, and all of them together.
const MOST: f64 = 8.0;
const MOST_IN_ALL: f64 = 1e4;
/// The share of a search's work that corners may take; of more than some 200,000 points none is tried.
const SHARE: f64 = 0.05;
/// From so many times a tolerance its largest distance may come down to it.
const NEAR: f64 = 2.0;

impl Sparsest {
    /// The best curve with those corners smooth that turn little and are not worth what they cost: all of them, or one
    /// after the other, those first that turn least (D 13.18). None are where parameters were given, which this would
    /// change.
    #[inline(never)]
    pub(super) fn jointed(&self, mut best: Found) -> Found {
        if self.asked.timed || self.asked.aim.is_fine() {
            return best;
        }
        let one = self.work_of(2.0 * ROUNDS as f64, &best.spline.space.breaks);
        let most = (SHARE * MOST_WORK / one) as usize;
        let mut slight = slight_corners(&best.spline, SEEMING, 0.0);
        if slight.len() > 1
            && most > 0
            && let Some(found) = self.with_joints(&slight, &best)
        {
            return found;
        }
        let straightness = |k: &usize| {
            let [before, after] = best.spline.ways(*k);
            before.dot(&after) / (before.norm() * after.norm()).max(f64::MIN_POSITIVE)
        };
        sort_by_number(&mut slight, &|k| -straightness(k));
        for k in slight.into_iter().take(most) {
            best = self.with_joints(&[k], &best).unwrap_or(best);
        }
        best
    }

    /// The fit with smooth joints in place of these corners, where it is worth what they spare: a corner costs more
    /// than its numbers, for it is seen.
    #[inline(never)]
    fn with_joints(&self, corners: &[usize], best: &Found) -> Option<Found> {
        let price = self.pricing.price;
        let (mut breaks, mut located) = at_one_speed(&best.spline, &best.located, corners)?;
        corners.iter().for_each(|&k| breaks.multiplicity[k] = breaks.degree - 1);
        let spared = price.whole(&best.spline.space.breaks) - price.whole(&breaks);
        let enough = best.distances.squares + spared + CORNER * price.0 * corners.len() as f64;
        let mut spline = Spline::of(&FreeKnots::new(breaks, &located));
        for _ in 0..ROUNDS {
            spline.project(&mut located, 2);
            spline.tighten(&located);
        }
        spline.straighten();
        let mut distances = spline.project(&mut located, 3);
        let near = match self.asked.aim {
            Aim::Tolerance(tolerance) => {
                if distances.largest > tolerance && distances.largest < NEAR * tolerance {
                    distances = minimax(&mut spline, &mut located, tolerance);
                    located.weights.clone_from(&best.located.weights);
                }
                distances.largest <= tolerance
            }
            _ => distances.squares <= enough,
        };
        let kept = near && !self.is_spoiled(&spline, &located);
        kept.then_some(Found { spline, located, distances, wild: None })
    }
}

/// The breaks of a spline and its points, with pieces of such lengths that the curve is as fast after a corner as
/// before it; a closed one, which may come round faster than it set out, a little faster at each. Where many corners in
/// a row make it faster, only these count; nothing where they make its pieces too long or short for numbers.
fn at_one_speed(spline: &Spline, located: &Located, corners: &[usize]) -> Option<(Breaks, Located)> {
    let space = &spline.space;
    let breaks = &space.breaks;
    let all: Vec<usize> = (0..breaks.len()).filter(|&k| breaks.multiplicity[k] == breaks.degree).collect();
    let stretches = stretches(spline, &all).or_else(|| stretches(spline, corners))?;
    let stretched = |(span, stretch): (&Span, f64)| 2.0 * span.half * stretch;
    let mut lengths: Vec<f64> = space.spans.iter().zip(stretches).map(stretched).collect();
    let unit = breaks.end / lengths.iter().sum::<f64>();
    lengths.iter_mut().for_each(|length| *length *= unit);
    // What lies before a closed curve's first knot belongs to its last piece.
    let last = lengths.len() - 1;
    let lead =
        if breaks.closed { breaks.at[0] / (2.0 * space.spans[last].half) * lengths[last] } else { 0.0 };
    let mut begin = lead;
    let mut begins = Vec::with_capacity(lengths.len());
    for length in &lengths {
        begins.push(begin);
        begin += length;
    }
    let mut guess = 0;
    let place = |&t: &f64| {
        let (s, t) = space.find(t, guess);
        guess = s;
        let span = &space.spans[s];
        let t = begins[s] + (t - span.middle + span.half) / (2.0 * span.half) * lengths[s];
        if breaks.closed && t >= breaks.end { t - breaks.end } else { t.min(breaks.end) }
    };
    let parameters = located.parameters.iter().map(place).collect();
    let at = if breaks.closed { begins } else { begins.split_off(1) };
    Some((Breaks { at, ..breaks.clone() }, Located { parameters, ..located.clone() }))
}

/// How many times as long each piece is to be for the curve to be as fast after these corners as before them; nothing
/// where that is too much.
fn stretches(spline: &Spline, corners: &[usize]) -> Option<Vec<f64>> {
    let (space, breaks) = (&spline.space, &spline.space.breaks);
    let mut rises = vec![1.0; breaks.len()];
    corners.iter().for_each(|&k| rises[k] = rise(spline, k));
    let whole = if breaks.closed { rises.iter().fold(1.0, |whole, rise| whole * rise) } else { 1.0 };
    let share = libm::pow(whole, -1.0 / corners.len().max(1) as f64);
    corners.iter().for_each(|&k| rises[k] *= share);
    let (mut stretch, mut low, mut high) = (1.0, 1.0, 1.0);
    let mut stretches = Vec::with_capacity(space.spans.len());
    for s in 0..space.spans.len() {
        // The first piece of a closed curve begins at its first knot, that of an open one before it.
        if let Some(k) = if breaks.closed { Some(s) } else { s.checked_sub(1) } {
            stretch *= rises[k];
        }
        (low, high) = (smaller(low, stretch), larger(high, stretch));
        stretches.push(stretch);
    }
    (high <= MOST_IN_ALL * low).then_some(stretches)
}

/// How many times as fast the curve is after corner k as before it; 1 at other knots.
fn rise(spline: &Spline, k: usize) -> f64 {
    let breaks = &spline.space.breaks;
    let [before, after] = spline.ways(k).map(|way| way.norm());
    let known = breaks.multiplicity[k] == breaks.degree && before > 0.0 && after > 0.0;
    if known { (after / before).clamp(1.0 / MOST, MOST) } else { 1.0 }
}
