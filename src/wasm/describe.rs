//! Curves on their way to JavaScript: one run of numbers for each.

use crate::numerics::Vector;
use crate::{HermiteCurve, Space};

/// The spaces in the face's order.
pub(super) const SPACES: [Space; 3] = [Space::Trigonometric, Space::Hyperbolic, Space::Polynomial];

/// Numbers in pairs, as points or vectors.
#[cfg(any(feature = "wasm", feature = "wasm-fit", feature = "wasm-trace"))]
pub(super) fn pairs(numbers: &[f64]) -> Vec<Vector> {
    numbers.chunks_exact(2).map(|pair| Vector::new(pair[0], pair[1])).collect()
}

/// Appends numbers: one where all are the same, none where that one is `implied`. Returns how many.
pub(super) fn push_short(output: &mut Vec<f64>, numbers: &[f64], implied: Option<f64>) -> f64 {
    let before = output.len();
    match numbers.first() {
        Some(&first) if numbers.iter().all(|&n| n == first) => {
            if Some(first) != implied {
                output.push(first);
            }
        }
        _ => output.extend_from_slice(numbers),
    }
    (output.len() - before) as f64
}

/// Appends vectors; adding 0 turns −0 into 0, so that JSON can carry every number.
fn push_vectors(output: &mut Vec<f64>, vectors: &[Vector]) {
    for vector in vectors {
        output.extend_from_slice(&[vector.x + 0.0, vector.y + 0.0]);
    }
}

/// Appends a curve to the output.
///
/// Header: points, closed, space, arriving tangents, ω's, lengths, end of the domain. Then as many numbers as the
/// header says: points, tangents, tangentsIn (only where they differ), omega (one or one per segment), lengths (none
/// where all are 1).
pub(super) fn describe(output: &mut Vec<f64>, curve: &HermiteCurve) {
    let count = curve.points().len();
    let start = output.len();
    let space = SPACES.iter().position(|&s| s == curve.space()).unwrap_or(0);
    let differ = curve.tangents_in() != curve.tangents();
    output.reserve(7 + 6 * count);
    let arriving = if differ { count } else { 0 };
    let header = [count, usize::from(curve.is_closed()), space, arriving, 0, 0].map(|n| n as f64);
    output.extend_from_slice(&header);
    output.push(curve.domain().1);
    push_vectors(output, curve.points());
    push_vectors(output, curve.tangents());
    if differ {
        push_vectors(output, curve.tangents_in());
    }
    output[start + 4] = push_short(output, curve.omega(), None);
    output[start + 5] = push_short(output, curve.lengths(), Some(1.0));
}
