//! Uniform sampling of interpolating and B-spline curves, block by block.
//!
//! On a piece the curve is in the space of its roots, which has n₀ dimensions. About the middle of a block
//!
//! ```text
//! r(a ± τ) = Σ r⁽ʲ⁾(a) e_j(τ), j even  ±  Σ r⁽ʲ⁾(a) e_j(τ), j odd
//! ```
//!
//! with the functions e_j of the space that have e_j⁽ⁱ⁾(0) = δᵢⱼ, i < n₀; they have the parity of j because the list of roots is
//! symmetric. They are the same for all blocks: one table serves all of a sampling (D 9.10). A block costs n₀ derivatives at
//! its middle, and then two points at a time cost n₀ multiplications for each coordinate, whatever the number of weights.

use std::sync::Arc;

use super::b_spline::BSplineCurve;
use super::interpolating::InterpolatingCurve;
use super::lattice::{Lattice, Place, Shape};
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, check, filled, too_many};

/// Pairs of samples in the largest block.
const PAIRS: usize = 128;
/// Terms of the Taylor sums of e_j, beyond their first: (10/4)³⁰/30! and less is left.
const TERMS: usize = 40;

/// Samples curves uniformly and remembers its tables from one call to the next.
///
/// The results do not depend on what it remembers, nor on how a sampling is cut into ranges.
#[derive(Clone, Debug, Default)]
pub struct SplineSampler {
    /// What the tables were made for: they hold while this is alive.
    shape: Option<Arc<Shape>>,
    /// From sample to sample, in units of a piece.
    step: f64,
    /// e_j − δ₀ⱼ at τ = step·(k + ½) for blocks of even size and step·(k + 1) for odd ones; even j first. Row by row.
    tables: [Vec<f64>; 2],
    built: [usize; 2],
    /// Taylor coefficients of e_j, `TERMS` each.
    series: Vec<f64>,
    /// Weights of the derivatives at the middle of a block, for either part of a cell, and where that is.
    weights: [Vec<f64>; 2],
    places: [f64; 2],
    /// Derivatives at the middle of a block.
    jet: Vec<f64>,
}

/// How samples fall on pieces: sample i at i·pieces/steps, in whole numbers.
#[derive(Clone, Copy, Debug)]
struct Fall {
    pieces: u64,
    steps: u64,
    count: usize,
}

impl Fall {
    fn new(lattice: &Lattice, count: usize) -> Self {
        let steps = if lattice.closed { count } else { count.saturating_sub(1) }.max(1) as u64;
        Self { pieces: lattice.piece_count() as u64, steps, count }
    }

    fn piece_of(&self, i: usize) -> usize {
        (i as u64 * self.pieces / self.steps).min(self.pieces - 1) as usize
    }

    /// The first sample on piece p, or the number of samples for the piece beyond the last.
    fn first(&self, p: usize) -> usize {
        if p as u64 >= self.pieces {
            self.count
        } else {
            (p as u64 * self.steps).div_ceil(self.pieces) as usize
        }
    }

    /// Where on piece p half/2 samples from the start are, −1/2 to 1/2.
    fn y(&self, p: usize, half: usize) -> f64 {
        let place = half as f64 * self.pieces as f64 - 2.0 * p as f64 * self.steps as f64;
        place / (2.0 * self.steps as f64) - 0.5
    }
}

impl SplineSampler {
    /// A sampler that remembers nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Samples `first`, `first + 1`, … of the uniform sampling of `curve` by `count` points, or of a derivative, as many as
    /// `out` has room for, interleaved.
    ///
    /// Sample i lies at i/count of the parameter range of a closed curve, at i/(count − 1) of an open one.
    ///
    /// # Accuracy
    ///
    /// Within 1e-14·(1 + Σ|λ|) of the points' size of [`InterpolatingCurve::evaluate_into`]; samples at a point are that point
    /// to the last bit (`tests/spline_sampling.rs`).
    ///
    /// # Errors
    ///
    /// More than 4 million points; a derivative above n₀ − 1.
    pub fn interpolating(
        &mut self,
        curve: &InterpolatingCurve,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        self.run(curve.lattice(), count, first, derivative, out)
    }

