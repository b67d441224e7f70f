//! The last knots of noisy points: those that points by length ask for, where the speed of an open curve changes, go
//! once points slide as freely as they come nearer. (D 13.21)

use super::following::STAYS;
use super::rounding::{SEEMING, slight_corners};
use super::{Aim, EASILY, Found, Phase, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::{CORNER, Price, hopes, settle};
use crate::fit::knots::spline::Spline;

/// Steps until one polynomial is as near as it comes, those of a trial, and those of all points once averages are.
const LONE: usize = 32;
const STEPS: usize = 12;
const FEW_STEPS: usize = 4;
/// Slides of the other knots before points slide.
const SLIDES: usize = 2;
/// So many knots are tried: what one costs where points stay says little.
const TRIALS: usize = 12;
/// How many numbers' worth the knots that go must spare at least, one knot and a third: where points are along the
/// curve is no longer known then.
const PAYS: f64 = 4.0;

/// A curve whose points slide, while knots are taken from it.
#[derive(Clone, Debug)]
pub(super) struct Sliding {
    spline: Spline,
    located: Located,
    squares: f64,
    /// What it cost with all knots.
    begun: f64,
    /// Ways to do without one of its knots.
    trials: Vec<Breaks>,
    /// Where it has sharp corners.
    corners: Vec<f64>,
}

impl Sparsest {
    /// Whether knots are still to be taken away while the points of the best curve slide: of noisy points along an open
    /// way. On outlines what points say along the curve is worth more.
    pub(super) fn may_slide(&self) -> bool {
        let Some(best) = &self.found else { return false };
        let breaks = &best.spline.space.breaks;
        let has_knots = breaks.degree > 1 && !breaks.is_empty();
        let noisy = matches!(self.asked.aim, Aim::Noise(_)) && !self.asked.timed;
        noisy && has_knots && !breaks.closed && best.wild.is_none()
    }

    /// Takes the next knot away, lets points and the others slide, and goes on with what costs less; where none is left
    /// to try, that becomes the best curve if it spares enough.
    pub(super) fn slide(&mut self, next: usize) -> Phase {
        let Some(sliding) = &self.sliding else { return self.begin_sliding() };
        let Some(breaks) = sliding.trials.get(next).cloned() else { return self.end_sliding() };
        let enough = self.cost_of(sliding) - self.pricing.price.whole(&breaks);
        let (spline, located, squares) = self.slid(breaks, sliding.located.clone());
        let stay = corners_stay(&sliding.corners, &spline.space.breaks);
        if squares >= enough || !stay || self.is_spoiled(&spline, &located) {
            return Phase::Last(next + 1);
        }
        let begun = sliding.begun;
        self.slide_on(spline, located, squares, begun)
    }

    /// One polynomial where that costs less; else the best curve with points that slide, unless it has sharp corners of
    /// even points: where these are is told along the curve.
    #[inline(never)]
    fn begin_sliding(&mut self) -> Phase {
        let Some(best) = &self.found else { return Phase::Done };
        let breaks = best.spline.space.breaks.clone();
        let price = self.pricing.price;
        let mut seen = if self.view.is_averaged() { self.view.seen.clone() } else { best.located.clone() };
        let (whole, now) = (price.whole(&breaks), best.spline.project(&mut seen, 6).squares);
        let corners = sharp_corners(&best.spline);
        let mut located = self.view.unmoved();
        let mut spline = Spline::of(&FreeKnots::new(breaks.bare(), &located));
        let squares = spline.ease(&mut located, LONE, 0.0).squares;
        // A corner that is seen should be there.
        let bonus = CORNER * price.0 * corners.len() as f64;
        if squares + bonus <= now + whole && !self.is_spoiled(&spline, &located) {
            let (begun, trials) = (f64::INFINITY, Vec::new());
            self.sliding = Some(Sliding { spline, located, squares, begun, trials, corners });
            return self.end_sliding();
        }
        if self.asked.spaced && !corners.is_empty() {
            return Phase::Done;
        }
        let (spline, located, squares) = self.slid(breaks, seen);
        self.slide_on(spline, located, squares, squares + whole)
    }

    /// Squares and prices together.
    fn cost_of(&self, sliding: &Sliding) -> f64 {
        sliding.squares + self.pricing.price.whole(&sliding.spline.space.breaks)
    }

    /// The fit on some breaks that slide a little, after which the points slide.
    #[inline(never)]
    fn slid(&self, breaks: Breaks, mut located: Located) -> (Spline, Located, f64) {
        let worth = EASILY * self.pricing.price.0;
        let mut spline = Spline::of(&settle(FreeKnots::new(breaks, &located), &located, worth, SLIDES));
        let squares = spline.ease(&mut located, STEPS, 0.0).squares;
        (spline, located, squares)
    }

    /// The same from this curve on.
    #[inline(never)]
    fn slide_on(&mut self, spline: Spline, located: Located, squares: f64, begun: f64) -> Phase {
        let fitted = FreeKnots::new(spline.space.breaks.clone(), &located);
        // Whatever a knot costs, the cheapest are tried.
        let trials = hopes(fitted.breaks(), &fitted.removals(), Price(f64::MAX), TRIALS);
        let corners = sharp_corners(&spline);
        self.sliding = Some(Sliding { spline, located, squares, begun, trials, corners });
        Phase::Last(0)
    }

    /// What was slid to, if it spares enough, with all points, and those that are even placed by length again.
    #[inline(never)]
    fn end_sliding(&mut self) -> Phase {
        let Some(sliding) = self.sliding.take() else { return Phase::Done };
        if sliding.begun - self.cost_of(&sliding) < PAYS * self.pricing.price.0 {
            return Phase::Done;
        }
        let (mut spline, mut located) = (sliding.spline, sliding.located);
        if self.view.is_averaged() {
            self.view.seen = located;
            located = self.view.following(&spline.space.breaks);
            spline.ease(&mut located, FEW_STEPS, 0.0);
        }
        spline.straighten();
        let distances = spline.project(&mut located, 3);
        if !self.is_spoiled(&spline, &located) {
            let found = Found { spline, located, distances, wild: None };
            let spaced = if self.asked.spaced { self.spaced_out(&found) } else { None };
            self.evening.even = false;
            self.found = spaced.or(Some(found));
        }
        Phase::Done
    }
}

/// Where a curve has corners that are none by noise alone.
fn sharp_corners(spline: &Spline) -> Vec<f64> {
    let (breaks, slight) = (&spline.space.breaks, slight_corners(spline, SEEMING, 0.0));
    let is_sharp = |k: &usize| breaks.multiplicity[*k] == breaks.degree && !slight.contains(k);
    (0..breaks.len()).filter(is_sharp).map(|k| breaks.at[k]).collect()
}

/// Whether corners are where they were: what points say along the curve tells where that is.
fn corners_stay(corners: &[f64], after: &Breaks) -> bool {
    let is_at = |at: f64| move |(t, m): (&f64, &usize)| *m == after.degree && (t - at).abs() < STAYS;
    corners.iter().all(|&at| after.at.iter().zip(&after.multiplicity).any(is_at(at)))
}
