//! The same surface with a finer net, and room for detail in a part of it.

use super::axis::{Axis, Direction, MOST_LEVELS};
use super::layer::{Layer, Window};
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::generator::{Interpolator, Roots};
use crate::limits::{MOST_POINTS, check, filled, too_many};

/// One doubling of a direction: fine point 2k + first + i gets `filter[i]` times coarse point k.
struct Doubling {
    filter: Vec<f64>,
    first: i64,
}

impl Doubling {
    /// The filter from a level to the next one, for control points that move with the surface.
    fn new(roots: &Roots, level: u32) -> Result<Self> {
        let order = roots.order() as i64;
        let scale = f64::from(1_u32 << level);
        let (coarse, fine) = (roots.scaled(scale), roots.scaled(2.0 * scale));
        let mut filter = two_scale(&fine);
        let mut first = -(order / 2);
        let mut normalised = fine.integral() / coarse.integral();
        if level == 0 {
            filter = spread(&filter, Interpolator::new(roots)?.lambda());
            first = order / 2 - 2 * (order - 1);
            normalised = fine.integral();
        }
        for tap in &mut filter {
            *tap *= normalised;
        }
        Ok(Self { filter, first })
    }
}

/// 2^{1−n₀}·Π(1 + e^a z) over the roots a of the fine grid.
fn two_scale(roots: &Roots) -> Vec<f64> {
    let mut filter = vec![libm::exp2(1.0 - roots.order() as f64)];
    for root in roots.as_slice().iter().filter(|root| root.im >= 0.0) {
        let e = libm::exp(root.re);
        let factor = if root.im == 0.0 { [1.0, e, 0.0] } else { [1.0, 2.0 * e * libm::cos(root.im), e * e] };
        let before = filter.clone();
        filter.extend(core::iter::repeat_n(0.0, if root.im == 0.0 { 1 } else { 2 }));
        for (i, sum) in filter.iter_mut().enumerate() {
            *sum = (0..=i.min(2)).map(|k| factor[k] * before.get(i - k).copied().unwrap_or(0.0)).sum();
        }
    }
    filter
}

/// The filter's translates by n = −(n₀ − 2) … n₀ − 2, λₙ times each.
fn spread(filter: &[f64], lambda: &[f64]) -> Vec<f64> {
    let most = lambda.len() - 1;
    let mut result = vec![0.0; filter.len() + 2 * most];
    for n in 0..=2 * most {
        for (sum, tap) in result[n..].iter_mut().zip(filter) {
            *sum += lambda[n.abs_diff(most)] * tap;
        }
    }
    result
}

/// The axis of the next level.
pub(super) fn doubled(axis: &Axis) -> Result<Axis> {
    let Direction { ref roots, closed, level, .. } = axis.direction;
    let intervals = 2 * axis.intervals;
    let count = if closed { intervals } else { intervals + roots.order() - 1 };
    Axis::new(Direction { roots: roots.clone(), count, closed, level: level + 1 }, "levels")
}

/// The points of a net with one direction doubled: the one that runs over `axis`, `outer` times, each time with `inner`
/// numbers a point.
fn double(net: &[f64], axis: &Axis, fine: &Axis, outer: usize, inner: usize) -> Result<Vec<f64>> {
    let Doubling { filter, first } = Doubling::new(&axis.direction.roots, axis.direction.level)?;
    let (count, fine_count) = (axis.direction.count, fine.direction.count);
    let mut result = filled(0.0, outer * fine_count * inner)?;
    // Open rows are numbered from the first that counts; closed ones from the one at parameter 0.
    let (offset, fine_offset) = if axis.direction.closed { (0, 0) } else { (axis.start, fine.start) };
    for o in 0..outer {
        let (coarse, fine_rows) =
            (&net[o * count * inner..], &mut result[o * fine_count * inner..(o + 1) * fine_count * inner]);
        for k in 0..count {
            let point = &coarse[k * inner..(k + 1) * inner];
            for (i, tap) in filter.iter().enumerate() {
                let mut row = 2 * (k as i64 + offset) + first + i as i64 - fine_offset;
                if axis.direction.closed {
                    row = row.rem_euclid(fine_count as i64);
                } else if row < 0 || row >= fine_count as i64 {
                    continue;
                }
                let row = row as usize;
                for (sum, number) in fine_rows[row * inner..(row + 1) * inner].iter_mut().zip(point) {
                    *sum += tap * number;
                }
            }
        }
    }
    Ok(result)
}

impl Layer {
    /// The same layer, whole, `levels` doublings finer in u and in v.
    fn doubled(&self, levels: [u32; 2]) -> Result<Self> {
        let (mut u, mut v, mut net) = (self.u.clone(), self.v.clone(), self.net.clone());
        for _ in 0..levels[0] {
            let fine = doubled(&u)?;
            net = double(&net, &u, &fine, 1, 3 * v.direction.count)?;
            u = fine;
        }
        for _ in 0..levels[1] {
            let fine = doubled(&v)?;
            net = double(&net, &v, &fine, u.direction.count, 3)?;
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
        let fine = if other.net.len() == 3 * other.u.direction.count * other.v.direction.count {
            other.doubled(levels)?
        } else {
            other.spread()?.doubled(levels)?
        };
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

/// How many points a direction has `levels` doublings on.
pub(super) fn grown(axis: &Axis, levels: u32) -> usize {
    let intervals = axis.intervals.checked_shl(levels).unwrap_or(usize::MAX);
    let order = axis.direction.roots.order();
    if levels == 0 { axis.direction.count } else { intervals.saturating_add(order) }
}

impl TensorSurface {
    /// The same surface with 2^`levels_u` times the points in u and 2^`levels_v` times in v.
    ///
    /// A direction that is refined is in B-spline form: its points are control points, near the surface and ever nearer,
    /// in the normalisation in which they move with the surface under affine maps. Detail that was added locally stays; what the finer net can hold goes into it.
    ///
    /// # Accuracy
    ///
    /// The surface changes by at most 1e-12 of its size (`tests/surface_refine.rs`).
    ///
    /// # Errors
    ///
    /// `OutOfRange` for more than 12 levels in all; `LimitExceeded` for `levels` beyond 16 million points.
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
        Ok(Self { layers })
    }
}

pub(super) fn check_levels(base: &Layer, levels: [u32; 2]) -> Result<()> {
    for (finer, level) in levels.into_iter().zip(base.levels()) {
        check("levels", None, f64::from(finer), 0.0, f64::from(MOST_LEVELS - level))?;
    }
    let needed = grown(&base.u, levels[0]).saturating_mul(grown(&base.v, levels[1]));
    if needed > MOST_POINTS {
        return Err(too_many("levels", "maxSurfacePoints", MOST_POINTS, needed));
    }
    Ok(())
}
