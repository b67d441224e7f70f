//! Detail where it is wanted: patches of finer control points over a net that stays as it is.

use super::axis::{Axis, Direction, MOST_LEVELS};
use super::layer::{Layer, Window};
use super::refine::{check_total, doubled, grown, within_points};
use super::tensor::{TensorSurface, check_displacement, check_point};
use crate::error::{Error, Result};
use crate::limits::{check, filled, settle};
use crate::numerics::Vector3;
use crate::numerics::angle::wrapped;

impl TensorSurface {
    /// The same surface with room for detail around (u, v): a patch of finer control points, `levels` doublings beyond
    /// the base's, of all that lie within `reach` of (u, v) in each direction. The rest of the net stays as it is.
    ///
    /// A patch is a layer of displacements on a finer grid, all 0 at first: the surface is unchanged to the last bit,
    /// and a point of the net that is moved later takes the detail along. \[FB88\]
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `u`, `v`, `levels` (1 to 12) and `reach` (0 to 1e6); `LimitExceeded` for `levels` that make
    /// more than 12 with those that there are, or a patch of more than 4,194,304 points; `Degenerate` for `reach` where
    /// no control point is within it.
    pub fn refine_at(&self, u: f64, v: f64, levels: u32, reach: f64) -> Result<Self> {
        self.check_place(u, v)?;
        check("reach", None, reach, 0.0, 1e6)?;
        check("levels", None, f64::from(levels), 1.0, f64::from(MOST_LEVELS))?;
        let base = self.base();
        check_total(base, [levels, levels])?;
        let [level_u, level_v] = base.levels().map(|level| level + levels);
        let (fine_u, fine_v) =
            (self.finer(level_u, |layer| &layer.u)?, self.finer(level_v, |layer| &layer.v)?);
        let (Some(rows), Some(columns)) = (around(&fine_u, u, reach), around(&fine_v, v, reach)) else {
            return Err(Error::degenerate("reach", None, "no control point is within it"));
        };
        within_points(rows.count.saturating_mul(columns.count))?;
        self.with_patch(fine_u, fine_v, rows, columns)
    }

    fn with_patch(&self, u: Axis, v: Axis, rows: Window, columns: Window) -> Result<Self> {
        let net = filled(0.0, 3 * rows.count * columns.count)?;
        let mut layers = self.layers.clone();
        layers.push(Layer { u, v, rows, columns, net });
        Ok(Self { layers })
    }

    /// How many patches there are.
    pub fn patch_count(&self) -> usize {
        self.layers.len() - 1
    }

    /// Level, first row and count of patch `k` in u and in v.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `patch`.
    pub fn patch_window(&self, patch: usize) -> Result<[(u32, usize, usize); 2]> {
        let Layer { u, v, rows, columns, .. } = self.patch(patch)?;
        Ok([(u.direction.level, rows.first, rows.count), (v.direction.level, columns.first, columns.count)])
    }

    /// The displacements of patch `k`, three numbers a point, v fastest.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `patch`.
    pub fn displacements(&self, patch: usize) -> Result<&[f64]> {
        Ok(&self.patch(patch)?.net)
    }

    /// The control points of a patch, three numbers each, v fastest: where the refined net of the surface has them.
    ///
    /// Overlapping patches of the same level share them; a patch that is finer in either direction counts not.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `patch`.
    pub fn patch_points(&self, patch: usize) -> Result<Vec<f64>> {
        let layer = self.patch(patch)?;
        let mut shown = Layer { net: filled(0.0, layer.net.len())?, ..layer.clone() };
        let coarser = |other: &&Layer| (0..2).all(|d| other.levels()[d] <= layer.levels()[d]);
        for other in self.layers.iter().filter(coarser) {
            shown.absorb(other)?;
        }
        Ok(shown.net)
    }

    /// Moves control point (i, j) of a patch, counted within it.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `patch`, `i` and `j`; `NotFinite` and `OutOfRange` for `x`, `y` and `z`; `OutOfRange` for
    /// `displacements` where the point would be moved by more than 2e9.
    pub fn set_patch_point(&mut self, patch: usize, i: usize, j: usize, point: Vector3) -> Result<()> {
        let layer = self.patch(patch)?;
        layer.check(i, j)?;
        check_point(&point)?;
        let shown = self.patch_points(patch)?;
        let at = 3 * (i * layer.columns.count + j);
        let mut moved = [0.0; 3];
        for (k, number) in moved.iter_mut().enumerate() {
            *number = layer.point(i, j)[k] + (point[k] - shown[at + k]);
            check_displacement(Some(at + k), *number)?;
        }
        settle(&mut moved);
        self.layers[patch + 1].point_mut(i, j).copy_from_slice(&moved);
        Ok(())
    }

