//! From located points to the spline with the fewest knots, in steps that each take a few passes over the points.

mod beginning;
mod evening;
mod following;
mod growing;
mod joints;
mod last_knots;
mod lone;
mod polishing;
mod resort;
mod rounding;
mod runs;
mod sliding;
mod spacing;
mod straightening;
mod sweeping;
mod view;

use self::evening::Evening;
use self::last_knots::Fewer;
use self::resort::Resort;
pub(in crate::fit) use self::resort::Resorted;
use self::sliding::Sliding;
use self::sweeping::Swept;
use self::view::View;
use super::breaks::Breaks;
use super::free_knots::{FreeKnots, Located};
use super::search::{Price, better, settle, thinner};
use super::spline::{Distances, Spline};
use super::stray::{Leash, WIDEST};
use crate::fit::outcome::FitStatus;

/// How many times the price rises at once where points are many, and how many of these go back when that was too much.
const LEAP: f64 = 16.0;
const BACK: f64 = 4.0;
/// Rounds of refinement before searches that began differently are compared.
const WARMING: usize = 8;
/// What a number of the curve costs, in units of the noise's variance.
const PER_NUMBER: f64 = 3.0;
/// The share of a number's price that makes knots slide once more.
const EASILY: f64 = 0.1;
/// More points than this are searched in a hurry.
const FEW: usize = 2000;
/// With a knot for fewer points than this a line is rough.
const ROUGH: usize = 250;
/// How many numbers' worth a fit whose points were free must be ahead of the others: free points round small corners.
const AHEAD: f64 = 20.0;
/// Rounds after which growing, thinning and refining have gone on long enough.
const MOST_ROUNDS: usize = 400;
/// The same in work: a round tries about thirty fits, each a pass over the points and some hundred operations a knot.
const MOST_WORK: f64 = 1e8;
/// A tolerance below this, in units of the drawing, is met by nearly as many numbers as the points have: few of them
/// can be spared, and one in so many of those operations looks for them; as for those that are more than the points,
/// which only points in no order ask for.
const FINE: f64 = 1e-7;
const HURRY: f64 = 5.0;

/// What the curve is to keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fit) enum Aim {
    /// The points are noisy by this standard deviation in each coordinate.
    Noise(f64),
    /// No point may be farther away than this.
    Tolerance(f64),
    /// The weighted sum of squares, at the points' parameters, may not be larger than this.
    Squares(f64),
}

/// Which splines are searched.
#[derive(Clone, Copy, Debug)]
pub(in crate::fit) struct Plan {
    pub(in crate::fit) degree: usize,
    /// How often a knot may count.
    pub(in crate::fit) sharpest: usize,
    /// How often a knot counts at least.
    pub(in crate::fit) smoothest: usize,
    pub(in crate::fit) closed: bool,
    /// By how much a corner turns at least.
    pub(in crate::fit) least_turn: f64,
    /// The parameter runs from 0 to here.
    pub(in crate::fit) end: f64,
    /// Whether points follow one another evenly.
    pub(in crate::fit) spaced: bool,
    /// Whether they are free to slide while knots go.
    pub(in crate::fit) free: bool,
    /// Whether their parameters were given: the curve is to keep about to these.
    pub(in crate::fit) timed: bool,
    /// Whether knots that a tolerance can do without are taken away one after the other.
    pub(in crate::fit) sweeps: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Grow,
    Thin,
    Lighten,
    Refine,
    Polish,
    Sweep,
    Last(usize),
    RoundOff,
    Straighten,
    Done,
}

/// A spline that was found, with the parameters of the points' feet and their distances.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Found {
    pub(in crate::fit) spline: Spline,
    pub(in crate::fit) located: Located,
    pub(super) distances: Distances,
    /// A piece that leaves the way of the points, if there is one.
    wild: Option<usize>,
}

impl Found {
    /// Whether it swings far from points that are noisy by so much: of points in no order hardly any lie between two
    /// knots, and nothing holds it.
    fn swings(&self, noise: f64) -> bool {
        self.wild.is_some() && self.spline.strays(&self.located, Leash::wide(&self.located, noise)).is_some()
    }

    /// Whether it swings away from these points for what it is off them.
    pub(in crate::fit) fn is_wild(&self, data: &Located) -> bool {
        self.spline.wild_piece(data, self.distances.squares).is_some()
    }
}

/// The search, to be stepped.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Sparsest {
    asked: Asked,
    view: View,
    pricing: Pricing,
    evening: Evening,
    effort: Effort,
    phase: Phase,
    /// How often a knot may count in the end.
    sharpest: usize,
    /// The fit in hand.
    fitted: FreeKnots,
    /// The best so far.
    found: Option<Found>,
    /// What was found with fewer averages, which hid something.
    coarse: Option<Found>,
    /// How many knots there were when there were enough.
    at_first: usize,
    /// Whether straight pieces were looked for.
    straightened: bool,
    resort: Resort,
    swept: Swept,
    /// Ways to do without a knot of the best, while these are tried.
    fewer: Fewer,
    /// The same with points that slide, while knots are taken away.
    sliding: Option<Sliding>,
}

