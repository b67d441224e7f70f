//! A net over a window of two axes: the base of a surface, or detail that is added to it.

use super::axis::{Axis, Place};
use crate::error::Result;
use crate::limits::check;

/// Rows first, first + 1, … of an axis, round its end where it is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Window {
    pub(super) first: usize,
    pub(super) count: usize,
}

impl Window {
    /// Every row of an axis.
    pub(super) fn whole(axis: &Axis) -> Self {
        Self { first: 0, count: axis.direction.count }
    }

    /// Which of the window's rows a row of the axis is.
    pub(super) fn position(self, axis: &Axis, row: usize) -> Option<usize> {
        let position =
            if row >= self.first { row - self.first } else { row + axis.direction.count - self.first };
        (position < self.count && (axis.direction.closed || row >= self.first)).then_some(position)
    }

    /// The row of the axis that is number `position` of the window.
    pub(super) fn row(self, axis: &Axis, position: usize) -> usize {
        let row = self.first + position;
        if row >= axis.direction.count { row - axis.direction.count } else { row }
    }
}

/// Points, or displacements, in a window of the product of two axes; v runs fastest, three numbers each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layer {
    pub(super) u: Axis,
    pub(super) v: Axis,
    pub(super) rows: Window,
    pub(super) columns: Window,
    pub(super) net: Vec<f64>,
}

/// Weights in both directions at one place.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    u: Vec<f64>,
    v: Vec<f64>,
}

impl Layer {
    /// Checks the numbers of a point of the window.
    pub(super) fn check(&self, i: usize, j: usize) -> Result<()> {
        check("i", None, i as f64, 0.0, (self.rows.count - 1) as f64)?;
        check("j", None, j as f64, 0.0, (self.columns.count - 1) as f64)
    }

    /// The three numbers of the point at a place in the window.
    pub(super) fn point(&self, i: usize, j: usize) -> &[f64] {
        let at = 3 * (i * self.columns.count + j);
        &self.net[at..at + 3]
    }

    /// The same, to be changed.
    pub(super) fn point_mut(&mut self, i: usize, j: usize) -> &mut [f64] {
        let at = 3 * (i * self.columns.count + j);
        &mut self.net[at..at + 3]
    }

    /// Adds the layer's value, or a derivative, at a place to `sum`.
    pub(super) fn add(
        &self,
        (u, v): (Place, Place),
        (du, dv): (usize, usize),
        scratch: &mut Scratch,
        sum: &mut [f64; 3],
    ) {
        scratch.u.resize(self.u.width(), 0.0);
        scratch.v.resize(self.v.width(), 0.0);
        self.u.weights(u, du, &mut scratch.u);
        self.v.weights(v, dv, &mut scratch.v);
        for (a, wu) in scratch.u.iter().enumerate() {
            let Some(i) = self.rows.position(&self.u, self.u.row(u.interval + a)) else { continue };
            let mut across = [0.0; 3];
            for (b, wv) in scratch.v.iter().enumerate() {
                if let Some(j) = self.columns.position(&self.v, self.v.row(v.interval + b)) {
                    for (total, number) in across.iter_mut().zip(self.point(i, j)) {
                        *total += wv * number;
                    }
                }
            }
            for (total, number) in sum.iter_mut().zip(across) {
                *total += wu * number;
            }
        }
    }
}
