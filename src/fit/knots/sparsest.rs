//! From located points to the spline with the fewest knots, in steps that each take a few passes over the points.

mod evening;
mod last_knots;
mod polishing;
mod rounding;
mod straight;

use self::evening::Free;
use super::bins::averages;
use super::breaks::Breaks;
use super::foot_points::{Distances, Spline};
use super::free_knots::{FreeKnots, Located};
use super::polyline;
use super::search::{Price, better, least, settle, thinner};
use super::start;
use crate::fit::outcome::FitStatus;

/// How many times the price rises at once where points are many, and how many of these go back when that was too much.
const LEAP: f64 = 16.0;
const BACK: f64 = 4.0;
/// About so many averages of points are looked at at first; half as many points more are not averaged.
const SEEN: usize = 450;
/// How many averages a knot needs, of those that the search begins with, and how many times as many are looked at where that is too few, or
/// where they hid something.
const PER_KNOT: usize = 3;
const CLOSER: usize = 4;
/// More points than this are searched in a hurry.
const FEW: usize = 2000;
/// Rounds of refinement before searches that began differently are compared.
const WARMING: usize = 8;
/// How many numbers' worth a fit whose points were free must be ahead of the others: free points round small corners.
const AHEAD: f64 = 20.0;
/// Rounds of adding knots in a row.
const MOST_GROWTH: usize = 60;
/// The most corners to begin with.
const MOST_VERTICES: usize = 600;
/// What a number of the curve costs, in units of the noise's variance.
const PER_NUMBER: f64 = 3.0;
/// Rounds after which growing, thinning and refining have gone on long enough.
const MOST_ROUNDS: usize = 400;
/// The same in work: a round tries about thirty fits, each a pass over the points and some hundred operations a knot.
const MOST_WORK: f64 = 1e8;

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
    /// Whether they do, and are free to slide while knots go.
    pub(in crate::fit) even: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Grow,
    Thin,
    Lighten,
    Refine,
    Polish,
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

/// The search, to be stepped.
#[derive(Clone, Debug)]
pub(in crate::fit) struct Sparsest {
    full: Located,
    /// The same points, or averages of them, and about how many these are.
    seen: Located,
    averages: usize,
    /// What was found with fewer averages, which hid something.
    coarse: Option<Found>,
    /// The round before knots were added last.
    grown: usize,
    aim: Aim,
    /// Whether points follow one another evenly.
    spaced: bool,
    /// Whether they do, and where they belong is known.
    even: bool,
    /// How often a knot may count in the end.
    sharpest: usize,
    price: Price,
    /// What is known of the points, whatever was asked for.
    noise: f64,
    fitted: FreeKnots,
    phase: Phase,
    rounds: usize,
    work: f64,
    /// Rounds of refinement that a start of corners needs before it can be compared.
    warming: usize,
    repairs: usize,
    /// How often a wild piece was taken out.
    tamings: usize,
    at_first: usize,
    /// How often the present price was tried again, and how many pieces there were then.
    rounds_at_price: usize,
    pieces_at_price: usize,
    /// How many times the price rises at once where points are many.
    leap: f64,
    found: Option<Found>,
    /// The fit while knots are taken from it and points are free to slide.
    free: Option<Free>,
    /// Whether that is over.
    placed: bool,
    /// By how much a corner turns at least, and how often slighter ones were made smooth.
    least_turn: f64,
    roundings: usize,
    /// Whether straight pieces were looked for.
    straightened: bool,
}

impl Sparsest {
    /// A search among the splines of a plan. `noise` is what is known of the points even where a tolerance is asked
    /// for: knots that only follow noise are then not begun with.
    pub(in crate::fit) fn new(full: Located, plan: Plan, aim: Aim, noise: f64) -> Self {
        let whole = matches!(aim, Aim::Squares(_));
        let even = plan.even;
        let seen = if whole { full.clone() } else { from_afar(&full, SEEN) };
        let price = match aim {
            Aim::Noise(noise) => PER_NUMBER * noise * noise,
            Aim::Tolerance(tolerance) => (0.05 * tolerance * tolerance).max(PER_NUMBER * noise * noise),
            Aim::Squares(target) => 1e-3 * target,
        };
        let mut breaks = start::even(plan.degree, plan.closed, plan.end, seen.points.len(), plan.smoothest);
        // Sharper knots are cheap ways to bend; smooth ones are to come first.
        breaks.sharpest = if even { plan.smoothest } else { plan.sharpest };
        let fitted = FreeKnots::new(breaks, &seen);
        let mut search = Self::begun(full, seen, fitted, (aim, price), noise);
        (search.spaced, search.even) = (plan.spaced, even);
        (search.sharpest, search.least_turn) = (plan.sharpest, plan.least_turn);
        search.warming = if matches!(aim, Aim::Noise(_)) { WARMING } else { 0 };
        search
    }

