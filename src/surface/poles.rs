//! Editing, with poles that stay smooth.
//!
//! At a pole a row of the net is one point, many times. The rows beyond it are not free: the tangents that arrive there
//! from all sides lie in one plane only if row −r differs from row r by a first harmonic, a·cos 2πk/M + b·sin 2πk/M
//! (D 11.2).

use core::f64::consts::TAU;

use super::axis::Axis;
use super::tensor::{TensorSurface, check_point};
use crate::error::Result;
use crate::limits::settle;
use crate::numerics::Vector3;
use crate::numerics::angle::sin_cos;

/// A pole counts as smooth where the rows at it keep to the rule within this part of their size: what lies elsewhere,
/// however far away, has no part in it.
const KEPT: f64 = 1e-9;
/// And within this part of their distance from the origin: the rule is a sum over a row, of numbers that are rounded
/// there.
const ROUNDING: f64 = 1e-14;

/// One end of an open direction that closes to a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pole {
    /// Whether u is the open direction.
    open_u: bool,
    /// Points round the pole.
    around: usize,
    /// The row that is one point.
    row: usize,
    /// Rows beyond it.
    beyond: usize,
    /// Whether the rows beyond have larger numbers.
    last: bool,
}

impl Pole {
    /// Row r inside the surface, or −r beyond the pole.
    fn inside(self, r: usize) -> usize {
        if self.last { self.row - r } else { self.row + r }
    }

    fn outside(self, r: usize) -> usize {
        if self.last { self.row + r } else { self.row - r }
    }

    /// How many rows inside a row is, if one beyond follows it.
    #[inline]
    fn steps_inside(self, row: usize) -> Option<usize> {
        let steps = if self.last { self.row.wrapping_sub(row) } else { row.wrapping_sub(self.row) };
        (1..=self.beyond).contains(&steps).then_some(steps)
    }

    /// Place in the net of point k of a row.
    fn place(self, row: usize, k: usize) -> (usize, usize) {
        if self.open_u { (row, k) } else { (k, row) }
    }
}

impl TensorSurface {
    /// Moves net point (i, j); says whether others moved along.
    ///
    /// A smooth pole stays smooth: its points move together, and the rows beyond it follow the rows inside. That holds
    /// as long as the points beyond are left to themselves; after one of them was moved, all are the caller's.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for `i` and `j`; `NotFinite` and `OutOfRange` for `x`, `y` and `z`; `OutOfRange` for `net` where a
    /// point that follows would not be within ±1e9. The surface is as it was then.
    pub fn set_point(&mut self, i: usize, j: usize, mut point: Vector3) -> Result<bool> {
        self.base().check(i, j)?;
        check_point(&point)?;
        settle(point.as_mut_slice());
        let poles = self.smooth_poles();
        if poles.is_empty() {
            self.set(i, j, point);
            return Ok(false);
        }
        let mut moved = self.clone();
        let along = moved.follow(&poles, i, j, point);
        *self = moved.within_limits()?;
        Ok(along)
    }

    /// Moves point (i, j) and the points that follow it at smooth poles; whether any did.
    fn follow(&mut self, poles: &[Pole], i: usize, j: usize, point: Vector3) -> bool {
        self.set(i, j, point);
        let mut along = false;
        // Twice: where poles are near, the row of one is a row inside the other, and is whole only then.
        for &pole in poles.iter().chain(poles) {
            let row = if pole.open_u { i } else { j };
            if row == pole.row {
                for k in 0..pole.around {
                    let (i, j) = pole.place(row, k);
                    self.set(i, j, point);
                }
                along = true;
            } else if let Some(r) = pole.steps_inside(row) {
                self.mirror(pole, r);
                along = true;
            }
        }
        along
    }

