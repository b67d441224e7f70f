//! Many samples between two places for knots, replaced by few that say the same.
//!
//! Between two places every curve of the problem is one polynomial of the highest degree a. Its square distance to the
//! samples there is, but for a constant, that to a + 1 weighted points: the nodes and weights of Gauss's rule for the
//! samples' own weights, and at them the values of the samples' best polynomial. (D 12.11)

use crate::error::Result;
use crate::fit::convex::interval::TERMS;
use crate::fit::convex::scaled::Scaled;
use crate::limits;
use crate::numerics::Vector;
use crate::numerics::angle::sin_cos;
use crate::numerics::order::sort_numbers;
use crate::numerics::roots::bracketed_root;

/// Orthonormal polynomials of the samples of one cell by their three-term recurrence.
#[derive(Clone, Copy, Debug)]
struct Recurrence {
    centre: [f64; TERMS],
    /// `norm[k]`² is the square of the monic polynomial of degree k over that of degree k − 1; `norm[0]`² the weight.
    norm: [f64; TERMS],
    degree: usize,
}

impl Recurrence {
    /// The orthonormal polynomials 0 … degree at x, and the monic one behind them with its derivative.
    #[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
    fn at(&self, x: f64) -> ([f64; TERMS], f64, f64) {
        let mut values = [0.0; TERMS];
        let (mut before, mut here, mut slope_before, mut slope) = (0.0, 1.0 / self.norm[0], 0.0, 0.0);
        for k in 0..=self.degree {
            values[k] = here;
            let back = if k == 0 { 0.0 } else { self.norm[k] };
            let scale = if k < self.degree { 1.0 / self.norm[k + 1] } else { 1.0 };
            let next = ((x - self.centre[k]) * here - back * before) * scale;
            let next_slope = (here + (x - self.centre[k]) * slope - back * slope_before) * scale;
            (before, here, slope_before, slope) = (here, next, slope, next_slope);
        }
        (values, here, slope)
    }

    /// For the samples of a cell, in a variable within ±1; `None` where they are too few or too close together. Leaves
    /// the values of the orthonormal polynomials at the samples, one polynomial after the other.
    fn of_samples(x: &[f64], w: &[f64], degree: usize, values: &mut Vec<f64>) -> Option<Self> {
        let count = x.len();
        let mut recurrence = Self { centre: [0.0; TERMS], norm: [1.0; TERMS], degree };
        recurrence.norm[0] = w.iter().sum::<f64>().sqrt();
        values.clear();
        values.resize(count, 1.0 / recurrence.norm[0]);
        for k in 0..=degree {
            let here = &values[k * count..];
            let moment: f64 = x.iter().zip(w).zip(here).map(|((x, w), p)| w * x * (p * p)).sum();
            recurrence.centre[k] = moment;
            // The next one, still to be divided by its norm.
            let back = if k == 0 { 0.0 } else { recurrence.norm[k] };
            let mut square = 0.0;
            for (m, (x, w)) in x.iter().zip(w).enumerate() {
                let before = if k == 0 { 0.0 } else { values[(k - 1) * count + m] };
                let next = (x - moment) * values[k * count + m] - back * before;
                square += w * (next * next);
                values.push(next);
            }
            if square.is_nan() || square <= 1e-12 {
                return None;
            }
            if k < degree {
                recurrence.norm[k + 1] = square.sqrt();
                let scale = 1.0 / recurrence.norm[k + 1];
                values[(k + 1) * count..].iter_mut().for_each(|value| *value *= scale);
            }
        }
        Some(recurrence)
    }

    /// The nodes by Newton's method from those of even samples; `None` where that does not find all of them.
    fn even_nodes(&self) -> Option<[f64; TERMS]> {
        let mut nodes = [0.0; TERMS];
        let mut before = -1.0;
        for (i, node) in nodes.iter_mut().enumerate().take(self.degree + 1) {
            let angle = core::f64::consts::PI * (i as f64 + 0.75) / (self.degree as f64 + 1.5);
            let mut x = -sin_cos(angle).1;
            let mut settled = false;
            for _ in 0..8 {
                let (_, value, slope) = self.at(x);
                let step = value / slope;
                x -= step;
                settled = step.abs() < 1e-9;
                if settled || x.is_nan() || x.abs() >= 1.0 {
                    break;
                }
            }
            // Ascending, so all different, and as many as the degree: these are all zeros.
            if !settled || x <= before + 1e-6 || x >= 1.0 {
                return None;
            }
            (*node, before) = (x, x);
        }
        Some(nodes)
    }

