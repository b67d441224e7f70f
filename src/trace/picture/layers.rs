//! Pictures of a few flat colours: how much of which colour every pixel has (D 14.20).

use super::gray::count;
use super::mixture::{Mixture, Premultiplied, Seam, is_between, is_like, is_on_edge, premultiplied, squared};
use super::palette::MOST_COLORS;
use super::tint::{Color, Tint};
use crate::error::{Error, Result};
use crate::limits::{check, with_room};

/// No colour.
const NONE: u8 = u8::MAX;
/// Rows around a pixel in which its colours are looked for.
const REACH: usize = 2;
/// Rows that are kept: those, and one more on both sides, whose pixels say which of them are flat.
const KEPT: usize = 2 * REACH + 3;
/// Pixels around one, and itself.
const AROUND: usize = (2 * REACH + 1) * (2 * REACH + 1);
/// Squared distance up to which a pixel has a colour of the palette.
const NEAR: i32 = 24 * 24;
/// Squared distance up to which a pixel is taken for a mixture of two.
const MIXED: f64 = 32.0 * 32.0;
/// Squared distance from a mixture of two that roundings make,
const ROUNDED: f64 = 4.0 * 4.0;
/// and up to which a pixel is taken for a seam of two, if it is so many times nearer to one.
const SEAM: f64 = 4.0 * 4.0;
const NEARER: f64 = 8.0;
/// How much less a difference in light counts than one in hue, where something is thin.
const SHADE: f64 = 0.9;
/// How much a colour counts that is farther away than what is seen of something thin.
const AWAY: f64 = 0.02;
/// Squared distance up to which a pixel is a colour of the palette,
const EXACT: i32 = 16;
/// and so many around one that are none are single ones that were drawn, not the mixtures of an edge.
const OTHERS: usize = 2;
/// In a picture that was drawn pixel by pixel one side in so many may be a mixture's,
const MIXTURES: usize = 20;
/// and one in so many at least is that of something one pixel wide.
const SINGLE: usize = 5;
/// In a picture of more pixels single ones may be dithering, and are too many to be contours each.
const SMALL: usize = 64 * 64;
/// Alike neighbours of a pixel that is not on an edge.
const ALIKE: usize = 4;

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
    /// Whether it shows that colour itself, and is not on an edge's way from one to another.
    steady: Vec<bool>,
    /// Whether it is that colour but for roundings.
    exact: Vec<bool>,
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
    pub(super) width: usize,
    pub(super) colors: Vec<Color>,
    palette: Vec<Premultiplied>,
    /// The colour that a pixel has most of; what comes after the palette is nothing.
    pub(super) first: Vec<u8>,
    /// Another one, and its share in 255.
    pub(super) second: Vec<u8>,
    pub(super) share: Vec<u8>,
    /// Pixels of each colour.
    areas: Vec<usize>,
}

impl Layers {
    /// Begins a picture of those colours that is given row by row. Layers are opaque: those of translucent colours look
    /// as these do on white.
    ///
    /// # Errors
    ///
    /// A palette with fewer than 1 or more than 64 colours; sides and pixels as
    /// [`Gray::begin`](crate::trace::Gray::begin).
    pub fn begin<T: Copy + Into<Tint>>(width: usize, height: usize, colors: &[T]) -> Result<LayerRows> {
        Self::with_tints(width, height, &colors.iter().map(|&color| color.into()).collect::<Vec<Tint>>())
    }

    fn with_tints(width: usize, height: usize, colors: &[Tint]) -> Result<LayerRows> {
        check("colors", None, colors.len() as f64, 1.0, MOST_COLORS as f64)?;
        let mut palette: Vec<Premultiplied> = colors.iter().map(Tint::premultiplied).collect();
        palette.push([0; 4]);
        let pixels = count(width, height)?;
        let layers = Self {
            width,
            colors: colors.iter().map(Tint::on_white).collect(),
            areas: vec![0; palette.len()],
            palette,
            first: with_room(pixels)?,
            second: with_room(pixels)?,
            share: with_room(pixels)?,
        };
        Ok(LayerRows { height, window: vec![Line::default(); KEPT], given: 0, layers })
    }

