//! Combinations of the shifts of one function: what interpolating curves and B-spline curves have in common.

use std::sync::Arc;

use crate::error::{Error, Result};
use crate::generator::{ExponentialBSpline, Interpolator, PolynomialPieces, Roots};
use crate::limits::{LARGEST_COORDINATE, MOST_EVALUATIONS, MOST_POINTS, check, too_many, with_room};
use crate::numerics::angle::wrapped;

/// A curve Σ cₖ g((t − start)/step − k) in 2-D or 3-D, with all that evaluation needs beside it.
#[derive(Clone, Debug)]
pub(in crate::curve) struct Lattice {
    /// Shared by all curves that edits make of one another.
    pub(in crate::curve) shape: Arc<Shape>,
    pub(in crate::curve) dimension: usize,
    pub(in crate::curve) closed: bool,
    /// Parameter of the first knot, and the length of a cell.
    pub(super) start: f64,
    pub(super) step: f64,
    /// Parameter of the last knot: see [`Grid::end`].
    end: f64,
    /// How many cells there are.
    pub(super) cells: usize,
    /// The control points that act on cell j are numbers j … j + window − 1 here: closed lists go round.
    points: Vec<f64>,
}

/// Where the cells of a lattice lie.
#[derive(Clone, Copy, Debug)]
pub(in crate::curve) struct Grid {
    /// Parameter of the first knot.
    pub(super) start: f64,
    /// The length of a cell.
    pub(super) step: f64,
    /// Parameter of the last knot, or none for the first plus all steps.
    ///
    /// A curve and its refinements have one domain to the last bit. A third of a step is rounded, and no choice of its
    /// last bit makes three of them the step: the end is handed on, and with it the parameter at which a curve closes.
    pub(super) end: Option<f64>,
}

/// The function whose shifts are combined.
#[derive(Debug)]
pub(in crate::curve) struct Shape {
    /// In pieces, `per_cell` to a cell, about their middles, in units of a piece's length.
    pieces: PolynomialPieces,
    pub(in crate::curve) per_cell: usize,
    /// How many shifts act on a cell.
    pub(super) window: usize,
    /// The roots in that unit.
    pub(super) roots: Roots,
    /// χ₀ … χ_{n₀−1} of the differential equation that all pieces satisfy, in that unit.
    pub(super) characteristic: Vec<f64>,
    /// Whether the shifts sum to 1.
    pub(super) constants: bool,
    /// Whether the curve passes through its points, which sit at the start of cells.
    pub(super) interpolating: bool,
}

/// Where a parameter is: its cell, the piece of it, and the place on the piece, from −1/2 to 1/2.
#[derive(Clone, Copy, Debug)]
pub(in crate::curve) struct Place {
    pub(in crate::curve) cell: usize,
    pub(in crate::curve) part: usize,
    pub(in crate::curve) y: f64,
}

impl Shape {
    pub(super) fn of_interpolator(interpolator: &Interpolator) -> Self {
        let roots = interpolator.roots();
        Self {
            pieces: interpolator.pieces().stretched(0.5, 1.0),
            per_cell: 2,
            window: 2 * interpolator.support(),
            roots: roots.divided(2.0),
            characteristic: roots.divided(2.0).characteristic(),
            constants: roots.keeps_constants(),
            interpolating: true,
        }
    }

    /// The B-spline divided by its integral.
    pub(super) fn of_b_spline(spline: &ExponentialBSpline) -> Self {
        let roots = spline.roots();
        Self {
            pieces: spline.pieces().stretched(1.0, 1.0 / roots.integral()),
            per_cell: 1,
            window: spline.order(),
            roots: roots.clone(),
            characteristic: roots.characteristic(),
            constants: roots.keeps_constants(),
            interpolating: false,
        }
    }

    /// The cell that a piece is in, and which part of it.
    #[inline]
    pub(super) fn part_of(&self, piece: usize) -> (usize, usize) {
        if self.per_cell == 2 { (piece >> 1, piece & 1) } else { (piece, 0) }
    }

    /// The polynomial in y by which control point `k` of the window acts on a part of a cell.
    fn polynomial(&self, k: usize, part: usize) -> &[f64] {
        self.pieces.piece(self.per_cell * (self.window - 1 - k) + part)
    }

