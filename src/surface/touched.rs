//! What part of a mesh a point of the net moves.

use core::ops::Range;

use super::axis::Axis;
use super::layer::Layer;
use super::mesh::{Grid, Region};
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::numerics::lists::steps;

/// Mesh rows whose parameters lie in the intervals that row `i` of the net weighs on, and one more on each side.
fn rows(axis: &Axis, i: usize, count: usize) -> Range<usize> {
    let (intervals, width) = (axis.intervals, axis.width());
    let closed = axis.direction.closed;
    let (first, last) = if closed {
        // Interval m is weighed on by m + start … m + start + width − 1, so point i by m = i − start − width + 1 …
        // i − start.
        let last = i as i64 - axis.start;
        (last - width as i64 + 1, last + 1)
    } else {
        ((i as i64 - width as i64 + 1).max(0), (i as i64 + 1).min(intervals as i64))
    };
    let each = steps(count, closed) as f64 / intervals as f64;
    let from = (first as f64 * each).floor() as i64 - 1;
    let to = (last as f64 * each).ceil() as i64 + 1;
    if !closed {
        return from.max(0) as usize..(to.max(0) as usize + 1).min(count);
    }
    if to - from + 1 >= count as i64 {
        return 0..count;
    }
    let start = from.rem_euclid(count as i64) as usize;
    start..start + (to - from + 1) as usize
}

/// A range that holds both; where one of them runs across the seam it may be longer than need be.
fn joined(a: Range<usize>, b: &Range<usize>, count: usize) -> Range<usize> {
    let (start, end) = (a.start.min(b.start), a.end.max(b.end));
    if end - start >= count { 0..count } else { start..end }
}

/// The part of a grid that row i and column j of a layer weigh on together.
pub(super) fn region(layer: &Layer, grid: Grid, i: usize, j: usize) -> Region {
    Region { rows: rows(&layer.u, i, grid.rows), cols: rows(&layer.v, j, grid.cols) }
}

impl TensorSurface {
    /// The part of a mesh that [`TensorSurface::set_point`] of net point (i, j) changes.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `i`, `j`, `rows`, `cols`.
    pub fn touched(&self, grid: Grid, i: usize, j: usize) -> Result<Region> {
        let base = self.base();
        base.check(i, j)?;
        grid.check()?;
        let mut region = region(base, grid, i, j);
        // A point beside a pole takes others with it.
        for (i, j) in self.companions(i, j) {
            let more = self::region(base, grid, i, j);
            region.rows = joined(region.rows, &more.rows, grid.rows);
            region.cols = joined(region.cols, &more.cols, grid.cols);
        }
        Ok(region)
    }

    /// The part of a mesh that control point (i, j) of a patch moves.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `patch`, `i`, `j`, `rows`, `cols`.
    pub fn touched_by_patch(&self, grid: Grid, patch: usize, i: usize, j: usize) -> Result<Region> {
        let layer = self.patch(patch)?;
        layer.check(i, j)?;
        grid.check()?;
        Ok(region(layer, grid, layer.rows.row(&layer.u, i), layer.columns.row(&layer.v, j)))
    }
}
