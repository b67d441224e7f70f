//! The problem in units in which points, steps and weights are about one. All factors are powers of two: nothing is
//! rounded but the centre.

use super::problem::Problem;
use crate::error::Result;
use crate::limits;
use crate::numerics::Vector;

/// One component in these units.
#[derive(Clone, Debug)]
pub(crate) struct ScaledComponent {
    pub(crate) degree: usize,
    pub(crate) lambda: f64,
    /// Places for knots, from the start of the domain.
    pub(crate) grid: Vec<f64>,
    /// Index of the first sample that is not before place k of the grid; one more entry than places.
    pub(crate) first_sample: Vec<usize>,
}

/// The data in these units, coordinate by coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Scaled {
    pub(crate) t: Vec<f64>,
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) w: Vec<f64>,
    /// The length of the domain, which starts at 0.
    pub(crate) length: f64,
    pub(crate) closed: bool,
    /// What Σ w |r − p|² is beyond the sum over the samples kept here.
    pub(crate) beyond: f64,
    pub(crate) components: Vec<ScaledComponent>,
    pub(crate) centre: Vector,
    /// Where the domain starts in the caller's parameter.
    pub(crate) start: f64,
    /// One unit here in the caller's: of points, of the parameter, of weights.
    pub(crate) size: f64,
    pub(crate) step: f64,
    pub(crate) weight: f64,
}

/// The power of two next below a positive number; 1 for zero.
pub(crate) fn power_of_two(value: f64) -> f64 {
    let bits = value.to_bits() & 0x7FF0_0000_0000_0000;
    if bits == 0 || !value.is_finite() { 1.0 } else { f64::from_bits(bits) }
}

impl Scaled {
    pub(crate) fn new(problem: &Problem) -> Result<Self> {
        let count = problem.points.len();
        let (mut least, mut most) = (problem.points[0], problem.points[0]);
        for point in &problem.points {
            least = Vector::new(least.x.min(point.x), least.y.min(point.y));
            most = Vector::new(most.x.max(point.x), most.y.max(point.y));
        }
        let box_centre = (least + most) * 0.5;
        let mut mean = Vector::zeros();
        for point in &problem.points {
            mean += point - box_centre;
        }
        let centre = box_centre + mean / count as f64;
        let size = power_of_two((most.x - least.x).max(most.y - least.y));
        let span = problem.end - problem.start;
        let step = power_of_two(span / count as f64);
        let total: f64 = problem.weights.iter().sum();
        let weight = if problem.weights.is_empty() { 1.0 } else { power_of_two(total / count as f64) };
        let mut scaled = Self {
            t: limits::with_room(count)?,
            x: limits::with_room(count)?,
            y: limits::with_room(count)?,
            w: limits::with_room(count)?,
            length: span / step,
            closed: problem.closed,
            beyond: 0.0,
            components: Vec::new(),
            centre,
            start: problem.start,
            size,
            step,
            weight,
        };
        scaled.t.extend(problem.parameters.iter().map(|t| (t - problem.start) / step));
        scaled.x.extend(problem.points.iter().map(|p| (p.x - centre.x) / size));
        scaled.y.extend(problem.points.iter().map(|p| (p.y - centre.y) / size));
        scaled.w.extend(problem.weights.iter().map(|w| w / weight));
        scaled.w.resize(count, 1.0);
        for component in &problem.components {
            let mut grid = limits::with_room(component.grid.len())?;
            grid.extend(component.grid.iter().map(|place| (place - problem.start) / step));
            let degree = component.degree;
            let mut scaled_component =
                ScaledComponent { degree, lambda: 0.0, grid, first_sample: Vec::new() };
            scaled_component.lambda = component.lambda * scaled.lambda_factor(degree);
            scaled.components.push(scaled_component);
        }
        scaled.find_samples()?;
        Ok(scaled)
    }

    /// Finds the first sample of every place.
    pub(crate) fn find_samples(&mut self) -> Result<()> {
        for component in &mut self.components {
            component.first_sample = limits::with_room(component.grid.len() + 1)?;
            let mut sample = 0;
            for &place in &component.grid {
                while sample < self.t.len() && self.t[sample] < place {
                    sample += 1;
                }
                component.first_sample.push(sample);
            }
            component.first_sample.push(self.t.len());
        }
        Ok(())
    }

    /// λ here for a λ of 1 of the caller.
    pub(crate) fn lambda_factor(&self, degree: usize) -> f64 {
        let mut factor = 1.0 / (self.weight * self.size);
        for _ in 0..degree {
            factor /= self.step;
        }
        factor
    }

    /// The caller's objective for an objective of 1 here.
    pub(crate) fn objective_factor(&self) -> f64 {
        self.weight * self.size * self.size
    }
}
