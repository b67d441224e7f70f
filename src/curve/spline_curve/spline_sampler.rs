//! Uniform sampling of interpolating and B-spline curves, block by block.
//!
//! On a piece the curve is in the space of its roots, which has n₀ dimensions. About the middle of a block
//!
//! ```text
//! r(a ± τ) = Σ r⁽ʲ⁾(a) eⱼ(τ), j even  ±  Σ r⁽ʲ⁾(a) eⱼ(τ), j odd
//! ```
//!
//! with the functions eⱼ of the space that have eⱼ⁽ⁱ⁾(0) = δᵢⱼ, i < n₀; they have the parity of j because the list of
//! roots is symmetric. They are the same for all blocks: one table serves all of a sampling (D 9.10). A block costs n₀
//! derivatives at its middle, and then two points at a time cost n₀ multiplications for each coordinate, whatever the
//! number of weights.

use std::sync::Arc;

use super::fall::Fall;
use super::lattice::{Lattice, Shape};
use super::taylor::{every_other, series, shift};
use super::{Generator, SplineCurve};
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, MOST_ROOTS, check, filled, too_many};

/// Pairs of samples in the largest block.
const PAIRS: usize = 256;
/// Pairs that are worked on at once.
const TILE: usize = 4;
/// Blocks whose matrices are remembered.
const SLOTS: usize = 16;

/// Samples curves uniformly and remembers its tables from one call to the next.
///
/// The results do not depend on what it remembers, nor on how a sampling is cut into ranges.
#[derive(Clone, Debug, Default)]
pub struct SplineSampler {
    /// What the tables were made for: they hold while this is alive.
    shape: Option<Arc<Shape>>,
    /// From sample to sample, in units of a piece.
    step: f64,
    /// eⱼ − δ₀ⱼ at τ = step·(k + ½) for blocks of even size and step·(k + 1) for odd ones; even j first. Row by row.
    tables: [Vec<f64>; 2],
    built: [usize; 2],
    /// How many even and how many odd rows they have, and the first even j.
    rows: (usize, usize),
    skipped: usize,
    /// Taylor coefficients of eⱼ: of every other power from j mod 2 on, `terms` each.
    series: Vec<f64>,
    terms: usize,
    /// What every control point weighs in the derivatives at the middle of a piece, for either part of a cell.
    weights: [Vec<f64>; 2],
    /// What the derivatives at the middle of a piece make of those at the middle of a block, and where that is.
    shifts: [Vec<f64>; SLOTS],
    places: [f64; SLOTS],
    /// Derivatives at the middle of a block.
    jet: Vec<[f64; 3]>,
}

impl SplineSampler {
    /// A sampler that remembers nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Samples `first`, `first + 1`, … of the uniform sampling of `curve` by `count` points, or of a derivative, as
    /// many as `out` has room for, interleaved.
    ///
    /// Sample i lies at i/count of the parameter range of a closed curve, at i/(count − 1) of an open one.
    ///
    /// # Accuracy
    ///
    /// Within 1e-14·(1 + Σ|λ|) of the points' size of [`SplineCurve::evaluate_into`]; samples at a point are that point
    /// to the last bit (`tests/curve/spline_sampling.rs`).
    ///
    /// # Errors
    ///
    /// More than 4 million points; a derivative above n₀ − 1 and above 2.
    pub fn points<G: Generator>(
        &mut self,
        curve: &SplineCurve<G>,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        self.run(&curve.lattice, count, first, derivative, out, false).map(|_| ())
    }

    /// The same for who wants all samples in ranges of any length: as many as fit without cutting a block in two, which
    /// is half the work. Returns how many; not 0 while there are any and room for 512.
    ///
    /// # Errors
    ///
    /// Those of [`SplineSampler::points`].
    pub fn blocks<G: Generator>(
        &mut self,
        curve: &SplineCurve<G>,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
    ) -> Result<usize> {
        self.run(&curve.lattice, count, first, derivative, out, true)
    }

