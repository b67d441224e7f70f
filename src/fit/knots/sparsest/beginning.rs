//! How a search begins: with even knots, with the corners of a polyline, or with the knots of a fit that has too many.

use super::growing::{SEEN, from_afar};
use super::{Aim, Found, LEAP, PER_NUMBER, Phase, Plan, Sparsest, WARMING};
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::search::{Price, least};
use crate::fit::knots::{polyline, start};

/// The most corners to begin with.
const MOST_VERTICES: usize = 600;

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
}
