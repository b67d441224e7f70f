//! Going back down: the nearest curve on a coarser grid, and how far away it is.

use super::b_spline::BSplineCurve;
use super::interpolating::InterpolatingCurve;
use super::lattice::{Grid, Lattice, check_points};
use super::spline_sampler::SplineSampler;
use crate::error::{Error, Result};
use crate::generator::affine_refinement_filter;
use crate::limits::{LARGEST_FACTOR, MOST_OUTPUT_POINTS, check, filled};
use crate::refine::{Target, least_squares};

/// Places per piece at which a change is looked at.
const LOOKS: usize = 8;
/// Of a closed curve.
const LEAST_CELLS: usize = 3;

impl BSplineCurve {
    /// The curve on the grid that is coarser by m whose refinement has the control points nearest to these, in the sum
    /// of squares, and the largest distance between the two curves, parameter by parameter.
    ///
    /// What was refined and not changed comes back.
    ///
    /// # Errors
    ///
    /// m not from 1 to 1024, or not a divisor of the number of cells, or so large that |im|·step ≥ π or the offset is
    /// not within ±1e9; a coarse grid of fewer than 3 closed cells; points that would not be within ±1e9.
    ///
    /// # Accuracy
    ///
    /// The distance is looked at in 8 places per cell, and between them by a parabola: to about 3e-3 of itself.
    ///
    /// # Source
    ///
    /// (D 9.11).
    pub fn reduce(&self, m: usize) -> Result<(Self, f64)> {
        check("m", None, m as f64, 1.0, LARGEST_FACTOR as f64)?;
        let lattice = &self.lattice;
        let (dimension, closed, order) = (self.dimension(), self.is_closed(), self.roots().order());
        if !lattice.cells.is_multiple_of(m) {
            return Err(Error::degenerate("m", None, "it does not divide the number of cells"));
        }
        self.check_factor(m, &|m| self.step() * m)?;
        let cells = lattice.cells / m;
        if closed && cells < LEAST_CELLS {
            return Err(Error::too_few("points", cells, LEAST_CELLS));
        }
        let count = if closed { cells } else { cells + order - 1 };
        let local = self.roots().divided(1.0 / (lattice.step * m as f64));
        let grid = Grid { step: lattice.step * m as f64, ..lattice.grid() };
        // Zeros that tell at once whether there is such a grid.
        let coarse =
            Self::with_roots(filled(0.0, count * dimension)?, dimension, closed, self.roots().clone(), grid)?;
        let filter = affine_refinement_filter(&local, m)?;
        let target = Target::finer(count, closed, order, m)?;
        let points = least_squares(&target, self.points(), dimension, m, &filter, coarse.points().len())?;
        check_points(&points, dimension, 1)?;
        let refined = target.fill(&points, dimension, m, &filter)?;
        let difference = refined.iter().zip(self.points()).map(|(a, b)| a - b).collect();
        Ok((coarse.with_points(points)?, self.with_points(difference)?.lattice.reach()?))
    }

    /// The interpolating curve through this one's points at the integers, and the largest distance between the two.
    ///
    /// Comes back exactly from [`InterpolatingCurve::refine`] as long as nothing was changed.
    ///
    /// # Errors
    ///
    /// `step` where the grid is not 1/2, 1/4, 1/6, … of a unit or does not start at 0, where a prime factor of that
    /// number is above 1024, or where the length is not whole; too few points, or roots without an interpolator.
    pub fn interpolating(&self) -> Result<(InterpolatingCurve, f64)> {
        let lattice = &self.lattice;
        let factor = (1.0 / lattice.step).round();
        let whole = (lattice.step * factor - 1.0).abs() < 1e-12 && lattice.start == 0.0;
        let m0 = factor as usize;
        if !whole || !m0.is_multiple_of(2) || m0 == 0 || !lattice.cells.is_multiple_of(m0) {
            return Err(Error::degenerate("step", None, "the grid is no even part of a unit from 0 on"));
        }
        let segments = lattice.cells / m0;
        let count = if self.is_closed() { segments } else { segments + 1 };
        let (_, end) = self.domain();
        let t: Vec<f64> = (0..count).map(|k| (k as f64).min(end)).collect();
        let mut points = filled(0.0, count * self.dimension())?;
        self.evaluate_into(&t, 0, &mut points)?;
        let roots = Some(self.roots().clone());
        let curve = InterpolatingCurve::new(points, self.dimension(), self.is_closed(), roots)?;
        let Some((first, others)) = factors(m0) else {
            return Err(Error::degenerate("step", None, "a prime factor of 1/step is above 1024"));
        };
        let mut refined = curve.refine(1, first, 2)?;
        for m in others {
            refined = refined.refine(m)?;
        }
        let difference = refined.points().iter().zip(self.points()).map(|(a, b)| a - b).collect();
        Ok((curve, self.with_points(difference)?.lattice.reach()?))
    }
}

/// An even number as a product of numbers to 1024 of which the first is even, if it is one.
fn factors(number: usize) -> Option<(usize, Vec<usize>)> {
    let divisor = |number: usize, most: usize| {
        (1..=most.min(number)).rev().find(|&divisor| number.is_multiple_of(divisor)).unwrap_or(1)
    };
    let first = divisor(number / 2, LARGEST_FACTOR / 2);
    let (mut rest, mut others) = (number / 2 / first, Vec::new());
    while rest > 1 {
        let next = divisor(rest, LARGEST_FACTOR);
        if next == 1 {
            return None;
        }
        rest /= next;
        others.push(next);
    }
    Some((2 * first, others))
}

impl Lattice {
    /// The largest distance from the origin: of parabolas through three of `LOOKS` places per piece, where they have a
    /// peak.
    fn reach(&self) -> Result<f64> {
        let places =
            (self.piece_count().saturating_mul(LOOKS) + usize::from(!self.closed)).min(MOST_OUTPUT_POINTS);
        let samples = SplineSampler::all(self, places, 0)?;
        let norm = |point: &[f64]| point.iter().map(|x| x * x).sum::<f64>().sqrt();
        let around = samples.len() - if self.closed { 2 * self.dimension } else { 0 };
        let before = samples[around..].chunks_exact(self.dimension);
        let (mut most, mut last) = (0.0_f64, [0.0; 2]);
        for (k, here) in before.chain(samples.chunks_exact(self.dimension)).map(norm).enumerate() {
            most = most.max(here);
            let [first, middle] = last;
            let bend = 2.0 * middle - first - here;
            if k > 1 && middle >= first && middle >= here && bend > 0.0 {
                most = most.max(middle + (here - first) * (here - first) / (8.0 * bend));
            }
            last = [middle, here];
        }
        Ok(most)
    }
}
