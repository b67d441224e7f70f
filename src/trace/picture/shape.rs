//! The shapes of a picture's colours, which lie on one another without gaps (D 14.20).

use super::gray::Gray;
use super::layers::Layers;
use super::palette::MOST_COLORS;
use super::tint::Color;
use crate::error::{Error, Result};
use crate::limits::with_room;

/// The shape of one layer as a picture in gray, a few rows at a time.
///
/// It is where its colour is, and all that lies on it: every connected region of higher layers that touches it. So no
/// gap can open between a layer and what lies on it, however their outlines are rounded.
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