    /// A whole sampling, with tables that are forgotten.
    pub(super) fn all(lattice: &Lattice, count: usize, derivative: usize) -> Result<Vec<f64>> {
        // A count that is refused needs no room.
        let room = if count > MOST_OUTPUT_POINTS { 0 } else { count };
        let mut points = filled(0.0, lattice.dimension * room)?;
        Self::new().run(lattice, count, 0, derivative, &mut points, false)?;
        Ok(points)
    }

    /// Walks the pieces that the range touches, a block at a time. Returns how many samples were made: where only whole
    /// blocks are wanted, those that fit.
    #[inline(never)]
    fn run(
        &mut self,
        lattice: &Lattice,
        count: usize,
        first: usize,
        derivative: usize,
        out: &mut [f64],
        whole: bool,
    ) -> Result<usize> {
        let dimension = lattice.dimension;
        let most = (lattice.shape.roots.order() - 1).max(2);
        check("derivative", None, derivative as f64, 0.0, most as f64)?;
        if count > MOST_OUTPUT_POINTS {
            return Err(too_many("count", "maxOutputPoints", MOST_OUTPUT_POINTS, count));
        }
        if !out.len().is_multiple_of(dimension) {
            return Err(Error::wrong_length("out", out.len(), out.len() / dimension * dimension));
        }
        let end = count.min(first.saturating_add(out.len() / dimension));
        if first >= end {
            return Ok(0);
        }
        let fall = Fall::new(lattice, count);
        let shape = &*lattice.shape;
        self.suit(&lattice.shape, fall.pieces as f64 / fall.steps as f64);
        let (mut i, mut rest) = (first, out);
        let mut piece = fall.piece_of(i);
        let mut start = fall.first(piece);
        while i < end {
            let stop = fall.first(piece + 1);
            // Blocks at the same place of their pieces recur: with each piece, or where each has one block after some.
            let mut slot = if stop - start <= 2 * PAIRS { piece } else { shape.part_of(piece).1 };
            while i < stop.min(end) {
                let skipped = (i - start) & (2 * PAIRS - 1);
                let begin = i - skipped;
                let size = (2 * PAIRS).min(stop - begin);
                let number = (size - skipped).min(end - i);
                if whole && number < size - skipped && i > first {
                    return Ok(i - first);
                }
                let (now, later) = rest.split_at_mut(number * dimension);
                self.turn(fall.y(piece, 2 * begin + size - 1), slot & (SLOTS - 1));
                self.take(lattice, piece, slot & (SLOTS - 1));
                for _ in 0..derivative {
                    self.differentiate(shape, shape.per_cell as f64 / lattice.step);
                }
                if number == size {
                    self.fill(dimension, size, now);
                } else {
                    self.fill_part(dimension, size, skipped, now);
                }
                if derivative == 0 && shape.interpolating {
                    // Samples on points are the points: the first of a piece, or the last of all.
                    for (k, edge) in [(begin, 0), (count - 1, number - 1)] {
                        if k == i + edge && (edge == 0 || i + number == count) {
                            fall.settle(
                                lattice,
                                piece,
                                k,
                                &mut now[edge * dimension..(edge + 1) * dimension],
                            );
                        }
                    }
                }
                (i, rest, slot) = (i + number, later, slot + 2);
            }
            (piece, start) = (piece + 1, stop);
        }
        Ok(end - first)
    }

    /// Forgets tables of other curves.
    fn suit(&mut self, shape: &Arc<Shape>, step: f64) {
        let same = self.shape.as_ref().is_some_and(|known| Arc::ptr_eq(known, shape));
        if !same {
            self.places = [f64::NAN; SLOTS];
            (self.series, self.terms) = series(shape);
            for (part, weights) in self.weights.iter_mut().enumerate().take(shape.per_cell) {
                weights.clear();
                for k in 0..shape.window {
                    weights.extend((0..shape.characteristic.len()).map(|j| shape.weight(k, part, 0.0, j)));
                }
            }
            let (order, constants) = (shape.characteristic.len(), usize::from(shape.constants));
            self.rows = (order.div_ceil(2) - constants, order / 2);
            self.skipped = 2 * constants;
            self.shape = Some(shape.clone());
        }
        if !same || self.step != step {
            self.built = [0; 2];
            self.step = step;
        }
    }

