//! Going back down: the nearest surface with a coarser net, and how far away it is.

use super::axis::{Axis, Direction, surplus};
use super::layer::{Layer, Scratch, Window};
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::generator::{Interpolator, affine_refinement_filter};
use crate::limits::{check, with_room};
use crate::numerics::Vector3;
use crate::refine::{Target, least_squares};

/// Places per interval, in each direction, at which a change is measured.
const LOOKS: usize = 4;

/// The axis of the level before.
fn halved(axis: &Axis) -> Result<Axis> {
    let Direction { ref roots, closed, level, .. } = axis.direction;
    if !axis.intervals.is_multiple_of(2) {
        return Err(Error::degenerate("levels", None, "the number of intervals is odd"));
    }
    let intervals = axis.intervals / 2;
    let count = if closed { intervals } else { intervals + surplus(roots, level - 1) };
    Axis::new(Direction { roots: roots.clone(), count, closed, level: level - 1 }, ["levels"; 2])
}

/// The points of the level before whose refinement is nearest, for a net with `inner` numbers a point.
fn halve(net: &[f64], fine: &Axis, coarse: &Axis, inner: usize) -> Result<Vec<f64>> {
    let Direction { ref roots, count, closed, level } = coarse.direction;
    let (filter, target) = if level == 0 {
        let filter = Interpolator::new(roots)?.affine_pre_filter(2)?;
        (filter, Target::from_points(count, closed, roots.order(), 2))
    } else {
        let filter = affine_refinement_filter(&roots.divided(coarse.scale), 2)?;
        (filter, Target::finer(count, closed, roots.order(), 2)?)
    };
    let mut result = with_room(net.len())?;
    for points in net.chunks_exact(fine.direction.count * inner) {
        result.extend(least_squares(&target, points, inner, 2, &filter, count * inner)?);
    }
    Ok(result)
}

impl TensorSurface {
    /// The surface with a net that is coarser by 2^`levels_u` in u and by 2^`levels_v` in v whose refinement has the control points
    /// nearest to this one's, direction by direction, in the sum of squares; and the largest distance between the two,
    /// parameter by parameter. Patches stay as they are.
    ///
    /// What was refined and not changed comes back.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for more levels than a direction has, and for a coarser `net` that is not within ±1e9; `Degenerate` and `TooFewPoints` for a net that cannot be halved so
    /// often.
    ///
    /// # Accuracy
    ///
    /// The distance is the largest of 4 × 4 places in each field of the net.
    pub fn reduce(&self, levels_u: u32, levels_v: u32) -> Result<(Self, f64)> {
        let base = self.base();
        let [most_u, most_v] = base.levels();
        check("levels", None, f64::from(levels_u), 0.0, f64::from(most_u))?;
        check("levels", None, f64::from(levels_v), 0.0, f64::from(most_v))?;
        let (mut u, mut v, mut net) = (base.u.clone(), base.v.clone(), base.net.clone());
        for _ in 0..levels_u {
            let coarse = halved(&u)?;
            net = halve(&net, &u, &coarse, 3 * v.direction.count)?;
            u = coarse;
        }
        for _ in 0..levels_v {
            let coarse = halved(&v)?;
            net = halve(&net, &v, &coarse, 3)?;
            v = coarse;
        }
        let (rows, columns) = (Window::whole(&u), Window::whole(&v));
        let coarse = Layer { u, v, rows, columns, net };
        let mut difference = coarse.doubled([levels_u, levels_v])?;
        for (number, before) in difference.net.iter_mut().zip(&base.net) {
            *number -= before;
        }
        let deviation = Self { layers: vec![difference] }.reach();
        let mut layers = vec![coarse];
        layers.extend_from_slice(&self.layers[1..]);
        Ok((Self { layers }.within_limits()?, deviation))
    }

    /// The largest distance from the origin.
    fn reach(&self) -> f64 {
        let base = self.base();
        let places = |axis: &Axis| (LOOKS * axis.intervals, axis.end());
        let ((rows, end_u), (cols, end_v)) = (places(&base.u), places(&base.v));
        let (mut most, mut scratch): (f64, _) = (0.0, Scratch::default());
        for i in 0..=rows {
            for j in 0..=cols {
                let (u, v) = (end_u * i as f64 / rows as f64, end_v * j as f64 / cols as f64);
                most = most.max(Vector3::from(self.value(u, v, (0, 0), &mut scratch)).norm());
            }
        }
        most
    }
}
