//! Tridiagonal systems whose corners may be filled: the continuity conditions of an open or closed curve.

use super::Vector;

/// Row i of a cyclic tridiagonal system: before·xᵢ₋₁ + center·xᵢ + after·xᵢ₊₁ = right, indices modulo the size.
#[derive(Clone, Copy, Debug, Default)]
pub struct Row {
    /// Coefficient of the unknown before, the last one for row 0.
    pub before: f64,
    /// Coefficient of the row's own unknown.
    pub center: f64,
    /// Coefficient of the unknown after, the first one for the last row.
    pub after: f64,
    /// The right-hand side.
    pub right: Vector,
}

/// Solves the system by elimination without pivoting, in place: the solution is left in the right-hand sides.
///
/// `None` where a pivot is below a thousandth of its row: the system has no unique solution, or none that this
/// elimination finds with digits to spare. A diagonal of at least twice what stands beside it always suffices. O(n),
/// any n from 2 up.
pub fn solve(rows: &mut [Row]) -> Option<()> {
    let (last, others) = rows.split_last_mut()?;
    // Forward: xᵢ = right − after·xᵢ₊₁ − before·xₙ₋₁, for the row before the first with xₙ₋₁ itself.
    let (mut y, mut u, mut v) = (Vector::zeros(), 0.0, -1.0);
    for row in others.iter_mut() {
        let pivot = regular(row.center - row.before * u, row)?;
        y = (row.right - y * row.before) / pivot;
        v = -row.before * v / pivot;
        u = row.after / pivot;
        (row.right, row.after, row.before) = (y, u, v);
    }
    let before_last = (y, -u - v);
    // Backward: xᵢ = right + before·xₙ₋₁, from the last but one down to the first.
    let (mut p, mut q) = (Vector::zeros(), 1.0);
    for row in others.iter_mut().rev() {
        (p, q) = (row.right - p * row.after, -row.after * q - row.before);
        (row.right, row.before) = (p, q);
    }
    let pivot = regular(last.center + last.before * before_last.1 + last.after * q, last)?;
    last.right = (last.right - before_last.0 * last.before - p * last.after) / pivot;
    for row in others {
        row.right += last.right * row.before;
    }
    Some(())
}

fn regular(pivot: f64, row: &Row) -> Option<f64> {
    let size = row.before.abs() + row.center.abs() + row.after.abs();
    (pivot.abs() > 1e-3 * size).then_some(pivot)
}

#[cfg(test)]
mod tests {
    use super::{Row, Vector, solve};

    #[test]
    fn a_cyclic_system_of_any_size_is_solved() {
        for n in 2..9_usize {
            let x: Vec<Vector> = (0..n).map(|i| Vector::new(1.0 + i as f64, (i * i) as f64 - 3.0)).collect();
            let mut rows: Vec<Row> = (0..n)
                .map(|i| {
                    let (before, center, after) = (1.0, 5.0 + i as f64, -2.0);
                    let right = x[(i + n - 1) % n] * before + x[i] * center + x[(i + 1) % n] * after;
                    Row { before, center, after, right }
                })
                .collect();
            solve(&mut rows).expect("the diagonal dominates");
            for (found, expected) in rows.iter().zip(&x) {
                assert!((found.right - expected).norm() < 1e-13, "size {n}");
            }
        }
    }

    #[test]
    fn a_singular_system_has_no_answer() {
        let row = Row { before: 1.0, center: 2.0, after: 1.0, right: Vector::new(1.0, 0.0) };
        assert!(solve(&mut [row; 4]).is_none(), "(1, −1, 1, −1) solves the homogeneous system");
        assert!(solve(&mut []).is_none(), "nothing is asked");
    }
}
