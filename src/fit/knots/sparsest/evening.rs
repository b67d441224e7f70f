//! Points that are free to slide while knots are taken away, and where they belong afterwards: of points that follow
//! one another evenly that is known along the curve, too, not only across it.

use super::view::from_afar;
use super::{AHEAD, EASILY, Found, PER_NUMBER, Phase, Sparsest, WARMING};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::even::by_length;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::{apart, cheapest, clusters, least, settle};
use crate::fit::knots::spline::Spline;
use crate::fit::report::weight;

/// Steps towards a curve whose points are free to slide, before knots are taken from it.
const ROUNDS: usize = 2;
/// Steps before the points are placed again.
const EASED: usize = 4;
/// Steps of a trial, and how many times what one brings may be missing afterwards.
const MOST_STEPS: usize = 5;
const PACE: f64 = 2.0;
/// A trial is given up at once whose squares are missing, for every knot less, so many times what they were with it.
const HOPELESS: f64 = 20.0;
/// The cheapest knots that are tried one by one.
const SINGLES: usize = 4;
/// How many numbers' worth points that were free all the time must be ahead of those of a search that began with
/// corners.
const FAR_AHEAD: f64 = 45.0;

/// A spline whose points are free to slide along it: only their distances count.
#[derive(Clone, Debug)]
struct Free {
    spline: Spline,
    feet: Located,
    squares: f64,
}

impl Free {
    /// So many steps to smaller distances.
    fn ease(&mut self, steps: usize) {
        for _ in 0..steps {
            self.spline.tighten(&self.feet);
            self.squares = self.spline.project(&mut self.feet, 2).squares;
        }
    }
}

/// Where the search is with points that are free while knots are taken away.
#[derive(Clone, Debug, Default)]
pub(super) struct Evening {
    /// Whether that is to come, or is over and where they belong is known.
    pub(super) even: bool,
    /// The fit while knots are taken from it and points are free to slide.
    free: Option<Free>,
    /// Whether that is over.
    placed: bool,
    /// Whether points were at their feet from then on.
    loose: bool,
}

impl Evening {
    /// Whether knots are still to be taken away while points slide.
    pub(super) fn is_ahead(&self) -> bool {
        self.even && !self.placed
    }
}

impl Sparsest {
    /// Ends the search, after a look at it with points that are free to slide.
    pub(super) fn evened(&mut self) -> Phase {
        if !self.evening.placed && !self.effort.is_tired() {
            return Phase::Lighten;
        }
        let spline = Spline::of(&FreeKnots::new(self.fitted.breaks().clone(), &self.view.full));
        let wild = spline.strays(&self.view.seen, self.leash());
        let mut located = self.view.full.clone();
        let distances = spline.project(&mut located, 3);
        located.parameters.clone_from(&self.view.full.parameters);
        self.concluded(Found { spline, located, distances, wild })
    }

    /// Takes knots away from a fit whose points are free to slide along it, many at a time, and one by one at last. The
    /// parameters that points have by their numbers, or by length, ask for knots where the speed of the sparsest curve
    /// changes: with free points there is nothing to ask for.
    pub(super) fn lighten(&mut self) -> Phase {
        let free = match self.evening.free.take() {
            Some(free) => free,
            None => freed(&self.fitted, self.view.seen.clone()),
        };
        let fitted = FreeKnots::new(free.spline.space.breaks.clone(), &free.feet);
        let now = free.squares + self.pricing.price.whole(fitted.breaks());
        for breaks in self.fewer(&fitted) {
            let trial = FreeKnots::new(breaks, &free.feet);
            let enough = now - self.pricing.price.whole(trial.breaks());
            let gone = fitted.breaks().len() - trial.breaks().len();
            if trial.squares - enough > HOPELESS * gone as f64 * free.squares {
                continue;
            }
            let trial = settle(trial, &free.feet, EASILY * self.pricing.price.0, 2);
            if let Some(lighter) = freed_to(&trial, free.feet.clone(), enough) {
                self.evening.free = Some(lighter);
                return Phase::Lighten;
            }
        }
        self.place(free);
        Phase::Refine
    }

    /// Knots to try, the boldest first: many gone, few gone, one gone, some joined to a corner.
    fn fewer(&self, fitted: &FreeKnots) -> Vec<Breaks> {
        let breaks = fitted.breaks();
        let cheapest = cheapest(&fitted.removals());
        let room = breaks.len().saturating_sub(least(breaks));
        let mut doomed = Vec::new();
        for share in [4, 8] {
            let most = (breaks.len() / share).min(room);
            if most > 1 {
                doomed.push(apart(&cheapest, breaks.len(), most));
            }
        }
        doomed.extend(cheapest.iter().take(SINGLES.min(room)).map(|&k| vec![k]));
        let mut trials: Vec<Breaks> = doomed.iter().map(|knots| breaks.without(knots)).collect();
        trials.extend(clusters(&self.sharpening(breaks), self.view.full.points.len()));
        trials
    }

