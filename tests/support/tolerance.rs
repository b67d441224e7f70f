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

/// Distances to a nearest point, relative to the size of curve and place: the finder stops at 1e-13 of the curve's
/// size.
pub(crate) const NEAREST: f64 = 4e-13;

/// Lengths, relative: sums of up to 24 speeds per segment, each a few roundings.
pub(crate) const LENGTH: f64 = 4e-15;

/// Areas and centres, relative to the area or the size: a few roundings for each segment, up to 100 of them.
pub(crate) const AREA: f64 = 2e-14;

/// Extremes, relative to the size of the coordinates: a few roundings, as the place of an extreme does not matter.
pub(crate) const BOUNDS: f64 = 4e-15;

/// Golden values and first derivatives of generators, Bernstein functions and curves, relative to the largest:
/// [`WEIGHTS`] and the four terms of a curve.
pub(crate) const VALUES: f64 = 4e-15;

/// Golden second derivatives, relative to the largest: they are six times the data's size.
pub(crate) const SECOND_DERIVATIVES: f64 = 1e-14;

/// Entries of masks relative to the largest entry: the weights' own accuracy.
pub(crate) const MASKS: f64 = 2e-15;

/// Points of the vector scheme relative to the data: one combination of four terms a level, no growth.
pub(crate) const SCHEME_POINTS: f64 = 4e-15;

/// Derivatives of the vector scheme relative to the data, for one segment a unit long: each level doubles (for
/// arity 2) what a rounding of the points does to their difference quotient.
pub(crate) const SCHEME_DERIVATIVES: f64 = 1e-13;

/// Gram entries, relative: sums of sixteen products that each know six digits more than they need.
pub(crate) const GRAM: f64 = 3e-14;

/// Riesz bounds, relative.
pub(crate) const RIESZ: f64 = 1e-12;

/// Measured distances against the deviation that was reported, relative to the extent: some tens of roundings each in
/// the reading, the oracle's centres of arcs, the evaluation and the search.
pub(crate) const DRAWN: f64 = 1e-13;

/// Exponential B-splines and their derivatives, relative to the largest: sums of at most 34 Taylor terms at each of up
/// to four knots. The worst seen is 1.5e-14, for the roots 0, 0, ±5.
pub(crate) const B_SPLINES: f64 = 2e-14;

/// Weights λ of interpolators, relative to the largest: plain elimination. The worst seen is 3.9e-14, for eight roots
/// to ±2.5i.
pub(crate) const LAMBDA: f64 = 1e-13;

/// Interpolators and their derivatives, relative to the largest and to 1 + 2Σ|λ|, which is what cancels in them: the
/// B-spline's own accuracy. The worst seen is 4.9e-15, for the roots 0, 0, ±5.
pub(crate) const INTERPOLATORS: f64 = 1e-14;

/// Points and derivatives of surfaces, relative to ten times the largest number of the net: sums of some fifty
/// products, each of two weights that know their last digits but one; the largest weights are 1.3.
pub(crate) const SURFACES: f64 = 2e-13;

/// Sums over all points of a net or a curve, relative to the sizes of what is added up: weights that know their last
/// digits but one, for roots some of which nearly coincide.
pub(crate) const SUMS: f64 = 2e-13;

/// Points of exact surfaces off them, relative to their size: sixteen products of weights of 1.3 at most. The worst
/// seen is 3e-15, on the smallest sphere, whose weights are the largest.
pub(crate) const EXACT: f64 = 1e-14;

/// What is on both sides of a seam, relative to the size: the last place of a parameter, times a derivative.
pub(crate) const SEAM: f64 = 4e-14;

/// Normals of exact surfaces: two derivatives' roundings over their length.
pub(crate) const NORMALS: f64 = 1e-13;

/// Normals within 1e-8 of a pole: there the limit stands for the product, which is off by as much.
pub(crate) const NORMALS_AT_POLES: f64 = 1e-7;

/// Curvatures, relative: second derivatives over the square of first ones, which are small beside poles.
pub(crate) const CURVATURES: f64 = 1e-11;

/// Curvatures at poles, relative: fourth derivatives' rounding over the square of the first that are not 0.
pub(crate) const CURVATURES_AT_POLES: f64 = 1e-12;

/// Curvatures beside poles, relative: rounding over the square of the distance, 2⁻¹¹, where a cubic's error takes over.
pub(crate) const CURVATURES_BESIDE_POLES: f64 = 3e-8;

/// The same where curvatures change in less than that, as beside the pole on a coin's edge: the worst seen is 1.5e-3,
/// where rounding is as large as what the cubic does not see.
pub(crate) const CURVATURES_OF_COINS: f64 = 3e-3;

/// Refined surfaces, relative to their size.
pub(crate) const REFINED: f64 = 1e-12;

/// Taps of refinement filters, relative to the largest: products of up to eight factors of one rounding each.
pub(crate) const FILTERS: f64 = 2e-15;
