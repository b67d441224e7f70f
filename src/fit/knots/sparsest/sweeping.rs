//! Before the last knots are tried one by one on the whole curve, each of them is in its neighbourhood.

use super::last_knots::MANY;
use super::rounding::SEEMING;
use super::{Aim, FEW, Found, MOST_WORK, Phase, Sparsest};
use crate::fit::knots::stray::Leash;
use crate::fit::knots::sweep::Sweep;
use crate::numerics::angle::sin_cos;

/// The share of a search's work that a sweep may take.
const SHARE: f64 = 0.5;
/// With a knot for fewer points than this nothing tells corners from noise.
const TOLD: usize = 8;
/// How many times as far from the lines between the points as these from the curve it may be.
const SLACK: f64 = 1.1;

/// How far the sweep of the best curve is.
#[derive(Clone, Debug)]
pub(super) enum Swept {
    Not,
    /// The sweep, and what it took so far.
    Underway(Box<Sweep>, f64),
    Over,
}

impl Sparsest {
    /// Whether there is a curve to be swept: one that keeps a tolerance with many knots, of which no piece has to be
    /// straight. What few knots can do without is found by fits of the whole curve; and many points of one with few
    /// knots take as long as all of the search, for nothing.
    pub(super) fn may_sweep(&self) -> bool {
        let Some(found) = &self.found else { return false };
        let count = self.view.full.points.len();
        self.asked.sweeps
            && !self.asked.aim.is_fine()
            && matches!(self.swept, Swept::Not)
            && found.spline.space.breaks.straight.is_empty()
            && found.spline.space.breaks.len() >= MANY
            && (count <= FEW || self.is_rough(found))
            && self.missed().is_none()
    }

    /// A round of the sweep, or the end of it.
    pub(super) fn sweep(&mut self) -> Phase {
        let (Aim::Tolerance(tolerance), Some(best)) = (self.asked.aim, &self.found) else {
            return Phase::Done;
        };
        match &mut self.swept {
            Swept::Not => {
                let crowded = TOLD * best.spline.space.breaks.pieces() > self.view.full.points.len();
                let staying = if crowded { -2.0 } else { sin_cos(SEEMING).1 };
                let leash = Leash { slack: SLACK * tolerance, share: 0.0 };
                let sweep = Sweep::new(&best.spline, &best.located, tolerance, leash, staying);
                self.swept = Swept::Underway(Box::new(sweep), 0.0);
                return Phase::Sweep;
            }
            Swept::Underway(sweep, work) if *work < SHARE * MOST_WORK => {
                if let Some(more) = sweep.step(&best.located) {
                    *work += more;
                    return Phase::Sweep;
                }
            }
            _ => {}
        }
        if let Swept::Underway(sweep, _) = core::mem::replace(&mut self.swept, Swept::Over) {
            let (spline, mut located) = sweep.swept(best.located.clone());
            let distances = spline.project(&mut located, 3);
            if distances.largest <= tolerance {
                self.found = Some(Found { spline, located, distances, wild: None });
            }
        }
        Phase::Last(0)
    }
}