    /// The other points of the net that move with (i, j).
    pub(super) fn companions(&self, i: usize, j: usize) -> Vec<(usize, usize)> {
        let mut found = Vec::new();
        for pole in self.smooth_poles() {
            let row = if pole.open_u { i } else { j };
            let moved =
                if row == pole.row { Some(row) } else { pole.steps_inside(row).map(|r| pole.outside(r)) };
            if let Some(row) = moved {
                found.extend((0..pole.around).map(|k| pole.place(row, k)));
            }
        }
        found
    }

    fn get(&self, i: usize, j: usize) -> Vector3 {
        Vector3::from_column_slice(self.base().point(i, j))
    }

    fn set(&mut self, i: usize, j: usize, point: Vector3) {
        self.layers[0].point_mut(i, j).copy_from_slice(point.as_slice());
    }

    /// What row −r of a smooth pole is: row r less twice its first harmonic.
    fn mirrored(&self, pole: Pole, r: usize) -> Vec<Vector3> {
        let row: Vec<Vector3> = (0..pole.around)
            .map(|k| {
                let (i, j) = pole.place(pole.inside(r), k);
                self.get(i, j)
            })
            .collect();
        let turn = |k: usize| sin_cos(TAU * k as f64 / pole.around as f64);
        let (mut a, mut b) = (Vector3::zeros(), Vector3::zeros());
        for (k, point) in row.iter().enumerate() {
            let (sin, cos) = turn(k);
            a += point * cos;
            b += point * sin;
        }
        let scale = 4.0 / pole.around as f64;
        let less = |k: usize| {
            let (sin, cos) = turn(k);
            (a * cos + b * sin) * scale
        };
        row.iter().enumerate().map(|(k, point)| point - less(k)).collect()
    }

    pub(super) fn mirror(&mut self, pole: Pole, r: usize) {
        for (k, point) in self.mirrored(pole, r).into_iter().enumerate() {
            let (i, j) = pole.place(pole.outside(r), k);
            self.set(i, j, point);
        }
    }

    /// The poles at which the net keeps to the rule.
    fn smooth_poles(&self) -> Vec<Pole> {
        let base = self.base();
        let mut found = Vec::new();
        for (open_u, open, round) in [(true, &base.u, &base.v), (false, &base.v, &base.u)] {
            found
                .extend(ends(open_u, open, round).into_iter().flatten().filter(|&pole| self.is_smooth(pole)));
        }
        found
    }

    /// How far off the rule the rows at a pole may be.
    fn slack(&self, pole: Pole) -> f64 {
        let (from, count) =
            (pole.place(pole.row - pole.beyond, 0), pole.place(2 * pole.beyond + 1, pole.around));
        let [least, most] = self.base().bounds(from.into(), count.into());
        KEPT * (most - least).norm() + ROUNDING * (least.norm() + most.norm())
    }

    fn is_smooth(&self, pole: Pole) -> bool {
        let near = self.slack(pole);
        let point = |row: usize, k: usize| {
            let (i, j) = pole.place(row, k);
            self.get(i, j)
        };
        let first = point(pole.row, 0);
        (1..pole.around).all(|k| (point(pole.row, k) - first).norm() <= near)
            && (1..=pole.beyond).all(|r| {
                let mirrored = self.mirrored(pole, r);
                mirrored.iter().enumerate().all(|(k, p)| (p - point(pole.outside(r), k)).norm() <= near)
            })
    }
}

/// The two places where a pole can be: where an open direction of points on the surface meets a closed one.
pub(super) fn ends(open_u: bool, open: &Axis, round: &Axis) -> [Option<Pole>; 2] {
    let (along, across) = (&open.direction, &round.direction);
    let beyond = along.roots.order().saturating_sub(2);
    let fits = !along.closed && across.closed && along.level == 0 && across.level == 0;
    // Both rows of a pair are in the net, and the other pole's are not the same.
    if !fits || open.intervals < beyond {
        return [None, None];
    }
    let pole = |row, last| Some(Pole { open_u, around: across.count, row, beyond, last });
    [pole(beyond, false), pole(along.count - 1 - beyond, true)]
}
