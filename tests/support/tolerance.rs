//! Every tolerance of the promises in this folder, with its reason.

/// Weights and their derivatives, relative to the largest of their kind: three terms of at most four times the
/// result, each with two roundings of 1.1e-16. The worst seen is 2.0e-15, at w just above π in the hyperbolic
/// space, 1.1e-15 elsewhere.
pub(crate) const WEIGHTS: f64 = 2.5e-15;

/// Places on drawings of size 10, absolute: 10 roundings of 1.1e-16 each, times the size.
pub(crate) const SMALL_DRAWING: f64 = 1.2e-14;

/// Points of arcs against SVG's own centre parametrisation, relative to the larger radius: about 40 roundings of
/// 1.1e-16 in that formula and as many in the curve. The worst seen is 6.8e-15.
pub(crate) const ARC: f64 = 1e-14;