    /// The same knots, which may become as sharp as was planned.
    pub(super) fn sharpening(&self, breaks: &Breaks) -> Breaks {
        Breaks { sharpest: self.sharpest, ..breaks.clone() }
    }

    /// Gives the points of a fit parameters again: where they are even, evenly along the curve or by their numbers,
    /// whichever explains them better; else their feet, where that costs less. Where neither does, the search goes on
    /// as one among knots at the parameters that points came with.
    fn place(&mut self, mut free: Free) {
        self.evening.placed = true;
        free.ease(EASED);
        if self.asked.spaced && self.place_evenly(&free) {
            return;
        }
        (self.evening.even, self.effort.warming) = (false, WARMING);
        self.evening.loose = !self.asked.spaced && self.is_better_free(&free);
        if self.evening.loose {
            self.view.seen = free.feet;
            let fitted = FreeKnots::new(self.sharpening(&free.spline.space.breaks), &self.view.seen);
            self.fitted = settle(fitted, &self.view.seen, EASILY * self.pricing.price.0, 2);
        } else {
            self.fitted = FreeKnots::new(self.sharpening(self.fitted.breaks()), &self.view.seen);
        }
    }

    /// Whether points cost less with their feet for parameters: what noise leaves along the curve is not seen then, and
    /// small corners may be lost.
    fn is_better_free(&self, free: &Free) -> bool {
        let price = self.pricing.price;
        let along = price.0 / PER_NUMBER * weight(&self.view.full);
        let cost = free.squares + price.whole(&free.spline.space.breaks) + along + AHEAD * price.0;
        cost < price.total(&self.fitted) && free.spline.strays(&free.feet, self.leash()).is_none()
    }

    /// The same for points that are even; answers whether they are found to be.
    fn place_evenly(&mut self, free: &Free) -> bool {
        let worth = EASILY * self.pricing.price.0;
        let breaks = self.sharpening(&free.spline.space.breaks);
        let numbered = settle(FreeKnots::new(breaks.clone(), &self.view.seen), &self.view.seen, worth, 2);
        let mut best = (self.view.full.clone(), self.view.seen.clone(), numbered);
        let mut full = self.view.full.clone();
        free.spline.project(&mut full, 6);
        if free.spline.strays(&free.feet, self.leash()).is_none()
            && let Some((parameters, breaks)) = by_length(&free.spline, &full)
        {
            let full = Located { parameters, ..self.view.full.clone() };
            let seen = from_afar(&full, self.view.averages);
            let fitted = settle(FreeKnots::new(self.sharpening(&breaks), &seen), &seen, worth, 2);
            if fitted.squares < best.2.squares {
                best = (full, seen, fitted);
            }
        }
        let are_even = self.pricing.price.total(&best.2) < self.pricing.price.total(&self.fitted);
        if are_even {
            (self.view.full, self.view.seen, self.fitted) = best;
        }
        are_even
    }

    /// What a search among uneven points costs: their parameters are as good as the curve that they were found by, so
    /// that only distances can be compared. Points that were free all the time are to be ahead for it.
    pub(super) fn cost_at_feet(&self) -> f64 {
        let mut feet = if self.view.is_averaged() {
            self.view.following(self.fitted.breaks())
        } else {
            self.view.seen.clone()
        };
        let price = self.pricing.price;
        let mut spline = Spline::of(&self.fitted);
        for _ in 0..ROUNDS {
            spline.project(&mut feet, 2);
            spline.tighten(&feet);
        }
        let squares = spline.project(&mut feet, 3).squares;
        let more = if self.evening.loose { FAR_AHEAD * price.0 } else { 0.0 };
        squares + price.rank(&self.fitted) - self.fitted.squares + more
    }
}

/// The fit after some steps with its points free to slide.
fn freed(fitted: &FreeKnots, mut feet: Located) -> Free {
    let spline = Spline::of(fitted);
    let squares = spline.project(&mut feet, 2).squares;
    let mut free = Free { spline, feet, squares };
    free.ease(ROUNDS);
    free
}

/// The same until the squares are below `enough`; `None` where they will not be.
fn freed_to(fitted: &FreeKnots, mut feet: Located, enough: f64) -> Option<Free> {
    let mut spline = Spline::of(fitted);
    let mut squares = spline.project(&mut feet, 2).squares;
    for step in 0..MOST_STEPS {
        let before = squares;
        spline.tighten(&feet);
        squares = spline.project(&mut feet, 2).squares;
        if squares < enough {
            return Some(Free { spline, feet, squares });
        }
        if step > 0 && PACE * (before - squares) < squares - enough {
            break;
        }
    }
    None
}
