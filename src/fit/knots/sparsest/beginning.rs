//! How a search begins: with even knots, with the corners of a polyline, or with the knots of a fit that has too many.

use super::resort::{ALMOST, Resort};
use super::{
    Aim, Asked, Effort, Evening, FEW, Fewer, Found, LEAP, PER_NUMBER, Phase, Plan, Pricing, Sparsest, Swept,
    View, WARMING,
};
use crate::error::Result;
use crate::fit::convex::problem::interpolating_grid;
use crate::fit::knots::breaks::Breaks;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::polyline::REACH;
use crate::fit::knots::search::{Price, least};
use crate::fit::knots::spline::Spline;
use crate::fit::knots::stray::Leash;
use crate::fit::knots::{adding, polyline};
use crate::fit::outcome::FitStatus;

/// The most corners to begin with.
const MOST_VERTICES: usize = 600;
/// A tolerance below so many standard deviations of the noise asks for knots that follow it.
const NEAR_NOISE: f64 = 4.0;
/// So many points a polyline of nearly all of them may be begun with, where a tolerance takes as many.
const MOST_THROUGH: usize = 6000;
/// And so many one that has a vertex more often than every [`REACH`] points, beyond which it draws no edge.
const MOST_CROWDED: usize = 16_000;

/// Of so many points at most a search begins with the curve through all of them.
const MOST_FOLLOWED: usize = 1500;

impl Sparsest {
    /// A search among the splines of a plan. `noise` is what is known of the points even where a tolerance is asked
    /// for: knots that only follow noise are then not begun with.
    pub(in crate::fit) fn new(full: Located, plan: Plan, aim: Aim, noise: f64) -> Self {
        let view = if matches!(aim, Aim::Squares(_)) { View::of_all(full) } else { View::new(full) };
        let mut breaks =
            adding::even(plan.degree, plan.closed, plan.end, view.seen.points.len(), plan.smoothest);
        // Sharper knots are cheap ways to bend; smooth ones are to come first.
        breaks.sharpest = if plan.free { plan.smoothest } else { plan.sharpest };
        let (least_turn, cornered) = (plan.least_turn, plan.sharpest == plan.degree);
        let asked = Asked {
            aim,
            noise,
            spaced: plan.spaced,
            timed: plan.timed,
            sweeps: plan.sweeps,
            least_turn,
            cornered,
        };
        let mut search = Self::begun(asked, view, breaks);
        (search.evening.even, search.sharpest) = (plan.free, plan.sharpest);
        search.effort.warming = if matches!(aim, Aim::Noise(_)) { WARMING } else { 0 };
        search
    }

    /// A search that begins with some knots, before anything was done.
    #[inline(never)]
    pub(super) fn begun(asked: Asked, view: View, breaks: Breaks) -> Self {
        Self {
            pricing: Pricing::new(&asked),
            asked,
            fitted: FreeKnots::new(breaks, &view.seen),
            view,
            evening: Evening::default(),
            effort: Effort::default(),
            phase: Phase::Grow,
            sharpest: 1,
            found: None,
            coarse: None,
            at_first: 0,
            straightened: false,
            resort: Resort::None,
            swept: Swept::Not,
            fewer: Fewer::default(),
            sliding: None,
        }
    }

