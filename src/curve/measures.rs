//! What is asked of curves, written once, against their [`Pieces`](super::pieces::Pieces): lengths, areas, bounds,
//! curvature, nearest points, polylines and cubic Béziers.

mod arc_chords;
mod arcs;
pub(super) mod area;
pub(super) mod bounds;
pub(super) mod by_length;
mod chords;
mod cubic_fit;
mod cubic_proof;
pub(super) mod cubics;
pub(super) mod curvature;
pub(super) mod flatten;
pub(super) mod length;
pub(super) mod nearest;
pub(super) mod nearest_in_space;
mod search;
mod spreading;
pub(crate) mod tolerance;

/// The measures themselves, for callers that hold a curve by its pieces.
#[cfg(all(target_arch = "wasm32", any(feature = "wasm", feature = "wasm-spline")))]
pub(crate) use self::{
    area::{area, centroid},
    bounds::bounds,
    cubics::to_cubics,
    curvature::curvature,
    flatten::flatten,
    length::{length, parameter_at_length},
    nearest_in_space::nearest_in_space,
};