    /// What control point `k` of the window weighs at a place, or a derivative by y.
    pub(super) fn weight(&self, k: usize, part: usize, y: f64, derivative: usize) -> f64 {
        self.pieces.value(self.per_cell * (self.window - 1 - k) + part, y, derivative)
    }

    /// The control point of the window that is next to a place: differences from it are small.
    pub(super) fn nearest(&self, part: usize, y: f64) -> usize {
        let right = if self.per_cell == 2 { part == 1 } else { self.window % 2 == 1 || y > 0.0 };
        if right { self.window / 2 } else { self.window / 2 - 1 }
    }
}

impl Lattice {
    /// Whether the cells of both lie in the same places, of curves of the same kind.
    pub(super) fn lies_as(&self, other: &Self) -> bool {
        let place = |of: &Self| (of.dimension, of.closed, of.start, of.step, of.end);
        place(self) == place(other)
    }

    /// A lattice over the points that act on its cells; a closed list is turned so that number `first` comes first.
    pub(super) fn new(
        shape: Arc<Shape>,
        points: &[f64],
        dimension: usize,
        closed: bool,
        first: usize,
        grid: Grid,
    ) -> Result<Self> {
        let (count, window) = (points.len() / dimension, shape.window);
        let cells = if closed { count } else { count + 1 - window };
        let mut all = with_room((cells + window - 1) * dimension)?;
        for k in 0..cells + window - 1 {
            let k = if closed { (k + first) % count } else { k };
            all.extend_from_slice(&points[k * dimension..(k + 1) * dimension]);
        }
        let Grid { start, step, end } = grid;
        let end = end.unwrap_or(start + cells as f64 * step);
        Ok(Self { shape, dimension, closed, start, step, end, cells, points: all })
    }

    /// First and last parameter.
    pub(super) fn domain(&self) -> (f64, f64) {
        (self.start, self.end)
    }

    /// The grid, for another curve with the same domain.
    pub(super) fn grid(&self) -> Grid {
        Grid { start: self.start, step: self.step, end: Some(self.end) }
    }

    /// How many polynomial pieces there are.
    pub(in crate::curve) fn piece_count(&self) -> usize {
        self.cells * self.shape.per_cell
    }

    /// The parameter where piece i starts; that of the end for i = `piece_count`.
    pub(in crate::curve) fn knot(&self, i: usize) -> f64 {
        if i == self.piece_count() {
            return self.end;
        }
        // Not beyond the end, where steps are rounded up.
        (self.start + i as f64 * self.step / self.shape.per_cell as f64).min(self.end)
    }

    /// How much of the parameter a piece takes.
    pub(in crate::curve) fn span(&self) -> f64 {
        self.step / self.shape.per_cell as f64
    }

    /// The point where piece i starts, or the end. Its knot would not do: far from 0 that is rounded, by any share of a
    /// cell.
    pub(in crate::curve) fn start_into(&self, i: usize, out: &mut [f64]) {
        let count = self.piece_count();
        let i = if self.closed { i % count } else { i };
        let (piece, y) = if i < count { (i, -0.5) } else { (count - 1, 0.5) };
        let (cell, part) = self.shape.part_of(piece);
        self.value(Place { cell, part, y }, 0, out);
    }

    /// The control points that act on a cell.
    #[inline]
    pub(super) fn window(&self, cell: usize) -> &[f64] {
        let size = self.shape.window * self.dimension;
        self.points.get(cell * self.dimension..cell * self.dimension + size).unwrap_or(&[])
    }

    /// Coefficients of ascending powers of y in [−1/2, 1/2] on piece i, all coordinates of each in turn.
    pub(in crate::curve) fn piece_into(&self, i: usize, out: &mut Vec<f64>) {
        let shape = &*self.shape;
        let (cell, part) = shape.part_of(i);
        let window = self.window(cell);
        let middle = shape.nearest(part, 0.0) * self.dimension;
        out.clear();
        out.resize(shape.pieces.stride * self.dimension, 0.0);
        for (k, point) in window.chunks_exact(self.dimension).enumerate() {
            for (sums, c) in out.chunks_exact_mut(self.dimension).zip(shape.polynomial(k, part)) {
                for (d, (sum, x)) in sums.iter_mut().zip(point).enumerate() {
                    *sum += c * if shape.constants { x - window[middle + d] } else { *x };
                }
            }
        }
        if shape.constants {
            for (sum, x) in out.iter_mut().zip(&window[middle..middle + self.dimension]) {
                *sum += x;
            }
        }
    }

