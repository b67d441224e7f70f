//! Knots that are taken for the true ones, and how the set of them changes.

use super::cone::{dot, typical_length};
use super::dual::maxima;
use crate::numerics::Vector;

/// The knots of one component, as places of its grid, with their jumps.
pub(super) type Knots = Vec<(usize, Vector)>;

/// A dual curve is longer than 1, and not by rounding.
const TOO_LONG: f64 = 1.0 + 1e-11;
/// What a jump that comes is of those that there are.
const FIRST_JUMP: f64 = 1e-2;

/// The knots of all components.
#[derive(Clone, Debug)]
pub(super) struct ActiveSet(pub(super) Vec<Knots>);

impl ActiveSet {
    /// The jumps of a closed curve sum to zero: one alone is none.
    pub(super) fn leave_lonely(&mut self, closed: bool) {
        for knots in &mut self.0 {
            if closed && knots.len() == 1 {
                knots.clear();
            }
        }
    }

    /// The knots of each component, as places of its grid.
    pub(super) fn places(&self) -> Vec<Vec<usize>> {
        self.0.iter().map(|knots| knots.iter().map(|(place, _)| *place).collect()).collect()
    }

    /// All jumps.
    pub(super) fn jumps(&self) -> Vec<Vector> {
        self.0.iter().flatten().map(|(_, jump)| *jump).collect()
    }

    /// The jumps as they were found, and knots where the dual curve is too long; answers whether there are any. Where
    /// there is no other, a jump that comes is `alone` long.
    pub(super) fn join(&mut self, jumps: &[Vector], eta: &[Vec<Vector>], closed: bool, alone: f64) -> bool {
        let (mut jumps, mut any) = (jumps.iter(), false);
        for (knots, eta) in self.0.iter_mut().zip(eta) {
            for (_, jump) in knots.iter_mut() {
                *jump = *jumps.next().unwrap_or(jump);
            }
            let typical = typical_length(knots.iter().map(|(_, jump)| jump));
            let first = if typical > 0.0 { FIRST_JUMP * typical } else { alone };
            for place in maxima(eta, closed, TOO_LONG) {
                if let Err(at) = knots.binary_search_by_key(&place, |(place, _)| *place) {
                    knots.insert(at, (place, eta[place] * first));
                    any = true;
                }
            }
        }
        any
    }

    /// Takes the knots out whose jumps have turned round on the way.
    pub(super) fn leave_turned(&mut self, from: &[Vector], to: &[Vector]) {
        let mut pairs = to.iter().zip(from);
        for knots in &mut self.0 {
            knots.retain(|_| pairs.next().is_some_and(|(a, b)| dot(*a, *b) > 0.0));
        }
    }

    /// Where jumps turn round on the way, goes as far as the first of them and takes it out. Answers whether there was
    /// one.
    pub(super) fn leave_first(&mut self, from: &[Vector], to: &[Vector]) -> bool {
        let vanishes = |(from, to): (&Vector, &Vector)| {
            let (here, there) = (dot(*from, *from), dot(*from, *to));
            if there > 0.0 { f64::INFINITY } else { here / (here - there) }
        };
        let at: Vec<f64> = from.iter().zip(to).map(vanishes).collect();
        let first = at.iter().fold(f64::INFINITY, |least, at| least.min(*at));
        if first > 1.0 {
            return false;
        }
        let mut ends = at.iter().zip(to);
        for knots in &mut self.0 {
            knots.retain_mut(|(_, jump)| {
                ends.next().is_some_and(|(at, end)| {
                    *jump += (end - *jump) * first;
                    *at > first
                })
            });
        }
        true
    }
}