/// What the curve is to be, and what is known of its points.
#[derive(Clone, Copy, Debug)]
struct Asked {
    aim: Aim,
    /// What is known of the points, whatever was asked for.
    noise: f64,
    /// Whether points follow one another evenly.
    spaced: bool,
    /// Whether their parameters were given.
    timed: bool,
    /// Whether knots that a tolerance can do without are taken away one after the other.
    sweeps: bool,
    /// By how much a corner turns at least.
    least_turn: f64,
    /// Whether there may be any.
    cornered: bool,
}

/// What numbers of the curve cost by now.
#[derive(Clone, Copy, Debug)]
struct Pricing {
    price: Price,
    /// How many times the price rises at once where points are many.
    leap: f64,
    /// How often the present price was tried again, and how many pieces there were then.
    rounds: usize,
    pieces: usize,
}

/// How long the search has gone on, and how often it has tried what it may only try so often.
#[derive(Clone, Copy, Debug, Default)]
struct Effort {
    rounds: usize,
    work: f64,
    /// The round before knots were added last.
    grown: usize,
    /// Rounds of refinement that a start of corners needs before it can be compared.
    warming: usize,
    /// How often a fit that broke the tolerance, or had needless knots, was mended.
    repairs: usize,
    /// How often a wild piece was taken out.
    tamings: usize,
    /// How often corners that turn too little were made smooth.
    roundings: usize,
    /// How often numbers may still become cheaper, as long as only what was begun with keeps the tolerance.
    cheapenings: usize,
}

impl Effort {
    fn is_tired(&self) -> bool {
        self.rounds > MOST_ROUNDS || self.work > MOST_WORK
    }
}

impl Aim {
    /// Whether so small a tolerance is asked for that it takes nearly all the numbers that the points have.
    pub(in crate::fit) fn is_fine(self) -> bool {
        matches!(self, Self::Tolerance(tolerance) if tolerance < FINE)
    }
}

impl Sparsest {
    /// Whether needless knots are gone, and needless corners round, so that searches can be compared.
    pub(in crate::fit) fn is_thinned(&self) -> bool {
        match self.phase {
            Phase::Grow | Phase::Thin | Phase::Lighten => false,
            Phase::Refine => self.effort.warming == 0 && !self.evening.is_ahead(),
            Phase::Polish => !self.evening.is_ahead(),
            _ => true,
        }
    }

    /// Sum of squares and prices, on all points: averages hide what they average.
    pub(in crate::fit) fn cost(&self) -> f64 {
        if matches!(self.asked.aim, Aim::Noise(_)) && !self.asked.spaced {
            return self.cost_at_feet();
        }
        let more = if self.evening.even { AHEAD * self.pricing.price.0 } else { 0.0 };
        if !self.view.is_averaged() {
            return self.pricing.price.rank(&self.fitted) + more;
        }
        self.pricing.price.rank(&FreeKnots::new(self.fitted.breaks().clone(), &self.view.full)) + more
    }

    /// Whether the best curve leaves the way of the points, how many pieces it has, and how far it is from the points.
    pub(in crate::fit) fn merit(&self) -> (bool, usize, f64) {
        let Some(found) = &self.found else { return (true, usize::MAX, f64::INFINITY) };
        let far = match self.asked.aim {
            Aim::Squares(_) => found.distances.squares,
            _ => found.distances.largest,
        };
        (found.wild.is_some(), found.spline.space.breaks.pieces(), far)
    }

    /// With how many knots the search began, after it had enough of them.
    pub(in crate::fit) fn knots_at_first(&self) -> usize {
        self.at_first
    }

    /// How the search ended.
    pub(in crate::fit) fn status(&self) -> FitStatus {
        let reached = match (self.asked.aim, &self.found) {
            (Aim::Tolerance(tolerance), Some(found)) => found.distances.largest <= tolerance,
            (Aim::Squares(target), Some(found)) => found.distances.squares <= target,
            (Aim::Tolerance(_) | Aim::Squares(_), None) => false,
            (Aim::Noise(_), _) => !self.effort.is_tired(),
        };
        if reached { FitStatus::Converged } else { FitStatus::Stalled }
    }

    /// The tolerance that was asked for, where the best curve so far does not keep it; that of the noise, where it
    /// swings far from the points.
    pub(in crate::fit) fn missed(&self) -> Option<f64> {
        match self.asked.aim {
            Aim::Tolerance(tolerance) if self.status() != FitStatus::Converged => Some(tolerance),
            Aim::Noise(noise)
                if noise > 0.0 && self.found.as_ref().is_some_and(|found| found.swings(noise)) =>
            {
                Some(WIDEST * noise)
            }
            _ => None,
        }
    }

