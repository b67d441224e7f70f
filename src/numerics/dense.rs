//! Small dense systems. What is larger than two by two is one function by nalgebra: every use of a generic
//! decomposition is kilobytes of wasm.

use nalgebra::DMatrix;

/// The inverse of an n × n matrix, row by row both, by elimination with partial pivoting; `None` if it is singular.
#[inline(never)]
pub(crate) fn inverse(matrix: &[f64], n: usize) -> Option<Vec<f64>> {
    // Columns here are rows there: the inverse of the transpose is the transpose of the inverse.
    let lu = DMatrix::from_column_slice(n, n, matrix).lu();
    let mut inverse = DMatrix::identity(n, n);
    lu.solve_mut(&mut inverse).then(|| inverse.as_slice().to_vec())
}

/// The step of Levenberg's method for two unknowns: `matrix` is that of the normal equations, its diagonal larger by
/// `damping` of its sum.
#[inline(never)]
pub(crate) fn damped_step(matrix: [f64; 3], right: [f64; 2], damping: f64) -> [f64; 2] {
    let more = damping * (matrix[0] + matrix[2]);
    let [a, b, c] = [matrix[0] + more, matrix[1], matrix[2] + more];
    let determinant = a * c - b * b;
    [(right[0] * c - right[1] * b) / determinant, (right[1] * a - right[0] * b) / determinant]
}

#[cfg(test)]
mod tests {
    use super::inverse;

    #[test]
    fn a_matrix_times_its_inverse_is_the_identity() {
        for n in 1..12_usize {
            let given: Vec<f64> =
                (0..n * n).map(|k| ((k * k + 3 * k) % 17) as f64 - 8.0 + (k % (n + 1) / n) as f64).collect();
            let found = inverse(&given, n).expect("regular by intent");
            let size = found.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            for i in 0..n {
                for j in 0..n {
                    let sum: f64 = (0..n).map(|k| given[i * n + k] * found[k * n + j]).sum();
                    let expected = f64::from(u8::from(i == j));
                    assert!((sum - expected).abs() < 1e-13 * size * 100.0, "size {n}, ({i}, {j}): {sum}");
                }
            }
        }
        assert!(inverse(&[1.0, 2.0, 2.0, 4.0], 2).is_none(), "singular");
    }
}
