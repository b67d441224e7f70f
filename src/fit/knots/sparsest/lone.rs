//! An open line that one polynomial explains needs no search: knots that points by length ask for, where its speed
//! changes, are not easily taken away again. (D 13.20)

use super::{Aim, FEW, Found, Phase, Plan, Sparsest};
use crate::error::Result;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::spline::Spline;

/// Steps until a polynomial is as near as it comes: where it is the line itself three to nine are enough most often.
const STEPS: usize = 32;
/// The same from where averages of many points have led.
const FEW_STEPS: usize = 4;
/// The share of a tolerance below which there is nothing to gain.
const NEAR: f64 = 1e-3;

impl Sparsest {
    /// A search that has found one polynomial within the tolerance, and has only straight pieces left to look for.
    ///
    /// # Errors
    ///
    /// `OutOfMemory`.
    pub(in crate::fit) fn of_one_piece(
        full: Located,
        plan: Plan,
        aim: Aim,
        noise: f64,
    ) -> Result<Option<Self>> {
        let Aim::Tolerance(tolerance) = aim else { return Ok(None) };
        if plan.closed || plan.timed || plan.degree < 2 {
            return Ok(None);
        }
        let mut search = Self::new(full, plan, aim, noise);
        let breaks = search.fitted.breaks().bare();
        search.fitted = FreeKnots::new(breaks, &search.view.seen);
        let mut spline = Spline::of(&search.fitted);
        let mut seen = search.view.seen.copied()?;
        let eased = spline.ease(&mut seen, STEPS, NEAR * tolerance);
        if eased.largest > tolerance || spline.strays(&seen, search.leash()).is_some() {
            return Ok(None);
        }
        search.view.seen = seen;
        let mut located = search.view.following(search.fitted.breaks());
        // Averages end before the points do.
        let steps = if located.points.len() > FEW { FEW_STEPS } else { STEPS };
        let distances = spline.ease(&mut located, steps, NEAR * tolerance);
        if distances.largest > tolerance {
            return Ok(None);
        }
        search.found = Some(Found { spline, located, distances, wild: None });
        search.phase = Phase::Straighten;
        Ok(Some(search))
    }
}
