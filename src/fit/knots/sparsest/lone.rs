//! An open line that one polynomial explains needs no search: knots that points by length ask for, where its speed
//! changes, are not easily taken away again. (D 13.20)

use super::{Aim, FEW, Found, Phase, Plan, Sparsest};
use crate::error::Result;
use crate::fit::knots::free_knots::{FreeKnots, Located};
use crate::fit::knots::spline::Spline;
use crate::numerics::plane::{cross, dot};

/// Steps until a polynomial is as near as it comes: where it is the line itself three to nine are enough most often.
const STEPS: usize = 32;
/// The same from where averages of many points have led.
const FEW_STEPS: usize = 4;
/// The share of a tolerance below which there is nothing to gain.
const NEAR: f64 = 1e-3;
/// A polynomial that is as near as this share of a tolerance shows no corner that is none of the points'.
const CLEARLY: f64 = 0.25;
/// An arc that is a tolerance away from the corner that it rounds off is eight tolerances by its turn long: a few more.
const ROUND: f64 = 10.0;
/// What turns by less than this, in radians, may be smooth.
const SHARP: f64 = 1.0;
/// Places at which its direction is looked at.
const PLACES: usize = 256;

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
        let (near, clear) = (distances.largest <= tolerance, distances.largest <= CLEARLY * tolerance);
        let least = search.asked.cornered.then(|| search.asked.least_turn.max(SHARP));
        if !near || !clear && least.is_some_and(|least| rounds_off(&spline, tolerance, least)) {
            return Ok(None);
        }
        search.found = Some(Found { spline, located, distances, wild: None });
        search.phase = Phase::Straighten;
        Ok(Some(search))
    }
}

/// Whether one polynomial turns by so much, or more, within what rounds a corner off by a tolerance.
fn rounds_off(spline: &Spline, tolerance: f64, least: f64) -> bool {
    let at = |i: usize, order: usize| spline.at(0, 2.0 * i as f64 / PLACES as f64 - 1.0, order);
    let steps: Vec<(f64, f64)> = (0..PLACES)
        .map(|i| {
            let [from, to] = [at(i, 1), at(i + 1, 1)];
            ((at(i + 1, 0) - at(i, 0)).norm(), libm::atan2(cross(from, to), dot(from, to)))
        })
        .collect();
    (0..PLACES).any(|first| {
        let (mut length, mut turn) = (0.0, 0.0_f64);
        steps[first..].iter().any(|step| {
            length += step.0;
            turn += step.1;
            turn.abs() >= least && length * turn.abs() <= ROUND * tolerance
        })
    })
}
