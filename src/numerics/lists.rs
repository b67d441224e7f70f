//! Sums over lists of numbers, and the steps of even ones.

/// Adds the numbers of a list, times their weight.
///
/// A function of its own: half a kilobyte of vector code, once and not wherever such a loop is.
#[inline(never)]
pub(crate) fn add_scaled(sums: &mut [f64], weight: f64, list: &[f64]) {
    for (sum, number) in sums.iter_mut().zip(list) {
        *sum += weight * number;
    }
}

/// The scalar product of two lists, as long as the shorter one.
#[inline]
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// How many steps lie between `count` places: as many on a closed way, one less on an open one; 1 at least, to divide
/// by.
pub(crate) fn steps(count: usize, closed: bool) -> usize {
    let steps = if closed { count } else { count.saturating_sub(1) };
    steps.max(1)
}
