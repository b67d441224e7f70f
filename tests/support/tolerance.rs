//! Every tolerance of the promises in this folder, with its reason.

/// Weights and their derivatives, relative to the largest of their kind: three terms of at most four times the
/// result, each with two roundings of 1.1e-16. The worst seen is 2.0e-15, at w just above π in the hyperbolic
/// space, 1.1e-15 elsewhere.
pub(crate) const WEIGHTS: f64 = 2.5e-15;
