//! The convex problem of a sparse fit, in the words of the paper.

use super::interval::MOST_DEGREE;
use crate::error::{Error, Result};
use crate::limits;
use crate::numerics::Vector;

/// How the size of a jump is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Norm {
    /// Its length: rotating the points rotates the curve.
    #[default]
    L2,
    /// |x| + |y|: the coordinates are fitted one by one. Beside the other for comparison.
    L1,
}

/// One spline of the sum that is fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// The degree, 1 … 5.
    pub degree: usize,
    /// λ, the price of a unit of jump of the highest derivative.
    pub lambda: f64,
    /// The places where knots may be, ascending; see [`uniform_grid`].
    pub grid: Vec<f64>,
}

/// minimise Σ wₘ |r(tₘ) − pₘ|² + Σᵢ λᵢ Σₖ |jump of Dᵃⁱrᵢ at the k-th knot|, r = Σ rᵢ, knots of rᵢ in its grid.
/// [LDAU22, eq. 7, 15, 16].
///
/// Two components have ascending degrees; what they share, polynomials of the first one's degree (closed: constants),
/// belongs to the second: closed r₁(start) = 0, open r₁ = 0 at degree₁ + 1 equidistant places from end to end.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The points pₘ.
    pub points: Vec<Vector>,
    /// Their parameters tₘ, not falling, in \[start, end) or, open, \[start, end\].
    pub parameters: Vec<f64>,
    /// Their weights wₘ > 0; empty means all 1.
    pub weights: Vec<f64>,
    /// Where the domain starts.
    pub start: f64,
    /// Where it ends: closed, the start of the next turn.
    pub end: f64,
    /// Whether the curve is closed.
    pub closed: bool,
    /// One spline, or two of ascending degrees.
    pub components: Vec<Component>,
    /// How jumps are measured.
    pub norm: Norm,
}

/// The knots of cardinal splines of that degree: a step of (end − start)/size, closed a multiple of it from the start
/// for odd degrees and half a step further for even ones, open those strictly inside. [LDAU22, III-A], (D 12.1).
pub fn uniform_grid(degree: usize, size: usize, start: f64, end: f64, closed: bool) -> Vec<f64> {
    let half = if degree.is_multiple_of(2) { 0.5 } else { 0.0 };
    let first = usize::from(!closed && half == 0.0);
    (first..size).map(|k| start + (end - start) * ((k as f64 + half) / size as f64)).collect()
}

/// A grid on which a spline of that degree can go through points at these parameters, which do not fall: odd degrees
/// have their knots at the parameters, even ones half-way between them; open ones only inside.
pub fn interpolating_grid(degree: usize, parameters: &[f64], start: f64, end: f64, closed: bool) -> Vec<f64> {
    let mut grid: Vec<f64> = if degree.is_multiple_of(2) {
        let after = parameters.iter().skip(1).copied().chain(closed.then_some(end));
        parameters.iter().zip(after).map(|(a, b)| 0.5 * (a + b)).collect()
    } else {
        parameters.to_vec()
    };
    grid.dedup();
    grid.retain(|&t| t < end && (t > start || closed));
    grid
}

impl Problem {
    /// Points at the parameters 0, 1, 2 …, and for each (degree, λ, N) a spline on the uniform grid of N steps.
    ///
    /// # Errors
    ///
    /// As for [`Problem::check`].
    pub fn of_points(points: &[Vector], closed: bool, splines: &[(usize, f64, usize)]) -> Result<Self> {
        let end = if closed { points.len() } else { points.len().saturating_sub(1) } as f64;
        for &(degree, _, size) in splines {
            check_grid_size(degree, size)?;
        }
        let problem = Self {
            points: points.to_vec(),
            parameters: (0..points.len()).map(|m| m as f64).collect(),
            weights: Vec::new(),
            start: 0.0,
            end,
            closed,
            components: splines
                .iter()
                .map(|&(degree, lambda, size)| Component {
                    degree,
                    lambda,
                    grid: uniform_grid(degree, size, 0.0, end, closed),
                })
                .collect(),
            norm: Norm::L2,
        };
        problem.check()?;
        Ok(problem)
    }

