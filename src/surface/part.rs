//! Part of a layer on a finer grid, from as few of its points as that takes: a patch on the twelfth level is some ten
//! points wide, and the whole grid there has hundreds of millions.

use super::axis::{Axis, Direction};
use super::layer::{Layer, Window};
use super::refine::doubled;
use crate::error::Result;
use crate::generator::Interpolator;
use crate::limits::{filled, with_room};
use crate::refine::{finer, from_points};

/// A run of an axis's points; of a closed one it may begin before the first and go on beyond the last, round its end.
#[derive(Clone, Copy)]
struct Run {
    first: i64,
    count: usize,
}

/// One direction's way from the grid of a layer to a finer one: the axes on it, and the run of points that is wanted on
/// each and on the last.
struct Way {
    axes: Vec<Axis>,
    runs: Vec<Run>,
}

/// The fewest points that have a doubling, and which of the finer points is the first that an open list from point 0 on
/// gives.
fn doubling(axis: &Axis) -> (usize, i64) {
    let Direction { ref roots, closed, level, .. } = axis.direction;
    let order = roots.order();
    let least = if level == 0 { 2 * order - 2 } else { order };
    let lead = if level == 0 { order + order / 2 - 3 } else { order - 1 - order / 2 };
    (least, if closed { lead as i64 } else { 0 })
}

/// The run of an axis's points that the doubling needs for a run of the finer ones.
fn needed(axis: &Axis, fine: Run) -> Run {
    let (least, lead) = doubling(axis);
    let mut first = (fine.first - lead).div_euclid(2);
    if !axis.direction.closed {
        first = first.min((axis.direction.count - least) as i64);
    }
    // A list of the least length gives order + 1 places, and each point more gives two.
    let places = (fine.first + fine.count as i64 - lead - 2 * first) as usize;
    let more = places.saturating_sub(axis.direction.roots.order() + 1).div_ceil(2);
    Run { first, count: least + more }
}

impl Way {
    /// From an axis to a finer one, or the same, of which a window is wanted.
    fn new(from: &Axis, to: &Axis, window: Window) -> Result<Self> {
        let mut axes = Vec::new();
        let mut axis = from.clone();
        while axis.direction.level < to.direction.level {
            let fine = doubled(&axis)?;
            axes.push(axis);
            axis = fine;
        }
        let mut runs = vec![Run { first: window.first as i64, count: window.count }];
        for axis in axes.iter().rev() {
            runs.push(needed(axis, runs[runs.len() - 1]));
        }
        runs.reverse();
        Ok(Self { axes, runs })
    }

    /// The points of the first run doubled step by step, in every list of those that follow each other; a point has
    /// `inner` numbers.
    fn follow(&self, mut net: Vec<f64>, inner: usize) -> Result<Vec<f64>> {
        for ((axis, from), to) in self.axes.iter().zip(&self.runs).zip(&self.runs[1..]) {
            let Direction { ref roots, level, .. } = axis.direction;
            let interpolator = if level == 0 { Some(Interpolator::new(roots)?) } else { None };
            let coarse = roots.divided(axis.scale);
            let skipped = (to.first - 2 * from.first - doubling(axis).1) as usize * inner;
            let mut result = with_room(net.len() / from.count * to.count)?;
            for points in net.chunks_exact(from.count * inner) {
                let places = match &interpolator {
                    Some(interpolator) => from_points(points, inner, false, interpolator, 2)?,
                    None => finer(points, inner, false, &coarse, 2)?,
                };
                result.extend_from_slice(&places[skipped..skipped + to.count * inner]);
            }
            net = result;
        }
        Ok(net)
    }
}

/// Number of a run's point on its axis.
fn row(axis: &Axis, at: i64) -> usize {
    if axis.direction.closed { at.rem_euclid(axis.direction.count as i64) as usize } else { at as usize }
}

impl Layer {
    /// The points of a run in each direction, 0 outside the window.
    fn cut(&self, u: Run, v: Run) -> Result<Vec<f64>> {
        let mut net = filled(0.0, 3 * u.count * v.count)?;
        let mut places = with_room(v.count)?;
        places.extend((0..v.count as i64).map(|j| self.columns.position(&self.v, row(&self.v, v.first + j))));
        for (i, line) in net.chunks_exact_mut(3 * v.count).enumerate() {
            let Some(i) = self.rows.position(&self.u, row(&self.u, u.first + i as i64)) else { continue };
            for (point, place) in line.as_chunks_mut::<3>().0.iter_mut().zip(&places) {
                if let Some(j) = *place {
                    point.copy_from_slice(self.point(i, j));
                }
            }
        }
        Ok(net)
    }

    /// The numbers of this layer in windows of axes as fine as its own or finer.
    fn within(&self, [u, v]: [&Axis; 2], [rows, columns]: [Window; 2]) -> Result<Vec<f64>> {
        let (u, v) = (Way::new(&self.u, u, rows)?, Way::new(&self.v, v, columns)?);
        let net = self.cut(u.runs[0], v.runs[0])?;
        v.follow(u.follow(net, 3 * v.runs[0].count)?, 3)
    }

    /// Adds the numbers of `other`, written with this layer's finer axes, to those of this one.
    pub(super) fn absorb(&mut self, other: &Self) -> Result<()> {
        let net = other.within([&self.u, &self.v], [self.rows, self.columns])?;
        for (sum, number) in self.net.iter_mut().zip(net) {
            *sum += number;
        }
        Ok(())
    }

    /// The same layer, `levels` doublings finer in u and in v: a whole one whole, a patch as all points that its own
    /// reach.
    pub(super) fn doubled(&self, levels: [u32; 2]) -> Result<Self> {
        let (u, rows) = reached(&self.u, self.rows, levels[0])?;
        let (v, columns) = reached(&self.v, self.columns, levels[1])?;
        let net = self.within([&u, &v], [rows, columns])?;
        Ok(Self { u, v, rows, columns, net })
    }
}

/// The axis that is `levels` doublings finer, and the points there that those of a window reach.
fn reached(axis: &Axis, mut window: Window, levels: u32) -> Result<(Axis, Window)> {
    let mut axis = axis.clone();
    for _ in 0..levels {
        let Direction { ref roots, closed, .. } = axis.direction;
        let order = roots.order();
        let fine = doubled(&axis)?;
        let whole = Window::whole(&fine);
        // A point reaches order + 1 finer ones, and two points side by side share all of them but two.
        let count = 2 * window.count + order - 1;
        window = if window.count == axis.direction.count || (closed && count >= whole.count) {
            whole
        } else if closed {
            let first = 2 * window.first + whole.count - order / 2;
            Window { first: first % whole.count, count }
        } else {
            let end = (2 * window.first + window.count * 2).min(whole.count);
            let first = (2 * window.first).saturating_sub(order - 1);
            Window { first, count: end - first }
        };
        axis = fine;
    }
    Ok((axis, window))
}
