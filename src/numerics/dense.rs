//! Small dense systems. A library's elimination is made for any size and any storage: 11 kB of wasm where this is half of one.

/// The inverse of an n × n matrix, row by row, by elimination with partial pivoting; `None` if a pivot is 0 or no number.
#[inline(never)]
pub(crate) fn inverse(matrix: &[f64], n: usize) -> Option<Vec<f64>> {
    let width = 2 * n;
    let mut rows = vec![0.0; n * width];
    for (i, (row, given)) in rows.chunks_exact_mut(width).zip(matrix.chunks_exact(n)).enumerate() {
        row[..n].copy_from_slice(given);
        row[n + i] = 1.0;
    }
    for k in 0..n {
        let size = |i: usize| rows[i * width + k].abs();
        let best = (k..n).fold(k, |best, i| if size(i) > size(best) { i } else { best });
        let pivot = rows[best * width + k];
        // Written so that NaN fails.
        if pivot.abs() > 0.0 {
            for j in 0..width {
                rows.swap(k * width + j, best * width + j);
                rows[k * width + j] /= pivot;
            }
        } else {
            return None;
        }
        for i in (0..n).filter(|&i| i != k) {
            let factor = rows[i * width + k];
            for j in 0..width {
                rows[i * width + j] -= factor * rows[k * width + j];
            }
        }
    }
    Some(rows.chunks_exact(width).flat_map(|row| &row[n..]).copied().collect())
}

#[cfg(test)]
mod tests {
    use super::inverse;
    use nalgebra::DMatrix;

    #[test]
    fn inverses_are_those_of_a_library() {
        for n in 1..12_usize {
            let given: Vec<f64> = (0..n * n).map(|k| ((k * k + 3 * k) % 17) as f64 - 8.0).collect();
            let expected = DMatrix::from_row_slice(n, n, &given).try_inverse();
            let Some(expected) = expected.filter(|m| m.abs().max() < 1e6) else { continue };
            let got = inverse(&given, n).expect("the library finds one");
            let off = (DMatrix::from_row_slice(n, n, &got) - &expected).abs().max();
            assert!(off < 1e-10 * expected.abs().max(), "size {n}: {off:e}");
        }
        assert!(inverse(&[1.0, 2.0, 2.0, 4.0], 2).is_none(), "singular");
        assert!(inverse(&[f64::NAN, 0.0, 0.0, 1.0], 2).is_none(), "no numbers");
    }
}