    /// The same for a B-spline curve.
    ///
    /// # Errors
    ///
    /// As [`Self::interpolating`].
    pub fn b_spline(
        &mut self,
        curve: &BSplineCurve,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        self.run(curve.lattice(), count, first, derivative, out)
    }

    /// A whole sampling, with tables that are forgotten.
    pub(super) fn all(lattice: &Lattice, count: usize, derivative: usize) -> Result<Vec<f64>> {
        // A count that is refused needs no room.
        let room = if count > MOST_OUTPUT_POINTS { 0 } else { count };
        let mut points = filled(0.0, lattice.dimension * room)?;
        Self::new().run(lattice, count, 0, derivative, &mut points)?;
        Ok(points)
    }

    #[inline(never)]
    fn run(
        &mut self,
        lattice: &Lattice,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        let dimension = lattice.dimension;
        let most = (lattice.shape.roots.order() - 1).max(2);
        check("derivative", None, derivative as f64, 0.0, most as f64)?;
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        if out.len() % dimension != 0 {
            return Err(Error::wrong_length("out", out.len(), out.len() / dimension * dimension));
        }
        let end = count.min(first.saturating_add(out.len() / dimension));
        if first >= end {
            return Ok(());
        }
        let fall = Fall::new(lattice, count);
        self.suit(&lattice.shape, fall.pieces as f64 / fall.steps as f64);
        let (mut i, mut rest) = (first, out);
        let mut piece = fall.piece_of(i);
        while i < end {
            let (start, stop) = (fall.first(piece), fall.first(piece + 1));
            while i < stop.min(end) {
                let begin = i - (i - start) % (2 * PAIRS);
                let size = (2 * PAIRS).min(stop - begin);
                let number = (size - (i - begin)).min(end - i);
                let (now, later) = rest.split_at_mut(number * dimension);
                let y = fall.y(piece, 2 * begin + size - 1);
                self.take(lattice, piece, y, derivative, size);
                if number == size {
                    self.fill(dimension, size, now);
                } else {
                    self.fill_part(dimension, size, i - begin, now);
                }
                // Samples on points are the points.
                for (k, edge) in [(begin, 0), (begin + size - 1, number - 1)] {
                    let place = fall.place(lattice, piece, k);
                    if derivative == 0 && (i..i + number).contains(&k) && lattice.on_point(place) {
                        lattice.value(place, 0, &mut now[edge * dimension..(edge + 1) * dimension]);
                    }
                }
                (i, rest) = (i + number, later);
            }
            piece += 1;
        }
        Ok(())
    }

    /// Forgets tables of other curves.
    fn suit(&mut self, shape: &Arc<Shape>, step: f64) {
        let same = self.shape.as_ref().is_some_and(|known| Arc::ptr_eq(known, shape));
        if !same {
            self.places = [f64::NAN; 2];
            self.series = series(shape);
            self.shape = Some(shape.clone());
        }
        if !same || self.step != step {
            self.built = [0; 2];
            self.step = step;
        }
    }

    /// Derivatives at y on a piece, by y but in the scale of the parameter: value first, as many as the space has dimensions.
    fn take(&mut self, lattice: &Lattice, piece: usize, y: f64, derivative: usize, size: usize) {
        let Some(shape) = self.shape.clone() else { return };
        let (dimension, order) = (lattice.dimension, shape.roots.order());
        let (cell, part) = (piece / shape.per_cell, piece % shape.per_cell);
        if self.places[part] != y {
            self.places[part] = y;
            self.weights[part].clear();
            for j in 0..order {
                self.weights[part].extend((0..shape.window).map(|k| shape.weight(k, part, y, j)));
            }
        }
        let window = lattice.window(cell);
        let near = shape.nearest(part, 0.0) * dimension;
        self.jet.clear();
        self.jet.resize(order * dimension, 0.0);
        // A single sample needs its value only.
        let rows = if size == 1 && derivative == 0 { 1 } else { order };
        let weights = self.weights[part].chunks_exact(shape.window).take(rows);
        for (jet, weights) in self.jet.chunks_exact_mut(dimension).zip(weights) {
            for (weight, point) in weights.iter().zip(window.chunks_exact(dimension)) {
                for (d, (sum, x)) in jet.iter_mut().zip(point).enumerate() {
                    *sum += weight * if shape.constants { x - window[near + d] } else { *x };
                }
            }
        }
        if shape.constants {
            for (value, x) in self.jet.iter_mut().zip(&window[near..near + dimension]) {
                *value += x;
            }
        }
        let unit = shape.per_cell as f64 / lattice.step;
        for _ in 0..derivative {
            self.differentiate(&shape, dimension, unit);
        }
    }

