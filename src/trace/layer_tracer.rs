//! Pictures of a few flat colours: the shape of each layer, traced like ink.

use super::options::{SPECKLE, Source, TraceOptions};
use super::picture::blocks::Blocks;
use super::picture::gray::Gray;
use super::picture::layers::Layers;
use super::picture::shape::{Shape, drawn};
use super::picture::tint::Color;
use super::tracer::Tracer;
use super::work::{Progress, Stage, TracedContour};
use crate::error::{Error, Result};

/// One layer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TracedLayer {
    /// Its colour.
    pub color: Color,
    /// Its outlines; together they are filled by either rule.
    pub contours: Vec<TracedContour>,
}

#[derive(Debug)]
enum Phase {
    Shape(Box<Shape>),
    Tracing(Box<Tracer>),
}

/// A picture of a few flat colours that is being traced: a [`Census`](super::Census) finds the colours,
/// [`Layers::begin`] takes them with the pixels.
///
/// ```
/// use expline::trace::{Census, LayerTracer, Layers, TraceOptions};
///
/// // A red square on white, 32 × 32 pixels of red, green, blue and opacity.
/// let inside = |i: usize| (8..24).contains(&(i % 32)) && (8..24).contains(&(i / 32));
/// let color = |i: usize| if inside(i) { [220, 40, 40, 255] } else { [255; 4] };
/// let pixels: Vec<u8> = (0..32 * 32).flat_map(color).collect();
///
/// let mut census = Census::new(32)?;
/// census.push_rgba_rows(&pixels); // or some rows at a time
/// let palette = census.palette(8)?; // at most eight colours
/// let mut rows = Layers::begin(32, 32, &palette)?;
/// rows.push_rgba_rows(&pixels)?;
/// let mut tracer = LayerTracer::new(rows.finish()?, &TraceOptions::default());
/// while !tracer.step(4000.0)? {} // some 4 ms of work; tracer.progress() tells how many layers are done
/// assert_eq!(tracer.layers().len(), 2, "white below, red on it");
/// assert_eq!(tracer.layers()[1].contours[0].cusps.len(), 4, "with its corners");
/// # Ok::<(), expline::Error>(())
/// ```
///
/// # Cost
///
/// As [`Tracer`], for every layer; 10 bytes for each pixel, and 4 more for each of a region that winds through all of
/// the picture.
#[derive(Debug)]
pub struct LayerTracer {
    layers: Layers,
    options: TraceOptions,
    blocks: Option<Blocks>,
    by_pixels: bool,
    order: Vec<u8>,
    visible: Vec<(usize, Color)>,
    found: Vec<TracedLayer>,
    /// Layers that are done, and contours in those. Where these are too many, all other layers are only counted.
    done: usize,
    count: usize,
    phase: Option<Phase>,
}

impl LayerTracer {
    /// Begins; nothing is done yet. Of the options, source, threshold and inversion do not matter: a layer's shape is
    /// ink on paper.
    pub fn new(layers: Layers, options: &TraceOptions) -> Self {
        let (order, visible) = drawn(&layers);
        let source = Source::Brightness;
        // Crumbs of mixtures are as small as dots, but between two there are none.
        let by_pixels = layers.is_by_pixels();
        let least = if by_pixels && layers.is_small() { 0.0 } else { SPECKLE };
        let speckle = options.speckle.or_else(|| (by_pixels || order.len() > 2).then_some(least));
        let options = TraceOptions { source, threshold: None, inverted: false, speckle, ..*options };
        Self {
            layers,
            options,
            blocks: None,
            by_pixels,
            order,
            visible,
            found: Vec::new(),
            done: 0,
            count: 0,
            phase: None,
        }
    }

    /// Begins a picture whose squares the layers have as pixels.
    pub fn of_squares(layers: Layers, options: &TraceOptions, blocks: Option<Blocks>) -> Self {
        let mut tracer = Self::new(layers, options);
        tracer.blocks = blocks;
        tracer
    }

    /// How many layers are done, and how many there are.
    pub fn progress(&self) -> (usize, usize) {
        (self.done, self.visible.len())
    }

    /// Goes on for about `budget` microseconds, at least by the least bit of work; whether all is done.
    ///
    /// # Errors
    ///
    /// More contours in all layers together than a drawing has, once all are counted; no memory.
    pub fn step(&mut self, budget: f64) -> Result<bool> {
        let Some(&(rank, color)) = self.visible.get(self.done) else { return self.ended() };
        match &mut self.phase {
            None => self.phase = Some(Phase::Shape(Box::new(Shape::new(&self.layers, &self.order, rank)?))),
            Some(Phase::Shape(shape)) => {
                // A step takes half a millisecond or so.
                for _ in 0..(budget / 500.0).clamp(1.0, 1e6) as usize {
                    if let Some(gray) = shape.step(&self.layers)? {
                        self.begin(gray)?;
                        break;
                    }
                }
            }
            Some(Phase::Tracing(tracer)) => {
                let step = tracer.step(budget);
                self.traced(step, color)?;
            }
        }
        if self.done == self.visible.len() { self.ended() } else { Ok(false) }
    }

    fn is_over(&self) -> bool {
        self.count > self.options.most_contours
    }

    /// All layers are done.
    fn ended(&self) -> Result<bool> {
        if self.is_over() {
            return Err(Error::limit("data", "maxContours", self.options.most_contours, self.count as f64));
        }
        Ok(true)
    }

    fn begin(&mut self, mut gray: Gray) -> Result<()> {
        gray.by_pixels = self.by_pixels;
        let rest = self.options.most_contours.saturating_sub(self.count).max(1);
        let options = TraceOptions { most_contours: rest, ..self.options };
        self.phase = Some(Phase::Tracing(Box::new(Tracer::of_squares(gray, &options, self.blocks)?)));
        Ok(())
    }

    /// A layer's trace went on. If it has more contours than there may be, the next layer is next, so that the refusal
    /// says how many all have.
    fn traced(&mut self, step: Result<Progress>, color: Color) -> Result<()> {
        let progress = match step {
            Ok(progress) => progress,
            Err(error) => {
                let Error::LimitExceeded { limit: "maxContours", needed, .. } = *error else {
                    return Err(error);
                };
                self.counted(needed as usize);
                return Ok(());
            }
        };
        if self.is_over() && progress.stage > Stage::Contours {
            // Of those that are only counted the first stage behind contours is as long as there are any.
            self.counted(progress.total);
        } else if progress.done
            && let Some(Phase::Tracing(tracer)) = self.phase.take()
        {
            let contours = tracer.result()?.contours;
            let count = contours.len();
            self.found.push(TracedLayer { color, contours });
            self.counted(count);
        }
        Ok(())
    }

    /// A layer with so many contours is done.
    fn counted(&mut self, count: usize) {
        (self.done, self.count, self.phase) = (self.done + 1, self.count + count, None);
    }

    /// What was found so far, the lowest layer first.
    pub fn layers(&self) -> &[TracedLayer] {
        &self.found
    }
}
