//! Pictures of a few flat colours: how much of which colour every pixel has, and the shapes that lie on one another (D 14.20).

use super::gray::Gray;
use super::palette::{Color, MOST_COLORS};
use crate::error::{Error, Result};
use crate::limits::{check, with_room};

/// No colour.
const NONE: u8 = u8::MAX;
/// Rows around a pixel in which its colours are looked for.
const REACH: usize = 2;
/// Rows that are kept: those, and one more on both sides, whose pixels say which of them are flat.
const KEPT: usize = 2 * REACH + 3;
/// Squared distance up to which a pixel has a colour of the palette.
const NEAR: i32 = 24 * 24;
/// Squared distance up to which a pixel is taken for a mixture of two.
const MIXED: f64 = 32.0 * 32.0;
/// Alike neighbours of a pixel that is not on an edge.
const ALIKE: usize = 4;

/// Colours with red, green and blue as far as they are there: nothing is (0, 0, 0, 0).
type Premultiplied = [i32; 4];

fn squared(a: &Premultiplied, b: &Premultiplied) -> i32 {
    (0..4).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum()
}

/// One row of the window.
#[derive(Clone, Debug, Default)]
struct Line {
    pixels: Vec<Premultiplied>,
    /// The colour that a pixel has, or none.
    labels: Vec<u8>,
    /// Whether enough of its neighbours have it too.
    flat: Vec<bool>,
    /// Whether all of them have.
    inner: Vec<bool>,
}

/// A picture of flat colours that is being given row by row.
#[derive(Clone, Debug)]
pub struct LayerRows {
    height: usize,
    /// The last rows, by their number modulo [`KEPT`].
    window: Vec<Line>,
    /// Rows that were given.
    given: usize,
    layers: Layers,
}

/// How much of which colour every pixel has: three bytes each.
#[derive(Clone, Debug)]
pub struct Layers {
    width: usize,
    colors: Vec<Color>,
    palette: Vec<Premultiplied>,
    /// The colour that a pixel has most of; what comes after the palette is nothing.
    first: Vec<u8>,
    /// Another one, and its share in 255.
    second: Vec<u8>,
    share: Vec<u8>,
    /// Pixels of each colour.
    areas: Vec<usize>,
}

impl Layers {
    /// Begins a picture of those colours that is given row by row.
    ///
    /// # Errors
    ///
    /// A palette with fewer than 1 or more than 64 colours; sides and pixels as [`Gray::begin`].
    pub fn begin(width: usize, height: usize, colors: &[Color]) -> Result<LayerRows> {
        check("colors", None, colors.len() as f64, 1.0, MOST_COLORS as f64)?;
        // For its checks.
        drop(Gray::begin(width, height)?);
        let opaque = |color: &Color| [color[0], color[1], color[2], 255].map(i32::from);
        let mut palette: Vec<Premultiplied> = colors.iter().map(opaque).collect();
        palette.push([0; 4]);
        let pixels = width * height;
        let layers = Self {
            width,
            colors: colors.to_vec(),
            areas: vec![0; palette.len()],
            palette,
            first: with_room(pixels)?,
            second: with_room(pixels)?,
            share: with_room(pixels)?,
        };
        Ok(LayerRows { height, window: vec![Line::default(); KEPT], given: 0, layers })
    }

    /// Colours as they lie on one another, the lowest first: what covers most lies lowest, and nothing, the last number, below all.
    fn order(&self) -> Vec<u8> {
        let nothing = self.colors.len();
        let mut order: Vec<u8> = Vec::new();
        for label in 0..nothing {
            if self.areas[label] == 0 {
                continue;
            }
            let below = order.iter().position(|&other| self.areas[usize::from(other)] < self.areas[label]);
            order.insert(below.unwrap_or(order.len()), label as u8);
        }
        if self.areas[nothing] > 0 {
            order.insert(0, nothing as u8);
        }
        order
    }
}

impl LayerRows {
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

    /// Takes the next row: which pixels have a colour of the palette.
    fn label(&mut self, row: &[u8]) {
        let line = &mut self.window[self.given % KEPT];
        line.pixels.clear();
        line.labels.clear();
        let mut before = ([-1; 4], NONE);
        for pixel in row.chunks_exact(4) {
            let alpha = i32::from(pixel[3]);
            let pixel: Premultiplied =
                core::array::from_fn(
                    |k| if k == 3 { alpha } else { (i32::from(pixel[k]) * alpha + 127) / 255 },
                );
            if pixel != before.0 {
                let (mut label, mut least) = (NONE, NEAR + 1);
                for (i, color) in self.layers.palette.iter().enumerate() {
                    let gap = squared(&pixel, color);
                    if gap < least {
                        (label, least) = (i as u8, gap);
                    }
                }
                before = (pixel, label);
            }
            line.pixels.push(pixel);
            line.labels.push(before.1);
        }
        for list in [&mut line.flat, &mut line.inner] {
            list.clear();
            list.resize(line.labels.len(), false);
        }
    }

