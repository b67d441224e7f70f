//! Factors and solutions for the commonest shapes, whose sizes the compiler knows: splines on a circle of degree 1 and
//! 3, both coordinates of a point together. Loops of known length become vector instructions without a remainder.

use super::{invert, least_pivots};

/// Twice the half-width of the widest of these bands, and two.
const ROOM: usize = 20;

/// The factors L D L′; a column holds the diagonal, H entries of the band and B of the border. Two columns at a time:
/// what they take from those behind them is taken in one pass. The band has an even number of columns.
#[allow(clippy::needless_range_loop, reason = "matrices are written with their indices")]
pub(super) fn factor<const H: usize, const B: usize, const S: usize>(
    columns: &mut [f64],
    corner: &mut [f64],
    floor: f64,
) -> usize {
    let least = least_pivots(columns, S, floor);
    let columns = columns.as_chunks_mut::<S>().0;
    let corner = corner.as_chunks_mut::<B>().0;
    let mut held = 0;
    let mut j = 0;
    while let Some((pair, rest)) = columns[j..].split_first_chunk_mut::<2>() {
        let [head, second] = pair;
        held += usize::from(invert(&mut head[0], least[j]));
        let mut u = [0.0; ROOM];
        u[..=H].copy_from_slice(&head[..=H]);
        let own = head[1] * head[0];
        for i in 0..H {
            second[i] -= own * u[i + 1];
        }
        for i in 1 + H..S {
            second[i] -= own * head[i];
        }
        held += usize::from(invert(&mut second[0], least[j + 1]));
        let inverses = (head[0], second[0]);
        let mut v = [0.0; ROOM];
        v[..=H].copy_from_slice(&second[..=H]);
        let (u_border, v_border): ([f64; B], [f64; B]) =
            (core::array::from_fn(|i| head[1 + H + i]), core::array::from_fn(|i| second[1 + H + i]));
        // Beyond the band u and v are zero: every column behind is treated as if all of it coupled.
        for (k, column) in rest.iter_mut().take(H).enumerate() {
            let (a, b) = (u[k + 2] * inverses.0, v[k + 1] * inverses.1);
            if let (Some(u), Some(v)) = (u[k + 2..].first_chunk::<H>(), v[k + 1..].first_chunk::<H>()) {
                for i in 0..H {
                    column[i] -= a * u[i] + b * v[i];
                }
            }
            for i in 0..B {
                column[1 + H + i] -= a * u_border[i] + b * v_border[i];
            }
        }
        for (k, column) in corner.iter_mut().enumerate() {
            let (a, b) = (u_border[k] * inverses.0, v_border[k] * inverses.1);
            for i in 0..B {
                column[i] -= a * u_border[i] + b * v_border[i];
            }
        }
        j += 2;
    }
    held
}

/// The first half of the solution, down the band; what it leaves for the border is taken from there. The next H
/// unknowns are kept beside the list: each is read from it once, and none waits until another is written.
pub(super) fn forward<const H: usize, const B: usize, const S: usize>(
    columns: &[f64],
    band: &mut [f64],
    border: &mut [f64],
) {
    let Some(border) = border.first_chunk_mut::<B>() else { return };
    let mut next: [f64; H] = core::array::from_fn(|i| band.get(i).copied().unwrap_or(0.0));
    for (j, column) in columns.as_chunks::<S>().0.iter().enumerate() {
        let value = next[0] * column[0];
        for i in 1..H {
            next[i - 1] = next[i] - value * column[i];
        }
        next[H - 1] = band.get(j + H).copied().unwrap_or(0.0) - value * column[H];
        band[j] = value;
        for i in 0..B {
            border[i] -= value * column[1 + H + i];
        }
    }
}

/// The second half, up the band. What was found last is added last: all other products do not wait for it.
pub(super) fn backward<const H: usize, const B: usize, const S: usize>(
    columns: &[f64],
    band: &mut [f64],
    border: &[f64],
) {
    let Some(border) = border.first_chunk::<B>() else { return };
    let mut found = [0.0; H];
    for (value, column) in band.iter_mut().zip(columns.as_chunks::<S>().0).rev() {
        let mut known = 0.0;
        for i in 0..B {
            known += border[i] * column[1 + H + i];
        }
        for i in (0..H).rev() {
            known += found[i] * column[1 + i];
        }
        *value -= known * column[0];
        found.copy_within(..H - 1, 1);
        found[0] = *value;
    }
}
