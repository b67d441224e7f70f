//! What a fit answers: splines on the knots that are really there.

use super::problem::Problem;
use super::spline_space::KnotSpace;
use crate::error::{Error, Result};
use crate::numerics::Vector;

/// Where a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Status {
    /// There is more to do.
    Running,
    /// The gap is reached.
    Converged,
    /// The iterations are used up; the gap says how far it came.
    IterationLimit,
    /// Rounding allows no further progress; the gap says how far it came.
    Stalled,
}

/// One component of the fitted curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    /// Its degree.
    pub degree: usize,
    /// Its λ.
    pub lambda: f64,
    /// The knots, ascending: no jump here is zero, everywhere else it is exactly zero.
    pub knots: Vec<f64>,
    /// The jump of the highest derivative at each knot.
    pub jumps: Vec<Vector>,
    /// The coefficients in [`Solution::space`]; closed without knots: one, the constant.
    pub coefficients: Vec<Vector>,
}

/// A fitted curve with what is known of it. All numbers are in the units of the [`Problem`].
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The components, in the order of the problem.
    pub components: Vec<Spline>,
    /// Where the domain starts and ends, and whether it is closed.
    pub domain: (f64, f64, bool),
    /// The value of what is minimised.
    pub objective: f64,
    /// Σ w |r − p|².
    pub data_term: f64,
    /// λ Σ |jump| of each component.
    pub regularizers: Vec<f64>,
    /// The relative duality gap of the iteration that the curve comes from; `certificate::verify` finds it anew.
    pub gap: f64,
    /// How the run stood.
    pub status: Status,
    /// Iterations of the run.
    pub iterations: usize,
}

impl Solution {
    /// The spline space of a component.
    ///
    /// # Errors
    ///
    /// As for [`KnotSpace::new`], and `WrongLength` for another number of jumps or coefficients than the knots ask for;
    /// none for a solution that the solver made.
    pub fn space(&self, component: &Spline) -> Result<KnotSpace> {
        let (start, end, closed) = self.domain;
        let Spline { degree, knots, jumps, coefficients, .. } = component;
        let space = KnotSpace::new(*degree, knots, start, end, closed)?;
        if jumps.len() != knots.len() {
            return Err(Error::wrong_length("jumps", jumps.len(), knots.len()));
        }
        if coefficients.len() != space.dimension() {
            return Err(Error::wrong_length("coefficients", coefficients.len(), space.dimension()));
        }
        Ok(space)
    }

    /// A derivative of the curve at each parameter; order 0 is the place. At a knot the limit from the right.
    ///
    /// # Errors
    ///
    /// As for [`Solution::space`].
    pub fn evaluate(&self, parameters: &[f64], order: usize) -> Result<Vec<Vector>> {
        let mut sum = vec![Vector::zeros(); parameters.len()];
        for component in &self.components {
            let space = self.space(component)?;
            for (point, &t) in sum.iter_mut().zip(parameters) {
                *point += space.evaluate(&component.coefficients, t, order);
            }
        }
        Ok(sum)
    }

    /// The data term over the number of points: the mean square distance where all weights are 1. [LDAU22, eq. 20]
    pub fn quadratic_fitting_error(&self, problem: &Problem) -> f64 {
        self.data_term / problem.points.len().max(1) as f64
    }

    /// How many knots there are in all components.
    pub fn knot_count(&self) -> usize {
        self.components.iter().map(|component| component.knots.len()).sum()
    }
}
