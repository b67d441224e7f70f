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

/// Solves the system by elimination without pivoting, in place of which the answer is checked.
///
/// `None` where a pivot is lost (below 1e-9 of its row) or a residual exceeds 1e-10 of the system's size: it has
/// no unique solution, or none that elimination finds. Systems with a dominant diagonal always succeed. O(n), any
/// n from 1 up.
pub fn solve(rows: &[Row]) -> Option<Vec<Vector>> {
    let n = rows.len();
    let last = rows.last()?;
    if n == 1 {
        let pivot = regular(last.before + last.center + last.after, last)?;
        return accept(rows, vec![last.right / pivot]);
    }
    // Forward: xᵢ = y − u·xᵢ₊₁ − v·xₙ₋₁.
    let mut kept = Vec::with_capacity(n);
    let (mut y, mut u, mut v) = (Vector::zeros(), 0.0, -1.0);
    for row in &rows[..n - 1] {
        let pivot = regular(row.center - row.before * u, row)?;
        y = (row.right - y * row.before) / pivot;
        v = -row.before * v / pivot;
        u = row.after / pivot;
        kept.push((y, u, v));
    }
    // Backward: xᵢ = p + q·xₙ₋₁, from the last but one down to the first.
    let (mut p, mut q) = (Vector::zeros(), 1.0);
    let mut before_last = (p, q);
    for (i, (y, u, v)) in kept.iter().enumerate().rev() {
        p = y - p * *u;
        q = -u * q - v;
        if i + 2 == n {
            before_last = (p, q);
        }
    }
    let pivot = regular(last.center + last.before * before_last.1 + last.after * q, last)?;
    let end = (last.right - before_last.0 * last.before - p * last.after) / pivot;
    let mut x = vec![end; n];
    let mut next = end;
    for (x, (y, u, v)) in x.iter_mut().zip(&kept).rev() {
        next = y - next * *u - end * *v;
        *x = next;
    }
    accept(rows, x)
}

fn regular(pivot: f64, row: &Row) -> Option<f64> {
    let size = row.before.abs() + row.center.abs() + row.after.abs();
    (pivot.abs() > 1e-9 * size).then_some(pivot)
}

fn accept(rows: &[Row], x: Vec<Vector>) -> Option<Vec<Vector>> {
    let n = x.len();
    let size = |v: &Vector| v.x.abs().max(v.y.abs());
    let largest = x.iter().map(size).fold(0.0, f64::max);
    let fits = rows.iter().enumerate().all(|(i, row)| {
        let (before, after) = (x[(i + n - 1) % n], x[(i + 1) % n]);
        let residual = before * row.before + x[i] * row.center + after * row.after - row.right;
        let scale = (row.before.abs() + row.center.abs() + row.after.abs()) * largest;
        size(&residual) <= 1e-10 * (scale + size(&row.right))
    });
    fits.then_some(x)
}

#[cfg(test)]
mod tests {
    use super::{Row, Vector, solve};

    #[test]
    fn a_cyclic_system_of_any_size_is_solved() {
        for n in 1..9_usize {
            let x: Vec<Vector> = (0..n).map(|i| Vector::new(1.0 + i as f64, (i * i) as f64 - 3.0)).collect();
            let rows: Vec<Row> = (0..n)
                .map(|i| {
                    let (before, center, after) = (1.0, 5.0 + i as f64, -2.0);
                    let right = x[(i + n - 1) % n] * before + x[i] * center + x[(i + 1) % n] * after;
                    Row { before, center, after, right }
                })
                .collect();
            let solution = solve(&rows).expect("the diagonal dominates");
            for (found, expected) in solution.iter().zip(&x) {
                assert!((found - expected).norm() < 1e-13, "size {n}");
            }
        }
    }

    #[test]
    fn a_singular_system_has_no_answer() {
        let row = Row { before: 1.0, center: 2.0, after: 1.0, right: Vector::new(1.0, 0.0) };
        assert!(solve(&[row; 4]).is_none(), "(1, −1, 1, −1) solves the homogeneous system");
        assert!(solve(&[]).is_none(), "nothing is asked");
    }
}