    /// Makes the matrix in a slot that of y.
    #[inline]
    fn turn(&mut self, y: f64, slot: usize) {
        if self.places[slot] != y {
            self.places[slot] = y;
            let Some(shape) = &self.shape else { return };
            shift(&self.series, self.terms, &shape.characteristic, y, &mut self.shifts[slot]);
        }
    }

    /// Derivatives at the middle of a block: value first, as many as the space has dimensions; z is 0 in the plane.
    #[inline(never)]
    fn take(&mut self, lattice: &Lattice, piece: usize, slot: usize) {
        let shape = &*lattice.shape;
        let (cell, part) = shape.part_of(piece);
        let window = lattice.window(cell);
        let near = shape.nearest(part, 0.0) * lattice.dimension;
        // Where nothing sums to 1, differences from 0.
        let near = if shape.constants { lifted(&window[near..near + lattice.dimension]) } else { [0.0; 3] };
        let (mut middle, order) = ([[0.0; 3]; MOST_ROOTS], shape.characteristic.len());
        let weights = self.weights[part].chunks_exact(order);
        for (point, weights) in window.chunks_exact(lattice.dimension).zip(weights) {
            let mut point = lifted(point);
            add(&mut point, &near, -1.0);
            for (sums, weight) in middle.iter_mut().zip(weights) {
                add(sums, &point, *weight);
            }
        }
        self.jet.clear();
        for factors in self.shifts[slot].chunks_exact(order) {
            let mut sums = if self.jet.is_empty() { near } else { [0.0; 3] };
            for (factor, derivatives) in factors.iter().zip(&middle) {
                add(&mut sums, derivatives, *factor);
            }
            self.jet.push(sums);
        }
    }

    /// Makes the jet that of the derivative: the last one follows from the differential equation.
    fn differentiate(&mut self, shape: &Shape, unit: f64) {
        let mut last = [0.0; 3];
        for (jet, c) in self.jet.iter().zip(&shape.characteristic) {
            add(&mut last, jet, -c);
        }
        self.jet.push(last);
        self.jet.remove(0);
        for jet in self.jet.as_flattened_mut() {
            *jet *= unit;
        }
    }
}

#[inline(always)]
fn lifted(point: &[f64]) -> [f64; 3] {
    match *point {
        [x, y] => [x, y, 0.0],
        [x, y, z, ..] => [x, y, z],
        _ => [0.0; 3],
    }
}

#[inline(always)]
fn add(sums: &mut [f64; 3], numbers: &[f64; 3], factor: f64) {
    for (sum, x) in sums.iter_mut().zip(numbers) {
        *sum += factor * x;
    }
}

impl SplineSampler {
    /// The derivative whose factor is in row k of the tables.
    fn order_of(&self, k: usize) -> usize {
        if k < self.rows.0 { 2 * k + self.skipped } else { 2 * (k - self.rows.0) + 1 }
    }

