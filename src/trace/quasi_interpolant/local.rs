//! Local polynomials, weighted by distance, and the blossoms that make them coefficients of a spline.

use super::cloud::Cloud;
use super::knots::{Knots, MOST_DEGREE};
use crate::error::Result;
use crate::limits::{filled, with_room};

/// Added to the normal matrix's diagonal: clouds with too few abscissae have an answer as well.
const RIDGE: f64 = 1e-9;

type Row = [f64; MOST_DEGREE + 1];

/// Fits the polynomial of a spline's degree to the k points nearest to a Greville abscissa (D 14.2).
///
/// The answer is linear in the ordinates: [`LocalFit::influence`] says how much each of them counts.
pub(super) struct LocalFit {
    k: usize,
    order: Vec<usize>,
    weights: Vec<f64>,
    influence: Vec<f64>,
}

impl LocalFit {
    pub(super) fn new(k: usize) -> Result<Self> {
        Ok(Self { k, order: with_room(k + 1)?, weights: filled(0.0, k)?, influence: filled(0.0, k)? })
    }

    /// Coefficient q of the quasi-interpolant.
    pub(super) fn coefficient(&mut self, cloud: &Cloud, knots: &Knots, q: usize) -> f64 {
        self.weigh(cloud, knots, q);
        self.influence().map(|(i, share)| share * cloud.y()[i]).sum()
    }

    /// The points that count and how much, after [`LocalFit::weigh`].
    pub(super) fn influence(&self) -> impl Iterator<Item = (usize, f64)> {
        self.order.iter().copied().zip(self.influence.iter().copied())
    }

    /// Finds how much each of the neighbours counts in coefficient q.
    pub(super) fn weigh(&mut self, cloud: &Cloud, knots: &Knots, q: usize) {
        let center = knots.abscissa(q);
        cloud.nearest(center, self.k + 1, &mut self.order);
        let offset = |i: usize| cloud.x()[i] - center;
        let reach = self.order.iter().fold(1e-9_f64, |most, &i| most.max(offset(i).abs()));
        self.order.truncate(self.k);
        let size = knots.degree() + 1;
        let mut matrix = [[0.0; MOST_DEGREE + 1]; MOST_DEGREE + 1];
        for (weight, &i) in self.weights.iter_mut().zip(&self.order) {
            let ratio = offset(i).abs() / (1.001 * reach);
            let rest = (1.0 - ratio * ratio * ratio).clamp(0.0, 1.0);
            *weight = rest * rest.sqrt() + 1e-6;
            let row = powers(offset(i), size);
            for a in 0..size {
                for b in 0..=a {
                    matrix[a][b] += *weight * row[a] * row[b];
                }
            }
        }
        (0..size).for_each(|a| matrix[a][a] += RIDGE);
        factor(&mut matrix, size);
        let functional = solve(&matrix, size, blossom_weights(knots, q, center));
        for ((share, &weight), &i) in self.influence.iter_mut().zip(&self.weights).zip(&self.order) {
            let row = powers(offset(i), size);
            *share = weight * (0..size).map(|a| row[a] * functional[a]).sum::<f64>();
        }
    }
}

fn powers(x: f64, size: usize) -> Row {
    let mut row = [0.0; MOST_DEGREE + 1];
    let mut power = 1.0;
    for value in &mut row[..size] {
        *value = power;
        power *= x;
    }
    row
}

/// The blossom of xᵐ about the centre at the knots of coefficient q, for m = 0 … p: the m-th elementary symmetric
/// function of the knots' offsets, divided by the binomial coefficient. For p = 2 it is 1, 0, −(t₂ − t₁)²/4.
fn blossom_weights(knots: &Knots, q: usize, center: f64) -> Row {
    let degree = knots.degree();
    let mut symmetric = [0.0; MOST_DEGREE + 1];
    symmetric[0] = 1.0;
    for (count, &knot) in knots.inner(q).iter().enumerate() {
        for m in (0..=count).rev() {
            symmetric[m + 1] += symmetric[m] * (knot - center);
        }
    }
    let mut binomial = 1.0;
    for (m, value) in symmetric.iter_mut().enumerate().take(degree + 1) {
        *value /= binomial;
        binomial = binomial * (degree - m) as f64 / (m + 1) as f64;
    }
    symmetric
}

/// Cholesky's factor in the lower triangle.
fn factor(matrix: &mut [Row; MOST_DEGREE + 1], size: usize) {
    for a in 0..size {
        for b in 0..=a {
            let known: f64 = (0..b).map(|c| matrix[a][c] * matrix[b][c]).sum();
            let rest = matrix[a][b] - known;
            matrix[a][b] = if a == b { rest.max(RIDGE * RIDGE).sqrt() } else { rest / matrix[b][b] };
        }
    }
}

fn solve(matrix: &[Row; MOST_DEGREE + 1], size: usize, mut x: Row) -> Row {
    for a in 0..size {
        let known: f64 = (0..a).map(|b| matrix[a][b] * x[b]).sum();
        x[a] = (x[a] - known) / matrix[a][a];
    }
    for a in (0..size).rev() {
        let known: f64 = (a + 1..size).map(|b| matrix[b][a] * x[b]).sum();
        x[a] = (x[a] - known) / matrix[a][a];
    }
    x
}