    /// The zeros of the polynomial of degree + 1: between those of each degree lie those of the one before.
    fn nodes(&self) -> [f64; TERMS] {
        if let Some(nodes) = self.even_nodes() {
            return nodes;
        }
        let mut nodes = [0.0; TERMS];
        for k in 0..=self.degree {
            let lower = Self { degree: k, ..*self };
            let before = nodes;
            for i in 0..=k {
                let low = if i == 0 { -1.0 } else { before[i - 1] };
                let high = if i == k { 1.0 } else { before[i] };
                let rising = (k - i).is_multiple_of(2);
                nodes[i] = bracketed_root(low, high, rising, 0.5 * (low + high), &mut |x| {
                    let (_, value, slope) = lower.at(x);
                    (value, slope)
                });
            }
        }
        nodes
    }
}

/// Replaces the samples of every cell between places where they are many; what their distances have beyond those of
/// the points that replace them is added to `data.beyond`. O(M).
pub(crate) fn compress(data: &mut Scaled) -> Result<()> {
    let degree = data.components.iter().map(|c| c.degree).max().unwrap_or(1);
    let places: usize = data.components.iter().map(|c| c.grid.len()).sum();
    if data.t.len() < 3 * (degree + 1) * places {
        return Ok(());
    }
    let mut bounds = limits::with_room(places + 2)?;
    bounds.extend(data.components.iter().flat_map(|c| c.grid.iter().copied()));
    bounds.push(0.0);
    bounds.push(data.length);
    sort_numbers(&mut bounds);
    bounds.dedup();
    let mut few = [Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    let (mut xs, mut values, mut from) = (Vec::new(), Vec::new(), 0);
    for cell in bounds.windows(2) {
        let mut to = from;
        while to < data.t.len() && (data.t[to] < cell[1] || cell[1] >= data.length) {
            to += 1;
        }
        let (middle, half) = (0.5 * (cell[0] + cell[1]), 0.5 * (cell[1] - cell[0]));
        xs.clear();
        xs.extend(data.t[from..to].iter().map(|t| (t - middle) / half));
        let rule = if to - from > degree + 2 {
            Recurrence::of_samples(&xs, &data.w[from..to], degree, &mut values)
        } else {
            None
        };
        match rule {
            Some(rule) => data.beyond += replace(data, from, (&xs, &values), &rule, (middle, half), &mut few),
            None => {
                few[0].extend_from_slice(&data.t[from..to]);
                few[1].extend_from_slice(&data.x[from..to]);
                few[2].extend_from_slice(&data.y[from..to]);
                few[3].extend_from_slice(&data.w[from..to]);
            }
        }
        from = to;
    }
    [data.t, data.x, data.y, data.w] = few;
    data.find_samples()
}

/// Writes the points that replace the samples of a cell; answers the square distance that they lack.
fn replace(
    data: &Scaled,
    from: usize,
    (xs, values): (&[f64], &[f64]),
    rule: &Recurrence,
    (middle, half): (f64, f64),
    few: &mut [Vec<f64>; 4],
) -> f64 {
    // Orthonormal, so that the best polynomial leaves Σ w|p|² less the squares of its coefficients; the samples' first
    // point is taken off, or that difference would lose its digits.
    let count = xs.len();
    let origin = Vector::new(data.x[from], data.y[from]);
    let mut best = [Vector::zeros(); TERMS];
    let mut rest = 0.0;
    for m in 0..count {
        let w = data.w[from + m];
        let point = Vector::new(data.x[from + m], data.y[from + m]) - origin;
        rest += w * (point.x * point.x + point.y * point.y);
        for (k, sum) in best.iter_mut().enumerate().take(rule.degree + 1) {
            *sum += point * (w * values[k * count + m]);
        }
    }
    let explained: f64 = best.iter().map(|v| v.x * v.x + v.y * v.y).sum();
    let rest = (rest - explained).max(0.0);
    let polynomial = |values: &[f64; TERMS]| {
        best.iter().zip(values).fold(origin, |sum, (term, value)| sum + term * *value)
    };
    for &node in &rule.nodes()[..=rule.degree] {
        let values = rule.at(node).0;
        let point = polynomial(&values);
        few[0].push(middle + half * node);
        few[1].push(point.x);
        few[2].push(point.y);
        few[3].push(1.0 / values.iter().map(|v| v * v).sum::<f64>());
    }
    rest
}
