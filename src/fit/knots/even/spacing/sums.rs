//! The equations of points that are equally far apart along a curve, gathered piece by piece.
//!
//! Where a point's place moves along the curve depends on all coefficients, but in one way for all points of a piece, except
//! for the coefficients of that piece: a point costs no more than one that depends on its piece alone.

use super::growth::{Local, Place};
use crate::fit::knots::breaks::{HIGHEST, Polynomial};
use crate::fit::knots::envelope::Envelope;
use crate::fit::knots::foot_points::Across;
use crate::fit::knots::free_knots::product;
use crate::numerics::Vector;

/// How much less it counts that a curve's parameter stays as it is than what points say.
const STAY: f64 = 0.01;
/// The length before the piece, the whole length, and the first point's.
pub(super) const LENGTHS: usize = 3;
pub(super) const SIZE: usize = LENGTHS + 2 * (HIGHEST + 1);

/// Sums over the points of a piece: of products of what their places move by along the curve, and with what they are off;
/// and the same across, where only the piece's own coefficients count.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    products: [[f64; SIZE]; SIZE],
    right: [f64; SIZE],
    own: Across,
}

impl Default for Sums {
    fn default() -> Self {
        Self { products: [[0.0; SIZE]; SIZE], right: [0.0; SIZE], own: Across::default() }
    }
}

impl Sums {
    /// Takes a point that is `rest` beside its place; `lengths` is how its length along the curve, less that of the place, grows
    /// with the first three, and `grown` how the place's length from the start of the piece grows with the coefficients there.
    /// Of N unknowns, T coefficients are used. Loops of a length that is known become vector instructions.
    #[inline(always)]
    pub(super) fn take<const T: usize, const N: usize>(
        &mut self,
        w: f64,
        rest: Vector,
        lengths: [f64; LENGTHS],
        (place, grown): (&Place, &Local),
    ) {
        let (along, mut far) = (place.along, [0.0; N]);
        far[..LENGTHS].copy_from_slice(&lengths);
        for i in 0..T {
            far[LENGTHS + 2 * i] = place.shares[i] * along.x - grown[2 * i];
            far[LENGTHS + 2 * i + 1] = place.shares[i] * along.y - grown[2 * i + 1];
        }
        let beside = w * rest.dot(&along);
        for i in 0..N {
            self.right[i] += beside * far[i];
            let f = w * far[i];
            for (sum, far) in self.products[i][..N].iter_mut().zip(far) {
                *sum += f * far;
            }
        }
        let off = w * (rest.y * along.x - rest.x * along.y);
        let [xx, yy] = [along.x * along.x, along.y * along.y];
        let weight = [w * (yy + STAY * xx), w * (STAY - 1.0) * along.x * along.y, w * (xx + STAY * yy)];
        self.own.take::<T>(place.u, weight, [-off * along.y, off * along.x]);
    }

    /// Adds the sums to the equations of all coefficients. `dense` are the growths of the first two lengths by all of them,
    /// `units` the numbers of the unknowns that the others are, two for each function of the basis.
    pub(super) fn spread(
        &self,
        equations: &mut Envelope,
        right: &mut [f64],
        [before, whole]: [&[f64]; 2],
        (units, basis): (&[usize], &[Polynomial]),
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
                equations.add(i, j, of[2 + p][2 + q]);
            }
        }
        for (p, i) in basis.iter().zip(units[1..].chunks_exact(2)) {
            let weighted = self.own.weighted(basis.len() - 1, p);
            for lane in 0..2 {
                right[i[lane]] += product(p, &self.own.right[lane]);
            }
            for (q, j) in basis.iter().zip(units[1..].chunks_exact(2)) {
                let [xx, xy, yy] = weighted.each_ref().map(|weighted| product(weighted, q));
                for (a, b, value) in [(0, 0, xx), (0, 1, xy), (1, 0, xy), (1, 1, yy)] {
                    equations.add(i[a], j[b], value);
                }
            }
        }
    }
}
