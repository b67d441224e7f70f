//! The door to tracing: a picture and options in, curves out, a few milliseconds at a time.

use super::chain_work::ChainWork;
use super::ink::InkWork;
use super::picture::gray::Gray;
use super::picture::tones::Tones;
use crate::curve::HermiteCurve;
use crate::error::{Error, Result};
use crate::limits::check;
use crate::numerics::Point;

/// What is followed in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The outlines of ink.
    Brightness,
    /// Edges: where the shade changes fastest.
    Edges,
    /// The centre lines of thin strokes.
    Lines,
}

/// Which spline follows a contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// As few lines, arcs and cubics as there may be.
    Sparse,
    /// Weighted quasi-interpolants, tube by tube.
    QuasiInterpolant,
}

/// How a picture is traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceOptions {
    /// What is followed.
    pub source: Source,
    /// By which spline.
    pub model: Model,
    /// The shade between ink and paper, 0 … 255; found if it is not given, and dark ink on paper in uneven light is then followed as if
    /// the light were even (D 14.24).
    pub threshold: Option<f64>,
    /// The deviation in pixels of the Gaussian that the picture is blurred by before contours are looked for; found if it is not given.
    pub blur: Option<f64>,
    /// Light ink on dark paper. What is light and lies on a transparent ground is ink in any case.
    pub inverted: bool,
    /// Contours that enclose fewer square pixels are left out, and edges that are shorter than the outline of a square of so many.
    pub speckle: f64,
    /// The least turning of a corner, in radians.
    pub corner: f64,
    /// The largest deviation of the first curve from the contour, in pixels; refined curves are nearer.
    pub tolerance: f64,
    /// Whether curves are refined against the picture's coverage.
    pub refined: bool,
    /// More contours than this are not a drawing but a photograph.
    pub most_contours: usize,
}

impl Default for TraceOptions {
    fn default() -> Self {
        Self {
            source: Source::Brightness,
            model: Model::Sparse,
            threshold: None,
            blur: None,
            inverted: false,
            speckle: 2.0,
            corner: 0.49,
            tolerance: 0.22,
            refined: true,
            most_contours: 1_500,
        }
    }
}

impl TraceOptions {
    /// Whether paper is looked for, and the light that falls on it: edges need none, and on a dark ground there is little to see.
    pub(super) fn finds_light(&self) -> bool {
        self.source != Source::Edges && self.threshold.is_none() && !self.inverted
    }

    fn check(&self) -> Result<()> {
        if let Some(threshold) = self.threshold {
            check("threshold", None, threshold, 0.0, 255.0)?;
        }
        if let Some(blur) = self.blur {
            check("blur", None, blur, 0.0, 10.0)?;
        }
        check("corner", None, self.corner, 0.05, core::f64::consts::PI)?;
        check("tolerance", None, self.tolerance, 0.01, 1e3)?;
        check("speckle", None, self.speckle, 0.0, 1e9)?;
        check("maxContours", None, self.most_contours as f64, 1.0, 1e6)
    }
}

/// What is being done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The picture is looked at: tones, noise, edges.
    Edges,
    /// Contours are followed.
    Contours,
    /// Corners are looked for.
    Corners,
    /// Contours become splines.
    Splines,
    /// Splines are moved until they explain the picture.
    Refinement,
}

/// How far the work is. Stages come in their order, and in a stage `completed` never falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Whether the result is there.
    pub done: bool,
    /// What is being done.
    pub stage: Stage,
    /// How much of the stage is done.
    pub completed: usize,
    /// Of how much.
    pub total: usize,
}

/// How far a curve is from the contour that it follows, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metrics {
    /// The root mean square distance of the contour's points.
    pub rmse: f64,
    /// Their mean distance.
    pub mae: f64,
    /// Their largest distance.
    pub max: f64,
    /// The largest distance between both, in both directions: more than `max` where a sharp corner stands beyond its contour,
    /// which pixels cut off.
    pub hausdorff: f64,
    /// The share of their pixels that are next to each other: see [`super::Jaccard::tolerant`].
    pub jaccard: f64,
}