    /// The rows of the picture around one.
    fn around(&self, row: usize, reach: usize) -> core::ops::RangeInclusive<usize> {
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
            let line = &mut self.window[row % KEPT];
            (line.flat[column], line.inner[column]) = (alike > ALIKE, alike == 9);
        }
    }

    /// Says what the pixels of a row are made of.
    fn mix(&mut self, row: usize) {
        if row >= self.height || self.layers.first.len() != row * self.layers.width {
            return;
        }
        for column in 0..self.layers.width {
            let line = &self.window[row % KEPT];
            let label = line.labels[column];
            let (first, second, share) =
                if line.inner[column] { (label, label, 0.0) } else { self.mixture(row, column) };
            let (first, second, share) =
                if share > 0.5 { (second, first, 1.0 - share) } else { (first, second, share) };
            self.layers.areas[usize::from(first)] += 1;
            self.layers.first.push(first);
            self.layers.second.push(second);
            self.layers.share.push((255.0 * share + 0.5) as u8);
        }
    }

    /// The two colours of an edge's pixel and the share of the second: its own and one that lies flat nearby, two that do, or any.
    fn mixture(&self, row: usize, column: usize) -> (u8, u8, f64) {
        let line = &self.window[row % KEPT];
        let (pixel, label) = (&line.pixels[column], line.labels[column]);
        let columns = column.saturating_sub(REACH)..=(column + REACH).min(self.layers.width - 1);
        let mut near = [NONE; (2 * REACH + 1) * (2 * REACH + 1)];
        let mut count = 0;
        for row in self.around(row, REACH) {
            let other = &self.window[row % KEPT];
            for column in columns.clone() {
                let label = other.labels[column];
                if other.flat[column] && !near[..count].contains(&label) {
                    near[count] = label;
                    count += 1;
                }
            }
        }
        let near = &near[..count];
        if line.flat[column] {
            // A tenth of another colour tells where the edge is as well as a half does.
            let mut pairs = near.iter().map(|&other| (label, other));
            return self.nearest_mixture(pixel, f64::INFINITY, &mut pairs).unwrap_or((label, label, 0.0));
        }
        let mut pairs = near.iter().enumerate().flat_map(|(i, &a)| near[i..].iter().map(move |&b| (a, b)));
        if let Some(best) = self.nearest_mixture(pixel, MIXED, &mut pairs) {
            return best;
        }
        if label != NONE {
            return (label, label, 0.0);
        }
        // Something thin, that is flat nowhere: with what is around it, or alone.
        let all = 0..self.layers.palette.len() as u8;
        let mut pairs = all.flat_map(|b| near.iter().map(move |&a| (a, b)).chain([(b, b)]));
        self.nearest_mixture(pixel, f64::INFINITY, &mut pairs).unwrap_or((0, 0, 0.0))
    }

    /// The first of the mixtures that is nearest to a pixel, if one is nearer than `least`.
    fn nearest_mixture(
        &self,
        pixel: &Premultiplied,
        mut least: f64,
        pairs: &mut dyn Iterator<Item = (u8, u8)>,
    ) -> Option<(u8, u8, f64)> {
        let mut best = None;
        for (a, b) in pairs {
            let (share, gap) = self.between(pixel, a, b);
            if gap < least {
                (best, least) = (Some((a, b, share)), gap);
            }
        }
        best
    }

    /// The share of `b` in the mixture of two colours that is nearest to a pixel, and the squared distance.
    fn between(&self, pixel: &Premultiplied, a: u8, b: u8) -> (f64, f64) {
        let (from, to) = (&self.layers.palette[usize::from(a)], &self.layers.palette[usize::from(b)]);
        let whole = squared(from, to);
        let along: i32 = (0..4).map(|k| (pixel[k] - from[k]) * (to[k] - from[k])).sum();
        let share = if whole == 0 { 0.0 } else { (f64::from(along) / f64::from(whole)).clamp(0.0, 1.0) };
        let mut gap = 0.0;
        for k in 0..4 {
            let off = f64::from(pixel[k] - from[k]) - share * f64::from(to[k] - from[k]);
            gap += off * off;
        }
        (share, gap)
    }
}