    /// A search that begins with a fit, before anything was done.
    #[inline(never)]
    fn begun(full: Located, seen: Located, fitted: FreeKnots, (aim, price): (Aim, f64), noise: f64) -> Self {
        Self {
            full,
            seen,
            averages: SEEN,
            coarse: None,
            grown: 0,
            aim,
            spaced: false,
            even: false,
            sharpest: 1,
            price: Price(price),
            noise,
            fitted,
            phase: Phase::Grow,
            rounds: 0,
            work: 0.0,
            warming: 0,
            repairs: 0,
            tamings: 0,
            at_first: 0,
            rounds_at_price: 0,
            pieces_at_price: usize::MAX,
            leap: LEAP,
            found: None,
            free: None,
            placed: false,
            least_turn: 0.0,
            roundings: 0,
            straightened: false,
        }
    }

    /// A search that begins with corners only: those of a polyline near the points, which for a tolerance is an answer
    /// already. `None` where a polyline needs more vertices than are worth it.
    pub(in crate::fit) fn from_corners(full: Located, plan: Plan, aim: Aim, noise: f64) -> Option<Self> {
        let near = match aim {
            Aim::Noise(noise) => 4.0 * noise,
            Aim::Tolerance(tolerance) => 0.9 * tolerance,
            Aim::Squares(_) => return None,
        };
        let most = MOST_VERTICES.min(full.points.len() / 3);
        let vertices = polyline::vertices(&full.points, plan.closed, near, most)?;
        let mut search = Self::new(full, plan, aim, noise);
        let breaks = polyline::corners(&vertices, &search.full, search.fitted.breaks());
        if breaks.len() < least(&breaks).max(1) {
            return None;
        }
        // Corners are not averaged away.
        if search.full.points.len() < 16 * vertices.len() {
            search.seen = search.full.clone();
        }
        search.at_first = breaks.len();
        search.fitted = FreeKnots::new(breaks.clone(), &search.seen);
        (search.phase, search.warming) = (Phase::Thin, WARMING);
        if let Aim::Tolerance(tolerance) = aim {
            let spline = polyline::through(&vertices, &search.full, breaks);
            let mut located = search.full.clone();
            let distances = spline.project_beyond(&mut located, 3, search.near());
            if distances.largest <= tolerance {
                search.found = Some(Found { spline, located, distances, wild: None });
            }
        }
        Some(search)
    }

    /// A search for fewer knots than those of `breaks` with a sum of squares that is not larger than `target`.
    pub(in crate::fit) fn pruning(full: Located, breaks: Breaks, target: f64, noise: f64) -> Self {
        let at_first = breaks.len();
        let fitted = FreeKnots::new(breaks, &full);
        let aim = (Aim::Squares(target), 1e-3 * target);
        let mut search = Self::begun(full.clone(), full, fitted, aim, noise);
        (search.phase, search.at_first) = (Phase::Thin, at_first);
        search
    }

    /// Whether needless knots are gone, and needless corners round, so that searches can be compared.
    pub(in crate::fit) fn is_thinned(&self) -> bool {
        match self.phase {
            Phase::Grow | Phase::Thin | Phase::Lighten => false,
            Phase::Refine => self.warming == 0 && (!self.even || self.placed),
            Phase::Polish => !self.even || self.placed,
            _ => true,
        }
    }

    /// Sum of squares and prices, on all points: averages hide what they average.
    pub(in crate::fit) fn cost(&self) -> f64 {
        let more = if self.even { AHEAD * self.price.0 } else { 0.0 };
        if !self.is_averaged() {
            return self.price.rank(&self.fitted) + more;
        }
        self.price.rank(&FreeKnots::new(self.fitted.breaks().clone(), &self.full)) + more
    }

