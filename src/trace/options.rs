//! What a tracer can be told.

use crate::error::Result;
use crate::limits::check;

/// What is followed in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Source {
    /// The outlines of ink.
    Brightness,
    /// Edges: where the shade changes fastest.
    Edges,
    /// The centre lines of thin strokes.
    Lines,
}

/// Which spline follows a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Model {
    /// As few lines, arcs and cubics as there may be.
    Sparse,
    /// Weighted quasi-interpolants, tube by tube.
    QuasiInterpolant,
}

/// How a picture is traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceOptions {
    /// What is followed; by default [`Source::Brightness`].
    pub source: Source,
    /// By which spline; by default [`Model::Sparse`].
    pub model: Model,
    /// The shade between ink and paper, 0 … 255; found if it is not given, and dark ink on paper in uneven light is
    /// then followed as if the light were even (D 14.24).
    pub threshold: Option<f64>,
    /// The deviation in pixels, 0 … 10, of the Gaussian that the picture is blurred by before contours are looked for;
    /// found if it is not given.
    pub blur: Option<f64>,
    /// Light ink on dark paper; by default it is dark on light. What is light and lies on a transparent ground is ink
    /// in any case.
    pub inverted: bool,
    /// Contours that enclose fewer square pixels, 0 … 1e9, are left out, and edges that are shorter than the outline of
    /// a square of so many. If it is not given that is 2, but where nothing is noise and strokes are thin, refined
    /// outlines of dots with gray at their edges are kept from a quarter of a pixel at the threshold on: no dust is as
    /// small in a drawing that is itself.
    pub speckle: Option<f64>,
    /// The least turning of a corner, in radians, 0.05 … π; by default 0.49, which is 28°. With π there are none.
    pub corner: f64,
    /// How far the first curve of a contour may be from its points, in pixels, 0.01 … 1000; by default 0.22. That is
    /// about so: pieces are fitted to places half a pixel apart, and the ends of a piece, corners and pieces of two
    /// pixels may be farther: of smooth shapes the largest distance was up to 1.3 times as much at the default, and 5
    /// times at .05. A refined curve begins within .18 and goes where the picture says; above the default joints may
    /// leave more in proportion. Twice as much is allowed in noise, three times where pixels only say which centres are
    /// inside. What was reached is [`Metrics::max`](super::Metrics::max). Where a picture was scaled up by repeating
    /// pixels, this counts in those pixels.
    pub tolerance: f64,
    /// Whether curves are refined against the picture's coverage, as they are by default.
    pub refined: bool,
    /// More contours than this, 1 … 1,000,000, are not a drawing but a photograph; by default 1500.
    pub most_contours: usize,
}

/// Contours of less area, in pixels, are left out if nothing else is asked for.
pub(super) const SPECKLE: f64 = 2.0;

impl Default for TraceOptions {
    fn default() -> Self {
        Self {
            source: Source::Brightness,
            model: Model::Sparse,
            threshold: None,
            blur: None,
            inverted: false,
            speckle: None,
            corner: 0.49,
            tolerance: 0.22,
            refined: true,
            most_contours: 1_500,
        }
    }
}

impl TraceOptions {
    /// Whether paper is looked for, and the light that falls on it: edges need none, and on a dark ground there is
    /// little to see.
    pub(super) fn finds_light(&self) -> bool {
        self.source != Source::Edges && self.threshold.is_none() && !self.inverted
    }

    /// The area below which contours are left out, in pixels, whatever they are.
    pub(super) fn least(&self) -> f64 {
        self.speckle.unwrap_or(SPECKLE)
    }

    pub(super) fn check(&self) -> Result<()> {
        if let Some(threshold) = self.threshold {
            check("threshold", None, threshold, 0.0, 255.0)?;
        }
        if let Some(blur) = self.blur {
            check("blur", None, blur, 0.0, 10.0)?;
        }
        check("corner", None, self.corner, 0.05, core::f64::consts::PI)?;
        check("tolerance", None, self.tolerance, 0.01, 1e3)?;
        check("speckle", None, self.least(), 0.0, 1e9)?;
        check("maxContours", None, self.most_contours as f64, 1.0, 1e6)
    }
}
