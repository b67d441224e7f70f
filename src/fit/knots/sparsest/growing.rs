//! Knots are added until there are enough, looked at from afar where points are many.

use super::{Aim, Phase, Sparsest};
use crate::fit::knots::bins::averages;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::foot_points::Spline;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::start;

/// About so many averages of points are looked at at first; half as many points more are not averaged.
pub(super) const SEEN: usize = 450;
/// How many averages a knot needs, of those that the search begins with, and how many times as many are looked at where that is too few, or
/// where they hid something.
const PER_KNOT: usize = 3;
const CLOSER: usize = 4;
/// Rounds of adding knots in a row.
const MOST_GROWTH: usize = 60;

impl Sparsest {
    /// The points as they are looked at before anything moved them.
    pub(super) fn seen_from_afar(&self) -> Located {
        from_afar(&self.full, self.averages)
    }

    /// Goes on with more averages.
    #[inline(never)]
    pub(super) fn look_closer(&mut self, breaks: Breaks) -> Phase {
        self.averages = CLOSER * self.seen.points.len();
        self.seen = self.seen_from_afar();
        self.fitted = FreeKnots::new(breaks, &self.seen);
        (self.grown, self.repairs, self.even) = (self.rounds, 0, false);
        Phase::Grow
    }

    /// A round of adding knots where the points are farthest from the curve, or the end of that.
    pub(super) fn grow(&mut self) -> Phase {
        let denser = match self.aim {
            Aim::Noise(noise) => start::denser(&self.fitted, &self.seen, 2.0 * noise * noise),
            Aim::Squares(target) if self.fitted.squares > 0.5 * target => {
                let count = self.seen.points.len().max(1) as f64;
                start::denser(&self.fitted, &self.seen, 0.3 * target / count)
            }
            Aim::Squares(_) => None,
            Aim::Tolerance(tolerance) => {
                let spline = Spline::of(&self.fitted);
                spline.project(&mut self.seen, 2);
                let breaks = start::closer(&spline, &self.seen, 0.6 * tolerance);
                breaks.map(|breaks| FreeKnots::new(breaks, &self.seen))
            }
        };
        match denser {
            Some(fitted) if self.rounds < self.grown + MOST_GROWTH => {
                self.fitted = fitted;
                Phase::Grow
            }
            _ if self.is_averaged() && PER_KNOT * self.fitted.breaks().len() > self.seen.points.len() => {
                self.look_closer(self.fitted.breaks().clone())
            }
            _ => {
                self.fitted = FreeKnots::new(self.fitted.breaks().clone(), &self.seen);
                self.at_first = self.fitted.breaks().len();
                Phase::Thin
            }
        }
    }
}

/// The points, or averages of them where they are many.
pub(super) fn from_afar(full: &Located, count: usize) -> Located {
    if 2 * full.points.len() > 3 * count { averages(full, count) } else { full.clone() }
}