    /// The surface with one more patch and its displacements, as [`TensorSurface::patch_window`] and
    /// [`TensorSurface::displacements`] tell them.
    ///
    /// # Errors
    ///
    /// Those of [`TensorSurface::push_patch`].
    pub fn add_patch(
        &self,
        u: (u32, usize, usize),
        v: (u32, usize, usize),
        displacements: &[f64],
    ) -> Result<Self> {
        let mut surface = self.clone();
        surface.push_patch(u, v, displacements)?;
        Ok(surface)
    }

    /// Adds a patch to the surface itself: the way to add many, each at the cost of its own points.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `u.level`, `u.first`, `u.count` and those of `v`; `WrongLength`, `NotFinite` and `OutOfRange`
    /// for `displacements`. The surface is as it was then.
    pub fn push_patch(
        &mut self,
        u: (u32, usize, usize),
        v: (u32, usize, usize),
        displacements: &[f64],
    ) -> Result<()> {
        let names = [["u.level", "u.first", "u.count"], ["v.level", "v.first", "v.count"]];
        let (rows, columns) = (window(&self.base().u, u, names[0])?, window(&self.base().v, v, names[1])?);
        if displacements.len() != 3 * rows.count * columns.count {
            return Err(Error::wrong_length(
                "displacements",
                displacements.len(),
                3 * rows.count * columns.count,
            ));
        }
        for (i, &number) in displacements.iter().enumerate() {
            check_displacement(Some(i), number)?;
        }
        let mut net = filled(0.0, displacements.len())?;
        net.copy_from_slice(displacements);
        settle(&mut net);
        let (u, v) = (self.finer(u.0, |layer| &layer.u)?, self.finer(v.0, |layer| &layer.v)?);
        self.layers.push(Layer { u, v, rows, columns, net });
        Ok(())
    }

    /// The axis of a level that was checked: that of the last layer that has it, as patches are many and levels few.
    fn finer(&self, level: u32, axis: fn(&Layer) -> &Axis) -> Result<Axis> {
        if let Some(layer) = self.layers.iter().rev().find(|layer| axis(layer).direction.level == level) {
            return Ok(axis(layer).clone());
        }
        let mut fine = axis(self.base()).clone();
        while fine.direction.level < level {
            fine = doubled(&fine)?;
        }
        Ok(fine)
    }

    pub(super) fn patch(&self, patch: usize) -> Result<&Layer> {
        self.layers.get(patch.saturating_add(1)).ok_or_else(|| {
            Error::out_of_range("patch", None, patch as f64, 0.0, self.patch_count() as f64 - 1.0)
        })
    }
}

/// The window on the grid of a level; `names` are what the caller knows the three numbers by.
fn window(
    base: &Axis,
    (level, first, count): (u32, usize, usize),
    [of_level, of_first, of_count]: [&'static str; 3],
) -> Result<Window> {
    let least = base.direction.level;
    check(of_level, None, f64::from(level), f64::from(least.max(1)), f64::from(MOST_LEVELS))?;
    let points = grown(base, level - least);
    check(of_first, None, first as f64, 0.0, (points - 1) as f64)?;
    let room = if base.direction.closed { points } else { points - first };
    check(of_count, None, count as f64, 1.0, room as f64)?;
    Ok(Window { first, count })
}

/// The rows of an axis within `reach` of a parameter.
fn around(axis: &Axis, t: f64, reach: f64) -> Option<Window> {
    let Direction { count, closed, .. } = axis.direction;
    // Turns away from the domain, `reach` may be less than a rounding of t.
    let t = if closed { wrapped(t, axis.end()) } else { t };
    let first = axis.parameter(0);
    let from = ((t - reach - first) * axis.scale).ceil();
    let to = ((t + reach - first) * axis.scale).floor();
    if closed {
        if to - from + 1.0 >= count as f64 {
            return Some(Window { first: 0, count });
        }
        let start = wrapped(from, count as f64) as usize % count;
        return (to >= from).then(|| Window { first: start, count: (to - from) as usize + 1 });
    }
    let (from, to) = (from.max(0.0), to.min((count - 1) as f64));
    (to >= from).then(|| Window { first: from as usize, count: (to - from) as usize + 1 })
}