    /// Where t is: any finite t on a closed lattice, one in the domain on an open one.
    pub(in crate::curve) fn locate(&self, t: f64, index: Option<usize>) -> Result<Place> {
        let (least, most) = if self.closed { (f64::MIN, f64::MAX) } else { self.domain() };
        check("t", index, t, least, most)?;
        let cells = self.cells as f64;
        let u = (t - self.start) / self.step;
        let u = match self.closed {
            true => wrapped(u, cells),
            // Roundings of the step must not keep the end from being reached.
            false if t == self.end => cells,
            false => u,
        };
        let cell = (u as usize).min(self.cells - 1);
        let x = (u - cell as f64).clamp(0.0, 1.0) * self.shape.per_cell as f64;
        let part = (x as usize).min(self.shape.per_cell - 1);
        Ok(Place { cell, part, y: x - part as f64 - 0.5 })
    }

    /// The point at a place, or a derivative by t.
    pub(super) fn value(&self, place: Place, derivative: usize, out: &mut [f64]) {
        let (shape, window) = (&*self.shape, self.window(place.cell));
        let near = shape.nearest(place.part, place.y) * self.dimension;
        out.fill(0.0);
        if derivative == 0 && self.on_point(place) {
            out.copy_from_slice(&window[near..near + self.dimension]);
            return;
        }
        for (k, point) in window.chunks_exact(self.dimension).enumerate() {
            let weight = shape.weight(k, place.part, place.y, derivative);
            for (d, (sum, x)) in out.iter_mut().zip(point).enumerate() {
                *sum += weight * if shape.constants { x - window[near + d] } else { *x };
            }
        }
        let mut scale = 1.0;
        for _ in 0..derivative {
            scale *= shape.per_cell as f64 / self.step;
        }
        for (d, sum) in out.iter_mut().enumerate() {
            *sum *= scale;
            if derivative == 0 && shape.constants {
                *sum += window[near + d];
            }
        }
    }

    /// Whether a place is one of the points of a curve that passes through them.
    pub(super) fn on_point(&self, place: Place) -> bool {
        self.shape.interpolating && place.y == if place.part == 0 { -0.5 } else { 0.5 }
    }

    /// Points or derivatives at all parameters.
    pub(in crate::curve) fn evaluate_into(
        &self,
        t: &[f64],
        derivative: usize,
        out: &mut [f64],
    ) -> Result<()> {
        check("derivative", None, derivative as f64, 0.0, (self.shape.roots.order() - 1).max(2) as f64)?;
        if t.len() > MOST_EVALUATIONS {
            return Err(too_many("t", "maxEvalPoints", MOST_EVALUATIONS, t.len()));
        }
        if out.len() != self.dimension * t.len() {
            return Err(Error::wrong_length("out", out.len(), self.dimension * t.len()));
        }
        for (i, &t) in t.iter().enumerate() {
            self.locate(t, Some(i))?;
        }
        for (&t, out) in t.iter().zip(out.chunks_exact_mut(self.dimension)) {
            self.value(self.locate(t, None)?, derivative, out);
        }
        Ok(())
    }
}

/// The number of points in an interleaved list of finite numbers of a fair size, at least `least`.
pub(super) fn check_points(points: &[f64], dimension: usize, least: usize) -> Result<usize> {
    check("dimension", None, dimension as f64, 2.0, 3.0)?;
    let count = points.len() / dimension;
    if count * dimension != points.len() {
        return Err(Error::wrong_length("points", points.len(), (count + 1) * dimension));
    }
    if count < least {
        return Err(Error::too_few("points", count, least));
    }
    if count > MOST_POINTS {
        return Err(too_many("points", "maxPoints", MOST_POINTS, count));
    }
    for (i, &value) in points.iter().enumerate() {
        check("points", Some(i), value, -LARGEST_COORDINATE, LARGEST_COORDINATE)?;
    }
    Ok(count)
}
