//! Positions, normals and curvatures on a grid of parameters, row by row from tables.
//!
//! The weights of a row and of a column are worked out once each. A row of the mesh first combines the rows of the net
//! into one row of points and derivatives in u, and every vertex then combines `width` of those: 36 multiplications for
//! generators of three roots.

use core::ops::Range;

use super::axis::Axis;
use super::layer::{Layer, Scratch};
use super::normal::Jet;
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, check, filled, too_many, with_room};
use crate::numerics::Vector3;
use crate::numerics::lists::{add_scaled, steps};
use crate::numerics::pair::Pair;

/// A vertex whose ∂ᵤσ × ∂ᵥσ is below this part of the size squared asks [`TensorSurface::normal_at`]: the size of what it sees, so that
/// a vertex that a moved point does not reach keeps its bits.
const DOUBTFUL: f64 = 1e-9;

/// A grid of parameters: `rows` of them in u, `cols` in v.
///
/// Row i lies at i/rows of a closed direction, at i/(rows − 1) of an open one; columns alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// How many parameters in u.
    pub rows: usize,
    /// How many parameters in v.
    pub cols: usize,
}

/// Part of a grid: ranges of rows and columns that may run beyond the last one of a closed direction, round to the first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    /// Rows.
    pub rows: Range<usize>,
    /// Columns.
    pub cols: Range<usize>,
}

impl Grid {
    /// All of it.
    pub fn whole(self) -> Region {
        Region { rows: 0..self.rows, cols: 0..self.cols }
    }

    /// Refuses grids that are too small or have too many vertices.
    pub(crate) fn check(self) -> Result<()> {
        check("rows", None, self.rows as f64, 2.0, MOST_OUTPUT_POINTS as f64)?;
        check("cols", None, self.cols as f64, 2.0, MOST_OUTPUT_POINTS as f64)?;
        let needed = self.rows.saturating_mul(self.cols);
        if needed > MOST_OUTPUT_POINTS {
            return Err(too_many("rows", "maxOutputPoints", MOST_OUTPUT_POINTS, needed));
        }
        Ok(())
    }
}

/// The parameter of row i of `count`.
fn parameter(axis: &Axis, i: usize, count: usize) -> f64 {
    axis.end() * (i as f64 / steps(count, axis.direction.closed) as f64)
}

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
            let place = axis.nearest_place(parameter(axis, i % count, count));
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
struct Combined<'a> {
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
    active: bool,
    /// Of every pair of columns, its interval.
    intervals: Vec<usize>,
    /// Of every pair, the weights of those points and of their derivatives, [first, second, first, second].
    pairs: Vec<[f64; 4]>,
}

impl<'a> Combined<'a> {
    fn new(layer: &'a Layer, grid: Grid, region: &Region, kinds: usize) -> Result<Self> {
        let Layer { v, columns, .. } = layer;
        let mut places = with_room(v.run())?;
        places.extend((0..v.run()).map(|at| columns.position(v, v.row(at)).unwrap_or(columns.count)));
        Ok(Self {
            layer,
            rows: Table::new(&layer.u, &region.rows, grid.rows)?,
            columns: Table::new(&layer.v, &region.cols, grid.cols)?,
            places,
            lines: filled(0.0, v.run().saturating_mul(3 * layer.u.width()))?,
            interval: usize::MAX,
            row: filled(0.0, v.run().saturating_mul(3 * kinds))?,
            active: false,
            intervals: Vec::new(),
            pairs: Vec::new(),
        })
    }

