//! Going back down: the nearest surface with a coarser net, and how far away it is.

use super::axis::{Axis, Direction, surplus};
use super::layer::{Layer, Scratch, Window};
use super::tensor::TensorSurface;
use crate::error::{Error, Result};
use crate::generator::{Interpolator, affine_refinement_filter};
use crate::limits::{check, with_room};
use crate::numerics::Vector3;
use crate::refine::{Target, least_squares};

/// Places per interval, in each direction, at which a change is looked at.
const LOOKS: usize = 4;
/// From rows and columns that come as near to the largest as this the way leads uphill. Between looks a change grows by
/// a seventh at most.
const NEAR: f64 = 0.85;
/// Halvings of the step on the way: a peak is then known to 1e-4 of its height.
const HALVINGS: usize = 6;
/// Steps on the way, where a ridge is long.
const MOST_STEPS: usize = 32;

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
    /// The surface with a net that is coarser by 2^`levels_u` in u and by 2^`levels_v` in v whose refinement has the
    /// control points nearest to this one's, direction by direction, in the sum of squares; and the largest distance
    /// between the two, parameter by parameter. Patches stay as they are.
    ///
    /// What was refined and not changed comes back.
    ///
    /// # Errors
    ///
    /// `OutOfRange` for more levels than a direction has, and for a coarser `net` that is not within ±1e9; `Degenerate`
    /// and `TooFewPoints` for a net that cannot be halved so often.
    ///
    /// # Accuracy
    ///
    /// The distance is looked at in 4 × 4 places of each field of the net, and followed uphill from the largest of
    /// them: to about 1e-4 of itself.
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
        let looks = [&base.u, &base.v].map(|axis| LOOKS * axis.intervals);
        let step = [base.u.end() / looks[0] as f64, base.v.end() / looks[1] as f64];
        let mut scratch = Scratch::default();
        // The largest of each row and of each column: of two peaks in one row the way may lead higher from the lower
        // look.
        let mut far = vec![(0.0, [0.0; 2]); looks[0] + looks[1] + 2];
        for i in 0..=looks[0] {
            for j in 0..=looks[1] {
                let place = [step[0] * i as f64, step[1] * j as f64];
                let distance = self.distance(place, &mut scratch);
                for line in [i, looks[0] + 1 + j] {
                    if distance > far[line].0 {
                        far[line] = (distance, place);
                    }
                }
            }
        }
        let most = far.iter().fold(0.0_f64, |most, look| most.max(look.0));
        let near = far.into_iter().filter(|look| look.0 > NEAR * most);
        near.map(|(_, place)| self.climbed(place, step, &mut scratch)).fold(most, f64::max)
    }

    /// The distance from the origin where no step from a place leads farther.
    fn climbed(&self, from: [f64; 2], mut step: [f64; 2], scratch: &mut Scratch) -> f64 {
        let (mut best, mut at, mut halvings) = (self.distance(from, scratch), from, 0);
        for _ in 0..MOST_STEPS {
            let before = best;
            for [du, dv] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
                let place = [at[0] + du * step[0], at[1] + dv * step[1]];
                let there = self.distance(place, scratch);
                if there > best {
                    (best, at) = (there, place);
                }
            }
            if best <= before {
                halvings += 1;
                step = step.map(|step| 0.5 * step);
            }
            if halvings > HALVINGS {
                break;
            }
        }
        best
    }

    fn distance(&self, [u, v]: [f64; 2], scratch: &mut Scratch) -> f64 {
        Vector3::from(self.value(u, v, (0, 0), scratch)).norm()
    }
}