    /// How many pieces the best curve has, and how far it is from the points.
    pub(in crate::fit) fn merit(&self) -> (usize, f64) {
        match &self.found {
            Some(found) => (found.spline.space.breaks.pieces(), found.distances.largest),
            None => (usize::MAX, f64::INFINITY),
        }
    }

    /// With how many knots the search began, after it had enough of them.
    pub(in crate::fit) fn knots_at_first(&self) -> usize {
        self.at_first
    }

    /// How the search ended.
    pub(in crate::fit) fn status(&self) -> FitStatus {
        let reached = match (self.aim, &self.found) {
            (Aim::Tolerance(tolerance), Some(found)) => found.distances.largest <= tolerance,
            (Aim::Tolerance(_), None) => false,
            (Aim::Squares(target), Some(found)) => found.distances.squares <= target,
            (Aim::Squares(_), None) => false,
            (Aim::Noise(_), _) => !self.is_tired(),
        };
        if reached { FitStatus::Converged } else { FitStatus::Stalled }
    }

    /// Whether the search has ended.
    pub(in crate::fit) fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    fn is_tired(&self) -> bool {
        self.rounds > MOST_ROUNDS || self.work > MOST_WORK
    }

    /// How many rounds there were.
    pub(in crate::fit) fn rounds(&self) -> usize {
        self.rounds
    }

    /// The best spline so far.
    pub(in crate::fit) fn finish(mut self) -> Found {
        match self.found.take() {
            Some(found) => found,
            None => self.polished(2),
        }
    }

    /// One round of the search.
    pub(in crate::fit) fn step(&mut self) {
        self.rounds += 1;
        let fits = if matches!(self.phase, Phase::Refine | Phase::Last(_)) { 30.0 } else { 2.0 };
        let knots = self.fitted.breaks().coefficients() as f64;
        self.work += fits * (self.seen.points.len() as f64 + 40.0 * knots);
        let (tired, was) = (self.is_tired(), self.phase);
        self.phase = match was {
            Phase::Grow if !tired => self.grow(),
            Phase::Thin if !tired => match thinner(&self.fitted, &self.seen, self.price) {
                Some(fitted) => {
                    self.fitted = fitted;
                    Phase::Thin
                }
                None => {
                    let worth = 0.1 * self.price.0;
                    let smooth = self.fitted.breaks().sharpest < self.sharpest;
                    let most = if smooth { 4 } else { 6 };
                    self.fitted = settle(self.fitted.clone(), &self.seen, worth, most);
                    if smooth { Phase::Lighten } else { Phase::Refine }
                }
            },
            Phase::Refine if !tired => match better(&self.fitted, &self.seen, self.price) {
                Some(fitted) => {
                    self.fitted = fitted;
                    self.warming = self.warming.saturating_sub(1);
                    Phase::Refine
                }
                None => Phase::Polish,
            },
            Phase::Lighten if !tired => self.lighten(),
            Phase::Polish => self.polish(),
            Phase::Last(next) if !tired => self.last(next),
            Phase::RoundOff => self.round_off(),
            Phase::Straighten => self.straighten(),
            Phase::Last(_) | Phase::Done => Phase::Done,
            Phase::Grow | Phase::Thin | Phase::Lighten | Phase::Refine => Phase::Polish,
        };
        if self.phase == Phase::Done && !self.straightened {
            let rounded = was == Phase::RoundOff || self.least_turn <= 0.0;
            self.phase = if rounded { Phase::Straighten } else { Phase::RoundOff };
        }
    }

    /// The points as they are looked at before anything moved them.
    fn seen_from_afar(&self) -> Located {
        from_afar(&self.full, self.averages)
    }

    /// Goes on with more averages.
    #[inline(never)]
    fn look_closer(&mut self, breaks: Breaks) -> Phase {
        self.averages = CLOSER * self.seen.points.len();
        self.seen = self.seen_from_afar();
        self.fitted = FreeKnots::new(breaks, &self.seen);
        (self.grown, self.repairs, self.even) = (self.rounds, 0, false);
        Phase::Grow
    }

    fn grow(&mut self) -> Phase {
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
fn from_afar(full: &Located, count: usize) -> Located {
    if 2 * full.points.len() > 3 * count { averages(full, count) } else { full.clone() }
}
