//! A fit whose points' parameters are free, and what follows from how near it comes.

use super::{Aim, BACK, FEW, Found, LEAP, Phase, Sparsest};
use crate::fit::knots::adding;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::FreeKnots;
use crate::fit::knots::search::{better, least};
use crate::fit::knots::spline::{Distances, Spline};
use crate::fit::knots::stray::{Leash, WIDEST};
use crate::fit::report::weight;

/// How often pieces that swing away from the points are taken out.
const MOST_TAMINGS: usize = 20;

/// How many times the variance of the noise points may be away from a curve, in the mean of squares, for nothing to be
/// hidden.
const EXPLAINED: f64 = 1.3;

impl Sparsest {
    /// The fit with the points' parameters free, on the averages first and then on all points.
    pub(super) fn polished(&mut self, rounds: usize) -> Found {
        let mut spline = Spline::of(&self.fitted);
        let mut seen = self.view.seen.clone();
        for _ in 0..rounds {
            spline.project(&mut seen, 2);
            spline.tighten(&seen);
        }
        // Free parameters let a curve with many knots wander between the points.
        let mut wild = None;
        if spline.pulled_back(&mut seen, self.leash()).is_none() {
            spline = Spline::of(&self.fitted);
            // A piece between sharp knots may have too few points to be held by, and swings as it likes.
            wild = spline.strays(&self.view.seen, Leash { slack: self.slack(), share: 1.0 });
        } else {
            self.view.seen = seen;
        }
        let mut located = if self.view.is_averaged() {
            self.view.following(self.fitted.breaks())
        } else {
            self.view.seen.clone()
        };
        let mut distances = spline.project_beyond(&mut located, 3, self.near());
        if wild.is_some() {
            distances.largest = f64::INFINITY;
        }
        Found { spline, located, distances, wild }
    }

    pub(super) fn polish(&mut self) -> Phase {
        if let Aim::Squares(target) = self.asked.aim {
            return self.weigh(target);
        }
        if self.evening.even {
            return self.evened();
        }
        let found = self.polished(4);
        self.concluded(found)
    }

    /// What follows from a fit.
    pub(super) fn concluded(&mut self, found: Found) -> Phase {
        let breaks = found.spline.space.breaks.clone();
        if let Some(piece) = found.wild
            && self.effort.tamings < MOST_TAMINGS
            && breaks.len() > least(&breaks)
        {
            self.effort.tamings += 1;
            self.view.seen = self.view.unmoved();
            self.fitted = FreeKnots::new(without_piece(breaks, piece), &self.view.seen);
            // At the price of a number that a tolerance begins with, refining would undo what was repaired.
            return if matches!(self.asked.aim, Aim::Tolerance(_)) { Phase::Polish } else { Phase::Refine };
        }
        match self.asked.aim {
            Aim::Noise(noise) => self.settled(found, noise),
            Aim::Tolerance(tolerance) => self.judge(found, tolerance),
            Aim::Squares(_) => Phase::Done,
        }
    }

    /// What follows from a fit to points that are noisy by so much.
    fn settled(&mut self, found: Found, noise: f64) -> Phase {
        let breaks = found.spline.space.breaks.clone();
        if self.view.is_averaged()
            && !self.effort.is_tired()
            && found.distances.squares > self.explained(noise)
        {
            self.keep_cheaper(found);
            self.coarse = self.found.take();
            return self.look_closer(Breaks { sharpest: self.sharpest, ..breaks });
        }
        self.effort.repairs += 1;
        let mut trial = None;
        // With the parameters at the feet some knots have become needless.
        if !self.evening.even && self.effort.repairs <= 3 && !self.effort.is_tired() {
            self.fitted = FreeKnots::new(breaks, &self.view.seen);
            trial = better(&self.fitted, &self.view.seen, self.pricing.price, false);
        }
        match trial {
            Some(trial) => {
                self.found = Some(found);
                self.fitted = trial;
                Phase::Refine
            }
            None => {
                self.keep_cheaper(found);
                Phase::Done
            }
        }
    }

    /// More than this noise does not leave of all points. A curve that averages show is as near to each of them as to
    /// their mean; what they hide is a shape between them (D 13.11).
    fn explained(&self, noise: f64) -> f64 {
        EXPLAINED * noise * noise * weight(&self.view.full)
    }

    /// Keeps a fit, or what was found from farther away where that is cheaper.
    #[inline(never)]
    fn keep_cheaper(&mut self, found: Found) {
        let cost =
            |found: &Found| found.distances.squares + self.pricing.price.whole(&found.spline.space.breaks);
        self.found = match self.coarse.take() {
            Some(coarse) if cost(&coarse) < cost(&found) => Some(coarse),
            _ => Some(found),
        };
    }

    /// Keeps the fit in hand, of which the sum of squares is all that is known.
    pub(super) fn keep_by_squares(&mut self, wild: Option<usize>) {
        self.found = Some(Found {
            spline: Spline::of(&self.fitted),
            located: self.view.full.clone(),
            distances: Distances { largest: f64::INFINITY, squares: self.fitted.squares },
            wild,
        });
    }

