//! One root, and when two of them are the same.

/// Roots closer than this, relative to 1 + |root|, count as equal, conjugate or opposite.
const NEAR: f64 = 1e-12;

/// One root: the spline keeps e^{re·t}·cos(im·t) and e^{re·t}·sin(im·t).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Root {
    /// Growth per unit of the parameter.
    pub re: f64,
    /// Frequency in radians per unit of the parameter.
    pub im: f64,
}

pub(super) fn size(root: Root) -> f64 {
    (root.re * root.re + root.im * root.im).sqrt()
}

pub(super) fn distance(a: Root, b: Root) -> f64 {
    (a.re - b.re).abs().max((a.im - b.im).abs())
}

pub(super) fn tolerance(root: Root) -> f64 {
    NEAR * (1.0 + size(root))
}
