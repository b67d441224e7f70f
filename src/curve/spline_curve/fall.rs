//! How uniform samples fall on the pieces of curves on a lattice.

use super::lattice::{Lattice, Place};
use crate::numerics::lists::steps;

/// How samples fall on pieces: sample i at i·pieces/steps, in whole numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fall {
    pub(super) pieces: u64,
    pub(super) steps: u64,
    count: usize,
    /// Samples on each piece, if they divide evenly; else 0.
    each: usize,
}

impl Fall {
    pub(super) fn new(lattice: &Lattice, count: usize) -> Self {
        let steps = steps(count, lattice.closed) as u64;
        let pieces = lattice.piece_count() as u64;
        let each = if steps.is_multiple_of(pieces) { (steps / pieces) as usize } else { 0 };
        Self { pieces, steps, count, each }
    }

    pub(super) fn piece_of(&self, i: usize) -> usize {
        (i as u64 * self.pieces / self.steps).min(self.pieces - 1) as usize
    }

    /// The first sample on piece p, or the number of samples for the piece beyond the last.
    pub(super) fn first(&self, p: usize) -> usize {
        if p as u64 >= self.pieces {
            self.count
        } else if self.each > 0 {
            p * self.each
        } else {
            (p as u64 * self.steps).div_ceil(self.pieces) as usize
        }
    }

    /// Where on piece p half/2 samples from the start are, −1/2 to 1/2; the same on all pieces if they are filled
    /// evenly.
    pub(super) fn y(&self, p: usize, half: usize) -> f64 {
        let place = half as f64 * self.pieces as f64 - 2.0 * p as f64 * self.steps as f64;
        place / (2.0 * self.steps as f64) - 0.5
    }

    /// Puts a point of the curve in the place of its sample.
    pub(super) fn settle(&self, lattice: &Lattice, piece: usize, i: usize, sample: &mut [f64]) {
        let (cell, part) = lattice.shape.part_of(piece);
        let place = Place { cell, part, y: self.y(piece, 2 * i) };
        if lattice.on_point(place) {
            lattice.value(place, 0, sample);
        }
    }
}