    /// Goes on with a higher price while the sum of squares is small enough.
    pub(super) fn weigh(&mut self, target: f64) -> Phase {
        let found = self.found.as_ref().map_or(f64::INFINITY, |found| found.distances.squares);
        let (kept, small) = (found <= target, self.fitted.squares <= target);
        let wild = Spline::of(&self.fitted).wild_piece(&self.view.full, self.fitted.squares);
        if small && wild.is_none() || !kept && self.fitted.squares < found {
            self.keep_by_squares(wild);
        }
        let breaks = self.fitted.breaks();
        if let Some(piece) = wild.filter(|_| small && breaks.len() > least(breaks))
            && self.effort.tamings < MOST_TAMINGS
        {
            self.effort.tamings += 1;
            self.fitted = FreeKnots::new(without_piece(breaks.clone(), piece), &self.view.seen);
            return Phase::Polish;
        }
        if small && breaks.len() > least(breaks) && !self.effort.is_tired() {
            self.pricing.price.0 *= 1.6;
            return Phase::Thin;
        }
        if kept { Phase::Last(0) } else { Phase::Done }
    }

    /// Goes on with a higher price while the tolerance is kept; repairs a first fit that breaks it.
    pub(super) fn judge(&mut self, found: Found, tolerance: f64) -> Phase {
        if found.distances.largest <= tolerance {
            return self.kept(found, tolerance);
        }
        if self.found.as_ref().is_some_and(|best| best.distances.largest <= tolerance) {
            return self.too_dear();
        }
        self.repaired(found, tolerance)
    }

    /// What follows from a fit that keeps the tolerance: a higher price, or the same once more.
    fn kept(&mut self, found: Found, tolerance: f64) -> Phase {
        let breaks = found.spline.space.breaks.clone();
        let fewer = self.found.as_ref().is_none_or(|best| {
            best.distances.largest > tolerance || breaks.pieces() <= best.spline.space.breaks.pieces()
        });
        if fewer {
            self.found = Some(found);
        }
        self.effort.cheapenings = 0;
        if self.effort.is_tired() || breaks.len() <= least(&breaks) {
            return Phase::Done;
        }
        let (few, pricing) = (self.view.full.points.len() <= FEW, &mut self.pricing);
        // At the feet the same price may buy a curve with fewer knots.
        let again = few && pricing.rounds < 3 && breaks.pieces() < pricing.pieces;
        (pricing.rounds, pricing.pieces) =
            if again { (pricing.rounds + 1, breaks.pieces()) } else { (0, usize::MAX) };
        if !again {
            pricing.price.0 *= if few { 2.5 } else { pricing.leap };
        }
        self.fitted = FreeKnots::new(breaks, &self.view.seen);
        Phase::Thin
    }

    /// What follows from a fit that breaks the tolerance when another one kept it: the last knots, or the same price
    /// with more averages, or a lower one.
    fn too_dear(&mut self) -> Phase {
        if let Some(phase) = self.thinned_less() {
            return phase;
        }
        let Some(best) = &self.found else { return Phase::Done };
        // What is too far away hides between averages, where a line is rough.
        if self.view.is_averaged()
            && self.pricing.leap == LEAP
            && self.is_rough(best)
            && !self.effort.is_tired()
        {
            self.look_closer(best.spline.space.breaks.clone());
            return Phase::Thin;
        }
        if self.view.full.points.len() <= FEW || self.pricing.leap < LEAP || self.effort.is_tired() {
            return Phase::Last(0);
        }
        // The price rose too fast: from the best curve on, it rises again, more slowly.
        self.pricing.price.0 /= BACK;
        self.pricing.leap = LEAP / BACK;
        self.fitted = FreeKnots::new(best.spline.space.breaks.clone(), &self.view.seen);
        Phase::Thin
    }

    /// What follows from a first fit that breaks the tolerance: knots where it does.
    fn repaired(&mut self, found: Found, tolerance: f64) -> Phase {
        self.effort.repairs += 1;
        let repaired = adding::closer(&found.spline, &self.view.seen, 0.8 * tolerance);
        let nearest = self.found.as_ref().is_none_or(|best| found.distances.largest < best.distances.largest);
        if nearest {
            self.found = Some(found);
        }
        match repaired {
            Some(breaks) if self.effort.repairs < 40 && !self.effort.is_tired() => {
                self.fitted = FreeKnots::new(breaks, &self.view.seen);
                Phase::Polish
            }
            // What is too far away hides between averages.
            None if self.view.is_averaged() && !self.effort.is_tired() => match &self.found {
                Some(found) => self.look_closer(found.spline.space.breaks.clone()),
                None => Phase::Done,
            },
            _ => Phase::Done,
        }
    }

    /// Of points that are no farther no more needs to be known before the search ends: many of them are only asked
    /// whether they keep the tolerance.
    pub(super) fn near(&self) -> f64 {
        match self.asked.aim {
            Aim::Tolerance(tolerance) if self.view.is_averaged() => tolerance,
            _ => 0.0,
        }
    }

    /// How far from the way of the points their curve may be. (D 13.16)
    pub(super) fn leash(&self) -> Leash {
        Leash { slack: self.slack(), share: 0.5 }
    }

    /// How far from the points their curve may be.
    pub(super) fn slack(&self) -> f64 {
        match self.asked.aim {
            Aim::Noise(noise) => WIDEST * noise,
            Aim::Tolerance(tolerance) => tolerance,
            Aim::Squares(_) => f64::INFINITY,
        }
    }
}

/// One of the knots at the ends of a piece less: the one that counts less.
fn without_piece(mut breaks: Breaks, piece: usize) -> Breaks {
    let count = breaks.len();
    let (before, after) = if breaks.closed {
        (piece % count, (piece + 1) % count)
    } else {
        (piece.saturating_sub(1), piece.min(count - 1))
    };
    let lesser = if breaks.multiplicity[before] < breaks.multiplicity[after] { before } else { after };
    breaks.remove(lesser);
    breaks
}
