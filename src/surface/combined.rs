//! A layer on its way to a mesh: its net's rows combined into one row of points, and that at the columns.

use core::ops::Range;

use super::axis::Axis;
use super::layer::Layer;
use super::normal::Jet;
use crate::error::Result;
use crate::limits::{filled, with_room};
use crate::numerics::Vector3;
use crate::numerics::lists::add_scaled;
use crate::numerics::pair::Pair;

/// Where each of a range of rows lies, and the weights of its points: for value and two derivatives.
struct Table {
    intervals: Vec<usize>,
    weights: Vec<[f64; 3]>,
}

impl Table {
    fn new(axis: &Axis, range: &Range<usize>, count: usize) -> Result<Self> {
        let width = axis.width();
        let mut intervals = with_room(range.len())?;
        let mut weights = with_room(range.len().saturating_mul(width))?;
        let mut of_one = [filled(0.0, width)?, filled(0.0, width)?, filled(0.0, width)?];
        for i in range.clone() {
            let place = axis.nearest_place(axis.uniform(i % count, count));
            intervals.push(place.interval);
            for (derivative, list) in of_one.iter_mut().enumerate() {
                axis.weights(place, derivative, list);
            }
            weights.extend((0..width).map(|w| [of_one[0][w], of_one[1][w], of_one[2][w]]));
        }
        Ok(Self { intervals, weights })
    }

    /// Interval and weights of number i of the range.
    #[inline(always)]
    fn at(&self, i: usize, width: usize) -> (usize, &[[f64; 3]]) {
        (self.intervals[i], &self.weights[width * i..width * (i + 1)])
    }
}

/// A layer with its tables, and the row that is being combined.
pub(super) struct Combined<'a> {
    layer: &'a Layer,
    rows: Table,
    columns: Table,
    /// For every place that columns meet, the position in the layer's window, or one beyond it.
    places: Vec<usize>,
    /// The `width` rows of the net that weigh on an interval, along those places, and which interval.
    lines: Vec<f64>,
    interval: usize,
    /// The points at every place that columns meet, then ∂ᵤ at each, then ∂ᵤᵤ where curvatures are wanted.
    row: Vec<f64>,
    /// Whether any row of the layer's window weighs on the row.
    pub(super) active: bool,
    /// Of every pair of columns, its interval.
    intervals: Vec<usize>,
    /// Of every pair, the weights of those points and of their derivatives, [first, second, first, second].
    pairs: Vec<[f64; 4]>,
}

impl<'a> Combined<'a> {
    /// For ranges of rows and of columns, each of so many in all, and for `kinds` of sums: points, ∂ᵤ and ∂ᵤᵤ.
    pub(super) fn new(
        layer: &'a Layer,
        [rows, columns]: [(&Range<usize>, usize); 2],
        kinds: usize,
    ) -> Result<Self> {
        let Layer { u, v, columns: window, .. } = layer;
        let mut places = with_room(v.run())?;
        places.extend((0..v.run()).map(|at| window.position(v, v.row(at)).unwrap_or(window.count)));
        Ok(Self {
            layer,
            rows: Table::new(u, rows.0, rows.1)?,
            columns: Table::new(v, columns.0, columns.1)?,
            places,
            lines: filled(0.0, v.run().saturating_mul(3 * u.width()))?,
            interval: usize::MAX,
            row: filled(0.0, v.run().saturating_mul(3 * kinds))?,
            active: false,
            intervals: Vec::new(),
            pairs: Vec::new(),
        })
    }

    /// Lays the weights of pairs of columns out side by side.
    pub(super) fn pair_up(&mut self, pairs: &[[usize; 2]]) -> Result<()> {
        let width = self.layer.v.width();
        self.intervals = with_room(pairs.len())?;
        self.pairs = with_room(pairs.len().saturating_mul(width))?;
        for &[first, second] in pairs {
            let ((interval, weights), (_, others)) =
                (self.columns.at(first, width), self.columns.at(second, width));
            self.intervals.push(interval);
            self.pairs
                .extend(weights.iter().zip(others).map(|(one, other)| [one[0], other[0], one[1], other[1]]));
        }
        Ok(())
    }