    /// Whether the problem can be posed.
    ///
    /// # Errors
    ///
    /// `TooFewPoints` below degree + 1 different parameters (closed: 2 points), `NotFinite`, `OutOfRange` for
    /// coordinates beyond 1e9, λ not in 0 … 1e60 and weights not in 1e-6 … 1e6, `WrongLength`, `Degenerate` for
    /// parameters or grids that fall or leave the domain, `LimitExceeded` beyond 500 000 points or places for knots.
    pub fn check(&self) -> Result<()> {
        let count = self.points.len();
        if count > limits::MOST_FIT_POINTS {
            return Err(limits::too_many("points", "most points", limits::MOST_FIT_POINTS, count));
        }
        if self.parameters.len() != count {
            return Err(Error::wrong_length("parameters", self.parameters.len(), count));
        }
        for (m, point) in self.points.iter().enumerate() {
            for value in [point.x, point.y] {
                let most = limits::LARGEST_COORDINATE;
                limits::check("points", Some(m), value, -most, most)?;
            }
        }
        if !self.weights.is_empty() && self.weights.len() != count {
            return Err(Error::wrong_length("weights", self.weights.len(), count));
        }
        for (m, &weight) in self.weights.iter().enumerate() {
            limits::check("weights", Some(m), weight, limits::LEAST_WEIGHT, limits::LARGEST_WEIGHT)?;
        }
        self.check_parameters()?;
        self.check_components()
    }

    fn check_parameters(&self) -> Result<()> {
        for (name, value) in [("start", self.start), ("end", self.end)] {
            let most = limits::LARGEST_COORDINATE;
            limits::check(name, None, value, -most, most)?;
        }
        if self.end - self.start < limits::LEAST_LENGTH {
            return Err(Error::degenerate("parameters", None, "they have no extent"));
        }
        let mut before = f64::NEG_INFINITY;
        let mut different = 0;
        for (m, &t) in self.parameters.iter().enumerate() {
            if !t.is_finite() {
                return Err(Error::not_finite("parameters", Some(m)));
            }
            if t < before || t < self.start || t > self.end || (self.closed && t >= self.end) {
                return Err(Error::degenerate("parameters", Some(m), "they fall or leave the domain"));
            }
            different += usize::from(t > before);
            before = t;
        }
        let highest = self.components.last().map_or(1, |c| c.degree);
        let needed = if self.closed { 2 } else { highest + 1 };
        if different < needed {
            return Err(Error::too_few("points", different, needed));
        }
        Ok(())
    }

    fn check_components(&self) -> Result<()> {
        if self.components.is_empty() || self.components.len() > 2 {
            return Err(Error::wrong_length("components", self.components.len(), 1));
        }
        for (i, component) in self.components.iter().enumerate() {
            limits::check("degree", Some(i), component.degree as f64, 1.0, MOST_DEGREE as f64)?;
            limits::check("lambda", Some(i), component.lambda, 0.0, limits::LARGEST_LAMBDA)?;
            if i > 0 && component.degree <= self.components[i - 1].degree {
                return Err(Error::degenerate("degree", Some(i), "degrees ascend"));
            }
            let mut before = f64::NEG_INFINITY;
            for (k, &place) in component.grid.iter().enumerate() {
                let inside = place < self.end && (place > self.start || self.closed && place >= self.start);
                if !(place > before && inside) {
                    return Err(Error::degenerate("grid", Some(k), "it ascends inside the domain"));
                }
                before = place;
            }
            let places = component.grid.len();
            if places > limits::MOST_FIT_POINTS {
                return Err(limits::too_many("grid", "most places", limits::MOST_FIT_POINTS, places));
            }
            if self.closed && places < component.degree + 2 {
                return Err(Error::too_few("grid", places, component.degree + 2));
            }
        }
        Ok(())
    }
}

fn check_grid_size(degree: usize, size: usize) -> Result<()> {
    if size > limits::MOST_FIT_POINTS {
        return Err(limits::too_many("gridSize", "most places", limits::MOST_FIT_POINTS, size));
    }
    limits::check("gridSize", None, size as f64, degree as f64 + 2.0, limits::MOST_FIT_POINTS as f64)
}