    /// Makes the jet that of the derivative: the last one follows from the differential equation.
    fn differentiate(&mut self, shape: &Shape, dimension: usize, unit: f64) {
        let last = self.jet.len() - dimension;
        for d in 0..dimension {
            let mut next = 0.0;
            for (j, c) in shape.characteristic.iter().enumerate() {
                next -= c * self.jet[j * dimension + d];
            }
            for at in (d..last).step_by(dimension) {
                self.jet[at] = unit * self.jet[at + dimension];
            }
            self.jet[last + d] = unit * next;
        }
    }
}

impl Fall {
    /// Where sample i is.
    fn place(&self, lattice: &Lattice, piece: usize, i: usize) -> Place {
        let per_cell = lattice.shape.per_cell;
        Place { cell: piece / per_cell, part: piece % per_cell, y: self.y(piece, 2 * i) }
    }
}

impl SplineSampler {
    /// How many even and how many odd rows the tables have.
    fn rows(&self) -> (usize, usize) {
        let Some(shape) = &self.shape else { return (0, 0) };
        let order = shape.roots.order();
        (order.div_ceil(2) - usize::from(shape.constants), order / 2)
    }

    /// The derivative whose factor is in row k of the tables.
    fn order_of(&self, k: usize) -> usize {
        let (even, _) = self.rows();
        let skipped = self.shape.as_ref().map_or(0, |shape| usize::from(shape.constants));
        if k < even { 2 * (k + skipped) } else { 2 * (k - even) + 1 }
    }

    /// Makes sure that the tables for blocks of this parity hold at least `pairs` places.
    #[inline(never)]
    fn build(&mut self, parity: usize, pairs: usize) {
        let (even, odd) = self.rows();
        self.tables[parity].resize((even + odd) * PAIRS, 0.0);
        for k in 0..even + odd {
            let j = self.order_of(k);
            let series = &self.series[j * TERMS..(j + 1) * TERMS];
            for place in self.built[parity]..pairs {
                let tau = self.step * if parity == 0 { place as f64 + 0.5 } else { place as f64 + 1.0 };
                let mut sum = 0.0;
                // What is 1 in e₀ is left out.
                for &c in series.iter().skip(usize::from(j == 0)).rev() {
                    sum = sum * tau + c;
                }
                self.tables[parity][k * PAIRS + place] = if j == 0 { sum * tau } else { sum };
            }
        }
        self.built[parity] = pairs;
    }

    /// One block, pairs of samples from its middle outwards.
    fn fill(&mut self, dimension: usize, size: usize, samples: &mut [f64]) {
        let (pairs, parity) = (size / 2, size % 2);
        if self.built[parity] < pairs {
            self.build(parity, pairs);
        }
        let (left, right) = samples.split_at_mut(pairs * dimension);
        let (middle, right) = right.split_at_mut(parity * dimension);
        middle.copy_from_slice(&self.jet[..middle.len()]);
        if pairs == 0 {
            return;
        }
        let (even, odd) = self.rows();
        match (dimension, even, odd) {
            (2, 1, 1) => self.pairs::<1, 1>(parity, left, right),
            (2, 1, 2) => self.pairs::<1, 2>(parity, left, right),
            (2, 2, 2) => self.pairs::<2, 2>(parity, left, right),
            _ => self.any_pairs(dimension, parity, left, right),
        }
    }

