//! Pieces that are straight as far as the points can tell become straight.

use super::{Aim, EASILY, Found, MOST_WORK, PER_NUMBER, Phase, Sparsest};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::even::by_length;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::{least, settle};
use crate::fit::knots::spline::Spline;
use crate::fit::knots::straight::bends;

/// How many pieces are tried alone where all together are too many.
const MOST_ALONE: usize = 12;
/// The share of a tolerance's square that a number is worth at least.
const SHARE: f64 = 0.01;
/// A piece that would cost so many times what its numbers are worth, knots where they are, is not tried alone: knots
/// that slide seldom make up for more.
const HOPELESS: f64 = 1.5;
/// The share of a search's work that joining straight pieces may take, and how many fits a trial is worth.
const JOINING: f64 = 0.5;
const TRIAL: f64 = 7.0;
/// The most slides to a fit with other straight pieces.
const FEW_SLIDES: usize = 3;
/// The most where these pieces are known, and the share of a number's price that makes another one there.
const MOST_SLIDES: usize = 12;
const HARDLY: f64 = 1e-3;
/// Points that are so many times farther from where they belong by length than noise says are not even.
const UNEVEN: f64 = 1.6;

impl Sparsest {
    /// Makes pieces of the best curve straight for as long as their distances from the points grow by no more than
    /// noise explains, and what was asked for is kept (D 13.10).
    pub(super) fn straighten(&mut self) -> Phase {
        self.straightened = true;
        let Some(mut best) = self.found.take() else { return Phase::Done };
        if self.near() > 0.0 {
            best.distances = best.spline.project(&mut best.located, 3);
        }
        let degree = best.spline.space.breaks.degree;
        if degree < 2 || best.wild.is_some() {
            self.found = Some(best);
            return Phase::Done;
        }
        let squares = best.distances.squares;
        if matches!(self.asked.aim, Aim::Squares(_)) {
            let mut feet = best.located.parameters.clone();
            best.distances = best.spline.feet(&best.located, &mut feet, 3);
        }
        best = self.followed(best);
        let spaced = self.asked.spaced && matches!(self.asked.aim, Aim::Noise(_));
        let mut found =
            if spaced { self.straightened_by_length(best) } else { self.straightened(best, HOPELESS) };
        if matches!(self.asked.aim, Aim::Squares(_)) {
            // What was asked for is about the parameters, not about feet.
            let straight = !found.spline.space.breaks.straight.is_empty();
            found.distances.squares = if straight { found.spline.squares(&found.located) } else { squares };
        }
        self.found = Some(found);
        Phase::Done
    }

    /// The curve of points that follow one another evenly with pieces straight that may be, and its points placed by
    /// length.
    fn straightened_by_length(&mut self, mut best: Found) -> Found {
        let has_lines = |found: &Found| !found.spline.space.breaks.straight.is_empty();
        let mut may_have = true;
        if self.evening.even {
            let free = self.freely_straightened(&best);
            may_have = has_lines(&free);
            if may_have && let Some(found) = self.spaced_out(&free) {
                return found;
            }
        }
        if may_have {
            best = self.straightened(best, HOPELESS);
        }
        if has_lines(&best) {
            best = self.placed_by_length(best);
        }
        match self.spaced_out(&best) {
            Some(found) => found,
            // Where points are is not known by lengths: they may as well slide.
            None if !self.evening.even => self.jointed(best),
            None => best,
        }
    }

    /// The curve of points that are held with pieces straight that are so once points may slide: by the parameters that
    /// points are held at even a straight side has a speed that changes.
    fn freely_straightened(&mut self, best: &Found) -> Found {
        let mut free = best.clone();
        free.distances = free.spline.project(&mut free.located, 3);
        self.evening.even = false;
        free = self.straightened(free, f64::INFINITY);
        self.evening.even = true;
        free
    }

    /// The curve with the pieces straight that may be, all together or one after the other; not tried alone are those
    /// that would cost so many times what their numbers are worth where they are.
    fn straightened(&self, mut best: Found, hopeless: f64) -> Found {
        let worth = self.number() * 2.0 * (best.spline.space.breaks.degree - 1) as f64;
        let order = bends(&best.spline, &best.located, worth);
        if let Some(found) = self.with_straight(&best, &order, worth) {
            best = found;
        } else if order.len() > 1 {
            let costs = FreeKnots::new(best.spline.space.breaks.clone(), &best.located).straightenings();
            let hopeful = order.iter().filter(|&&piece| costs[piece] <= hopeless * worth);
            for &piece in hopeful.take(MOST_ALONE) {
                best = self.with_straight(&best, &[piece], worth).unwrap_or(best);
            }
        }
        let none = best.spline.space.breaks.straight.is_empty();
        if none { best } else { self.with_fewer(best, self.number()) }
    }

