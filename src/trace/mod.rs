//! From pixels to piecewise splines.
//!
//! [`trace`] does it at once, [`Tracer`] in steps that can be stopped; [`TraceOptions`] say whether outlines of ink, edges
//! or centre lines are wanted. Ink is followed where the brightness crosses a threshold, and the curves are moved until
//! they cover of every pixel what the picture says. The steps of the weighted quasi-interpolant, from edges to the
//! spline of a tube, are here one by one as well.
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
mod arcs;
mod bends;
mod bitmap;
mod blur;
mod canny;
mod centering;
mod centre;
mod chain;
mod chain_work;
mod cloud;
mod contour;
mod corners;
mod coverage;
mod cubic;
mod cusps;
mod discs;
mod division;
mod ellipse;
mod equations;
mod field;
mod fillets;
mod grain;
mod graph;
mod gray;
mod ink;
mod knots;
mod layer_tracer;
mod layers;
mod light;
mod local;
mod maxima;
mod metrics;
mod outline;
mod palette;
mod parabola;
mod placement;
mod profile;
mod projection;
mod quasi_interpolant;
mod refine;
mod refinement;
mod samples;
mod selection;
mod settling;
mod sides;
mod simplify;
mod skyline;
mod straight;
mod strands;
mod tips;
mod tones;
mod tracer;
mod unknowns;
mod window;

pub use canny::{EdgeOptions, EdgePoint, Edges, edges};
pub use chain::{Chain, ChainPlace, Joint, Tube, TubeFit, fit_tube, fit_tube_with};
pub use cloud::Cloud;
pub use contour::{Contour, contours};
pub use cusps::{Cusp, CuspRule};
pub use discs::{DiscEnd, DiscRule, DiscTube};
pub use gray::{Gray, GrayRows, MOST_PIXELS, MOST_SIDE};
pub use knots::{Knots, MOST_DEGREE, MOST_INTERIOR};
pub use layer_tracer::{LayerTracer, TracedLayer};
pub use layers::{LayerRows, Layers};
pub use metrics::{Jaccard, diameter, directed_hausdorff, jaccard, mean_absolute, root_mean_square};
pub use palette::{Census, Color, MOST_COLORS};
pub use profile::{Profile, ProfileOptions};
pub use quasi_interpolant::{End, Estimator, QuasiInterpolant};
pub use selection::{
    Choice, Method, Rule, Score, choose, generalised_cross_validation, leave_one_out, left_out_locally,
};
pub use strands::profiles;
pub use tones::Tones;
pub use tracer::{
    Metrics, Model, Progress, Source, Stage, Trace, TraceOptions, TracedContour, Tracer, trace,
};
