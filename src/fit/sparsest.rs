//! From located points to the spline with the fewest knots, in steps that each take a few passes over the points.

use super::bins::averages;
use super::breaks::Breaks;
use super::foot_points::{Distances, Spline};
use super::free_knots::{FreeKnots, Located};
use super::outcome::FitStatus;
use super::polyline;
use super::search::{Price, better, hopes, least, settle, thinner};
use super::start;

/// About so many averages of points are looked at while knots are looked for; half as many points more are not averaged.
const SEEN: usize = 450;
/// More points than this are searched in a hurry.
const FEW: usize = 2000;
/// Rounds of refinement before searches that began differently are compared.
const WARMING: usize = 8;
/// The most corners to begin with.
const MOST_VERTICES: usize = 600;
/// What a number of the curve costs, in units of the noise's variance.
const PER_NUMBER: f64 = 3.0;
/// How often pieces that swing away from the points are taken out.
const MOST_TAMINGS: usize = 20;
/// Rounds after which growing, thinning and refining have gone on long enough.
const MOST_ROUNDS: usize = 400;
/// The same in work: a round tries about thirty fits, each a pass over the points and some hundred operations a knot.
const MOST_WORK: f64 = 1e8;

/// What the curve is to keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Aim {
    /// The points are noisy by this standard deviation in each coordinate.
    Noise(f64),
    /// No point may be farther away than this.
    Tolerance(f64),
    /// The weighted sum of squares, at the points' parameters, may not be larger than this.
    Squares(f64),
}

/// Which splines are searched.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    pub(super) degree: usize,
    /// How often a knot may count.
    pub(super) sharpest: usize,
    /// How often a knot counts at least.
    pub(super) smoothest: usize,
    pub(super) closed: bool,
    /// The parameter runs from 0 to here.
    pub(super) end: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Grow,
    Thin,
    Refine,
    Polish,
    Last(usize),
    Done,
}

/// A spline that was found, with the parameters of the points' feet and their distances.
#[derive(Clone, Debug)]
pub(super) struct Found {
    pub(super) spline: Spline,
    pub(super) located: Located,
    pub(super) distances: Distances,
    /// A piece that leaves the way of the points, if there is one.
    wild: Option<usize>,
}

/// The search, to be stepped.
#[derive(Clone, Debug)]
pub(super) struct Sparsest {
    full: Located,
    /// The same points, or averages of them.
    seen: Located,
    aim: Aim,
    price: Price,
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
    found: Option<Found>,
}

impl Sparsest {
    /// A search among the splines of a plan. `noise` is what is known of the points even where a tolerance is asked
    /// for: knots that only follow noise are then not begun with.
    pub(super) fn new(full: Located, plan: Plan, aim: Aim, noise: f64) -> Self {
        let whole = matches!(aim, Aim::Squares(_));
        let seen = if whole { full.clone() } else { from_afar(&full) };
        let price = match aim {
            Aim::Noise(noise) => PER_NUMBER * noise * noise,
            Aim::Tolerance(tolerance) => (0.05 * tolerance * tolerance).max(PER_NUMBER * noise * noise),
            Aim::Squares(target) => 1e-3 * target,
        };
        let mut breaks = start::even(plan.degree, plan.closed, plan.end, seen.points.len(), plan.smoothest);
        breaks.sharpest = plan.sharpest;
        let fitted = FreeKnots::new(breaks, &seen);
        Self {
            full,
            seen,
            aim,
            price: Price(price),
            fitted,
            phase: Phase::Grow,
            rounds: 0,
            work: 0.0,
            warming: if matches!(aim, Aim::Noise(_)) { WARMING } else { 0 },
            repairs: 0,
            tamings: 0,
            at_first: 0,
            rounds_at_price: 0,
            pieces_at_price: usize::MAX,
            found: None,
        }
    }

