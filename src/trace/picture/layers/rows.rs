//! A picture of flat colours that is given row by row: which pixels have a colour of the palette, which lie flat.

use super::Layers;
use crate::error::{Error, Result};
use crate::trace::picture::mixture::{Premultiplied, is_like, is_on_edge, premultiplied, squared};

/// No colour.
pub(super) const NONE: u8 = u8::MAX;
/// Rows around a pixel in which its colours are looked for.
pub(super) const REACH: usize = 2;
/// Rows that are kept: those, and one more on both sides, whose pixels say which of them are flat.
pub(super) const KEPT: usize = 2 * REACH + 3;
/// Squared distance up to which a pixel has a colour of the palette.
const NEAR: i32 = 24 * 24;
/// Squared distance up to which a pixel is a colour of the palette.
const EXACT: i32 = 16;
/// Alike neighbours of a pixel that is not on an edge.
const ALIKE: usize = 4;

/// One row of the window.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    pub(super) pixels: Vec<Premultiplied>,
    /// The colour that a pixel has, or none.
    pub(super) labels: Vec<u8>,
    /// Whether enough of its neighbours have it too.
    pub(super) flat: Vec<bool>,
    /// Whether all of them have.
    inner: Vec<bool>,
    /// Whether it shows that colour itself, and is not on an edge's way from one to another.
    pub(super) steady: Vec<bool>,
    /// Whether it is that colour but for roundings.
    pub(super) exact: Vec<bool>,
}

/// A picture of flat colours that is being given row by row.
#[derive(Clone, Debug)]
pub struct LayerRows {
    height: usize,
    /// The last rows, by their number modulo [`KEPT`].
    pub(super) window: Vec<Line>,
    /// Rows that were given.
    given: usize,
    pub(super) layers: Layers,
    /// Whether pixels share hues.
    pub(super) shares_hues: bool,
}

impl LayerRows {
    pub(super) fn new(height: usize, layers: Layers) -> Self {
        Self { height, window: vec![Line::default(); KEPT], given: 0, layers, shares_hues: false }
    }

    /// Says whether pixels share their hues, as [`Census::shares_hues`](crate::trace::Census::shares_hues) tells: then
    /// edges are where the light changes.
    #[must_use]
    pub fn sharing_hues(mut self, shared: bool) -> Self {
        self.shares_hues = shared;
        self
    }

    /// More rows, from red, green, blue and opacity, a byte each.
    ///
    /// # Errors
    ///
    /// A list that is not whole rows, or more rows than the picture has; nothing is taken then.
    pub fn push_rgba_rows(&mut self, bytes: &[u8]) -> Result<()> {
        let row = 4 * self.layers.width;
        let rest = self.height - self.given;
        if !bytes.len().is_multiple_of(row) || bytes.len() / row > rest {
            return Err(Error::wrong_length("data", bytes.len(), (bytes.len() / row).min(rest) * row));
        }
        for row in bytes.chunks_exact(row) {
            self.label(row);
            self.given += 1;
            self.flatten(self.given.wrapping_sub(2));
            self.mix(self.given.wrapping_sub(2 + REACH));
        }
        Ok(())
    }

    /// The picture, once all rows are there.
    ///
    /// # Errors
    ///
    /// Missing rows.
    pub fn finish(mut self) -> Result<Layers> {
        if self.given < self.height {
            return Err(Error::wrong_length(
                "data",
                4 * self.given * self.layers.width,
                4 * self.height * self.layers.width,
            ));
        }
        self.flatten(self.height - 1);
        for row in self.height.saturating_sub(1 + REACH)..self.height {
            self.mix(row);
        }
        Ok(self.layers)
    }

