//! The equations of points that are equally far apart along a curve, gathered piece by piece.
//!
//! Where a point's place moves along the curve depends on all coefficients, but in one way for all points of a piece, except
//! for the coefficients of that piece: a point costs no more than one that depends on its piece alone.

use super::growth::{Local, Place};
use crate::fit::knots::breaks::HIGHEST;
use crate::fit::knots::envelope::Envelope;
use crate::numerics::Vector;

/// How much less it counts that a curve's parameter stays as it is than what points say.
const STAY: f64 = 0.01;
/// The length before the piece, the whole length, and the first point's.
const LENGTHS: usize = 3;
const SIZE: usize = LENGTHS + 2 * (HIGHEST + 1);

/// Sums over the points of a piece: of products of what their places move by, and with what they are off.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    products: [[f64; SIZE]; SIZE],
    right: [f64; SIZE],
}

impl Default for Sums {
    fn default() -> Self {
        Self { products: [[0.0; SIZE]; SIZE], right: [0.0; SIZE] }
    }
}

impl Sums {
    /// Takes a point that is `rest` beside its place; `lengths` is how its length along the curve, less that of the place, grows
    /// with the first three, and `grown` how the place's length from the start of the piece grows with the coefficients there.
    /// So many coordinates of coefficients are used.
    pub(super) fn take(
        &mut self,
        w: f64,
        rest: Vector,
        lengths: [f64; LENGTHS],
        (place, grown): (&Place, &Local),
        used: usize,
    ) {
        let along = place.along;
        let (mut far, mut off, mut stay) = ([0.0; SIZE], [0.0; SIZE], [0.0; SIZE]);
        far[..LENGTHS].copy_from_slice(&lengths);
        for i in 0..used / 2 {
            let (k, a) = (LENGTHS + 2 * i, place.shares[i]);
            [stay[k], stay[k + 1]] = [a * along.x, a * along.y];
            [far[k], far[k + 1]] = [stay[k] - grown[2 * i], stay[k + 1] - grown[2 * i + 1]];
            [off[k], off[k + 1]] = [-a * along.y, a * along.x];
        }
        let (beside, across) = (w * rest.dot(&along), w * (rest.y * along.x - rest.x * along.y));
        for i in 0..LENGTHS + used {
            self.right[i] += beside * far[i] + across * off[i];
            let [f, o, s] = [w * far[i], w * off[i], STAY * w * stay[i]];
            for j in 0..=i {
                self.products[i][j] += f * far[j] + o * off[j] + s * stay[j];
            }
        }
    }

    /// Adds the sums to the equations of all coefficients. `dense` are the growths of the first two lengths by all of them,
    /// `units` the numbers of the unknowns that the others are.
    pub(super) fn spread(
        &self,
        equations: &mut Envelope,
        right: &mut [f64],
        [before, whole]: [&[f64]; 2],
        units: &[usize],
    ) {
        let of = &self.products;
        for (i, (a, b)) in before.iter().zip(whole).enumerate() {
            right[i] += self.right[0] * a + self.right[1] * b;
            equations.add_to_row(i, &before[..=i], of[0][0] * a + of[1][0] * b);
            equations.add_to_row(i, &whole[..=i], of[1][0] * a + of[1][1] * b);
        }
        for (p, &i) in units.iter().enumerate() {
            // The first two of the sums are those of the lengths.
            let k = 2 + p;
            right[i] += self.right[k];
            for (j, (a, b)) in before.iter().zip(whole).enumerate() {
                let product = of[k][0] * a + of[k][1] * b;
                equations.add(i, j, product);
                equations.add(j, i, product);
            }
        }
        for (p, &i) in units.iter().enumerate() {
            for (q, &j) in units.iter().enumerate() {
                equations.add(i, j, of[2 + p.max(q)][2 + p.min(q)]);
            }
        }
    }
}