    /// Colours as they lie on one another, the lowest first: what covers most lies lowest, and nothing, the last
    /// number, below all.
    pub(super) fn order(&self) -> Vec<u8> {
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

    /// Whether its pixels are so few that single ones may be contours each.
    pub(in crate::trace) fn is_small(&self) -> bool {
        self.first.len() <= SMALL
    }

    /// Whether the picture was drawn pixel by pixel, as sprites are: without mixtures, and many of the sides between
    /// colours are those of something one pixel wide.
    pub(in crate::trace) fn is_by_pixels(&self) -> bool {
        let (width, count) = (self.width, self.first.len());
        let differ = |at: usize, step: usize| self.first[at] != self.first[at + step];
        let (mut mixed, mut sides, mut single) = (0, 0, 0);
        for at in 0..count {
            mixed += usize::from(self.share[at] > 0);
            for (step, fits) in [(1, at % width + 2 < width), (width, at + 2 * width < count)] {
                if fits && differ(at, step) {
                    sides += 1;
                    single += usize::from(differ(at + step, step));
                }
            }
        }
        MIXTURES * mixed <= sides && SINGLE * single >= sides
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
            let steady = alike == 9 || alike > ALIKE && !self.is_on_edge(row, column);
            let line = &mut self.window[row % KEPT];
            (line.flat[column], line.inner[column], line.steady[column]) =
                (alike > ALIKE, alike == 9, steady);
        }
    }