    /// A search that begins with corners only: those of a polyline near the points, which for a tolerance is an answer
    /// already. `None` where a polyline needs more vertices than are worth it.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    pub(in crate::fit) fn from_corners(
        full: Located,
        plan: Plan,
        aim: Aim,
        noise: f64,
    ) -> Result<Option<Self>> {
        let near = match aim {
            Aim::Noise(noise) => 4.0 * noise,
            Aim::Tolerance(tolerance) => 0.9 * tolerance,
            Aim::Squares(_) => return Ok(None),
        };
        let count = full.points.len();
        let most = MOST_VERTICES.min(count / 3);
        let mut vertices = polyline::vertices(&full.points, plan.closed, near, most);
        let near_noise = matches!(aim, Aim::Tolerance(tolerance) if tolerance < NEAR_NOISE * noise);
        let crowded = vertices.as_ref().is_none_or(|found| REACH * found.len() > count);
        if let Aim::Tolerance(tolerance) = aim
            && (near_noise && count <= FEW
                || aim.is_fine() && count <= MOST_THROUGH
                || crowded && count > FEW && count <= MOST_CROWDED)
        {
            let fewest = polyline::fewest(&full.points, plan.closed, ALMOST * tolerance)?;
            vertices = vertices.filter(|found| found.len() <= fewest.len()).or(Some(fewest));
        }
        let Some(vertices) = vertices else { return Ok(None) };
        let mut search = Self::new(full, plan, aim, noise);
        let Some(breaks) = search.corners_at(&vertices)? else { return Ok(None) };
        // Corners are not averaged away.
        if search.view.full.points.len() < 16 * vertices.len() {
            search.view.seen = search.view.full.copied()?;
        }
        search.at_first = breaks.len();
        search.fitted = FreeKnots::new(breaks.clone(), &search.view.seen);
        (search.phase, search.effort.warming) = (Phase::Thin, WARMING);
        if let Aim::Tolerance(tolerance) = aim {
            let found = search.polyline(&vertices, breaks)?;
            // Through nearly all points it is as near as can be.
            if found.distances.largest <= tolerance || aim.is_fine() {
                search.found = Some(found);
            }
        }
        Ok(Some(search))
    }

    /// Knots at the corners of a polyline through some of the points, if that is enough of them: within a tolerance a
    /// line is.
    #[inline(never)]
    pub(super) fn corners_at(&self, vertices: &[usize]) -> Result<Option<Breaks>> {
        let breaks = polyline::corners(vertices, &self.view.full, self.fitted.breaks())?;
        let few = usize::from(!matches!(self.asked.aim, Aim::Tolerance(_)));
        Ok((breaks.len() >= least(&breaks).max(few)).then_some(breaks))
    }

    /// The polyline through some of the points.
    #[inline(never)]
    pub(super) fn polyline(&self, vertices: &[usize], breaks: Breaks) -> Result<Found> {
        let (spline, mut located) = polyline::through(vertices, &self.view.full, breaks)?;
        let distances = spline.project_beyond(&mut located, 3, self.near());
        Ok(Found { spline, located, distances, wild: None })
    }

    /// A search for fewer knots than those of `breaks` with a sum of squares that is not larger than `target`.
    pub(in crate::fit) fn pruning(full: Located, breaks: Breaks, target: f64, noise: f64) -> Self {
        let at_first = breaks.len();
        let asked = Asked {
            aim: Aim::Squares(target),
            noise,
            spaced: false,
            timed: true,
            sweeps: false,
            least_turn: 0.0,
            cornered: true,
        };
        let mut search = Self::begun(asked, View::of_all(full), breaks);
        (search.phase, search.at_first) = (Phase::Thin, at_first);
        search
    }

    /// The same from the curve through all points on, where nothing that was found keeps the sum of squares on the way
    /// of the points.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    #[inline(never)]
    pub(in crate::fit) fn through_all_points(&self) -> Result<Option<Self>> {
        let (full, bare) = (&self.view.full, self.fitted.breaks().bare());
        let Aim::Squares(target) = self.asked.aim else { return Ok(None) };
        if !self.merit().0 && self.status() == FitStatus::Converged || full.points.len() > MOST_FOLLOWED {
            return Ok(None);
        }
        let mut at = interpolating_grid(bare.degree, &full.parameters, 0.0, bare.end, bare.closed);
        // The first and the last piece of an open curve reach over several points.
        let spare = if bare.closed { 0 } else { (bare.degree / 2).min(at.len() / 2) };
        at.truncate(at.len() - spare);
        at.drain(..spare);
        let breaks = Breaks { multiplicity: vec![1; at.len()], at, ..bare };
        let mut search = Self::pruning(full.copied()?, breaks, target, self.asked.noise);
        // It is held by every point: what it swings is what was asked for.
        let wild = Spline::of(&search.fitted).strays(full, Leash::wide(full, 0.0));
        search.keep_by_squares(wild);
        Ok(Some(search))
    }
}

impl Pricing {
    /// What a number costs at first.
    pub(super) fn new(asked: &Asked) -> Self {
        let noise = PER_NUMBER * asked.noise * asked.noise;
        let price = match asked.aim {
            Aim::Noise(noise) => PER_NUMBER * noise * noise,
            Aim::Tolerance(tolerance) => (0.05 * tolerance * tolerance).max(noise),
            Aim::Squares(target) => 1e-3 * target,
        };
        Self { price: Price(price), leap: LEAP, rounds: 0, pieces: usize::MAX }
    }
}
