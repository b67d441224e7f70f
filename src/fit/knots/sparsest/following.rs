//! Corners in place of neighbouring knots, and knots less, that pay once the points have followed the curve.

use super::rounding::{SEEMING, slight_corners};
use super::{Aim, EASILY, Found, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::search::{CORNER, clusters, hopes, settle};
use crate::fit::knots::spline::Spline;

/// Rounds of knots that slide and points that follow, and slides in one; slides where points stay.
const ROUNDS: usize = 4;
const SLIDES: usize = 2;
const MOST_SLIDES: usize = 8;
/// So many of the cheapest knots are tried without.
const CHEAPEST: usize = 6;

/// By how much of a step between points a corner may move where a knot is taken away.
pub(super) const STAYS: f64 = 0.3;

impl Sparsest {
    /// The best curve of noisy points with corners in place of neighbouring knots that explain the points hardly
    /// better, and without knots that do not pay. Feet on a bend stay there: a corner is seen to be as near only once
    /// they have moved on (D 13.13).
    #[inline(never)]
    pub(super) fn followed(&self, mut best: Found) -> Found {
        let breaks = &best.spline.space.breaks;
        match self.asked.aim {
            Aim::Noise(_) if self.sharpest == breaks.degree => {}
            Aim::Tolerance(_) => return self.jointed(best),
            _ => return best,
        }
        let mut next = 0;
        loop {
            let before = &best.spline.space.breaks;
            let mut trials = clusters(&self.sharpening(before), best.located.points.len());
            // A corner that is seen should be there.
            let bonus = (next < trials.len()).then_some(CORNER);
            // Where points are held knots have been taken away with the points where they are.
            if next >= trials.len() && !self.evening.even {
                let fitted = FreeKnots::new(before.clone(), &best.located);
                trials.extend(hopes(before, &fitted.removals(), self.pricing.price, CHEAPEST));
            }
            if next >= trials.len() {
                return if self.asked.spaced { best } else { self.jointed(best) };
            }
            match self.after(trials.swap_remove(next), bonus, &best) {
                Some(found) => (best, next) = (found, 0),
                None => next += 1,
            }
        }
    }

    /// The fit on other breaks that slide, and whose points follow where they are free, if it is worth its price and a
    /// bonus of some numbers; without one corners have to stay as well.
    #[inline(never)]
    fn after(&self, breaks: Breaks, bonus: Option<f64>, best: &Found) -> Option<Found> {
        let price = self.pricing.price;
        let spared = price.whole(&best.spline.space.breaks) - price.whole(&breaks);
        let (held, mut located) = (self.evening.even, best.located.clone());
        let slides = if held { MOST_SLIDES } else { SLIDES };
        let (mut breaks, mut round) = (breaks, 0);
        let spline = loop {
            let fitted = settle(FreeKnots::new(breaks, &located), &located, EASILY * price.0, slides);
            let mut spline = Spline::of(&fitted);
            round += 1;
            if held {
                break spline;
            }
            spline.project(&mut located, 2);
            spline.tighten(&located);
            if round == ROUNDS {
                break spline;
            }
            spline.project(&mut located, 2);
            breaks = spline.space.breaks;
        };
        let distances = spline.project(&mut located, 3);
        if held {
            located.parameters.clone_from(&best.located.parameters);
        }
        // A corner that hardly turns is not seen. Where lengths are known, it is one that may become smooth by them.
        let seen = self.asked.spaced || slight_corners(&spline, SEEMING, 0.0).is_empty();
        let enough = best.distances.squares + spared + bonus.filter(|_| seen).unwrap_or(0.0) * price.0;
        let stay = bonus.is_some() || corners_stay(&best.spline.space.breaks, &spline.space.breaks);
        let kept = stay && distances.squares <= enough && !self.is_spoiled(&spline, &located);
        kept.then_some(Found { spline, located, distances, wild: None })
    }
}

/// Whether corners are where they were: they are not to pay for a knot less.
fn corners_stay(before: &Breaks, after: &Breaks) -> bool {
    let stays = |t: f64| after.at.iter().any(|at| (at - t).abs() < STAYS);
    before.at.iter().zip(&before.multiplicity).all(|(t, m)| *m < before.degree || stays(*t))
}
