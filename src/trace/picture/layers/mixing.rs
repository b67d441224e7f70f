//! What the pixels of edges are made of: two colours of the palette, by what lies around them.

use super::rows::{KEPT, LayerRows, NONE, REACH};
use crate::trace::picture::hues::by_light;
use crate::trace::picture::mixture::{Mixture, Premultiplied, Seam, is_between, squared};

/// Pixels around one, and itself.
const AROUND: usize = (2 * REACH + 1) * (2 * REACH + 1);
/// Squared distance up to which a pixel is taken for a mixture of two.
const MIXED: f64 = 32.0 * 32.0;
/// Squared distance from a mixture of two that roundings make,
const ROUNDED: f64 = 4.0 * 4.0;
/// and up to which a pixel is taken for a seam of two, if it is so many times nearer to one.
const SEAM: f64 = 4.0 * 4.0;
const NEARER: f64 = 8.0;
/// How much more than a hue the light of a mixture counts, squared, where hues are shared.
const LIT: f64 = 16.0;
/// How much less a difference in light counts than one in hue, where something is thin.
const SHADE: f64 = 0.9;
/// How much a colour counts that is farther away than what is seen of something thin.
const AWAY: f64 = 0.02;
/// So many pixels around one that are no colours of the palette are single ones that were drawn, not the mixtures of an
/// edge.
const OTHERS: usize = 2;

impl LayerRows {
    /// Whether all pixels around one have colours of the palette, and it has: there are no mixtures then.
    pub(super) fn is_crisp(&self, row: usize, column: usize) -> bool {
        let columns = column.saturating_sub(REACH)..=(column + REACH).min(self.layers.width - 1);
        let mut others = 0;
        for row in self.around(row, REACH) {
            others += self.window[row % KEPT].exact[columns.clone()].iter().filter(|&&exact| !exact).count();
        }
        others <= OTHERS && self.window[row % KEPT].exact[column]
    }

    /// The two colours of an edge's pixel and the share of the second.
    pub(super) fn mixture(&self, row: usize, column: usize) -> (u8, u8, f64) {
        let mut room = [NONE; AROUND];
        let near = self.flat_around(row, column, &mut room);
        if self.shares_hues
            && let Some(mixed) = self.mixture_by_light(near, row, column)
        {
            return mixed;
        }
        let mixed = self.mixture_of(near, row, column);
        match near {
            &[a, b] => self.seam(a, b, row, column, mixed).unwrap_or(mixed),
            _ => mixed,
        }
    }

    /// The mixture of two colours that lie flat nearby, unless its light is that of none. Where a hue is shared by
    /// pixels, light alone tells where an edge is, and hue only which two it lies between.
    fn mixture_by_light(&self, near: &[u8], row: usize, column: usize) -> Option<(u8, u8, f64)> {
        let pixel = by_light(&self.window[row % KEPT].pixels[column]);
        let (mut best, mut least) = (None, LIT * MIXED);
        for (i, &a) in near.iter().enumerate() {
            for &b in &near[i + 1..] {
                let [from, to] = [a, b].map(|label| by_light(&self.layers.palette[usize::from(label)]));
                let Mixture { share, gap, .. } = Mixture::new(&pixel, &from, &to);
                if gap < least {
                    (best, least) = (Some((a, b, share)), gap);
                }
            }
        }
        best
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
