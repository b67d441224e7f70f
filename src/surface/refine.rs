//! The same surface with a finer net, and room for detail in a part of it.

use super::axis::{Axis, Direction, MOST_LEVELS};
use super::layer::{Layer, Window};
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::generator::Interpolator;
use crate::limits::{MOST_SURFACE_POINTS, check, filled, too_many, with_room};
use crate::refine::{finer, from_points};

/// The axis of the next level.
pub(super) fn doubled(axis: &Axis) -> Result<Axis> {
    let Direction { ref roots, closed, level, .. } = axis.direction;
    let intervals = 2 * axis.intervals;
    let count = if closed { intervals } else { intervals + roots.order() - 1 };
    Axis::new(Direction { roots: roots.clone(), count, closed, level: level + 1 }, ["levels"; 2])
}

/// The points of a net with the direction doubled that runs over `axis`: again and again, each time with `inner`
/// numbers a point.
fn double(net: &[f64], axis: &Axis, inner: usize) -> Result<Vec<f64>> {
    let Direction { ref roots, count, closed, level } = axis.direction;
    let interpolator = if level == 0 { Some(Interpolator::new(roots)?) } else { None };
    let coarse = roots.divided(axis.scale);
    let mut result = with_room(2 * net.len())?;
    for points in net.chunks_exact(count * inner) {
        result.extend(match &interpolator {
            Some(interpolator) => from_points(points, inner, closed, interpolator, 2)?,
            None => finer(points, inner, closed, &coarse, 2)?,
        });
    }
    Ok(result)
}

impl Layer {
    /// The same layer, whole, `levels` doublings finer in u and in v.
    pub(super) fn doubled(&self, levels: [u32; 2]) -> Result<Self> {
        let (mut u, mut v, mut net) = (self.u.clone(), self.v.clone(), self.net.clone());
        for _ in 0..levels[0] {
            let fine = doubled(&u)?;
            net = double(&net, &u, 3 * v.direction.count)?;
            u = fine;
        }
        for _ in 0..levels[1] {
            let fine = doubled(&v)?;
            net = double(&net, &v, 3)?;
            v = fine;
        }
        let (rows, columns) = (Window::whole(&u), Window::whole(&v));
        Ok(Self { u, v, rows, columns, net })
    }

    /// The layer with 0 for every point outside its window.
    fn spread(&self) -> Result<Self> {
        let (u, v) = (self.u.clone(), self.v.clone());
        let (rows, columns) = (Window::whole(&u), Window::whole(&v));
        let mut whole = Self { net: filled(0.0, 3 * rows.count * columns.count)?, u, v, rows, columns };
        for i in 0..self.rows.count {
            for j in 0..self.columns.count {
                let place = (self.rows.row(&self.u, i), self.columns.row(&self.v, j));
                whole.point_mut(place.0, place.1).copy_from_slice(self.point(i, j));
            }
        }
        Ok(whole)
    }

    pub(super) fn levels(&self) -> [u32; 2] {
        [self.u.direction.level, self.v.direction.level]
    }

    /// Adds the numbers of `other`, written with this layer's finer axes, to those of this one.
    pub(super) fn absorb(&mut self, other: &Self) -> Result<()> {
        let levels = [0, 1].map(|d| self.levels()[d] - other.levels()[d]);
        let fine = other.spread()?.doubled(levels)?;
        for i in 0..self.rows.count {
            for j in 0..self.columns.count {
                let place = (self.rows.row(&self.u, i), self.columns.row(&self.v, j));
                for (sum, number) in self.point_mut(i, j).iter_mut().zip(fine.point(place.0, place.1)) {
                    *sum += number;
                }
            }
        }
        Ok(())
    }
}

/// How many points a direction has `levels` doublings on, which are 12 at most.
pub(super) fn grown(axis: &Axis, levels: u32) -> usize {
    let Direction { ref roots, count, closed, .. } = axis.direction;
    if levels == 0 {
        return count;
    }
    let intervals = axis.intervals.saturating_mul(1 << levels);
    if closed { intervals } else { intervals.saturating_add(roots.order() - 1) }
}

impl TensorSurface {
    /// The same surface with 2^`levels_u` times the points in u and 2^`levels_v` times in v.
    ///
    /// A direction that is refined is in B-spline form: its points are control points, near the surface and ever
    /// nearer, in the normalisation in which they move with the surface under affine maps. Detail that was added
    /// locally stays; what the finer net can hold goes into it.
    ///
    /// # Accuracy
    ///
    /// The surface changes by at most 1e-12 of its size (`tests/surface_refine.rs`).
    ///
    /// # Errors
    ///
    /// `OutOfRange` for more than 12 levels, and for a finer `net` that is not within ±1e9; `LimitExceeded` for
    /// `levels` that make more than 12 with those that there are, or more than 4,194,304 points.
    ///
    /// # Source
    ///
    /// [SFBGU17, prop. 3 and eq. 20], with one division of the roots and normalised: (D 11.4).
    pub fn refine(&self, levels_u: u32, levels_v: u32) -> Result<Self> {
        let base = self.base();
        check_levels(base, [levels_u, levels_v])?;
        let mut refined = base.doubled([levels_u, levels_v])?;
        let mut layers = Vec::new();
        for patch in &self.layers[1..] {
            let behind = [0, 1].map(|d| refined.levels()[d].saturating_sub(patch.levels()[d]));
            let patch = if behind == [0, 0] { patch.clone() } else { patch.spread()?.doubled(behind)? };
            if patch.levels() == refined.levels() {
                refined.absorb(&patch)?;
            } else {
                layers.push(patch);
            }
        }
        layers.insert(0, refined);
        Self { layers }.within_limits()
    }
}

pub(super) fn check_levels(base: &Layer, levels: [u32; 2]) -> Result<()> {
    for (finer, level) in levels.into_iter().zip(base.levels()) {
        check("levels", None, f64::from(finer), 0.0, f64::from(MOST_LEVELS))?;
        let total = level + finer;
        if total > MOST_LEVELS {
            return Err(too_many("levels", "maxLevels", MOST_LEVELS as usize, total as usize));
        }
    }
    let needed = grown(&base.u, levels[0]).saturating_mul(grown(&base.v, levels[1]));
    if needed > MOST_SURFACE_POINTS {
        return Err(too_many("levels", "maxSurfacePoints", MOST_SURFACE_POINTS, needed));
    }
    Ok(())
}
