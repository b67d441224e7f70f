//! A picture under way: its rows, then the work on them.

use crate::trace::{
    BlockScan, Blocks, Census, ColorLight, Gray, GrayRows, LayerRows, LayerTracer, Layers, LightScan, Tint,
    TraceOptions, Tracer,
};
use crate::{Error, Result};

pub(super) const NOT_OPEN: Error =
    Error::Degenerate { argument: "image", index: None, reason: "it is not open" };

/// A picture and how far it is.
pub(super) struct Job {
    pub(super) size: [usize; 2],
    pub(super) channels: usize,
    /// How many colours at most are looked for.
    pub(super) most_colors: usize,
    /// The colours that are wanted, once they are known.
    pub(super) palette: Vec<Tint>,
    /// Whether pixels share their hues, where colours were looked for.
    pub(super) shares_hues: bool,
    pub(super) options: TraceOptions,
    pub(super) state: State,
    /// Looks for squares of equal pixels in colours, while they are given for the first time.
    pub(super) scan: BlockScan,
    /// Those that were found, and are traced instead of pixels.
    pub(super) blocks: Option<Blocks>,
    /// Looks for uneven light in colours, while they are given for the first time,
    pub(super) light_scan: Option<LightScan>,
    /// and what was found, by which rows are made even from then on.
    pub(super) light: Option<ColorLight>,
    /// Pixels that were given since they were last wanted, and squares that were taken from them.
    pub(super) read: [usize; 2],
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
    /// Begins to read rows.
    #[inline(never)]
    pub(super) fn begin(&mut self) -> Result<()> {
        let [width, height] = self.blocks.map_or(self.size, |blocks| blocks.extent());
        self.read = [0; 2];
        self.state = match (self.most_colors, self.palette.is_empty()) {
            (0, true) => State::Ink(Gray::begin(width, height)?),
            (_, true) => State::Counting(Census::new(width)?),
            _ => State::Colors(Layers::begin(width, height, &self.palette)?.sharing_hues(self.shares_hues)),
        };
        Ok(())
    }

    pub(super) fn push(&mut self, rows: &mut [u8]) -> Result<()> {
        let mut bright: Vec<u8>;
        let mut colors = if self.channels == 4 || matches!(self.state, State::Ink(_)) {
            rows
        } else {
            bright = rows.iter().flat_map(|&shade| [shade, shade, shade, 255]).collect();
            &mut bright
        };
        self.scan.look(colors, 4);
        if let Some(scan) = &mut self.light_scan {
            scan.push_rgba_rows(colors);
        }
        if let Some(light) = &self.light {
            light.even(self.read[0] / self.size[0], colors);
            self.read[0] += colors.len() / 4;
        }
        if let Some(blocks) = &self.blocks {
            let count = thin(blocks, &mut self.read, colors);
            colors = &mut colors[..count];
        }
        match &mut self.state {
            State::Ink(picture) if self.channels == 4 => picture.push_rgba_rows(colors),
            State::Ink(picture) => picture.push_gray_rows(colors),
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
        if let Some(found) = self.scan.end() {
            self.blocks = Some(found);
            self.light_scan = None;
            self.begin()?;
            return Ok(true);
        }
        if let Some(scan) = self.light_scan.take() {
            self.light = scan.light();
            if self.light.is_some() {
                self.begin()?;
                return Ok(true);
            }
        }
        self.state = match core::mem::replace(&mut self.state, State::Failed) {
            State::Ink(rows) => {
                State::Tracing(Tracer::new(rows.finish_for(self.options.inverted)?, &self.options)?)
            }
            State::Counting(mut census) => {
                self.palette = census.palette(self.most_colors)?;
                self.shares_hues = census.shares_hues();
                if self.palette.is_empty() {
                    // All of it is transparent, so any colour will do.
                    self.palette.push([0; 3].into());
                }
                self.begin()?;
                return Ok(true);
            }
            State::Colors(rows) => {
                let tracer = LayerTracer::of_squares(rows.finish()?, &self.options, self.blocks);
                State::Layers(Box::new(tracer))
            }
            further => further,
        };
        Ok(false)
    }
}

/// Leaves the first pixels of all squares that begin in some rows at their beginning, and says how many bytes these
/// are. It counts how many pixels were given and squares taken by then.
fn thin(blocks: &Blocks, [given, taken]: &mut [usize; 2], bytes: &mut [u8]) -> usize {
    let pixels = bytes.as_chunks_mut::<4>().0;
    let (first, mut count) = (*given, 0);
    *given += pixels.len();
    loop {
        let at = blocks.pixel(*taken);
        if at >= *given {
            return 4 * count;
        }
        pixels[count] = pixels[at - first];
        count += 1;
        *taken += 1;
    }
}