    /// Samples of a block from `skipped` on, where a range of samples begins or ends within it.
    #[cold]
    #[inline(never)]
    fn fill_part(&mut self, dimension: usize, size: usize, skipped: usize, samples: &mut [f64]) {
        let mut block = [0.0; 6 * PAIRS];
        self.fill(dimension, size, &mut block[..size * dimension]);
        let skipped = skipped * dimension;
        samples.copy_from_slice(&block[skipped..skipped + samples.len()]);
    }

    /// Row k of the tables, and the derivative that it multiplies.
    fn row(&self, parity: usize, k: usize, pairs: usize, dimension: usize) -> (&[f64], &[f64]) {
        let j = self.order_of(k) * dimension;
        (&self.tables[parity][k * PAIRS..k * PAIRS + pairs], &self.jet[j..j + dimension])
    }

    /// The samples at middle ± τ in the plane, for E even and O odd rows. Compilers make vector code of it.
    #[inline(never)]
    fn pairs<const E: usize, const O: usize>(&self, parity: usize, left: &mut [f64], right: &mut [f64]) {
        let (left, right) = (left.as_chunks_mut::<2>().0, right.as_chunks_mut::<2>().0);
        let pairs = left.len().min(PAIRS);
        let row = |k: usize| self.row(parity, k, pairs, 2);
        let value = [self.jet[0], self.jet[1]];
        let even: [_; E] = core::array::from_fn(row);
        let odd: [_; O] = core::array::from_fn(|k| row(E + k));
        let even = even.map(|(table, jet)| (&table[..pairs], [jet[0], jet[1]]));
        let odd = odd.map(|(table, jet)| (&table[..pairs], [jet[0], jet[1]]));
        for (p, (left, right)) in left.iter_mut().rev().zip(right).enumerate().take(pairs) {
            for d in 0..2 {
                let (mut sum, mut difference) = (value[d], 0.0);
                for (table, jet) in &even {
                    sum += jet[d] * table[p];
                }
                for (table, jet) in &odd {
                    difference += jet[d] * table[p];
                }
                (left[d], right[d]) = (sum - difference, sum + difference);
            }
        }
    }

    /// The same for any dimension and any number of rows, row by row.
    #[inline(never)]
    fn any_pairs(&self, dimension: usize, parity: usize, left: &mut [f64], right: &mut [f64]) {
        let (even, odd) = self.rows();
        let pairs = left.len() / dimension;
        for (left, right) in left.chunks_exact_mut(dimension).rev().zip(right.chunks_exact_mut(dimension)) {
            right.copy_from_slice(&self.jet[..dimension]);
            left.fill(0.0);
        }
        // Sums go to the right, differences to the left.
        for k in 0..even + odd {
            let (table, jet) = self.row(parity, k, pairs, dimension);
            let places = left.chunks_exact_mut(dimension).rev().zip(right.chunks_exact_mut(dimension));
            for ((left, right), factor) in places.zip(table) {
                let slots = if k < even { right } else { left };
                for (slot, c) in slots.iter_mut().zip(jet) {
                    *slot += c * factor;
                }
            }
        }
        for (left, right) in left.chunks_exact_mut(dimension).rev().zip(right.chunks_exact_mut(dimension)) {
            for (left, right) in left.iter_mut().zip(right) {
                (*left, *right) = (*right - *left, *right + *left);
            }
        }
    }
}

/// The Taylor coefficients of e_j for all j, `TERMS` each: e_j⁽ᵐ⁺ⁿ⁾ = −Σ χᵢ e_j⁽ᵐ⁺ⁱ⁾.
#[inline(never)]
fn series(shape: &Shape) -> Vec<f64> {
    let order = shape.characteristic.len();
    let mut all = vec![0.0; order * TERMS];
    for (j, row) in all.chunks_exact_mut(TERMS).enumerate() {
        row[j] = 1.0;
        for m in order..TERMS {
            let before = &row[m - order..m];
            row[m] = -shape.characteristic.iter().zip(before).map(|(c, y)| c * y).sum::<f64>();
        }
        let mut factorial = 1.0;
        for (q, c) in row.iter_mut().enumerate() {
            factorial *= q.max(1) as f64;
            *c /= factorial;
        }
    }
    all
}