    /// What a number of the curve is worth in squares of distances.
    fn number(&self) -> f64 {
        match self.asked.aim {
            Aim::Noise(noise) => PER_NUMBER * noise * noise,
            Aim::Squares(_) => PER_NUMBER * self.asked.noise * self.asked.noise,
            Aim::Tolerance(tolerance) => {
                (PER_NUMBER * self.asked.noise * self.asked.noise).max(SHARE * tolerance * tolerance)
            }
        }
    }

    /// The same with its points equally far apart along it, where they are: between straight sides that tells where
    /// corners are.
    fn placed_by_length(&self, best: Found) -> Found {
        let breaks = &best.spline.space.breaks;
        let placed = if self.evening.even {
            Some((best.located.parameters.clone(), breaks.clone()))
        } else {
            by_length(&best.spline, &best.located)
        };
        let Some((parameters, breaks)) = placed else { return best };
        let located = Located { parameters, ..best.located.clone() };
        let worth = HARDLY * self.pricing.price.0;
        let fitted = settle(FreeKnots::new(breaks, &located), &located, worth, MOST_SLIDES);
        // Both coordinates of all points.
        let noise = 2.0 * self.pricing.price.0 / PER_NUMBER * located.points.len() as f64;
        if fitted.squares > UNEVEN * noise {
            return best;
        }
        let mut spline = Spline::of(&fitted);
        spline.straighten();
        let mut feet = located.parameters.clone();
        let distances = spline.feet(&located, &mut feet, 3);
        // Another fit to the same noise is about as near, to what its numbers are worth; points that are not even after
        // all are not.
        let farther =
            distances.squares - best.distances.squares > self.pricing.price.whole(&spline.space.breaks);
        let stray = farther || self.is_spoiled(&spline, &located);
        if stray { best } else { Found { spline, located, distances, wild: None } }
    }

    /// Whether a curve leaves the way of its points, or has a corner that is too slight.
    #[inline(never)]
    pub(super) fn is_spoiled(&self, spline: &Spline, located: &Located) -> bool {
        spline.strays(located, self.leash()).is_some() || !self.slight_corners(spline).is_empty()
    }

    /// The fit with these pieces straight as well, if it still keeps what was asked for.
    fn with_straight(&self, best: &Found, pieces: &[usize], worth: f64) -> Option<Found> {
        if pieces.is_empty() {
            return None;
        }
        let mut breaks = best.spline.space.breaks.clone();
        breaks.straight.resize(best.spline.space.spans.len(), false);
        pieces.iter().for_each(|&s| breaks.straight[s] = true);
        self.on(breaks, best, worth * pieces.len() as f64)
    }

    /// The fit without knots between straight pieces that noise explains as one.
    fn with_fewer(&self, mut best: Found, number: f64) -> Found {
        // A vertex of a polyline is its place along the points and on the plane.
        let worth = 3.0 * number;
        let (mut k, mut work) = (0, 0.0);
        while k < best.spline.space.breaks.len() {
            let breaks = &best.spline.space.breaks;
            let (before, after) = best.spline.space.sides(k);
            if !breaks.is_straight(before) || !breaks.is_straight(after) {
                k += 1;
                continue;
            }
            if work > JOINING * MOST_WORK {
                break;
            }
            work += self.work_of(TRIAL, breaks);
            let fewer = (breaks.len() > least(breaks)).then(|| breaks.without(&[k]));
            match fewer.and_then(|fewer| self.on(fewer, &best, worth)) {
                Some(found) => best = found,
                None => k += 1,
            }
        }
        best
    }

    /// The fit on other breaks, if its squares grow by no more than `worth` and it keeps what was asked for.
    #[inline(never)]
    fn on(&self, breaks: Breaks, best: &Found, worth: f64) -> Option<Found> {
        let mut located = best.located.clone();
        let held = self.evening.even || matches!(self.asked.aim, Aim::Squares(_));
        let mut fitted = FreeKnots::new(breaks, &located);
        if held {
            fitted = settle(fitted, &located, EASILY * self.pricing.price.0, FEW_SLIDES);
        }
        let mut spline = Spline::of(&fitted);
        for _ in 0..if held { 0 } else { FEW_SLIDES } {
            spline.project(&mut located, 2);
            spline.tighten(&located);
        }
        spline.straighten();
        let distances = spline.project(&mut located, 3);
        if held {
            located.parameters.clone_from(&best.located.parameters);
        }
        let kept = match self.asked.aim {
            Aim::Noise(_) => true,
            Aim::Tolerance(tolerance) => distances.largest <= tolerance.max(best.distances.largest),
            Aim::Squares(target) => spline.squares(&located) <= target,
        };
        let worth_it = kept && distances.squares - best.distances.squares <= worth;
        let stray = worth_it && self.is_spoiled(&spline, &located);
        (worth_it && !stray).then_some(Found { spline, located, distances, wild: None })
    }
}
