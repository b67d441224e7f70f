//! The equations of points that are equally far apart along a curve, gathered piece by piece.
//!
//! Where a point's place moves along the curve depends on all coefficients, but in one way for all points of a piece,
//! except for the coefficients of that piece: a point costs no more than one that depends on its piece alone. What
//! points are off is summed point by point, and says where steps lead; how places move, which says how long they are,
//! at two places in each part of a piece.

use super::growth::{Local, Place};
use crate::fit::knots::breaks::HIGHEST;
use crate::fit::knots::envelope::Envelope;
use crate::fit::knots::free_knots::product;
use crate::fit::knots::space::Polynomial;
use crate::fit::knots::spline::Across;
use crate::numerics::Vector;

/// Points whose places in a part differ by less, in the mean of squares, are at one.
const ONE_PLACE: f64 = 1e-12;
/// The length before the piece, the whole length, and the first point's.
pub(super) const LENGTHS: usize = 3;
const SIZE: usize = LENGTHS + 2 * (HIGHEST + 1);

/// Sums over the points of a part of a piece, which is from 0 to 1 there: of the powers of their places, and of these
/// with what they are off along the curve.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Crowd {
    weights: [f64; 4],
    pub(super) beside: [f64; 4],
}

impl Crowd {
    /// Takes a point at v that is `beside` its place, along the curve.
    #[inline(always)]
    pub(super) fn take(&mut self, v: f64, w: f64, beside: f64) {
        let powers = [1.0, v, v * v, v * v * v];
        for (k, power) in powers.into_iter().enumerate() {
            self.weights[k] += w * power;
            self.beside[k] += w * beside * power;
        }
    }

    /// Weights and places of two points that stand for all: sums of cubics are the same (Gauss's rule for the points'
    /// measure).
    pub(super) fn nodes(&self) -> [[f64; 2]; 2] {
        let [whole, first, second, third] = self.weights;
        if whole <= 0.0 {
            return [[0.0; 2]; 2];
        }
        let mean = first / whole;
        let square = second / whole - mean * mean;
        if square < ONE_PLACE {
            return [[whole, mean], [0.0, mean]];
        }
        let deviation = square.sqrt();
        let cube = third / whole - mean * (3.0 * square + mean * mean);
        let skewness = cube / (square * deviation);
        let root = (skewness * skewness + 4.0).sqrt();
        [0.5 * (skewness - root), 0.5 * (skewness + root)]
            .map(|x| [whole / (1.0 + x * x), mean + deviation * x])
    }
}

/// Sums over the points of a piece: of products of what their places move by along the curve, and with what they are
/// off; and the same across, where only the piece's own coefficients count.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    products: [[f64; SIZE]; SIZE],
    pub(super) right: [f64; SIZE],
    own: Across,
}

impl Default for Sums {
    fn default() -> Self {
        Self { products: [[0.0; SIZE]; SIZE], right: [0.0; SIZE], own: Across::default() }
    }
}

impl Sums {
    /// Takes a place of weight w that points are at; `lengths` is how a point's length along the curve, less that of
    /// the place, grows with the first three, and `grown` how the place's length from the start of the piece grows with
    /// the coefficients there. `stay` is how much it counts that the parameter stays as it is.
    pub(super) fn take(
        &mut self,
        [w, stay]: [f64; 2],
        lengths: [f64; LENGTHS],
        (place, grown): (&Place, &Local),
    ) {
        let (along, mut far) = (place.along, [0.0; SIZE]);
        far[..LENGTHS].copy_from_slice(&lengths);
        for i in 0..=HIGHEST {
            far[LENGTHS + 2 * i] = place.shares[i] * along.x - grown[2 * i];
            far[LENGTHS + 2 * i + 1] = place.shares[i] * along.y - grown[2 * i + 1];
        }
        for (sums, one) in self.products.iter_mut().zip(far) {
            sums.iter_mut().zip(far).for_each(|(sum, far)| *sum += w * one * far);
        }
        let [xx, yy] = [along.x * along.x, along.y * along.y];
        let weight = [w * (yy + stay * xx), w * (stay - 1.0) * along.x * along.y, w * (xx + stay * yy)];
        self.own.take::<{ HIGHEST + 1 }>(place.u, weight, [0.0; 2]);
    }

    /// Takes what a point at u is off, `rest` in both coordinates.
    pub(super) fn pull(&mut self, u: f64, rest: Vector) {
        let mut power = 1.0;
        for k in 0..=HIGHEST {
            self.own.right[0][k] += power * rest.x;
            self.own.right[1][k] += power * rest.y;
            power *= u;
        }
    }

    /// Adds the sums to the equations of all coefficients. `dense` are the growths of the first two lengths by all of
    /// them, `units` the numbers of the unknowns that the others are, two for each function of the basis.
    pub(super) fn spread(
        &self,
        equations: &mut Envelope,
        right: &mut [f64],
        [before, whole]: [&[f64]; 2],
        (units, basis): (&[usize], &[Polynomial]),
    ) {
        let of = &self.products;
        // The first two of the sums are those of the lengths.
        let both = |k: usize| before.iter().zip(whole).map(|(a, b)| of[k][0] * a + of[k][1] * b).collect();
        let mut rows: [Vec<f64>; 2] = [both(0), both(1)];
        for (p, &i) in units.iter().enumerate() {
            right[i] += self.right[2 + p];
            (0..2).for_each(|k| rows[k][i] += of[2 + p][k]);
            equations.add_to_row(i, &before[..=i], of[2 + p][0]);
            equations.add_to_row(i, &whole[..=i], of[2 + p][1]);
        }
        for (i, (a, b)) in before.iter().zip(whole).enumerate() {
            right[i] += self.right[0] * a + self.right[1] * b;
            equations.add_to_row(i, &rows[0][..=i], *a);
            equations.add_to_row(i, &rows[1][..=i], *b);
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

#[cfg(test)]
mod tests {
    use super::Crowd;

    #[test]
    fn two_places_stand_for_all_points_of_a_part() {
        let crowds: [&[[f64; 2]]; 4] = [
            &[[0.1, 1.0], [0.25, 2.0], [0.3, 0.5], [0.9, 1.0]],
            &[[0.2, 1.0], [0.7, 3.0]],
            &[[0.4, 2.0]],
            &[[0.4, 2.0], [0.4, 1.0], [0.4, 0.1]],
        ];
        for points in crowds {
            let mut crowd = Crowd::default();
            points.iter().for_each(|[v, w]| crowd.take(*v, *w, 0.0));
            let cubic = |v: f64| 1.0 + v * (2.0 + v * (3.0 - 5.0 * v));
            let expected: f64 = points.iter().map(|[v, w]| w * cubic(*v)).sum();
            let got: f64 = crowd.nodes().iter().map(|[w, v]| w * cubic(*v)).sum();
            assert!((got - expected).abs() < 1e-12 * expected, "{got} for {expected}");
            let inside = |[w, v]: &[f64; 2]| *w >= 0.0 && (0.0..=1.0).contains(v);
            assert!(crowd.nodes().iter().all(inside), "{:?}", crowd.nodes());
        }
        assert_eq!(Crowd::default().nodes()[0][0], 0.0, "no points, no weight");
    }
}
