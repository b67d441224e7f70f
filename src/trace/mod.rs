//! From pixels to piecewise splines.
//!
//! [`trace`] does it at once, [`Tracer`] in steps that can be stopped; [`TraceOptions`] say whether outlines of ink,
//! edges or centre lines are wanted. Ink is followed where the brightness crosses a threshold, and the curves are moved
//! until they cover of every pixel what the picture says. The steps of the weighted quasi-interpolant, from edges to
//! the spline of a tube, are here one by one as well.
//!
//! ```
//! use expline::trace::{Gray, TraceOptions, trace};
//!
//! // A black square from (8, 8) to (24, 24) on white.
//! let inside = |i: usize| (8..24).contains(&(i % 32)) && (8..24).contains(&(i / 32));
//! let pixels: Vec<u8> = (0..32 * 32).map(|i| if inside(i) { 0 } else { 255 }).collect();
//! let traced = trace(Gray::from_bytes(32, 32, &pixels)?, &TraceOptions::default())?;
//! assert_eq!(traced.contours.len(), 1, "one outline");
//! assert_eq!(traced.contours[0].cusps.len(), 4, "with its corners");
//! # Ok::<(), expline::Error>(())
//! ```
//!
//! Coordinates: x to the right, y down; pixel (column, row) covers [column, column + 1] × [row, row + 1].

mod agreement;
mod chain_work;
mod edges;
mod enlarged;
mod ink;
mod layer_tracer;
mod metrics;
mod options;
mod outline;
mod picture;
mod profile;
mod quality;
mod quasi_interpolant;
mod refinement;
mod samples;
mod tracer;
mod tubes;
mod work;

pub use edges::canny::{EdgeOptions, Edges, edges};
pub use edges::maxima::EdgePoint;
pub use edges::strands::profiles;
pub use layer_tracer::{LayerTracer, TracedLayer};
pub use metrics::{Jaccard, Metrics, diameter, directed_hausdorff, jaccard, mean_absolute, root_mean_square};
pub use options::{Model, Source, TraceOptions};
pub use picture::blocks::{BlockScan, Blocks};
pub use picture::census::Census;
pub use picture::color_light::{ColorLight, LightScan};
pub use picture::contour::{Contour, contours};
pub use picture::gray::{Gray, GrayRows, MOST_PIXELS, MOST_SIDE};
pub use picture::layers::{LayerRows, Layers};
pub use picture::palette::MOST_COLORS;
pub use picture::tint::{Color, Tint};
pub use picture::tones::Tones;
pub use profile::{Profile, ProfileOptions};
pub use quasi_interpolant::choice::{Choice, Rule, Score};
pub use quasi_interpolant::cloud::Cloud;
pub use quasi_interpolant::knots::{Knots, MOST_DEGREE, MOST_INTERIOR};
pub use quasi_interpolant::selection::{
    Method, choose, generalised_cross_validation, leave_one_out, left_out_locally,
};
pub use quasi_interpolant::{End, Estimator, QuasiInterpolant};
pub use tracer::{Tracer, trace};
pub use tubes::chain::{Chain, ChainPlace, Joint, Tube, TubeFit, fit_tube, fit_tube_with};
pub use tubes::cusps::{Cusp, CuspRule};
pub use tubes::discs::{DiscEnd, DiscRule, DiscTube};
pub use work::{Progress, Stage, Trace, TracedContour};
