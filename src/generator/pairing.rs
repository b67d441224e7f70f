//! Conjugates and opposites among roots, found within a tolerance and made exact.

use super::root::{Root, distance, tolerance};

/// A real root, or a pair re ± i·im with im > 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factor {
    pub(super) re: f64,
    pub(super) im: f64,
    /// Where the members are in the list, that with im > 0 first; a real root is both.
    pub(super) first: usize,
    pub(super) second: usize,
}

/// Matches every root above the real line with the nearest conjugate below it.
#[inline(never)]
pub(super) fn pair_up(list: &mut [Root]) -> core::result::Result<Vec<Factor>, usize> {
    let mut free = vec![true; list.len()];
    let mut factors = Vec::new();
    for i in 0..list.len() {
        let root = list[i];
        if !free[i] || root.im == 0.0 {
            continue;
        }
        let conjugate = Root { re: root.re, im: -root.im };
        let (mut best, mut least) = (None, tolerance(root));
        for j in 0..list.len() {
            let away = distance(list[j], conjugate);
            if free[j] && j != i && list[j].im != 0.0 && away <= least {
                (best, least) = (Some(j), away);
            }
        }
        free[i] = false;
        if let Some(j) = best {
            free[j] = false;
            let (re, im) = (0.5 * (root.re + list[j].re), 0.5 * (root.im - list[j].im));
            let (first, second) = if im > 0.0 { (i, j) } else { (j, i) };
            factors.push(Factor { re, im: im.abs(), first, second });
        } else if root.im.abs() <= tolerance(root) {
            factors.push(Factor { re: root.re, im: 0.0, first: i, second: i });
        } else {
            return Err(i);
        }
    }
    for (i, root) in list.iter().enumerate().filter(|(_, root)| root.im == 0.0) {
        factors.push(Factor { re: root.re, im: 0.0, first: i, second: i });
    }
    Ok(factors)
}

/// Makes opposite factors exactly opposite; the index of a root that has none.
#[inline(never)]
pub(super) fn oppose(factors: &mut [Factor]) -> Option<usize> {
    let mut free = vec![true; factors.len()];
    let mut without = None;
    for i in 0..factors.len() {
        if !free[i] {
            continue;
        }
        let this = factors[i];
        let opposite = Root { re: -this.re, im: this.im };
        let (mut best, mut least) = (None, tolerance(opposite));
        for j in i..factors.len() {
            let away = distance(Root { re: factors[j].re, im: factors[j].im }, opposite);
            // Itself when nothing is nearer: purely imaginary pairs and 0 are their own opposites.
            if free[j] && (away < least || (best.is_none() && away <= least)) {
                (best, least) = (Some(j), away);
            }
        }
        free[i] = false;
        if let Some(j) = best {
            free[j] = false;
            let re = 0.5 * (this.re - factors[j].re);
            let im = 0.5 * (this.im + factors[j].im);
            (factors[i].re, factors[i].im) = (re, im);
            (factors[j].re, factors[j].im) = (if j == i { re } else { -re }, im);
        } else {
            without = without.or(Some(this.first));
        }
    }
    without
}