    /// Lays the weights of pairs of columns out side by side.
    fn pair_up(&mut self, pairs: &[[usize; 2]]) -> Result<()> {
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
    fn prepare(&mut self, i: usize) {
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
    fn add_tangents(&self, pair: usize, sums: &mut [Pair; 9]) {
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
    fn add_jet(&self, c: usize, jet: &mut Jet) {
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

/// Lays the rows of the net that weigh on an interval out along the places that columns meet: zeros beyond a layer's window.
/// Whether any row is within it.
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
fn pairs_of(layers: &[Combined<'_>], across: usize) -> Result<Vec<[usize; 2]>> {
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

/// Positions and normals of a row of vertices, and the squares of ∂ᵤσ × ∂ᵥσ; whether all of those are above `doubtful`.
///
/// It calls nothing, and works on a pair of vertices at a time.
#[inline(never)]
fn fill_row(
    layers: &[Combined<'_>],
    pairs: &[[usize; 2]],
    doubtful: f64,
    positions: &mut [[f64; 3]],
    normals: &mut [[f64; 3]],
    squares: &mut [f64],
) -> bool {
    let across = positions.len().min(normals.len()).min(squares.len());
    let mut certain = true;
    for (pair, &[first, second]) in pairs.iter().enumerate() {
        // Never so: one check for all the lists.
        if first.max(second) >= across {
            break;
        }
        let mut sums = [Pair::twice(0.0); 9];
        for layer in layers.iter().filter(|layer| layer.active) {
            layer.add_tangents(pair, &mut sums);
        }
        let [x, y, z, a, b, c, d, e, f] = sums;
        let (p, q, r) = (b * f - c * e, c * d - a * f, a * e - b * d);
        let square = p * p + q * q + r * r;
        let scale = Pair::twice(1.0) / square.sqrt();
        let (p, q, r) = (p * scale, q * scale, r * scale);
        // The second is the first where it is alone.
        positions[second] = [x.second(), y.second(), z.second()];
        normals[second] = [p.second(), q.second(), r.second()];
        positions[first] = [x.first(), y.first(), z.first()];
        normals[first] = [p.first(), q.first(), r.first()];
        squares[second] = square.second();
        squares[first] = square.first();
        certain &= square.first() > doubtful && square.second() > doubtful;
    }
    certain
}

impl TensorSurface {
    /// The triangles of a mesh, three vertex numbers each; vertex (i, j) has number i·cols + j.
    ///
    /// They depend on the grid and on which directions are closed, and not on the net: at a pole some have no area. Seen from
    /// where the normals point they run counterclockwise.
    ///
    /// # Errors
    ///
    /// `OutOfRange` and `LimitExceeded` for `rows` and `cols`: at least 2, at most 4 million vertices.
    pub fn indices(&self, grid: Grid) -> Result<Vec<u32>> {
        grid.check()?;
        let [u, v] = self.directions().map(|direction| direction.closed);
        let Grid { rows, cols } = grid;
        let (bands, across) = (steps(rows, u), steps(cols, v));
        let mut indices = with_room(6 * bands * across)?;
        for i in 0..bands {
            let next = if i + 1 == rows { 0 } else { i + 1 };
            for j in 0..across {
                let right = if j + 1 == cols { 0 } else { j + 1 };
                let [a, b, c, d] = [i * cols + j, next * cols + j, next * cols + right, i * cols + right];
                indices.extend([a, b, c, a, c, d].map(|vertex| vertex as u32));
            }
        }
        Ok(indices)
    }

    /// The combined layers of a mesh, after its checks.
    fn combined(&self, grid: Grid, region: &Region, kinds: usize) -> Result<Vec<Combined<'_>>> {
        grid.check()?;
        check("rows", None, region.rows.len() as f64, 0.0, grid.rows as f64)?;
        check("cols", None, region.cols.len() as f64, 0.0, grid.cols as f64)?;
        self.layers.iter().map(|layer| Combined::new(layer, grid, region, kinds)).collect()
    }

    /// The parameters of vertex (i, j).
    fn vertex(&self, grid: Grid, i: usize, j: usize) -> (f64, f64) {
        let base = self.base();
        (parameter(&base.u, i % grid.rows, grid.rows), parameter(&base.v, j % grid.cols, grid.cols))
    }

    /// Positions and unit normals of the vertices of a region of a grid, three numbers each, row by row. Returns how many
    /// vertices have no normal: theirs is 0.
    ///
    /// A vertex has the same bits in every region.
    ///
    /// # Errors
    ///
    /// `OutOfRange` and `LimitExceeded` for `rows` and `cols`, as [`TensorSurface::indices`]; `WrongLength` where an array has
    /// not three numbers for each vertex of the region.
    ///
    /// # Cost
    ///
    /// 36 multiplications and a root a vertex for generators of three roots; a few microseconds at a pole.
    pub fn mesh_into(
        &self,
        grid: Grid,
        region: &Region,
        positions: &mut [f64],
        normals: &mut [f64],
    ) -> Result<usize> {
        let mut layers = self.combined(grid, region, 2)?;
        let needed = 3 * region.rows.len() * region.cols.len();
        for (argument, array) in [("positions", &*positions), ("normals", &*normals)] {
            if array.len() != needed {
                return Err(Error::wrong_length(argument, array.len(), needed));
            }
        }
        if needed == 0 {
            return Ok(0);
        }
        let (positions, normals) = (positions.as_chunks_mut::<3>().0, normals.as_chunks_mut::<3>().0);
        let across = region.cols.len();
        let doubtful = |size: f64| (DOUBTFUL * size * size) * (DOUBTFUL * size * size);
        // No vertex sees more than the whole net: what is certain by that is certain.
        let most = doubtful(self.extent());
        let (mut scratch, mut without, mut squares) = (Scratch::default(), 0, filled(0.0, across)?);
        let pairs = pairs_of(&layers, across)?;
        for layer in &mut layers {
            layer.pair_up(&pairs)?;
        }
        for i in 0..region.rows.len() {
            for layer in &mut layers {
                layer.prepare(i);
            }
            let vertices = i * across..(i + 1) * across;
            let (positions, normals) = (&mut positions[vertices.clone()], &mut normals[vertices]);
            if fill_row(&layers, &pairs, most, positions, normals, &mut squares) {
                continue;
            }
            for (j, (normal, &square)) in normals.iter_mut().zip(&squares).enumerate() {
                if square > most {
                    continue;
                }
                let (u, v) = self.vertex(grid, region.rows.start + i, region.cols.start + j);
                if square > doubtful(self.extent_at(u, v)) {
                    continue;
                }
                let limit = self.normal_at(u, v, &mut scratch);
                without += usize::from(limit == Vector3::zeros());
                normal.copy_from_slice(limit.as_slice());
            }
        }
        Ok(without)
    }

    /// Curvatures of the vertices of a region of a grid, row by row: all Gaussian ones, then all mean ones; see
    /// [`TensorSurface::curvature`].
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::mesh_into`].
    pub fn mesh_curvatures_into(&self, grid: Grid, region: &Region, out: &mut [f64]) -> Result<()> {
        let mut layers = self.combined(grid, region, 3)?;
        let needed = 2 * region.rows.len() * region.cols.len();
        if out.len() != needed {
            return Err(Error::wrong_length("out", out.len(), needed));
        }
        let (most, mut scratch) = (self.most(), Scratch::default());
        let across = region.cols.len().max(1);
        let (gaussian, mean) = out.split_at_mut(needed / 2);
        let rows = gaussian.chunks_exact_mut(across).zip(mean.chunks_exact_mut(across));
        let vertex = |i: usize, j: usize| self.vertex(grid, region.rows.start + i, region.cols.start + j);
        let mut beside = with_room(region.cols.len())?;
        beside.extend((0..region.cols.len()).map(|j| self.end_beside(false, vertex(0, j).1).is_some()));
        for (i, (gaussian, mean)) in rows.enumerate() {
            for layer in &mut layers {
                layer.prepare(i);
            }
            let row_beside = self.end_beside(true, vertex(i, 0).0).is_some();
            for (j, (gaussian, mean)) in gaussian.iter_mut().zip(mean).enumerate() {
                let mut jet = Jet::default();
                for layer in layers.iter().filter(|layer| layer.active) {
                    layer.add_jet(j, &mut jet);
                }
                let curvature = if !row_beside && !beside[j] && jet.is_regular(&most) {
                    jet.curvature()
                } else {
                    let (u, v) = vertex(i, j);
                    self.curvature_at(u, v, &mut scratch)
                };
                (*gaussian, *mean) = (curvature.gaussian, curvature.mean);
            }
        }
        Ok(())
    }
}
