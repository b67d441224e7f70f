//! Taylor sums of the functions eⱼ of a list of roots, eⱼ⁽ⁱ⁾(0) = δᵢⱼ, and what they make of derivatives elsewhere
//! (D 9.10).

use super::lattice::Shape;

/// Terms of the Taylor sums of eⱼ at most: (10/4)³⁰/30! and less is left.
const TERMS: usize = 40;
/// What is smaller than this on all of a piece is left out of them.
const NEGLIGIBLE: f64 = 1e-18;

/// Σ cₖ·y²ᵏ, times y for odd j.
pub(super) fn every_other(coefficients: &[f64], y: f64, j: usize) -> f64 {
    let square = y * y;
    let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * square + c);
    if j % 2 == 1 { sum * y } else { sum }
}

/// The matrix that takes derivatives at 0 to those at y: eⱼ⁽ⁱ⁾(y), row by row, with eⱼ′ = eⱼ₋₁ − χⱼ eₙ₋₁.
#[inline(never)]
pub(super) fn shift(series: &[f64], terms: usize, characteristic: &[f64], y: f64, matrix: &mut Vec<f64>) {
    let order = characteristic.len();
    matrix.clear();
    for (j, series) in series.chunks_exact(terms).enumerate() {
        matrix.push(every_other(series, y, j));
    }
    for i in 1..order {
        let above = (i - 1) * order;
        let last = matrix[above + order - 1];
        for (j, c) in characteristic.iter().enumerate() {
            let before = if j == 0 { 0.0 } else { matrix[above + j - 1] };
            matrix.push(before - c * last);
        }
    }
}

/// The Taylor coefficients of eⱼ for all j, every other one, and how many of each: eⱼ⁽ᵐ⁺ⁿ⁾ = −Σ χᵢ eⱼ⁽ᵐ⁺ⁱ⁾.
#[inline(never)]
pub(super) fn series(shape: &Shape) -> (Vec<f64>, usize) {
    let order = shape.characteristic.len();
    let mut all = vec![0.0; order * TERMS];
    let mut used = order;
    for (j, row) in all.chunks_exact_mut(TERMS).enumerate() {
        row[j] = 1.0;
        for m in order..TERMS {
            let before = &row[m - order..m];
            row[m] = -shape.characteristic.iter().zip(before).map(|(c, y)| c * y).sum::<f64>();
        }
        let mut scale = 1.0;
        for (q, c) in row.iter_mut().enumerate() {
            let divisor = q.max(1) as f64;
            *c /= scale * divisor;
            scale *= divisor;
        }
        // Beside the first term, on half a piece.
        let mut reach = 1.0;
        for (q, c) in row.iter().enumerate().skip(j) {
            if (c * reach).abs() > NEGLIGIBLE * row[j].abs() {
                used = used.max(q + 1);
            }
            reach *= 0.5;
        }
    }
    let terms = used.div_ceil(2);
    let mut kept = Vec::with_capacity(order * terms);
    for (j, row) in all.chunks_exact(TERMS).enumerate() {
        kept.extend(row[j % 2..].iter().step_by(2).take(terms));
    }
    (kept, terms)
}
