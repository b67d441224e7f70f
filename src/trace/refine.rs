//! Outlines moved until the coverage that they have is the coverage that the picture shows.

use super::coverage::{Band, Coverage};
use super::outline::Outline;
use super::skyline::Skyline;
use super::unknowns::{Column, Unknowns};
use crate::error::Result;
use crate::limits::filled;

/// Weight of staying where it is, in coverage per pixel, squared.
const DAMPING: f64 = 5e-3;
/// Nothing moves farther in one step, in pixels.
const LONGEST_STEP: f64 = 0.6;
/// Rounds of conjugate gradients: the factor knows all but pixels that two pieces share.
const ROUNDS: usize = 8;

/// All that the normal equations of one step are made of (D 14.4).
struct System {
    coverage: Coverage,
    /// The columns of all pieces, one after another, and where each piece's end.
    columns: Vec<Column>,
    ends: Vec<usize>,
    damping: Vec<f64>,
    factor: Skyline,
}

/// Moves the outlines by Gauss–Newton steps until `most` are done or nothing gets better; returns the root mean square of what is left.
pub(super) fn refine(outlines: &mut [Outline], band: &Band, most: usize) -> Result<f64> {
    let mut best = outlines.to_vec();
    let mut least = f64::MAX;
    let mut damping = DAMPING;
    for step in 0..=most {
        let coverage = band.cover(outlines)?;
        let rest = residual(&coverage, band);
        let square: f64 = rest.iter().map(|r| f64::from(*r) * f64::from(*r)).sum();
        if square < least {
            let done = least < f64::MAX && square > 0.9995 * least;
            least = square;
            best.clone_from_slice(outlines);
            damping = (0.5 * damping).max(0.2 * DAMPING);
            if done {
                break;
            }
        } else {
            outlines.clone_from_slice(&best);
            damping *= 8.0;
            if damping > 1e3 * DAMPING {
                break;
            }
            if step < most {
                let coverage = band.cover(outlines)?;
                let rest = residual(&coverage, band);
                advance(outlines, band, coverage, rest, damping)?;
            }
            continue;
        }
        if step < most {
            advance(outlines, band, coverage, rest, damping)?;
        }
    }
    outlines.clone_from_slice(&best);
    Ok((least / band.len().max(1) as f64).sqrt())
}

/// What the picture shows less what the outlines cover.
pub(super) fn residual(coverage: &Coverage, band: &Band) -> Vec<f32> {
    let mut values = coverage.values.clone();
    band.blur(&mut values, true);
    for (value, target) in values.iter_mut().zip(&band.target) {
        *value = target - *value;
    }
    values
}

/// What the outlines leave of the picture, pixel by pixel of the band.
pub(super) fn rest_of(outlines: &[Outline], band: &Band) -> Result<Vec<f32>> {
    Ok(residual(&band.cover(outlines)?, band))
}

fn advance(
    outlines: &mut [Outline],
    band: &Band,
    coverage: Coverage,
    mut rest: Vec<f32>,
    damping: f64,
) -> Result<()> {
    let mut numbering = Vec::new();
    let mut count = 0;
    for outline in outlines.iter() {
        let unknowns = Unknowns::new(outline, count);
        count = unknowns.end;
        numbering.push(unknowns);
    }
    let system = System::new(outlines, &numbering, coverage, count, damping)?;
    band.blur(&mut rest, false);
    let mut right = filled(0.0, count)?;
    system.gather(&rest, &mut right);
    let step = system.solve(band, right)?;
    for (outline, unknowns) in outlines.iter_mut().zip(&numbering) {
        unknowns.apply(outline, &step, LONGEST_STEP);
    }
    Ok(())
}

impl System {
    fn new(
        outlines: &[Outline],
        numbering: &[Unknowns],
        coverage: Coverage,
        count: usize,
        damping: f64,
    ) -> Result<Self> {
        let mut scales = filled(1.0, count)?;
        let (mut columns, mut ends, mut local) = (Vec::new(), Vec::new(), Vec::new());
        let mut first: Vec<usize> = (0..count).collect();
        for (outline, unknowns) in outlines.iter().zip(numbering) {
            unknowns.scales(outline, &mut scales);
            for i in 0..outline.len() {
                unknowns.columns(outline, i, &mut local);
                let least = local.iter().fold(usize::MAX, |least, column| least.min(column.0));
                for (unknown, _) in &local {
                    first[*unknown] = first[*unknown].min(least);
                }
                columns.extend_from_slice(&local);
                ends.push(columns.len());
            }
        }
        let damping: Vec<f64> = scales.iter().map(|scale| damping * scale.max(1e-6)).collect();
        let factor = Skyline::new(first)?;
        let mut system = Self { coverage, columns, ends, damping, factor };
        system.prepare();
        Ok(system)
    }

