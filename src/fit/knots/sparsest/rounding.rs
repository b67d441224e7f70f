//! Corners that turn by less than is asked for become smooth, and knots beside them make up for it.

use super::{Aim, Phase, Sparsest, Swept};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::spline::Spline;
use crate::numerics::Vector;
use crate::numerics::angle::sin_cos;

/// How often corners are looked for that have become too slight.
const MOST_TIMES: usize = 6;
/// Where, on the way to the next knots, the knots come that make up for a corner.
const BESIDE: f64 = 0.4;
/// By how much the price of a number falls at first, for the knots to be there when the tolerance is met.
const CHEAPER: f64 = 1.0 / 8.0;
/// Corners of noisy points that turn by less, in radians, may be smooth.
pub(super) const SEEMING: f64 = 0.5;
/// How many times as far as a point may be off the way is looked at, and in how many steps half a piece.
const FAR: f64 = 3.0;
const LOOKS: f64 = 16.0;

impl Sparsest {
    /// Corners that turn by less than is asked for.
    #[inline(never)]
    pub(super) fn slight_corners(&self, spline: &Spline) -> Vec<usize> {
        slight_corners(spline, self.asked.least_turn, FAR * self.slack())
    }

    /// Goes on without the corners of the best curve that are too slight, or ends the search.
    pub(super) fn round_off(&mut self) -> Phase {
        if matches!(self.asked.aim, Aim::Tolerance(_)) && self.effort.roundings == 0 {
            self.found = self.found.take().map(|best| self.jointed(best));
        }
        let Some(best) = &self.found else { return Phase::Done };
        let slight = self.slight_corners(&best.spline);
        if slight.is_empty()
            || self.effort.roundings >= MOST_TIMES
            || matches!(self.asked.aim, Aim::Squares(_))
        {
            return Phase::Done;
        }
        self.effort.roundings += 1;
        self.swept = Swept::Not;
        self.sharpest = best.spline.space.breaks.degree - 1;
        let breaks = without_corners(&best.spline.space.breaks, &slight);
        if !self.view.is_averaged() {
            self.view.seen = best.located.clone();
        } else {
            self.view.seen = self.view.unmoved();
        }
        self.fitted = FreeKnots::new(breaks, &self.view.seen);
        if matches!(self.asked.aim, Aim::Noise(_)) {
            self.effort.repairs = 0;
            return Phase::Refine;
        }
        (self.found, self.effort.repairs) = (None, 0);
        self.pricing.price.0 *= CHEAPER;
        Phase::Polish
    }
}

/// Corners at which the curve turns by less than an angle; or its way does, seen from `far`: a curve that runs a little
/// too far and back again turns round, though nothing else does.
pub(super) fn slight_corners(spline: &Spline, least: f64, far: f64) -> Vec<usize> {
    let breaks = &spline.space.breaks;
    if least <= 0.0 || breaks.degree < 2 {
        return Vec::new();
    }
    let cosine = sin_cos(least).1;
    let is_slight = |k: &usize| {
        let (before, after) = spline.space.sides(*k);
        let [arriving, leaving] = spline.ways(*k);
        let corner = spline.at(after, -1.0, 0);
        let seen = |s: usize, from: f64| {
            let place = |step: usize| spline.at(s, from * (1.0 - step as f64 / LOOKS), 0) - corner;
            let steps = 2 * LOOKS as usize;
            let step = (1..steps).find(|&step| place(step).norm() > far).unwrap_or(steps);
            place(step)
        };
        let little = |a: Vector, b: Vector| a.dot(&b) > cosine * a.norm() * b.norm();
        breaks.multiplicity[*k] == breaks.degree
            && (little(arriving, leaving) || little(-seen(before, 1.0), seen(after, -1.0)))
    };
    (0..breaks.len()).filter(is_slight).collect()
}

/// The breaks with all corners smooth that turn little, `None` where there are none: in noise a corner with the bend
/// beside it may stand for a smooth joint (D 13.14).
pub(super) fn without_seeming_corners(spline: &Spline) -> Option<Breaks> {
    let slight = slight_corners(spline, SEEMING, 0.0);
    let mut breaks = spline.space.breaks.clone();
    slight.iter().for_each(|&k| breaks.multiplicity[k] = breaks.degree - 1);
    (!slight.is_empty()).then_some(breaks)
}

/// The same breaks with these corners smooth, and with a knot on either side of each. No knot may become a corner, nor
/// begin as one.
fn without_corners(breaks: &Breaks, slight: &[usize]) -> Breaks {
    let mut smooth = breaks.clone();
    smooth.straight.clear();
    smooth.sharpest = breaks.degree - 1;
    smooth.smoothest = breaks.smoothest.min(smooth.sharpest);
    let mut added = Vec::new();
    for &k in slight {
        smooth.multiplicity[k] = smooth.sharpest;
        for way in [-BESIDE * breaks.gap_before(k), BESIDE * breaks.gap_after(k)] {
            added.push(breaks.wrapped(breaks.at[k] + way));
        }
    }
    smooth.add(&added);
    smooth
}