    /// Combines the net's rows for row i of the region.
    pub(super) fn prepare(&mut self, i: usize) {
        let (interval, weights) = self.rows.at(i, self.layer.u.width());
        if self.interval != interval {
            self.interval = interval;
            self.active = lay(self.layer, interval, &self.places, &mut self.lines);
        }
        if !self.active {
            return;
        }
        self.row.fill(0.0);
        let length = 3 * self.places.len();
        for (weights, line) in weights.iter().zip(self.lines.chunks_exact(length)) {
            for (&weight, sums) in weights.iter().zip(self.row.chunks_exact_mut(length)) {
                add_scaled(sums, weight, line);
            }
        }
    }

    /// Number `kind` of points, ∂ᵤ and ∂ᵤᵤ, for the points that weigh on an interval.
    #[inline(always)]
    fn points(&self, kind: usize, interval: usize) -> &[[f64; 3]] {
        let first = kind * self.places.len() + interval;
        &self.row.as_chunks::<3>().0[first..first + self.layer.v.width()]
    }

    /// Adds position, ∂ᵤ and ∂ᵥ at a pair of columns. Number by number, written out: this is where the time goes.
    #[inline(always)]
    pub(super) fn add_tangents(&self, pair: usize, sums: &mut [Pair; 9]) {
        let width = self.layer.v.width();
        let interval = self.intervals[pair];
        let points = self.points(0, interval).iter().zip(self.points(1, interval));
        let weights = &self.pairs[width * pair..width * (pair + 1)];
        let [mut x, mut y, mut z, mut ux, mut uy, mut uz, mut vx, mut vy, mut vz] = *sums;
        for ((&[px, py, pz], &[qx, qy, qz]), &[w, other, dw, d_other]) in points.zip(weights) {
            let (w, dw) = (Pair::new(w, other), Pair::new(dw, d_other));
            let (px, py, pz) = (Pair::twice(px), Pair::twice(py), Pair::twice(pz));
            let (qx, qy, qz) = (Pair::twice(qx), Pair::twice(qy), Pair::twice(qz));
            x += w * px;
            y += w * py;
            z += w * pz;
            ux += w * qx;
            uy += w * qy;
            uz += w * qz;
            vx += dw * px;
            vy += dw * py;
            vz += dw * pz;
        }
        *sums = [x, y, z, ux, uy, uz, vx, vy, vz];
    }

    /// Adds ∂ᵤ, ∂ᵥ, ∂ᵤᵤ, ∂ᵤᵥ and ∂ᵥᵥ at column c.
    pub(super) fn add_jet(&self, c: usize, jet: &mut Jet) {
        let (interval, weights) = self.columns.at(c, self.layer.v.width());
        let [points, by_u, by_uu] = [0, 1, 2].map(|kind| self.points(kind, interval));
        for (((&point, &by_u), &by_uu), &[w0, w1, w2]) in points.iter().zip(by_u).zip(by_uu).zip(weights) {
            let [p, by_u, by_uu] = [point, by_u, by_uu].map(Vector3::from);
            jet.u += by_u * w0;
            jet.v += p * w1;
            jet.uu += by_uu * w0;
            jet.uv += by_u * w1;
            jet.vv += p * w2;
        }
    }
}

/// Lays the rows of the net that weigh on an interval out along the places that columns meet: zeros beyond a layer's
/// window. Whether any row is within it.
#[inline(never)]
fn lay(layer: &Layer, interval: usize, places: &[usize], lines: &mut [f64]) -> bool {
    let Layer { u, rows, columns, net, .. } = layer;
    let mut any = false;
    for (a, line) in lines.chunks_exact_mut(3 * places.len()).enumerate() {
        let position = rows.position(u, u.row(interval + a));
        any |= position.is_some();
        for (&j, point) in places.iter().zip(line.as_chunks_mut::<3>().0) {
            let inside = position.filter(|_| j < columns.count).map(|i| 3 * (i * columns.count + j));
            *point = inside.and_then(|at| net[at..].first_chunk()).copied().unwrap_or([0.0; 3]);
        }
    }
    any
}

/// Two columns that lie between the same points in every layer, or one twice.
pub(super) fn pairs_of(layers: &[Combined<'_>], across: usize) -> Result<Vec<[usize; 2]>> {
    let mut pairs = with_room(across)?;
    let mut j = 0;
    while j < across {
        let together = j + 1 < across
            && layers.iter().all(|Combined { columns, .. }| columns.intervals[j] == columns.intervals[j + 1]);
        let second = j + usize::from(together);
        pairs.push([j, second]);
        j = second + 1;
    }
    Ok(pairs)
}