/// The shape of one layer as a picture in gray, a few rows at a time.
///
/// It is where its colour is, and all that lies on it: every connected region of higher layers that touches it. So no gap can open between
/// a layer and what lies on it, however their outlines are rounded.
#[derive(Debug)]
pub(in crate::trace) struct Shape {
    /// Height of each colour in the order, lowest first.
    ranks: [u8; MOST_COLORS + 1],
    rank: u8,
    /// Whether a pixel of a higher layer belongs to it.
    inside: Vec<bool>,
    /// Pixels whose neighbours have not been looked at.
    open: Vec<u32>,
    row: usize,
    gray: Option<super::gray::GrayRows>,
}

/// Pixels that are looked at in one step.
const BIT: usize = 1 << 15;

impl Shape {
    pub(in crate::trace) fn new(layers: &Layers, order: &[u8], rank: usize) -> Result<Self> {
        let mut ranks = [0; MOST_COLORS + 1];
        for (i, &label) in order.iter().enumerate() {
            ranks[usize::from(label)] = i as u8;
        }
        let mut inside = with_room(layers.first.len())?;
        inside.resize(layers.first.len(), false);
        Ok(Self { ranks, rank: rank as u8, inside, open: Vec::new(), row: 0, gray: None })
    }

    /// Goes on; the picture, once it is there.
    pub(in crate::trace) fn step(&mut self, layers: &Layers) -> Result<Option<Gray>> {
        let (width, height) = (layers.width, layers.first.len() / layers.width);
        let rows = (BIT / width).max(1);
        if self.gray.is_none() {
            if self.row < height {
                let end = (self.row + rows).min(height);
                for at in self.row * width..end * width {
                    if self.rank_of(layers.first[at]) == self.rank {
                        self.spread(layers, at)?;
                    }
                }
                self.row = end;
                return Ok(None);
            }
            for _ in 0..BIT {
                let Some(at) = self.open.pop() else {
                    self.gray = Some(Gray::begin(width, height)?);
                    self.row = 0;
                    break;
                };
                self.spread(layers, at as usize)?;
            }
            return Ok(None);
        }
        let end = (self.row + rows).min(height);
        let mut bytes = with_room((end - self.row) * width)?;
        bytes.extend((self.row * width..end * width).map(|at| 255 - self.coverage(layers, at)));
        self.row = end;
        if let Some(gray) = &mut self.gray {
            gray.push_gray_rows(&bytes)?;
        }
        if end < height {
            return Ok(None);
        }
        self.gray.take().map(super::gray::GrayRows::finish).transpose()
    }

    fn rank_of(&self, label: u8) -> u8 {
        self.ranks[usize::from(label)]
    }

    /// The four neighbours of a pixel.
    fn beside(layers: &Layers, at: usize) -> impl Iterator<Item = usize> {
        let (width, count) = (layers.width, layers.first.len());
        let column = at % width;
        [
            (column > 0).then(|| at - 1),
            (column + 1 < width).then_some(at + 1),
            at.checked_sub(width),
            Some(at + width).filter(|&below| below < count),
        ]
        .into_iter()
        .flatten()
    }

    /// Takes the neighbours in that belong to higher layers.
    fn spread(&mut self, layers: &Layers, at: usize) -> Result<()> {
        for near in Self::beside(layers, at) {
            if !self.inside[near] && self.rank_of(layers.first[near]) > self.rank {
                self.inside[near] = true;
                if self.open.try_reserve(1).is_err() {
                    return Err(Error::memory(8 * self.open.len()));
                }
                self.open.push(near as u32);
            }
        }
        Ok(())
    }

    /// How much of a pixel the shape covers, in 255.
    fn coverage(&self, layers: &Layers, at: usize) -> u8 {
        let (first, second, share) = (layers.first[at], layers.second[at], layers.share[at]);
        let higher = || {
            if self.rank_of(first) > self.rank {
                self.inside[at]
            } else {
                // Less than half of a pixel: it belongs to what it is the border of.
                self.rank_of(first) == self.rank || Self::beside(layers, at).any(|near| self.inside[near])
            }
        };
        let covers = |label: u8| match self.rank_of(label).cmp(&self.rank) {
            core::cmp::Ordering::Less => false,
            core::cmp::Ordering::Equal => true,
            core::cmp::Ordering::Greater => higher(),
        };
        let part = |label: u8, share: u8| if covers(label) { share } else { 0 };
        part(first, 255 - share) + part(second, share)
    }
}

/// The colours of the layers that are drawn, the lowest first, with the number of each in the order.
pub(in crate::trace) fn drawn(layers: &Layers) -> (Vec<u8>, Vec<(usize, Color)>) {
    let order = layers.order();
    let mut visible = Vec::new();
    for (rank, &label) in order.iter().enumerate() {
        if let Some(&color) = layers.colors.get(usize::from(label)) {
            visible.push((rank, color));
        }
    }
    (order, visible)
}