/// One curve.
#[derive(Clone, Debug)]
pub struct TracedContour {
    /// The curve; closed outlines of ink have a positive area, holes a negative one.
    pub curve: HermiteCurve,
    /// Whether its end is its start.
    pub closed: bool,
    /// Whether it bounds a hole.
    pub hole: bool,
    /// Corners, where the tangent jumps.
    pub cusps: Vec<Point>,
    /// How far it is from the sub-pixel contour.
    pub metrics: Metrics,
}

/// What was found in a picture.
#[derive(Clone, Debug)]
pub struct Trace {
    /// All curves; outlines of ink in the order of their first points, row by row.
    pub contours: Vec<TracedContour>,
    /// Ink, paper and noise.
    pub tones: Tones,
    /// The root mean square difference between the picture and the coverage of the curves near them; 0 without refinement.
    pub residual: f64,
}

/// Work that is done bit by bit. Every source is one.
pub(super) trait Work: core::fmt::Debug {
    /// Does a bit, of a millisecond or so; how long it took, in about microseconds.
    fn step(&mut self) -> Result<f64>;

    /// How far it is.
    fn progress(&self) -> Progress;

    /// What was found, once it is done.
    fn trace(&self) -> Option<&Trace>;

    /// After a refusal for too many contours: the speckle that would leave as many as are allowed.
    fn offer(&self) -> Option<f64> {
        None
    }
}

/// A picture that is being traced.
///
/// # Cost
///
/// O(pixels + length of the contours). Memory: 4 to 6 bytes for each pixel of drawings, the picture's own 2 among them; 7 of
/// noise, and 30 where outlines fill the picture, as a spiral of thin lines does.
#[derive(Debug)]
pub struct Tracer {
    work: Box<dyn Work>,
}

impl Tracer {
    /// Begins; nothing is done yet.
    ///
    /// # Errors
    ///
    /// Options out of range or that do not go together.
    pub fn new(gray: Gray, options: &TraceOptions) -> Result<Self> {
        options.check()?;
        let options = TraceOptions { inverted: options.inverted || gray.is_light_on_nothing(), ..*options };
        let work: Box<dyn Work> = match (options.source, options.model) {
            (Source::Brightness, Model::Sparse) => Box::new(InkWork::new(gray, options)?),
            _ => Box::new(ChainWork::new(gray, options)?),
        };
        Ok(Self { work })
    }

    /// Goes on for about `budget` microseconds, at least by the least bit of work, and no further than to the next stage. Whoever wants no
    /// more just stops.
    ///
    /// # Errors
    ///
    /// A picture with more contours than a drawing has, no memory. After an error every further step fails alike.
    pub fn step(&mut self, budget: f64) -> Result<Progress> {
        let mut spent = 0.0;
        let mut progress = self.work.progress();
        let stage = progress.stage;
        while !progress.done && progress.stage == stage {
            spent += self.work.step()?;
            progress = self.work.progress();
            if spent.is_nan() || spent >= budget {
                break;
            }
        }
        Ok(progress)
    }

    /// After a step was refused for too many contours: the least speckle, in square pixels, that leaves as many as are allowed.
    /// There is none for centre lines.
    pub fn offer(&self) -> Option<f64> {
        self.work.offer()
    }

    /// What was found.
    ///
    /// # Errors
    ///
    /// The work is not done.
    pub fn result(&self) -> Result<Trace> {
        match self.work.trace() {
            Some(trace) => Ok(trace.clone()),
            None => Err(Error::degenerate("trace", None, "the work is not done")),
        }
    }
}

/// Traces a picture in one go: [`Tracer`] without a pause.
///
/// # Errors
///
/// As [`Tracer::new`] and [`Tracer::step`].
pub fn trace(gray: Gray, options: &TraceOptions) -> Result<Trace> {
    let mut tracer = Tracer::new(gray, options)?;
    while !tracer.step(f64::INFINITY)?.done {}
    tracer.result()
}