    fn is_on_edge(&self, row: usize, column: usize) -> bool {
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

    /// Whether all pixels around one have colours of the palette, and it has: there are no mixtures then.
    fn is_crisp(&self, row: usize, column: usize) -> bool {
        let columns = column.saturating_sub(REACH)..=(column + REACH).min(self.layers.width - 1);
        let mut others = 0;
        for row in self.around(row, REACH) {
            others += self.window[row % KEPT].exact[columns.clone()].iter().filter(|&&exact| !exact).count();
        }
        others <= OTHERS && self.window[row % KEPT].exact[column]
    }

    /// The two colours of an edge's pixel and the share of the second.
    fn mixture(&self, row: usize, column: usize) -> (u8, u8, f64) {
        let mut room = [NONE; AROUND];
        let near = self.flat_around(row, column, &mut room);
        let mixed = self.mixture_of(near, row, column);
        match near {
            &[a, b] => self.seam(a, b, row, column, mixed).unwrap_or(mixed),
            _ => mixed,
        }
    }

    /// A seam of the only two colours that lie flat around a pixel, if that is clearly nearer than the mixture. What
    /// shows through lies below both, and so nowhere beside them.
    fn seam(
        &self,
        a: u8,
        b: u8,
        row: usize,
        column: usize,
        (first, second, _): (u8, u8, f64),
    ) -> Option<(u8, u8, f64)> {
        let pixel = &self.window[row % KEPT].pixels[column];
        let palette = &self.layers.palette;
        let [from, to, one, other] = [a, b, first, second].map(|label| &palette[usize::from(label)]);
        let gap = Mixture::new(pixel, one, other).gap;
        if gap <= ROUNDED {
            return None;
        }
        let columns = column.saturating_sub(REACH)..=(column + REACH).min(self.layers.width - 1);
        let is_beside = |label: u8| {
            self.around(row, REACH)
                .any(|row| self.window[row % KEPT].labels[columns.clone()].contains(&label))
        };
        let (mut best, mut least) = (None, SEAM.min(gap / NEARER));
        for (i, ground) in palette.iter().enumerate() {
            if let Some(seam) = Seam::new(pixel, from, to, ground)
                && seam.gap < least
                && !is_beside(i as u8)
            {
                (best, least) = (Some((a, b, seam.share)), seam.gap);
            }
        }
        best
    }

    /// The mixture of its own colour and one that lies flat nearby, of two that do, or of any.
    fn mixture_of(&self, near: &[u8], row: usize, column: usize) -> (u8, u8, f64) {
        let line = &self.window[row % KEPT];
        let (pixel, label) = (&line.pixels[column], line.labels[column]);
        if line.flat[column] && near.contains(&label) {
            // A tenth of another colour tells where the edge is as well as a half does.
            let mut pairs = near.iter().map(|&other| (label, other));
            return self
                .nearest_mixture(pixel, f64::INFINITY, 0.0, &mut pairs)
                .unwrap_or((label, label, 0.0));
        }
        let mut pairs = near.iter().enumerate().flat_map(|(i, &a)| near[i..].iter().map(move |&b| (a, b)));
        if let Some(best) = self.nearest_mixture(pixel, MIXED, 0.0, &mut pairs) {
            return best;
        }
        if label != NONE {
            return self.edge_of_thin(near, row, column).unwrap_or((label, label, 0.0));
        }
        // Something thin, that is flat nowhere: with what is around it, or alone. Its hue is truer than how dark it is.
        let all = 0..self.layers.palette.len() as u8;
        let mut pairs = all.flat_map(|b| near.iter().map(move |&a| (a, b)).chain([(b, b)]));
        self.nearest_mixture(pixel, f64::INFINITY, SHADE, &mut pairs).unwrap_or((0, 0, 0.0))
    }

    /// What a pixel that has a colour of the palette is made of all the same: beside something thin that is darker, or
    /// lighter, it shows some of that. Not in a line of its colour.
    fn edge_of_thin(&self, near: &[u8], row: usize, column: usize) -> Option<(u8, u8, f64)> {
        if self.is_in_line(row, column) {
            return None;
        }
        let (pixel, palette) = (&self.window[row % KEPT].pixels[column], &self.layers.palette);
        let beyond = self.beyond(near, row, column)?;
        let (mut best, mut least) = (None, f64::INFINITY);
        for (&a, b) in near.iter().flat_map(|a| (0..palette.len() as u8).map(move |b| (a, b))) {
            let [from, to] = [a, b].map(|label| &palette[usize::from(label)]);
            let [here, there] = [pixel, beyond].map(|pixel| Mixture::new(pixel, from, to));
            let off = |mixture: &Mixture| mixture.gap - SHADE * mixture.light;
            let gap = off(&here) + off(&there) + AWAY * f64::from(squared(beyond, to));
            if gap < least {
                (best, least) = (Some((a, b, here.share)), gap);
            }
        }
        best
    }

    /// The neighbour that is farthest from a colour nearby, of those that a pixel is between that colour and.
    fn beyond(&self, near: &[u8], row: usize, column: usize) -> Option<&Premultiplied> {
        let columns = column.saturating_sub(1)..=(column + 1).min(self.layers.width - 1);
        let pixel = &self.window[row % KEPT].pixels[column];
        let (mut best, mut farthest) = (None, 0);
        for &ground in near {
            let ground = &self.layers.palette[usize::from(ground)];
            for other in self.around(row, 1).flat_map(|row| &self.window[row % KEPT].pixels[columns.clone()])
            {
                let far = squared(ground, other);
                if far > farthest && is_between(pixel, ground, other, MIXED) {
                    (best, farthest) = (Some(other), far);
                }
            }
        }
        best
    }

    /// Whether a pixel has the colour of two on opposite sides, and is not on an edge. Beyond the border all is as it
    /// is here.
    fn is_in_line(&self, row: usize, column: usize) -> bool {
        let label = |row: usize, column: usize| self.window[row % KEPT].labels[column];
        let (rows, left, right) =
            (self.around(row, 1), column.saturating_sub(1), (column + 1).min(self.layers.width - 1));
        let (above, below) = (*rows.start(), *rows.end());
        let sides = [
            [label(row, left), label(row, right)],
            [label(above, column), label(below, column)],
            [label(above, left), label(below, right)],
            [label(below, left), label(above, right)],
        ];
        sides.contains(&[label(row, column); 2]) && !self.is_on_edge(row, column)
    }

    /// The colours that lie flat around a pixel. One that shows itself nowhere there, and is a mixture of two others,
    /// is their soft edge.
    fn flat_around<'a>(&self, row: usize, column: usize, room: &'a mut [u8; AROUND]) -> &'a [u8] {
        let columns = column.saturating_sub(REACH)..=(column + REACH).min(self.layers.width - 1);
        let (mut found, mut count, mut steady) = ([NONE; AROUND], 0, [false; AROUND]);
        for row in self.around(row, REACH) {
            let other = &self.window[row % KEPT];
            for column in columns.clone().filter(|&column| other.flat[column]) {
                let label = other.labels[column];
                let at = found[..count].iter().position(|&known| known == label).unwrap_or(count);
                found[at] = label;
                steady[at] |= other.steady[column];
                count = count.max(at + 1);
            }
        }
        let found = &found[..count];
        let is_soft = |label: u8| {
            let is_mixture = |a: u8, b: u8| {
                let Mixture { share, gap, .. } = self.between(label, a, b);
                gap < MIXED && share > 0.0 && share < 1.0
            };
            let others = || found.iter().filter(|&&other| other != label);
            others().any(|&a| others().any(|&b| is_mixture(a, b)))
        };
        let mut kept = 0;
        for (&label, steady) in found.iter().zip(steady) {
            if steady || !is_soft(label) {
                room[kept] = label;
                kept += 1;
            }
        }
        &room[..kept]
    }

    /// Three colours of the palette: the mixture of two that is nearest to the first.
    fn between(&self, label: u8, a: u8, b: u8) -> Mixture {
        let [color, from, to] = [label, a, b].map(|label| &self.layers.palette[usize::from(label)]);
        Mixture::new(color, from, to)
    }

    /// The first of the mixtures that is nearest to a pixel, if one is nearer than `least`; differences in light count
    /// less by the share `shade`.
    fn nearest_mixture(
        &self,
        pixel: &Premultiplied,
        mut least: f64,
        shade: f64,
        pairs: &mut dyn Iterator<Item = (u8, u8)>,
    ) -> Option<(u8, u8, f64)> {
        let mut best = None;
        for (a, b) in pairs {
            let [from, to] = [a, b].map(|label| &self.layers.palette[usize::from(label)]);
            let Mixture { share, gap, light } = Mixture::new(pixel, from, to);
            if gap - shade * light < least {
                (best, least) = (Some((a, b, share)), gap - shade * light);
            }
        }
        best
    }
}
