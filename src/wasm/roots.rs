//! Lists of roots on their way in and out.

use crate::Result;
use crate::generator::{Root, Roots};

/// Numbers in pairs, as roots.
pub(super) fn roots_of(numbers: &[f64]) -> Result<Roots> {
    let list: Vec<Root> = numbers.chunks_exact(2).map(|pair| Root { re: pair[0], im: pair[1] }).collect();
    Roots::new(&list, "roots")
}

/// Appends roots in pairs; adding 0 turns −0 into 0.
pub(super) fn push_roots(output: &mut Vec<f64>, roots: &Roots) {
    for root in roots.as_slice() {
        output.extend([root.re + 0.0, root.im + 0.0]);
    }
}
