//! Pictures of a few flat colours: the shape of each layer, traced like ink.

use super::options::{Source, TraceOptions};
use super::picture::gray::Gray;
use super::picture::layers::Layers;
use super::picture::palette::Color;
use super::picture::shape::{Shape, drawn};
use super::tracer::Tracer;
use super::work::TracedContour;
use crate::error::{Error, Result};

/// One layer.
#[derive(Clone, Debug)]
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

/// A picture of a few flat colours that is being traced.
///
/// # Cost
///
/// As [`Tracer`], for every layer; 10 bytes for each pixel, and 4 more for each of a region that winds through all of the picture.
#[derive(Debug)]
pub struct LayerTracer {
    layers: Layers,
    options: TraceOptions,
    order: Vec<u8>,
    visible: Vec<(usize, Color)>,
    found: Vec<TracedLayer>,
    phase: Option<Phase>,
}

impl LayerTracer {
    /// Begins; nothing is done yet. Of the options, source, threshold and inversion do not matter: a layer's shape is ink on paper.
    pub fn new(layers: Layers, options: &TraceOptions) -> Self {
        let (order, visible) = drawn(&layers);
        let source = Source::Brightness;
        let options = TraceOptions { source, threshold: None, inverted: false, ..*options };
        Self { layers, options, order, visible, found: Vec::new(), phase: None }
    }

    /// How many layers are done, and how many there are.
    pub fn progress(&self) -> (usize, usize) {
        (self.found.len(), self.visible.len())
    }

    /// Goes on for about `budget` microseconds, at least by the least bit of work; whether all is done.
    ///
    /// # Errors
    ///
    /// More contours in all layers together than a drawing has, no memory.
    pub fn step(&mut self, budget: f64) -> Result<bool> {
        let Some(&(rank, color)) = self.visible.get(self.found.len()) else { return Ok(true) };
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
                let done = tracer.step(budget).map_err(|error| self.all_contours(error))?.done;
                if done {
                    self.finish(color)?;
                }
            }
        }
        Ok(self.found.len() == self.visible.len())
    }

    fn count(&self) -> usize {
        self.found.iter().map(|layer| layer.contours.len()).sum()
    }

    fn begin(&mut self, gray: Gray) -> Result<()> {
        let rest = self.options.most_contours.saturating_sub(self.count()).max(1);
        let options = TraceOptions { most_contours: rest, ..self.options };
        self.phase = Some(Phase::Tracing(Box::new(Tracer::new(gray, &options)?)));
        Ok(())
    }

    fn finish(&mut self, color: Color) -> Result<()> {
        if let Some(Phase::Tracing(tracer)) = self.phase.take() {
            self.found.push(TracedLayer { color, contours: tracer.result()?.contours });
        }
        let (count, most) = (self.count(), self.options.most_contours);
        if count > most {
            return Err(Error::limit("data", "maxContours", most, count as f64));
        }
        Ok(())
    }

    /// A limit that one layer broke is that of all of them.
    fn all_contours(&self, mut error: Box<Error>) -> Box<Error> {
        if let Error::LimitExceeded { limit: "maxContours", most, needed, .. } = &mut *error {
            *most = self.options.most_contours as f64;
            *needed += self.count() as f64;
        }
        error
    }

    /// What was found so far, the lowest layer first.
    pub fn layers(&self) -> &[TracedLayer] {
        &self.found
    }
}
