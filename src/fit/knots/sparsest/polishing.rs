//! A fit whose points' parameters are free, and what follows from how near it comes.

use super::{Aim, BACK, FEW, Found, LEAP, Phase, Sparsest};
use crate::fit::knots::bins::followed;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::foot_points::{Distances, Spline};
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::{Price, better, least};
use crate::fit::knots::start;
use crate::fit::report::weight;

/// How often pieces that swing away from the points are taken out.
const MOST_TAMINGS: usize = 20;

/// How many times the variance of the noise points may be away from a curve, in the mean of squares, for nothing to be hidden.
const EXPLAINED: f64 = 1.3;

impl Sparsest {
    /// The fit with the points' parameters free, on the averages first and then on all points.
    pub(super) fn polished(&mut self, rounds: usize) -> Found {
        let mut spline = Spline::of(&self.fitted);
        let mut seen = self.seen.clone();
        for _ in 0..rounds {
            spline.project(&mut seen, 2);
            spline.tighten(&seen);
        }
        // Free parameters let a curve with many knots wander between the points.
        let mut wild = spline.strays(&seen, self.slack());
        if wild.is_some() {
            spline = Spline::of(&self.fitted);
            // A piece between sharp knots may have too few points to be held by, and swings as it likes.
            wild = spline.strays(&self.seen, self.slack());
        } else {
            self.seen = seen;
        }
        let mut located = if self.is_averaged() { self.following() } else { self.seen.clone() };
        let mut distances = spline.project_beyond(&mut located, 3, self.near());
        if wild.is_some() {
            distances.largest = f64::INFINITY;
        }
        Found { spline, located, distances, wild }
    }

    pub(super) fn polish(&mut self) -> Phase {
        if let Aim::Squares(target) = self.aim {
            return self.weigh(target);
        }
        if self.even {
            return self.evened();
        }
        let found = self.polished(4);
        self.concluded(found)
    }

    /// What follows from a fit.
    pub(super) fn concluded(&mut self, found: Found) -> Phase {
        let breaks = found.spline.space.breaks.clone();
        if let Some(piece) = found.wild
            && self.tamings < MOST_TAMINGS
            && breaks.len() > least(&breaks)
        {
            self.tamings += 1;
            self.seen = self.seen_from_afar();
            self.fitted = FreeKnots::new(without_piece(breaks, piece), &self.seen);
            return Phase::Refine;
        }
        match self.aim {
            Aim::Noise(noise) => self.settled(found, noise),
            Aim::Tolerance(tolerance) => self.judge(found, tolerance),
            Aim::Squares(_) => Phase::Done,
        }
    }

