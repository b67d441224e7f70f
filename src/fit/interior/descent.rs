//! The optimum followed from the price at which no knot is left down to the price that is asked for.
//!
//! Many knots in play that are worth little, as on open curves and for high degrees, leave the curve to rounding: the
//! interior point's equations know it only beside numbers 10¹⁶ times as large. On its own few knots the curve is well
//! determined, so there it is followed by an active set: Newton's method on the knots that there are; the first that
//! turns on the way goes; where none does, those come that the dual curve asks for. The objective falls with every round
//! at one price, so no set comes twice. (D 12.13)

use super::cone::{dot, norm};
use super::play::{maxima, median};
use super::polish::{Fixed, Newton, accuracy, newton};
use super::reduced::Reduced;
use super::run::Run;
use crate::error::Result;
use crate::fit::convex::solution::Status;
use crate::numerics::Vector;

/// What each price is of the one before.
const FALL: f64 = 0.4;
/// The gap at which one on the way is left for the next.
const ON_THE_WAY: f64 = 1e-3;
/// The most rounds at one price on the way, and at the last.
const MOST_ROUNDS: (usize, usize) = (20, 200);
/// The most products that all of it may take, some tenths of a second.
const MOST_WORK: f64 = 1e9;
/// What a jump that comes is of those that there are; and where there are none.
const FIRST_JUMP: (f64, f64) = (1e-2, 1e-9);

/// The knots of one component, as places of its grid, with their jumps.
type Active = Vec<(usize, Vector)>;

/// A curve with its dual curves.
type Found = (Fixed, Vec<Vec<Vector>>);

/// How far the optimum has been followed.
#[derive(Clone, Debug)]
pub(crate) struct Descent {
    /// The λ that are asked for.
    targets: Vec<f64>,
    /// The price that is in force, as a multiple of them.
    factor: f64,
    active: Vec<Active>,
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
        let none: Vec<Active> = vec![Vec::new(); self.data.components.len()];
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
        for set in &mut descent.active {
            // The jumps of a closed curve sum to zero: one alone is none.
            if self.data.closed && set.len() == 1 {
                set.clear();
            }
        }
        let places = |set: &Active| set.iter().map(|(place, _)| *place).collect();
        let chosen = descent.active.iter().map(places).collect();
        let start: Vec<Vector> = descent.active.iter().flatten().map(|(_, jump)| *jump).collect();
        let reduced = Reduced::new(&self.data, chosen, &self.iterate.reduced.elements)?;
        descent.work += reduced.work();
        let Some(newton) = newton(&self.data, reduced, &start, accuracy(gap)) else { return Ok(true) };
        if leave_first(&mut descent.active, &start, &newton) {
            return Ok(false);
        }
        let settled = newton.settled;
        let (fixed, eta) = self.assessed(newton);
        let found = fixed.measure.gap;
        let any = self.join(&mut descent.active, &fixed.jumps, &eta);
        if descent.best.as_ref().is_none_or(|(best, _)| found < best.measure.gap) {
            descent.best = Some((fixed, eta));
        }
        Ok(found <= gap || (settled && !any))
    }

    /// The jumps as they were found, and knots where the dual curve is too long; answers whether there are any.
    fn join(&self, active: &mut [Active], jumps: &[Vector], eta: &[Vec<Vector>]) -> bool {
        let (mut jumps, mut any) = (jumps.iter(), false);
        for (set, eta) in active.iter_mut().zip(eta) {
            for (_, jump) in set.iter_mut() {
                *jump = *jumps.next().unwrap_or(jump);
            }
            let typical = median(set.iter().map(|(_, jump)| norm(*jump)).collect());
            let first = if typical > 0.0 { FIRST_JUMP.0 * typical } else { FIRST_JUMP.1 };
            for place in maxima(eta, self.data.closed, 1.0 + 1e-11) {
                if let Err(at) = set.binary_search_by_key(&place, |(place, _)| *place) {
                    set.insert(at, (place, eta[place] * first));
                    any = true;
                }
            }
        }
        any
    }
}

/// Where jumps turn round between `start` and where Newton's method ended, goes as far as the first of them and takes it
/// out. Answers whether there was one.
fn leave_first(active: &mut [Active], start: &[Vector], newton: &Newton) -> bool {
    let vanishes = |(from, to): (&Vector, &Vector)| {
        let (here, there) = (dot(*from, *from), dot(*from, *to));
        if there > 0.0 { f64::INFINITY } else { here / (here - there) }
    };
    let at: Vec<f64> = start.iter().zip(&newton.jumps).map(vanishes).collect();
    let first = at.iter().fold(f64::INFINITY, |least, at| least.min(*at));
    if first > 1.0 {
        return false;
    }
    let mut ends = at.iter().zip(&newton.jumps);
    for set in active {
        set.retain_mut(|(_, jump)| {
            ends.next().is_some_and(|(at, end)| {
                *jump += (end - *jump) * first;
                *at > first
            })
        });
    }
    true
}
