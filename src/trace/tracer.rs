//! The door to tracing: a picture and options in, curves out, a few milliseconds at a time.

use super::chain_work::ChainWork;
use super::ink::InkWork;
use super::options::{Model, Source, TraceOptions};
use super::picture::blocks::Blocks;
use super::picture::gray::Gray;
use super::work::{Progress, Trace, Work};
use crate::error::{Error, Result};

/// A picture that is being traced.
///
/// ```
/// use expline::svg::{PrintOptions, to_path_d};
/// use expline::trace::{Gray, TraceOptions, Tracer};
///
/// // What a decoder gives: red, green, blue and opacity of 32 × 32 pixels, a dark square on white.
/// let inside = |i: usize| (8..24).contains(&(i % 32)) && (8..24).contains(&(i / 32));
/// let pixels: Vec<u8> = (0..32 * 32).flat_map(|i| if inside(i) { [0, 0, 0, 255] } else { [255; 4] }).collect();
/// let mut tracer = Tracer::new(Gray::from_rgba(32, 32, &pixels)?, &TraceOptions::default())?;
/// loop {
///     let progress = tracer.step(4000.0)?; // some 4 ms of work; show progress.stage, or end here
///     if progress.done {
///         break;
///     }
/// }
/// let mut d = String::new();
/// for contour in &tracer.result()?.contours {
///     d += &to_path_d(&contour.curve, &PrintOptions::default())?.d;
/// }
/// assert!(d.starts_with('M') && d.ends_with('Z'), "for <path d=\"…\"/>");
/// # Ok::<(), expline::Error>(())
/// ```
///
/// # Cost
///
/// O(pixels + length of the contours). Memory: 4 to 6 bytes for each pixel of drawings, noisy ones, too, the picture's
/// own 2 among them; 30 where outlines fill the picture, as a spiral of thin lines does.
pub struct Tracer {
    work: Box<dyn Work>,
    /// The squares that are traced instead of pixels.
    blocks: Option<Blocks>,
    /// What it failed by.
    failed: Option<Error>,
}

/// How far it is. Nobody looks through a picture and all outlines, and what would print them weighs kilobytes in the
/// wasm.
impl core::fmt::Debug for Tracer {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Tracer").field("progress", &self.work.progress()).finish_non_exhaustive()
    }
}

impl Tracer {
    /// Begins; nothing is done yet.
    ///
    /// # Errors
    ///
    /// Options out of range or that do not go together.
    pub fn new(mut gray: Gray, options: &TraceOptions) -> Result<Self> {
        let blocks = gray.take_blocks();
        Self::of_squares(gray, options, blocks)
    }

    /// Begins a picture of squares, each given as a pixel.
    pub(super) fn of_squares(gray: Gray, options: &TraceOptions, blocks: Option<Blocks>) -> Result<Self> {
        options.check()?;
        let mut options = *options;
        options.inverted |= gray.is_light_on_nothing();
        if let Some(blocks) = &blocks {
            blocks.adapt(&mut options);
        }
        let work: Box<dyn Work> = match (options.source, options.model) {
            (Source::Brightness, Model::Sparse) => Box::new(InkWork::new(gray, options)?),
            _ => Box::new(ChainWork::new(gray, options)?),
        };
        Ok(Self { work, blocks, failed: None })
    }

    /// Goes on for about `budget` microseconds, at least by the least bit of work, and no further than to the next
    /// stage. Whoever wants no more just stops.
    ///
    /// # Errors
    ///
    /// A picture with more contours than a drawing has, no memory. After an error every further step fails alike.
    pub fn step(&mut self, budget: f64) -> Result<Progress> {
        if let Some(error) = &self.failed {
            return Err(Box::new(error.clone()));
        }
        let mut spent = 0.0;
        let mut progress = self.work.progress();
        let stage = progress.stage;
        while !progress.done && progress.stage == stage {
            spent += self.work.step().inspect_err(|error| self.failed = Some((**error).clone()))?;
            progress = self.work.progress();
            if spent.is_nan() || spent >= budget {
                break;
            }
        }
        Ok(progress)
    }

    /// After a step was refused for too many contours: the least speckle, in square pixels, that leaves as many as are
    /// allowed. There is none for centre lines.
    pub fn offer(&self) -> Option<f64> {
        Some(self.work.offer()? * self.blocks.map_or(1.0, |blocks| blocks.area()))
    }

    /// What was found.
    ///
    /// # Errors
    ///
    /// The work is not done.
    pub fn result(&self) -> Result<Trace> {
        let Some(trace) = self.work.trace() else {
            return Err(Error::degenerate("trace", None, "the work is not done"));
        };
        let mut trace = trace.clone();
        if let Some(blocks) = &self.blocks {
            blocks.enlarge(&mut trace.contours);
        }
        Ok(trace)
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
