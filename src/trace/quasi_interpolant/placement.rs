//! Where knots go: from many even ones the least worthy leave, one by one, and those that stay move to where they
//! predict best.

use super::End;
use super::choice::Choice;
use super::cloud::Cloud;
use super::knots::Knots;
use super::projection::{Projection, REACH};
use crate::error::Result;
use crate::limits::with_room;
use crate::trace::metrics::root_mean_square;

/// The most even knots that are tried as they are, and the most from which knots leave.
const MOST_EVEN: usize = 8;
const MOST_PLACED: usize = 30;
/// Where a knot is tried, in parts of the way to the next one.
const MOVES: [f64; 4] = [-0.5, 0.5, -0.25, 0.25];

/// A tube whose knots are sought.
pub(super) struct Placement<'a> {
    pub(super) cloud: &'a Cloud,
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) degree: usize,
    pub(super) ends: [End; 2],
    /// The fewest interior knots.
    pub(super) least: usize,
    /// By what share of itself, divided by the number of points, the error has to fall for one more knot.
    pub(super) price: f64,
    /// Errors below are as good as none.
    pub(super) floor: f64,
}

/// Interior knots that were tried.
struct Candidate {
    inner: Vec<f64>,
    score: f64,
    neighbours: usize,
    /// The knot without which the error grows least.
    weakest: Option<usize>,
}

impl Placement<'_> {
    /// The knots, and what is known of them (D 14.11).
    ///
    /// # Cost
    ///
    /// At most 31 projections to leave knots out, and five for each knot that stays.
    pub(super) fn place(&self) -> Result<(Choice, Knots)> {
        let mut best = self.tried(self.even(self.least)?)?;
        if best.score > self.floor {
            let most = MOST_PLACED.min((self.cloud.len() / 2).saturating_sub(2)).max(self.least);
            for interior in self.least + 1..=MOST_EVEN.min(most) {
                self.better(&mut best, self.tried(self.even(interior)?)?);
            }
            let mut thinned = self.tried(self.even(most)?)?;
            while let Some(next) = self.thinned(&thinned)? {
                self.better(&mut best, core::mem::replace(&mut thinned, next));
            }
            self.better(&mut best, thinned);
            while self.settle(&mut best)? {}
            while let Some(mut next) = self.thinned(&best)? {
                while self.settle(&mut next)? {}
                if !self.better(&mut best, next) {
                    break;
                }
            }
        }
        let choice = Choice { interior: best.inner.len(), k: best.neighbours, score: best.score };
        Ok((choice, self.knots(&best.inner)?))
    }

    fn even(&self, interior: usize) -> Result<Vec<f64>> {
        let mut inner = with_room(interior)?;
        let width = (self.end - self.start) / (interior + 1) as f64;
        inner.extend((1..=interior).map(|i| self.start + width * i as f64));
        Ok(inner)
    }

    fn knots(&self, inner: &[f64]) -> Result<Knots> {
        let order = self.degree + 1;
        let mut list = with_room(inner.len() + 2 * order)?;
        list.resize(order, self.start);
        list.extend_from_slice(inner);
        list.resize(list.len() + order, self.end);
        Knots::new(&list, self.degree)
    }

    fn tried(&self, inner: Vec<f64>) -> Result<Candidate> {
        let knots = self.knots(&inner)?;
        let report = Projection::new(self.cloud, &knots, REACH, self.ends)?.report()?;
        let mut score = root_mean_square(report.left_out.iter().copied());
        let mut weakest = (0..inner.len()).min_by(|&a, &b| report.worth[a].total_cmp(&report.worth[b]));
        // A piece at an end that has not enough points of its own leads anywhere, whatever it predicts.
        for (points, knot) in report.outer.into_iter().zip([0, inner.len().saturating_sub(1)]) {
            if !inner.is_empty() && points <= self.degree {
                (score, weakest) = (f64::MAX, Some(knot));
            }
        }
        Ok(Candidate { inner, score, neighbours: report.neighbours, weakest })
    }

    /// One knot fewer, where there may be.
    fn thinned(&self, from: &Candidate) -> Result<Option<Candidate>> {
        match from.weakest {
            Some(weakest) if from.inner.len() > self.least => {
                let mut inner = with_room(from.inner.len())?;
                inner.extend_from_slice(&from.inner);
                inner.remove(weakest);
                Ok(Some(self.tried(inner)?))
            }
            _ => Ok(None),
        }
    }

    /// What is made small: the logarithm of the error and the price of the knots.
    fn burden(&self, candidate: &Candidate) -> f64 {
        let share = candidate.inner.len() as f64 / self.cloud.len() as f64;
        libm::log(candidate.score.max(self.floor)) + self.price * share
    }

    /// Takes the other one if its burden is less.
    fn better(&self, best: &mut Candidate, other: Candidate) -> bool {
        let better = self.burden(&other) < self.burden(best);
        if better {
            *best = other;
        }
        better
    }

    /// Moves every knot once, if that predicts better; whether it does by more than a hundredth.
    fn settle(&self, best: &mut Candidate) -> Result<bool> {
        let before = best.score;
        for at in 0..best.inner.len() {
            for part in MOVES {
                let here = best.inner[at];
                let beside = if part < 0.0 {
                    if at == 0 { self.start } else { best.inner[at - 1] }
                } else {
                    best.inner.get(at + 1).copied().unwrap_or(self.end)
                };
                let mut inner = with_room(best.inner.len())?;
                inner.extend_from_slice(&best.inner);
                inner[at] = here + part.abs() * (beside - here);
                self.better(best, self.tried(inner)?);
            }
        }
        Ok(best.score < 0.99 * before)
    }
}
