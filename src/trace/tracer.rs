//! The door to tracing: a picture and options in, curves out, a few milliseconds at a time.

use super::chain_work::ChainWork;
use super::ink::InkWork;
use super::options::{Model, Source, TraceOptions};
use super::picture::gray::Gray;
use super::work::{Progress, Trace, Work};
use crate::error::{Error, Result};

/// A picture that is being traced.
///
/// # Cost
///
/// O(pixels + length of the contours). Memory: 4 to 6 bytes for each pixel of drawings, noisy ones, too, the picture's own 2 among
/// them; 30 where outlines fill the picture, as a spiral of thin lines does.
pub struct Tracer {
    work: Box<dyn Work>,
    /// What it failed by.
    failed: Option<Error>,
}

/// How far it is. Nobody looks through a picture and all outlines, and what would print them weighs kilobytes in the wasm.
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
    pub fn new(gray: Gray, options: &TraceOptions) -> Result<Self> {
        options.check()?;
        let options = TraceOptions { inverted: options.inverted || gray.is_light_on_nothing(), ..*options };
        let work: Box<dyn Work> = match (options.source, options.model) {
            (Source::Brightness, Model::Sparse) => Box::new(InkWork::new(gray, options)?),
            _ => Box::new(ChainWork::new(gray, options)?),
        };
        Ok(Self { work, failed: None })
    }

    /// Goes on for about `budget` microseconds, at least by the least bit of work, and no further than to the next stage. Whoever wants no
    /// more just stops.
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
