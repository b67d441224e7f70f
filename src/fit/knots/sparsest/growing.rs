//! Knots are added until there are enough, looked at from afar where points are many.

use super::{Aim, Phase, Sparsest};
use crate::fit::knots::adding;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::spline::Spline;

/// How many averages a knot needs, of those that the search begins with, and how many times as many are looked at where
/// that is too few, or where they hid something.
const PER_KNOT: usize = 3;
const CLOSER: usize = 4;
/// Rounds of adding knots in a row.
const MOST_GROWTH: usize = 60;

impl Sparsest {
    /// Goes on with more averages.
    #[inline(never)]
    pub(super) fn look_closer(&mut self, breaks: Breaks) -> Phase {
        self.view.averages = CLOSER * self.view.seen.points.len();
        self.view.seen = self.view.unmoved();
        self.fitted = FreeKnots::new(breaks, &self.view.seen);
        (self.effort.grown, self.effort.repairs, self.evening.even) = (self.effort.rounds, 0, false);
        Phase::Grow
    }

    /// A round of adding knots where the points are farthest from the curve, or the end of that.
    pub(super) fn grow(&mut self) -> Phase {
        let denser = match self.asked.aim {
            Aim::Noise(noise) => adding::denser(&self.fitted, &self.view.seen, 2.0 * noise * noise),
            Aim::Squares(target) if self.fitted.squares > 0.5 * target => {
                let count = self.view.seen.points.len().max(1) as f64;
                adding::denser(&self.fitted, &self.view.seen, 0.3 * target / count)
            }
            Aim::Squares(_) => None,
            Aim::Tolerance(tolerance) => {
                let spline = Spline::of(&self.fitted);
                spline.project(&mut self.view.seen, 2);
                let breaks = adding::closer(&spline, &self.view.seen, 0.6 * tolerance);
                breaks.map(|breaks| FreeKnots::new(breaks, &self.view.seen))
            }
        };
        match denser {
            Some(fitted) if self.effort.rounds < self.effort.grown + MOST_GROWTH => {
                self.fitted = fitted;
                Phase::Grow
            }
            _ if self.view.is_averaged()
                && PER_KNOT * self.fitted.breaks().len() > self.view.seen.points.len() =>
            {
                self.look_closer(self.fitted.breaks().clone())
            }
            _ => {
                self.fitted = FreeKnots::new(self.fitted.breaks().clone(), &self.view.seen);
                self.at_first = self.fitted.breaks().len();
                Phase::Thin
            }
        }
    }
}
