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

/// Distances to a nearest point, relative to the size of curve and place: the finder stops at 1e-13 of the curve's size.
pub(crate) const NEAREST: f64 = 4e-13;

/// Lengths, relative: sums of up to 24 speeds per segment, each a few roundings.
pub(crate) const LENGTH: f64 = 4e-15;

/// Areas and centres, relative to the area or the size: a few roundings for each segment, up to 100 of them.
pub(crate) const AREA: f64 = 2e-14;

/// Extremes, relative to the size of the coordinates: a few roundings, as the place of an extreme does not matter.
pub(crate) const BOUNDS: f64 = 4e-15;
