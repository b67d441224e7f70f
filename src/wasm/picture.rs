//! A picture under way: its rows, then the work on them.

use crate::trace::{Census, Gray, GrayRows, LayerRows, LayerTracer, Layers, TraceOptions, Tracer};
use crate::{Error, Result};

pub(super) const NOT_OPEN: Error =
    Error::Degenerate { argument: "image", index: None, reason: "it is not open" };

/// A picture and how far it is.
pub(super) struct Job {
    pub(super) size: [usize; 2],
    pub(super) channels: usize,
    /// How many colours at most are looked for.
    pub(super) most_colors: usize,
    pub(super) options: TraceOptions,
    pub(super) state: State,
}

pub(super) enum State {
    Ink(GrayRows),
    Counting(Census),
    Colors(LayerRows),
    Tracing(Tracer),
    Layers(Box<LayerTracer>),
    /// The picture in even light, to be read.
    Shades(Gray),
    /// The rows could not be made a picture.
    Failed,
}

impl Job {
    pub(super) fn push(&mut self, rows: &[u8]) -> Result<()> {
        let bright: Vec<u8>;
        let colors = if self.channels == 4 || matches!(self.state, State::Ink(_)) {
            rows
        } else {
            bright = rows.iter().flat_map(|&shade| [shade, shade, shade, 255]).collect();
            &bright
        };
        match &mut self.state {
            State::Ink(picture) if self.channels == 4 => picture.push_rgba_rows(rows),
            State::Ink(picture) => picture.push_gray_rows(rows),
            State::Counting(census) => {
                census.push_rgba_rows(colors);
                Ok(())
            }
            State::Colors(picture) => picture.push_rgba_rows(colors),
            _ => Err(Box::new(NOT_OPEN)),
        }
    }

    /// What follows once all rows are there; whether they are wanted once more.
    pub(super) fn filled(&mut self) -> Result<bool> {
        let [width, height] = self.size;
        self.state = match core::mem::replace(&mut self.state, State::Failed) {
            State::Ink(rows) => {
                State::Tracing(Tracer::new(rows.finish_for(self.options.inverted)?, &self.options)?)
            }
            State::Counting(mut census) => {
                let mut palette = census.palette(self.most_colors)?;
                if palette.is_empty() {
                    // All of it is transparent, so any colour will do.
                    palette.push([0; 3].into());
                }
                self.state = State::Colors(Layers::begin(width, height, &palette)?);
                return Ok(true);
            }
            State::Colors(rows) => State::Layers(Box::new(LayerTracer::new(rows.finish()?, &self.options))),
            further => further,
        };
        Ok(false)
    }
}