    /// Takes the next row: which pixels have a colour of the palette. On a place of one shade that is the nearest one,
    /// however far.
    fn label(&mut self, row: &[u8]) {
        let mut line = core::mem::take(&mut self.window[self.given % KEPT]);
        line.pixels.clear();
        line.labels.clear();
        line.exact.clear();
        let above = &self.window[(self.given + KEPT - 1) % KEPT].pixels;
        let mut known = ([-1; 4], NONE, 0);
        for (column, &pixel) in row.as_chunks::<4>().0.iter().enumerate() {
            let pixel = premultiplied(pixel);
            if pixel != known.0 {
                let (label, least) = self.nearest(&pixel);
                known = (pixel, label, least);
            }
            let left = line.pixels.last().unwrap_or(&pixel);
            let is_plain = || is_like(&pixel, left) && is_like(&pixel, above.get(column).unwrap_or(&pixel));
            let label = if known.2 <= NEAR || is_plain() { known.1 } else { NONE };
            line.pixels.push(pixel);
            line.labels.push(label);
            line.exact.push(known.2 <= EXACT);
        }
        for list in [&mut line.flat, &mut line.inner, &mut line.steady] {
            list.clear();
            list.resize(line.labels.len(), false);
        }
        self.window[self.given % KEPT] = line;
    }

    /// The colour of the palette that is nearest, and its squared distance.
    fn nearest(&self, pixel: &Premultiplied) -> (u8, i32) {
        let (mut label, mut least) = (NONE, i32::MAX);
        for (i, color) in self.layers.palette.iter().enumerate() {
            let gap = squared(pixel, color);
            if gap < least {
                (label, least) = (i as u8, gap);
            }
        }
        (label, least)
    }

    /// The rows of the picture around one.
    pub(super) fn around(&self, row: usize, reach: usize) -> core::ops::RangeInclusive<usize> {
        row.saturating_sub(reach)..=(row + reach).min(self.given.min(self.height) - 1)
    }

    /// Says which pixels of a row are flat, and which are inside: those around it have come.
    fn flatten(&mut self, row: usize) {
        if row >= self.height {
            return;
        }
        let width = self.layers.width;
        for column in 0..width {
            let label = self.window[row % KEPT].labels[column];
            if label == NONE {
                continue;
            }
            let columns = column.saturating_sub(1)..=(column + 1).min(width - 1);
            let (mut seen, mut alike) = (0, 0);
            for near in self.around(row, 1) {
                let labels = &self.window[near % KEPT].labels[columns.clone()];
                seen += labels.len();
                alike += labels.iter().filter(|&&other| other == label).count();
            }
            // Beyond the border all is as it is here. The pixel itself counts too.
            alike += 9 - seen;
            let steady = alike == 9 || alike > ALIKE && !self.is_on_edge(row, column);
            let line = &mut self.window[row % KEPT];
            (line.flat[column], line.inner[column], line.steady[column]) =
                (alike > ALIKE, alike == 9, steady);
        }
    }

    pub(super) fn is_on_edge(&self, row: usize, column: usize) -> bool {
        let at = |row: usize, column: usize| &self.window[row % KEPT].pixels[column];
        let (rows, columns) =
            (self.around(row, 1), column.saturating_sub(1)..(column + 2).min(self.layers.width));
        let beside = [at(row, columns.start), at(row, columns.end - 1)];
        is_on_edge(
            at(row, column),
            [beside[0], beside[1], at(*rows.start(), column), at(*rows.end(), column)],
        )
    }

    /// Says what the pixels of a row are made of.
    fn mix(&mut self, row: usize) {
        if row >= self.height || self.layers.first.len() != row * self.layers.width {
            return;
        }
        for column in 0..self.layers.width {
            let line = &self.window[row % KEPT];
            let label = line.labels[column];
            let (first, second, share) = if line.inner[column] || self.is_crisp(row, column) {
                (label, label, 0.0)
            } else {
                self.mixture(row, column)
            };
            let (first, second, share) =
                if share > 0.5 { (second, first, 1.0 - share) } else { (first, second, share) };
            self.layers.areas[usize::from(first)] += 1;
            self.layers.first.push(first);
            self.layers.second.push(second);
            self.layers.share.push((255.0 * share + 0.5) as u8);
        }
    }
}