    /// A search that begins with corners only: those of a polyline near the points, which for a tolerance is an answer
    /// already. `None` where a polyline needs more vertices than are worth it.
    pub(super) fn from_corners(full: Located, plan: Plan, aim: Aim, noise: f64) -> Option<Self> {
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
            let distances = spline.project(&mut located, 3);
            if distances.largest <= tolerance {
                search.found = Some(Found { spline, located, distances, wild: None });
            }
        }
        Some(search)
    }

    /// A search for fewer knots than those of `breaks` with a sum of squares that is not larger than `target`.
    pub(super) fn pruning(full: Located, breaks: Breaks, target: f64) -> Self {
        let at_first = breaks.len();
        let fitted = FreeKnots::new(breaks, &full);
        Self {
            seen: full.clone(),
            full,
            aim: Aim::Squares(target),
            price: Price(1e-3 * target),
            fitted,
            phase: Phase::Thin,
            rounds: 0,
            work: 0.0,
            warming: 0,
            repairs: 0,
            tamings: 0,
            at_first,
            rounds_at_price: 0,
            pieces_at_price: usize::MAX,
            found: None,
        }
    }

    /// Whether needless knots are gone, and needless corners round, so that searches can be compared.
    pub(super) fn is_thinned(&self) -> bool {
        match self.phase {
            Phase::Grow | Phase::Thin => false,
            Phase::Refine => self.warming == 0,
            _ => true,
        }
    }

    /// Sum of squares and prices, on all points: averages hide what they average.
    pub(super) fn cost(&self) -> f64 {
        if self.seen.points.len() == self.full.points.len() {
            return self.price.rank(&self.fitted);
        }
        self.price.rank(&FreeKnots::new(self.fitted.breaks().clone(), &self.full))
    }

    /// How many pieces the best curve has, and how far it is from the points.
    pub(super) fn merit(&self) -> (usize, f64) {
        match &self.found {
            Some(found) => (found.spline.space.breaks.pieces(), found.distances.largest),
            None => (usize::MAX, f64::INFINITY),
        }
    }

    /// With how many knots the search began, after it had enough of them.
    pub(super) fn knots_at_first(&self) -> usize {
        self.at_first
    }

    /// How the search ended.
    pub(super) fn status(&self) -> FitStatus {
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
    pub(super) fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    fn is_tired(&self) -> bool {
        self.rounds > MOST_ROUNDS || self.work > MOST_WORK
    }

    /// How many rounds there were.
    pub(super) fn rounds(&self) -> usize {
        self.rounds
    }

    /// The best spline so far.
    pub(super) fn finish(mut self) -> Found {
        match self.found.take() {
            Some(found) => found,
            None => self.polished(2),
        }
    }

    /// One round of the search.
    pub(super) fn step(&mut self) {
        self.rounds += 1;
        let fits = if matches!(self.phase, Phase::Refine | Phase::Last(_)) { 30.0 } else { 2.0 };
        let knots = self.fitted.breaks().coefficients() as f64;
        self.work += fits * (self.seen.points.len() as f64 + 40.0 * knots);
        let tired = self.is_tired();
        self.phase = match self.phase {
            Phase::Grow if !tired => self.grow(),
            Phase::Thin if !tired => match thinner(&self.fitted, &self.seen, self.price) {
                Some(fitted) => {
                    self.fitted = fitted;
                    Phase::Thin
                }
                None => {
                    let worth = 0.1 * self.price.0;
                    self.fitted = settle(self.fitted.clone(), &self.seen, worth, 6);
                    Phase::Refine
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
            Phase::Polish => self.polish(),
            Phase::Last(next) if !tired => self.last(next),
            Phase::Last(_) | Phase::Done => Phase::Done,
            Phase::Grow | Phase::Thin | Phase::Refine => Phase::Polish,
        };
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
            Some(fitted) if self.rounds < 60 => {
                self.fitted = fitted;
                Phase::Grow
            }
            _ => {
                self.fitted = FreeKnots::new(self.fitted.breaks().clone(), &self.seen);
                self.at_first = self.fitted.breaks().len();
                Phase::Thin
            }
        }
    }

    /// The fit with the points' parameters free, on the averages first and then on all points.
    fn polished(&mut self, rounds: usize) -> Found {
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
        let averaged = self.seen.points.len() < self.full.points.len();
        let mut located = if averaged { self.full.clone() } else { self.seen.clone() };
        let mut distances = spline.project(&mut located, 3);
        if wild.is_some() {
            distances.largest = f64::INFINITY;
        }
        Found { spline, located, distances, wild }
    }

    /// How many knots are tried when fewer are hardly possible: all of them where that takes little time.
    fn trials(&self) -> usize {
        match self.full.points.len() {
            0..=800 => 40,
            801..=FEW => 4,
            _ => 1,
        }
    }

    /// How far from the points their curve may be.
    fn slack(&self) -> f64 {
        match self.aim {
            Aim::Noise(noise) => 4.0 * noise,
            Aim::Tolerance(tolerance) => tolerance,
            Aim::Squares(_) => f64::INFINITY,
        }
    }

    fn polish(&mut self) -> Phase {
        if let Aim::Squares(target) = self.aim {
            return self.weigh(target);
        }
        let found = self.polished(4);
        let breaks = found.spline.space.breaks.clone();
        if let Some(piece) = found.wild
            && self.tamings < MOST_TAMINGS
            && breaks.len() > least(&breaks)
        {
            self.tamings += 1;
            self.seen = from_afar(&self.full);
            self.fitted = FreeKnots::new(without_piece(breaks, piece), &self.seen);
            return Phase::Refine;
        }
        match self.aim {
            Aim::Noise(_) => {
                self.repairs += 1;
                // With the parameters at the feet some knots have become needless.
                if self.repairs <= 3 && !self.is_tired() {
                    self.found = Some(found);
                    self.fitted = FreeKnots::new(breaks, &self.seen);
                    let trial = better(&self.fitted, &self.seen, self.price);
                    if let Some(trial) = trial {
                        self.fitted = trial;
                        return Phase::Refine;
                    }
                    return Phase::Done;
                }
                self.found = Some(found);
                Phase::Done
            }
            Aim::Tolerance(tolerance) => self.judge(found, tolerance),
            Aim::Squares(_) => Phase::Done,
        }
    }

    /// Goes on with a higher price while the sum of squares is small enough.
    fn weigh(&mut self, target: f64) -> Phase {
        let kept = self.found.as_ref().is_some_and(|found| found.distances.squares <= target);
        let small = self.fitted.squares <= target;
        if small || !kept {
            let distances = Distances { largest: f64::INFINITY, squares: self.fitted.squares };
            self.found = Some(Found {
                spline: Spline::of(&self.fitted),
                located: self.full.clone(),
                distances,
                wild: None,
            });
        }
        let breaks = self.fitted.breaks();
        if small && breaks.len() > least(breaks) && !self.is_tired() {
            self.price = Price(self.price.0 * 1.6);
            return Phase::Thin;
        }
        if kept { Phase::Last(0) } else { Phase::Done }
    }

    /// Takes the next of the cheapest knots away from the best fit and lets the others slide.
    fn lighter(&mut self, next: usize, target: f64) -> Phase {
        let Some(best) = &self.found else { return Phase::Done };
        let fitted = FreeKnots::new(best.spline.space.breaks.clone(), &self.seen);
        let dear = Price(fitted.squares.max(1e-300));
        let trials = hopes(fitted.breaks(), &fitted.removals(), dear, self.trials());
        let Some(breaks) = trials.into_iter().nth(next) else { return Phase::Done };
        let trial = settle(FreeKnots::new(breaks, &self.seen), &self.seen, 1e-4 * target, 12);
        if trial.squares > target {
            return Phase::Last(next + 1);
        }
        self.fitted = trial;
        let distances = Distances { largest: f64::INFINITY, squares: self.fitted.squares };
        self.found = Some(Found {
            spline: Spline::of(&self.fitted),
            located: self.full.clone(),
            distances,
            wild: None,
        });
        Phase::Last(0)
    }

    /// Goes on with a higher price while the tolerance is kept; repairs a first fit that breaks it.
    fn judge(&mut self, found: Found, tolerance: f64) -> Phase {
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
                self.price = Price(self.price.0 * if few { 2.5 } else { 4.0 });
            }
            self.fitted = FreeKnots::new(breaks, &self.seen);
            return Phase::Thin;
        }
        if self.found.as_ref().is_some_and(|best| best.distances.largest <= tolerance) {
            return Phase::Last(0);
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

    /// Takes the next of the cheapest knots away from the best fit and lets the others make up for it, the farthest
    /// points weighing most.
    fn last(&mut self, next: usize) -> Phase {
        if let Aim::Squares(target) = self.aim {
            return self.lighter(next, target);
        }
        let (Aim::Tolerance(tolerance), Some(best)) = (self.aim, &self.found) else { return Phase::Done };
        let averaged = self.seen.points.len() < self.full.points.len();
        let mut seen = if averaged { self.seen.clone() } else { best.located.clone() };
        let fitted = FreeKnots::new(best.spline.space.breaks.clone(), &seen);
        let removals = fitted.removals();
        let dear = Price(fitted.squares.max(1e-300));
        let trials = hopes(fitted.breaks(), &removals, dear, self.trials());
        let Some(breaks) = trials.into_iter().nth(next) else { return Phase::Done };
        let trial = settle(FreeKnots::new(breaks, &seen), &seen, 1e-3 * fitted.squares, 6);
        let mut spline = Spline::of(&trial);
        let distances = minimax(&mut spline, &mut seen, tolerance);
        if distances.largest <= tolerance && spline.strays(&seen, tolerance).is_none() {
            let mut located = if averaged { self.full.clone() } else { seen };
            located.weights.clone_from(&self.full.weights);
            let distances = spline.project(&mut located, 3);
            if distances.largest <= tolerance {
                self.found = Some(Found { spline, located, distances, wild: None });
                return Phase::Last(0);
            }
        }
        Phase::Last(next + 1)
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

/// The points, or averages of them where they are many.
fn from_afar(full: &Located) -> Located {
    if 2 * full.points.len() > 3 * SEEN { averages(full, SEEN) } else { full.clone() }
}

/// Makes the largest distance smaller: far points weigh more from round to round (Lawson's way). The spline with the
/// smallest largest distance is kept.
fn minimax(spline: &mut Spline, data: &mut Located, enough: f64) -> Distances {
    if data.weights.is_empty() {
        data.weights = vec![1.0; data.points.len()];
    }
    let mut best: Option<(Spline, Distances)> = None;
    for round in 0..14 {
        if round > 0 {
            spline.tighten(data);
        }
        let distances = spline.project(data, 2);
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.1.largest);
        if distances.largest < before {
            best = Some((spline.clone(), distances));
        }
        if distances.largest <= enough || (round == 6 && before > 2.0 * enough) {
            break;
        }
        if round >= 2 {
            let mut at = 0;
            for m in 0..data.points.len() {
                let (s, t) = spline.space.find(data.parameters[m], at);
                at = s;
                let far = (spline.on(s, t, 0) - data.points[m]).norm() / distances.largest;
                data.weights[m] = (data.weights[m] * (0.4 + far * far)).clamp(1e-3, 1e3);
            }
        }
    }
    match best {
        Some((kept, distances)) => {
            *spline = kept;
            distances
        }
        None => Distances { largest: f64::INFINITY, squares: f64::INFINITY },
    }
}
