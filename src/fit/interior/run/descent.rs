//! The optimum followed from the price at which no knot is left down to the price that is asked for.
//!
//! Many knots in play that are worth little, as on open curves and for high degrees, leave the curve to rounding: the
//! interior point's equations know it only beside numbers 10¹⁶ times as large. On its own few knots the curve is well
//! determined, so there it is followed by an active set: Newton's method on the knots that there are; the first that
//! turns on the way goes; where none does, those come that the dual curve asks for. The objective falls with every
//! round at one price, so no set comes twice. (D 12.13)

use super::Run;
use crate::error::Result;
use crate::fit::convex::solution::Status;
use crate::fit::interior::active_set::ActiveSet;
use crate::fit::interior::fixed_knots::{Fixed, newton, tolerance_of_jumps};
use crate::fit::interior::reduced::Reduced;
use crate::numerics::Vector;

/// What each price is of the one before.
const FALL: f64 = 0.4;
/// The gap at which one on the way is left for the next.
const ON_THE_WAY: f64 = 1e-3;
/// The most rounds at one price on the way, and at the last.
const MOST_ROUNDS: (usize, usize) = (20, 200);
/// The most products that all of it may take, some tenths of a second.
const MOST_WORK: f64 = 1e9;
/// The first jump, where there is no other.
const FIRST_JUMP: f64 = 1e-9;

/// A curve with its dual curves.
type Found = (Fixed, Vec<Vec<Vector>>);

/// How far the optimum has been followed.
#[derive(Clone, Debug)]
pub(crate) struct Descent {
    /// The λ that are asked for.
    targets: Vec<f64>,
    /// The price that is in force, as a multiple of them.
    factor: f64,
    active: ActiveSet,
    /// Rounds at this price.
    rounds: usize,
    /// The best at this price.
    best: Option<Found>,
    /// Products so far.
    work: f64,
}

impl Run {
    /// Begins where no knot is left; the run goes on.
    pub(super) fn begin_descent(&mut self) -> Result<()> {
        let none = ActiveSet(vec![Vec::new(); self.data.components.len()]);
        let alone = self.improved(none.clone(), 1, false)?;
        self.finished = None;
        self.descent = Some(Descent {
            targets: self.data.components.iter().map(|component| component.lambda).collect(),
            factor: alone.map_or(1.0, |(fixed, _)| fixed.measure.longest.max(1.0)),
            active: none,
            rounds: 0,
            best: None,
            work: 0.0,
        });
        self.status = Status::Running;
        Ok(())
    }

    /// One round further; the run is over with the last.
    pub(super) fn descend(&mut self, mut descent: Descent) -> Result<Status> {
        self.price(&descent.targets, descent.factor);
        let last = descent.factor <= 1.0;
        let gap = if last { self.settings.gap } else { ON_THE_WAY.max(self.settings.gap) };
        let over = self.round(&mut descent, gap);
        self.price(&descent.targets, 1.0);
        let most = if last { MOST_ROUNDS.1 } else { MOST_ROUNDS.0 };
        let spent = descent.work > MOST_WORK;
        if over? || descent.rounds >= most || spent {
            let best = descent.best.take();
            if last || spent {
                return self.end_descent(best.filter(|_| last));
            }
            descent.factor = (descent.factor * FALL).max(1.0);
            descent.rounds = 0;
        }
        self.descent = Some(descent);
        Ok(self.status)
    }

    fn price(&mut self, targets: &[f64], factor: f64) {
        for (component, target) in self.data.components.iter_mut().zip(targets) {
            component.lambda = target * factor;
        }
    }

    fn end_descent(&mut self, best: Option<Found>) -> Result<Status> {
        if let Some((fixed, eta)) = best.filter(|(fixed, _)| fixed.measure.gap < self.measure.gap) {
            self.end_with(fixed, eta);
            self.doubt()?;
        }
        self.status = if self.is_near() { Status::Converged } else { Status::Stalled };
        Ok(self.status)
    }

    /// One set of knots; answers whether there is no further one at this price.
    fn round(&self, descent: &mut Descent, gap: f64) -> Result<bool> {
        descent.rounds += 1;
        let active = &mut descent.active;
        active.leave_lonely(self.data.closed);
        let start = active.jumps();
        let reduced = Reduced::new(&self.data, active.places(), &self.iterate.reduced.elements)?;
        descent.work += reduced.work();
        let Some(newton) = newton(&self.data, reduced, &start, tolerance_of_jumps(gap)) else {
            return Ok(true);
        };
        if active.leave_first(&start, &newton.jumps) {
            return Ok(false);
        }
        let settled = newton.settled;
        let (fixed, eta) = self.assessed(newton);
        let found = fixed.measure.gap;
        let any = active.join(&fixed.jumps, &eta, self.data.closed, FIRST_JUMP);
        if descent.best.as_ref().is_none_or(|(best, _)| found < best.measure.gap) {
            descent.best = Some((fixed, eta));
        }
        Ok(found <= gap || (settled && !any))
    }
}
