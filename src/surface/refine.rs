//! The same surface with a finer net, and room for detail in a part of it.

use super::axis::{Axis, Direction, MOST_LEVELS};
use super::layer::Layer;
use super::tensor::TensorSurface;
use crate::error::Result;
use crate::limits::{MOST_SURFACE_POINTS, check, too_many};

/// The axis of the next level.
pub(super) fn doubled(axis: &Axis) -> Result<Axis> {
    let Direction { ref roots, closed, level, .. } = axis.direction;
    let intervals = 2 * axis.intervals;
    let count = if closed { intervals } else { intervals + roots.order() - 1 };
    Axis::new(Direction { roots: roots.clone(), count, closed, level: level + 1 }, ["levels"; 2])
}

impl Layer {
    pub(super) fn levels(&self) -> [u32; 2] {
        [self.u.direction.level, self.v.direction.level]
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
    /// The surface changes by at most 1e-12 of its size (`tests/surface/refinement.rs`).
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
            let patch = if behind == [0, 0] { patch.clone() } else { patch.doubled(behind)? };
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

fn check_levels(base: &Layer, levels: [u32; 2]) -> Result<()> {
    check_total(base, levels)?;
    let needed = grown(&base.u, levels[0]).saturating_mul(grown(&base.v, levels[1]));
    within_points(needed)
}

/// Refuses more levels than there may be in all.
pub(super) fn check_total(base: &Layer, levels: [u32; 2]) -> Result<()> {
    for (finer, level) in levels.into_iter().zip(base.levels()) {
        check("levels", None, f64::from(finer), 0.0, f64::from(MOST_LEVELS))?;
        let total = level + finer;
        if total > MOST_LEVELS {
            return Err(too_many("levels", "maxLevels", MOST_LEVELS as usize, total as usize));
        }
    }
    Ok(())
}

/// Refuses more points than a net, or a patch, may have.
pub(super) fn within_points(needed: usize) -> Result<()> {
    if needed > MOST_SURFACE_POINTS {
        return Err(too_many("levels", "maxSurfacePoints", MOST_SURFACE_POINTS, needed));
    }
    Ok(())
}