    /// Whether averages of so many points may hide what a tolerance is broken by.
    fn is_rough(&self, found: &Found) -> bool {
        ROUGH * found.spline.space.breaks.pieces() > self.view.full.points.len()
    }

    /// Whether no other search of so many points is worth its time: this one kept a tolerance with few knots.
    pub(in crate::fit) fn suffices(&self) -> bool {
        let sparse = self.found.as_ref().is_some_and(|found| !self.is_rough(found));
        self.view.full.points.len() > FEW && sparse && self.missed().is_none()
    }

    /// What the curve is to keep to.
    pub(in crate::fit) fn aim(&self) -> Aim {
        self.asked.aim
    }

    /// Whether the best curve so far has corners and might have none.
    pub(in crate::fit) fn has_corners(&self) -> bool {
        self.found.as_ref().is_some_and(|found| {
            let breaks = &found.spline.space.breaks;
            breaks.degree > 1 && breaks.multiplicity.contains(&breaks.degree)
        })
    }

    /// By how much a corner turns at least.
    pub(in crate::fit) fn least_turn(&self) -> f64 {
        self.asked.least_turn
    }

    /// Whether the search has ended.
    pub(in crate::fit) fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    /// The best spline so far, where one was kept.
    pub(in crate::fit) fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// The best spline so far.
    #[inline(never)]
    pub(in crate::fit) fn finish(mut self) -> Found {
        match self.found.take() {
            Some(found) => found,
            None => self.polished(2),
        }
    }

    /// How much work so many fits are.
    fn work_of(&self, fits: f64, breaks: &Breaks) -> f64 {
        let one = self.view.seen.points.len() as f64 + 40.0 * breaks.coefficients() as f64;
        let hurried = self.asked.aim.is_fine() || breaks.len() > self.view.full.points.len();
        fits * one * if hurried { HURRY } else { 1.0 }
    }

    /// Knots that are not worth their price gone, or the end of that: the others slide to where they belong.
    fn thin(&mut self) -> Phase {
        let price = self.pricing.price;
        if let Some(fitted) = thinner(&self.fitted, &self.view.seen, price) {
            self.fitted = fitted;
            return Phase::Thin;
        }
        let smooth = self.fitted.breaks().sharpest < self.sharpest;
        let most = if smooth { 4 } else { 6 };
        self.fitted = settle(self.fitted.clone(), &self.view.seen, EASILY * price.0, most);
        if smooth { Phase::Lighten } else { Phase::Refine }
    }

    /// A cheaper fit at the present price, or the end of that.
    fn refine(&mut self) -> Phase {
        let near_first = matches!(self.asked.aim, Aim::Tolerance(_));
        let Some(fitted) = better(&self.fitted, &self.view.seen, self.pricing.price, near_first) else {
            return Phase::Polish;
        };
        self.fitted = fitted;
        self.effort.warming = self.effort.warming.saturating_sub(1);
        Phase::Refine
    }

    /// One round of the search.
    #[inline(never)]
    pub(in crate::fit) fn step(&mut self) {
        // A sweep has rounds and work of its own.
        self.effort.rounds += usize::from(self.phase != Phase::Sweep);
        let fits = match self.phase {
            Phase::Refine | Phase::Last(_) => 30.0,
            Phase::Sweep => 0.0,
            _ => 2.0,
        };
        let breaks = match (&self.phase, &self.found) {
            (Phase::Last(_), Some(found)) if self.asked.aim.is_fine() => &found.spline.space.breaks,
            _ => self.fitted.breaks(),
        };
        self.effort.work += self.work_of(fits, breaks);
        let (tired, was) = (self.effort.is_tired(), self.phase);
        self.phase = match was {
            Phase::Grow if !tired => self.grow(),
            Phase::Thin if !tired => self.thin(),
            Phase::Refine if !tired => self.refine(),
            Phase::Lighten if !tired => self.lighten(),
            Phase::Polish => self.polish(),
            Phase::Sweep => self.sweep(),
            Phase::Last(next) if !tired => self.last(next),
            Phase::RoundOff => self.round_off(),
            Phase::Straighten => self.straighten(),
            Phase::Last(_) | Phase::Done => Phase::Done,
            Phase::Grow | Phase::Thin | Phase::Lighten | Phase::Refine => Phase::Polish,
        };
        if matches!(self.phase, Phase::Last(0) | Phase::Done) && self.may_sweep() {
            self.phase = Phase::Sweep;
        }
        if self.phase == Phase::Done && !self.straightened {
            let rounded = was == Phase::RoundOff || self.asked.least_turn <= 0.0;
            self.phase = if rounded { Phase::Straighten } else { Phase::RoundOff };
        }
        if was == Phase::Straighten && self.may_slide() {
            self.phase = Phase::Last(0);
        }
    }
}
