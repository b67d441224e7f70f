//! Curves with patches as the measures see them: cut at the knots of the base and of all patches.

use super::lattice::Lattice;
use super::local::{LocalCurve, Patch};
use crate::curve::contract::Curve;
use crate::curve::pieces::Pieces;
use crate::error::Result;
use crate::generator::recentre;
use crate::limits::with_room;
use crate::numerics::angle::wrapped;
use crate::numerics::order::sort_numbers;

impl LocalCurve {
    /// All knots: those of the base, and those of the patches within them.
    pub(super) fn cut(&self) -> Result<Vec<f64>> {
        let (start, end) = self.base.domain();
        let mut knots: Vec<f64> = with_room(self.base.piece_count() + 1)?;
        knots.extend((0..=self.base.piece_count()).map(|i| self.base.knot(i)));
        for patch in &self.patches {
            for i in 0..=patch.lattice.cells {
                let knot = self.wrapped(patch.lattice.knot(i));
                if (start..end).contains(&knot) {
                    knots.push(knot);
                }
            }
        }
        // All are multiples of a power of 2 and exact: equal ones are equal to the last bit.
        sort_numbers(&mut knots);
        knots.dedup();
        Ok(knots)
    }

    fn wrapped(&self, t: f64) -> f64 {
        let (_, end) = self.base.domain();
        if self.base.is_closed() { wrapped(t, end) } else { t }
    }

    /// Where t is on a patch; more than once if the patch reaches around the curve.
    pub(super) fn turns(&self, patch: &Patch, t: f64) -> impl Iterator<Item = f64> + use<> {
        let (start, end) = patch.lattice.domain();
        let (period, closed) = (self.base.domain().1, self.base.is_closed());
        let mut t = if closed { t - period * ((t - start) / period).floor() } else { t };
        core::iter::from_fn(move || {
            let inside = (start..=end).contains(&t).then_some(t);
            t = if closed { t + period } else { f64::INFINITY };
            inside
        })
    }

    /// Adds the part of a lattice that starts at its parameter `at` and is as long as from `from` to `to`.
    fn add_piece(&self, lattice: &Lattice, (from, to): (f64, f64), at: f64, out: &mut Vec<f64>) {
        let dimension = lattice.dimension;
        let length = lattice.step / lattice.shape.per_cell as f64;
        let middle = (at + 0.5 * (to - from) - lattice.start) / length;
        let piece = (middle as usize).min(lattice.piece_count() - 1);
        let mut own = Vec::new();
        lattice.piece_into(piece, &mut own);
        if out.len() < own.len() {
            out.resize(own.len(), 0.0);
        }
        let mut line = Vec::new();
        for d in 0..dimension {
            line.clear();
            line.extend(own.iter().skip(d).step_by(dimension));
            recentre(&mut line, middle - piece as f64 - 0.5);
            let mut power = 1.0;
            for (sum, c) in out.iter_mut().skip(d).step_by(dimension).zip(&line) {
                *sum += c * power;
                power *= (to - from) / length;
            }
        }
    }
}

impl Pieces for LocalCurve {
    fn coordinate_count(&self) -> usize {
        self.base.dimension()
    }

    fn closed(&self) -> bool {
        self.base.is_closed()
    }

    fn piece_count(&self) -> usize {
        self.knots.len() - 1
    }

    fn knot(&self, i: usize) -> f64 {
        self.knots[i]
    }

    fn coefficients(&self, i: usize, out: &mut Vec<f64>) {
        let (from, to) = (self.knots[i], self.knots[i + 1]);
        out.clear();
        self.add_piece(&self.base.lattice, (from, to), from, out);
        for patch in &self.patches {
            for middle in self.turns(patch, 0.5 * (from + to)) {
                self.add_piece(&patch.lattice, (from, to), middle - 0.5 * (to - from), out);
            }
        }
    }

    fn values(&self, t: &[f64], derivative: usize, out: &mut [f64]) -> Result<()> {
        self.evaluate_into(t, derivative, out)
    }

    fn find(&self, t: f64) -> Result<(usize, f64)> {
        self.base.lattice.locate(t, None)?;
        let t = self.wrapped(t);
        let i = self.knots.partition_point(|&knot| knot <= t).saturating_sub(1).min(self.knots.len() - 2);
        let (from, to) = (self.knots[i], self.knots[i + 1]);
        Ok((i, ((t - from) / (to - from)).clamp(0.0, 1.0)))
    }
}

impl Curve for LocalCurve {
    fn as_pieces(&self) -> &dyn Pieces {
        self
    }
}