    /// The matrix without what two pieces share in one pixel, factored.
    fn prepare(&mut self) {
        self.factor.clear();
        for (piece, &end) in self.ends.iter().enumerate() {
            let columns = &self.columns[if piece == 0 { 0 } else { self.ends[piece - 1] }..end];
            let from = if piece == 0 { 0 } else { self.coverage.ends[piece - 1] };
            let mut square = [[0.0_f64; 8]; 8];
            for touch in &self.coverage.touches[from..self.coverage.ends[piece]] {
                let w = touch.weights.map(f64::from);
                for (row, a) in square.iter_mut().zip(w) {
                    for (entry, b) in row.iter_mut().zip(w) {
                        *entry += a * b;
                    }
                }
            }
            for (unknown, column) in columns {
                let image: [f64; 8] =
                    core::array::from_fn(|a| (0..8).map(|b| square[a][b] * column[b]).sum::<f64>());
                for (other, along) in columns.iter().filter(|(other, _)| other <= unknown) {
                    let value: f64 = image.iter().zip(along).map(|(a, b)| a * b).sum();
                    self.factor.add(*unknown, *other, value);
                }
            }
        }
        for (i, &value) in self.damping.iter().enumerate() {
            self.factor.add(i, i, value);
        }
        self.factor.factor();
    }

    fn pieces(&self) -> impl Iterator<Item = (&[Column], &[super::coverage::Touch])> {
        (0..self.ends.len()).map(|piece| {
            let (columns, touches) =
                if piece == 0 { (0, 0) } else { (self.ends[piece - 1], self.coverage.ends[piece - 1]) };
            (
                &self.columns[columns..self.ends[piece]],
                &self.coverage.touches[touches..self.coverage.ends[piece]],
            )
        })
    }

    /// What values of the pixels say to the unknowns: the transposed Jacobian.
    fn gather(&self, pixels: &[f32], unknowns: &mut [f64]) {
        for (columns, touches) in self.pieces() {
            let mut sum = [0.0; 8];
            for touch in touches {
                let value = f64::from(pixels[touch.pixel as usize]);
                for (sum, weight) in sum.iter_mut().zip(touch.weights) {
                    *sum += f64::from(weight) * value;
                }
            }
            for (unknown, column) in columns {
                unknowns[*unknown] += column.iter().zip(&sum).map(|(a, b)| a * b).sum::<f64>();
            }
        }
    }

    /// What a step of the unknowns does to the pixels: the Jacobian.
    fn scatter(&self, unknowns: &[f64], pixels: &mut [f32]) {
        for (columns, touches) in self.pieces() {
            let mut move_by = [0.0; 8];
            for (unknown, column) in columns {
                for (moved, along) in move_by.iter_mut().zip(column) {
                    *moved += unknowns[*unknown] * along;
                }
            }
            for touch in touches {
                let change: f64 = touch.weights.iter().zip(&move_by).map(|(&w, m)| f64::from(w) * m).sum();
                pixels[touch.pixel as usize] += change as f32;
            }
        }
    }

    /// Conjugate gradients, with the factored matrix to lead them.
    fn solve(&self, band: &Band, right: Vec<f64>) -> Result<Vec<f64>> {
        let count = right.len();
        let mut x = filled(0.0, count)?;
        let mut rest = right;
        let mut lead = rest.clone();
        self.factor.solve(&mut lead);
        let mut direction = lead.clone();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut energy = product(&rest, &lead);
        let first = energy;
        for _ in 0..ROUNDS {
            if energy.is_nan() || energy <= 1e-6 * first {
                break;
            }
            let mut pixels = vec![0.0_f32; band.len()];
            self.scatter(&direction, &mut pixels);
            band.blur(&mut pixels, false);
            band.blur(&mut pixels, false);
            let mut image: Vec<f64> = direction.iter().zip(&self.damping).map(|(d, w)| d * w).collect();
            self.gather(&pixels, &mut image);
            let curvature = product(&direction, &image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let length = energy / curvature;
            for i in 0..count {
                x[i] += length * direction[i];
                rest[i] -= length * image[i];
            }
            lead.clone_from(&rest);
            self.factor.solve(&mut lead);
            let next = product(&rest, &lead);
            let share = next / energy;
            energy = next;
            for i in 0..count {
                direction[i] = lead[i] + share * direction[i];
            }
        }
        Ok(x)
    }
}