    /// What follows from a fit to points that are noisy by so much.
    fn settled(&mut self, found: Found, noise: f64) -> Phase {
        let breaks = found.spline.space.breaks.clone();
        if self.is_averaged() && !self.is_tired() && found.distances.squares > self.explained(noise) {
            self.keep_cheaper(found);
            self.coarse = self.found.take();
            return self.look_closer(Breaks { sharpest: self.sharpest, ..breaks });
        }
        self.repairs += 1;
        let mut trial = None;
        // With the parameters at the feet some knots have become needless.
        if !self.even && self.repairs <= 3 && !self.is_tired() {
            self.fitted = FreeKnots::new(breaks, &self.seen);
            trial = better(&self.fitted, &self.seen, self.price);
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

    /// More than this noise does not leave of all points. A curve that averages show is as near to each of them as to their mean; what they hide
    /// is a shape between them (D 13.11).
    fn explained(&self, noise: f64) -> f64 {
        EXPLAINED * noise * noise * weight(&self.full)
    }

    /// Keeps a fit, or what was found from farther away where that is cheaper.
    #[inline(never)]
    fn keep_cheaper(&mut self, found: Found) {
        let cost = |found: &Found| found.distances.squares + self.price.whole(&found.spline.space.breaks);
        self.found = match self.coarse.take() {
            Some(coarse) if cost(&coarse) < cost(&found) => Some(coarse),
            _ => Some(found),
        };
    }

    /// Keeps the fit in hand, of which the sum of squares is all that is known.
    pub(super) fn keep_by_squares(&mut self) {
        self.found = Some(Found {
            spline: Spline::of(&self.fitted),
            located: self.full.clone(),
            distances: Distances { largest: f64::INFINITY, squares: self.fitted.squares },
            wild: None,
        });
    }

    /// Goes on with a higher price while the sum of squares is small enough.
    pub(super) fn weigh(&mut self, target: f64) -> Phase {
        let kept = self.found.as_ref().is_some_and(|found| found.distances.squares <= target);
        let small = self.fitted.squares <= target;
        if small || !kept {
            self.keep_by_squares();
        }
        let breaks = self.fitted.breaks();
        if small && breaks.len() > least(breaks) && !self.is_tired() {
            self.price = Price(self.price.0 * 1.6);
            return Phase::Thin;
        }
        if kept { Phase::Last(0) } else { Phase::Done }
    }

    /// Goes on with a higher price while the tolerance is kept; repairs a first fit that breaks it.
    pub(super) fn judge(&mut self, found: Found, tolerance: f64) -> Phase {
        let tired = self.is_tired();
        if found.distances.largest <= tolerance {
            let breaks = found.spline.space.breaks.clone();
            let fewer = self.found.as_ref().is_none_or(|best| {
                best.distances.largest > tolerance || breaks.pieces() <= best.spline.space.breaks.pieces()
            });
            if fewer {
                self.found = Some(found);
            }
            if tired || breaks.len() <= least(&breaks) {
                return Phase::Done;
            }
            // At the feet the same price may buy a curve with fewer knots.
            let few = self.full.points.len() <= FEW;
            let again = few && self.rounds_at_price < 3 && breaks.pieces() < self.pieces_at_price;
            (self.rounds_at_price, self.pieces_at_price) =
                if again { (self.rounds_at_price + 1, breaks.pieces()) } else { (0, usize::MAX) };
            if !again {
                self.price = Price(self.price.0 * if few { 2.5 } else { self.leap });
            }
            self.fitted = FreeKnots::new(breaks, &self.seen);
            return Phase::Thin;
        }
        if let Some(best) = self.found.as_ref().filter(|best| best.distances.largest <= tolerance) {
            if self.full.points.len() <= FEW || self.leap < LEAP || tired {
                return Phase::Last(0);
            }
            // The price rose too fast: from the best curve on, it rises again, more slowly.
            self.price = Price(self.price.0 / BACK);
            self.leap = LEAP / BACK;
            self.fitted = FreeKnots::new(best.spline.space.breaks.clone(), &self.seen);
            return Phase::Thin;
        }
        self.repairs += 1;
        let repaired = start::closer(&found.spline, &self.seen, 0.8 * tolerance);
        let nearest = self.found.as_ref().is_none_or(|best| found.distances.largest < best.distances.largest);
        if nearest {
            self.found = Some(found);
        }
        match repaired {
            Some(breaks) if self.repairs < 40 && !tired => {
                self.fitted = FreeKnots::new(breaks, &self.seen);
                Phase::Polish
            }
            _ => Phase::Done,
        }
    }

    /// All points, moved along the curve as their averages were.
    pub(super) fn following(&self) -> Located {
        let (full, breaks) = (&self.full, self.fitted.breaks());
        let parameters = [&self.seen_from_afar().parameters[..], &self.seen.parameters];
        let parameters = followed(full, self.averages, parameters, (breaks.closed, breaks.end));
        Located { parameters, points: full.points.clone(), weights: full.weights.clone() }
    }

    /// Whether averages are looked at while knots are looked for.
    pub(super) fn is_averaged(&self) -> bool {
        self.seen.points.len() < self.full.points.len()
    }

    /// Of points that are no farther no more needs to be known before the search ends: many of them are only asked
    /// whether they keep the tolerance.
    pub(super) fn near(&self) -> f64 {
        match self.aim {
            Aim::Tolerance(tolerance) if self.is_averaged() => tolerance,
            _ => 0.0,
        }
    }

    /// How far from the points their curve may be.
    pub(super) fn slack(&self) -> f64 {
        match self.aim {
            Aim::Noise(noise) => 4.0 * noise,
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
