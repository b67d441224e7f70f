//! Where the solver is: a point of the method, and what one look at the whole problem tells.

use super::cone::{Lorentz, norm};
use super::reduced::Reduced;
use crate::numerics::Vector;

/// A point of the method: coefficients, and one cone per knot.
#[derive(Clone, Debug)]
pub(crate) struct Iterate {
    pub(crate) reduced: Reduced,
    pub(crate) unknowns: Vec<Vector>,
    pub(crate) jumps: Vec<Vector>,
    pub(crate) cones: Vec<Pair>,
}

/// An iterate on the way, far enough from the boundary to start from again.
#[derive(Clone, Debug)]
pub(crate) struct Middle {
    pub(crate) chosen: Vec<Vec<usize>>,
    pub(crate) jumps: Vec<Vector>,
    pub(crate) cones: Vec<Pair>,
    pub(crate) eta: Vec<Vec<Vector>>,
    pub(crate) lambdas: Vec<f64>,
    pub(crate) slack: f64,
}

/// The primal and the dual vector of one cone, and its λ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) s: Lorentz,
    pub(crate) z: Lorentz,
    pub(crate) lambda: f64,
}

impl Pair {
    /// The jump, and by how much the dual vector is short of λ.
    pub(crate) fn sizes(&self) -> (f64, f64) {
        (norm(self.s.plane), (self.z.height - norm(self.z.plane)).max(f64::MIN_POSITIVE))
    }
}

/// What one look at the whole problem tells.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Measure {
    pub(crate) data_term: f64,
    pub(crate) primal: f64,
    pub(crate) dual: f64,
    /// The longest dual vector anywhere on the grids.
    pub(crate) longest: f64,
    pub(crate) gap: f64,
}

/// An objective below this is rounding: points are within ±1, known to 1e-16 each, and 500,000 squares of some of these
/// make it. What share of it could be saved tells nothing.
pub(crate) const ROUNDING: f64 = 1e-24;

/// Objective, bound and gap. The dual vector of residuals is feasible when scaled by 1/longest; a shorter scale that is
/// better is taken. (D 12.4)
pub(crate) fn measure(data_term: f64, regularizer: f64, work: f64, longest: f64) -> Measure {
    let primal = data_term + regularizer;
    let along = 2.0 * data_term + work;
    let scale = if data_term > 0.0 { along / (2.0 * data_term) } else { 1.0 };
    let scale = scale.min(1.0 / longest.max(f64::MIN_POSITIVE)).max(0.0);
    let dual = scale * along - scale * scale * data_term;
    let gap = if primal > ROUNDING { (primal - dual) / primal } else { 0.0 };
    Measure { data_term, primal, dual, longest, gap }
}