    /// Makes sure that the tables for blocks of this parity hold at least `pairs` places.
    #[inline(never)]
    fn build(&mut self, parity: usize, pairs: usize) {
        let (even, odd) = self.rows;
        self.tables[parity].resize((even + odd) * PAIRS, 0.0);
        for k in 0..even + odd {
            let j = self.order_of(k);
            let series = &self.series[j * self.terms..(j + 1) * self.terms];
            for place in self.built[parity]..pairs {
                let tau = self.step * if parity == 0 { place as f64 + 0.5 } else { place as f64 + 1.0 };
                // What is 1 in e₀ is left out.
                let (skipped, factor) = if j == 0 { (1, tau * tau) } else { (0, 1.0) };
                let value = every_other(&series[skipped..], tau, j) * factor;
                self.tables[parity][k * PAIRS + place] = value;
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
        middle.copy_from_slice(&self.jet[0][..middle.len()]);
        if pairs == 0 {
            return;
        }
        let done = match (dimension, self.rows) {
            (2, (1, 1)) => self.few_rows::<1>(parity, left, right),
            (2, (1, 2)) => self.few_rows::<2>(parity, left, right),
            (2, _) => self.tiles(parity, left, right),
            _ => 0,
        };
        for p in done..pairs {
            let (mut sum, mut difference) = (self.jet[0], [0.0; 3]);
            for k in 0..self.rows.0 + self.rows.1 {
                let into = if k < self.rows.0 { &mut sum } else { &mut difference };
                add(into, &self.jet[self.order_of(k)], self.tables[parity][k * PAIRS + p]);
            }
            for d in 0..dimension {
                left[(pairs - 1 - p) * dimension + d] = sum[d] - difference[d];
                right[p * dimension + d] = sum[d] + difference[d];
            }
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

    /// The samples at middle ± τ in the plane where there are one even and at most two odd rows, as for 3 and 4 roots,
    /// and how many pairs there were. Compilers make vector code of it: it is on its own so that they see that nothing
    /// overlaps.
    #[inline(never)]
    fn few_rows<const ODD: usize>(&self, parity: usize, left: &mut [f64], right: &mut [f64]) -> usize {
        let (left, right) = (left.as_chunks_mut::<2>().0, right.as_chunks_mut::<2>().0);
        let pairs = left.len();
        let [value, even, odd] = [0, self.order_of(0), 1].map(|j| self.jet[j]);
        let third = if ODD == 2 { self.jet[3] } else { [0.0; 3] };
        let table = |k: usize| &self.tables[parity][k * PAIRS..k * PAIRS + pairs];
        let tables = table(0).iter().zip(table(1)).zip(table(ODD));
        for (((first, second), last), (left, right)) in tables.zip(left.iter_mut().rev().zip(right)) {
            for d in 0..2 {
                let sum = value[d] + even[d] * first;
                let slope = odd[d] * second;
                let difference = if ODD == 2 { slope + third[d] * last } else { slope };
                (left[d], right[d]) = (sum - difference, sum + difference);
            }
        }
        pairs
    }

    /// The same for any number of rows, some pairs at a time.
    #[inline(never)]
    fn tiles(&self, parity: usize, left: &mut [f64], right: &mut [f64]) -> usize {
        let (even, odd) = self.rows;
        let [x, y, _] = self.jet[0];
        let places = left.rchunks_exact_mut(2 * TILE).zip(right.chunks_exact_mut(2 * TILE));
        let mut rows: [(&[f64], [f64; 2]); MOST_ROOTS] = [(&[], [0.0; 2]); MOST_ROOTS];
        for (k, (table, row)) in self.tables[parity].chunks_exact(PAIRS).zip(&mut rows).enumerate() {
            let [x, y, _] = self.jet[self.order_of(k)];
            *row = (table, [x, y]);
        }
        let mut first = 0;
        for (left, right) in places {
            let sums = combined(&rows[..even], first, [x, y]);
            let differences = combined(&rows[even..even + odd], first, [0.0; 2]);
            let places = left.rchunks_exact_mut(2).zip(right.chunks_exact_mut(2));
            for ((sum, difference), (left, right)) in sums.iter().zip(&differences).zip(places) {
                for d in 0..2 {
                    (left[d], right[d]) = (sum[d] - difference[d], sum[d] + difference[d]);
                }
            }
            first += TILE;
        }
        first
    }
}

/// Start and the sum over these rows of derivative and factor, for pairs `first` to `first` + TILE.
#[inline(always)]
fn combined(rows: &[(&[f64], [f64; 2])], first: usize, start: [f64; 2]) -> [[f64; 2]; TILE] {
    let mut sums = [start; TILE];
    for (table, jet) in rows {
        let Some(factors) = table.get(first..).and_then(|rest| rest.first_chunk::<TILE>()) else { continue };
        for (sum, factor) in sums.iter_mut().zip(factors) {
            for d in 0..2 {
                sum[d] += jet[d] * factor;
            }
        }
    }
    sums
}
