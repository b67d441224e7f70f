//! Positions, normals and curvatures on a grid of parameters, row by row from tables.
//!
//! The weights of a row and of a column are worked out once each. A row of the mesh first combines the rows of the net
//! into one row of points and derivatives in u, and every vertex then combines `width` of those: 36 multiplications for
//! generators of three roots.

use core::ops::Range;

use super::combined::{Combined, pairs_of};
use super::layer::Scratch;
use super::normal::Jet;
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::limits::{MOST_OUTPUT_POINTS, check, filled, too_many, with_room};
use crate::numerics::Vector3;
use crate::numerics::lists::steps;
use crate::numerics::pair::Pair;

/// A vertex whose ∂ᵤσ × ∂ᵥσ is below this part of the size squared asks [`TensorSurface::normal_at`]: the size of what
/// it sees, so that a vertex that a moved point does not reach keeps its bits.
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

/// Part of a grid: ranges of rows and columns that may run beyond the last one of a closed direction, round to the
/// first.
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
    /// They depend on the grid and on which directions are closed, and not on the net: at a pole some have no area.
    /// Seen from where the normals point they run counterclockwise.
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
        let ranges = [(&region.rows, grid.rows), (&region.cols, grid.cols)];
        self.layers.iter().map(|layer| Combined::new(layer, ranges, kinds)).collect()
    }

    /// The parameters of vertex (i, j).
    fn vertex(&self, grid: Grid, i: usize, j: usize) -> (f64, f64) {
        let base = self.base();
        (base.u.uniform(i % grid.rows, grid.rows), base.v.uniform(j % grid.cols, grid.cols))
    }

    /// Positions and unit normals of the vertices of a region of a grid, three numbers each, row by row. Returns how
    /// many vertices have no normal: theirs is 0.
    ///
    /// A vertex has the same bits in every region. The arrays are the region's own: what an edit touches is written
    /// beside the mesh, and copied into it.
    ///
    /// ```
    /// use expline::TensorSurface;
    /// use expline::numerics::Vector3;
    /// use expline::surface::Grid;
    ///
    /// let mut torus = TensorSurface::torus(3.0, 1.0, [8, 6])?;
    /// let (grid, count) = (Grid { rows: 64, cols: 48 }, 3 * 64 * 48);
    /// let (mut positions, mut normals) = (vec![0.0; count], vec![0.0; count]);
    /// torus.mesh_into(grid, &grid.whole(), &mut positions, &mut normals)?; // triangles: torus.indices(grid)
    ///
    /// torus.set_point(2, 0, Vector3::new(0.0, 5.0, 0.0))?;
    /// let region = torus.touched(grid, 2, 0)?;
    /// let size = 3 * region.rows.len() * region.cols.len();
    /// let (mut places, mut ways) = (vec![0.0; size], vec![0.0; size]);
    /// torus.mesh_into(grid, &region, &mut places, &mut ways)?;
    /// let vertices = region.rows.flat_map(|i| region.cols.clone().map(move |j| (i % 64) * 48 + j % 48));
    /// for (k, vertex) in vertices.enumerate() {
    ///     let (of, from) = (3 * vertex..3 * vertex + 3, 3 * k..3 * k + 3);
    ///     positions[of.clone()].copy_from_slice(&places[from.clone()]);
    ///     normals[of].copy_from_slice(&ways[from]);
    /// }
    /// let mut whole = vec![0.0; count];
    /// torus.mesh_into(grid, &grid.whole(), &mut whole, &mut vec![0.0; count])?;
    /// assert_eq!(positions, whole, "as if all of it were made again");
    /// # Ok::<(), expline::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// `OutOfRange` and `LimitExceeded` for `rows` and `cols`, as [`TensorSurface::indices`]; `WrongLength` where an
    /// array has not three numbers for each vertex of the region.
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
