//! A set of pixels, one bit each, and what a pixel's neighbours say.

use crate::error::Result;
use crate::limits::with_room;

/// Pixels that are set or not; beyond the border nothing is.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::trace) struct Bitmap {
    width: usize,
    height: usize,
    words: Vec<u64>,
}

/// Columns and rows to the eight neighbours, clockwise from the right; odd ones are diagonal.
const AROUND: [(isize, isize); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

impl Bitmap {
    pub(in crate::trace) fn new(width: usize, height: usize) -> Result<Self> {
        let count = (width * height).div_ceil(64);
        let mut words = with_room(count)?;
        words.resize(count, 0);
        Ok(Self { width, height, words })
    }

    pub(in crate::trace) fn width(&self) -> usize {
        self.width
    }

    pub(in crate::trace) fn height(&self) -> usize {
        self.height
    }

    pub(in crate::trace) fn get(&self, column: usize, row: usize) -> bool {
        let bit = row * self.width + column;
        self.words[bit / 64] >> (bit % 64) & 1 == 1
    }

    pub(in crate::trace) fn set(&mut self, column: usize, row: usize, value: bool) {
        let bit = row * self.width + column;
        let mask = 1 << (bit % 64);
        if value {
            self.words[bit / 64] |= mask;
        } else {
            self.words[bit / 64] &= !mask;
        }
    }

    /// Clears a pixel; whether it was set.
    pub(in crate::trace) fn take(&mut self, column: usize, row: usize) -> bool {
        let was = self.get(column, row);
        self.set(column, row, false);
        was
    }

    /// How many pixels are set.
    pub(in crate::trace) fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// The set pixels (column, row), row by row.
    pub(in crate::trace) fn pixels(&self) -> impl Iterator<Item = (usize, usize)> {
        let width = self.width;
        self.words.iter().enumerate().flat_map(move |(i, &word)| {
            let mut rest = word;
            core::iter::from_fn(move || {
                if rest == 0 {
                    return None;
                }
                let bit = i * 64 + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                Some((bit % width, bit / width))
            })
        })
    }

    /// The neighbour in one of eight directions, clockwise from the right, if it is in the picture.
    pub(in crate::trace) fn beside(
        &self,
        column: usize,
        row: usize,
        direction: usize,
    ) -> Option<(usize, usize)> {
        let (dx, dy) = AROUND[direction % 8];
        let (c, r) = (column.checked_add_signed(dx)?, row.checked_add_signed(dy)?);
        (c < self.width && r < self.height).then_some((c, r))
    }

    /// The eight neighbours as bits, clockwise from the right.
    pub(super) fn around(&self, column: usize, row: usize) -> u8 {
        let mut bits = 0;
        for direction in 0..8 {
            let set = self.beside(column, row, direction).is_some_and(|(c, r)| self.get(c, r));
            bits |= u8::from(set) << direction;
        }
        bits
    }

    /// The neighbours that a pixel is joined to, as bits: those beside it, and those at its corners where both pixels
    /// between are not set.
    pub(in crate::trace) fn joined(&self, column: usize, row: usize) -> u8 {
        let around = self.around(column, row);
        let mut bits = around & 0b0101_0101;
        for direction in [1, 3, 5, 7] {
            let between = 1 << (direction - 1) | 1 << ((direction + 1) % 8);
            if around >> direction & 1 == 1 && around & between == 0 {
                bits |= 1 << direction;
            }
        }
        bits
    }

    /// Makes lines one pixel wide, layer after layer: a pixel goes if what is around it stays joined without it and it
    /// is not an end.
    ///
    /// Each round takes pixels from one side only, those that were at the border when it began, so that lines do not
    /// shrink along themselves.
    pub(in crate::trace) fn thin(&mut self, layer: &mut Vec<(u32, u32)>) {
        let mut border: Vec<(u32, u32)> = Vec::new();
        loop {
            let before = layer.len();
            for side in [6, 2, 0, 4] {
                border.clear();
                border.extend(layer.iter().filter(|&&pixel| self.may_go(pixel, Some(side))));
                for &(column, row) in &border {
                    if self.may_go((column, row), None) {
                        self.set(column as usize, row as usize, false);
                    }
                }
                layer.retain(|&(column, row)| self.get(column as usize, row as usize));
            }
            if layer.len() == before {
                return;
            }
        }
    }

    fn may_go(&self, (column, row): (u32, u32), side: Option<usize>) -> bool {
        let around = self.around(column as usize, row as usize);
        let open = side.is_none_or(|side| around >> side & 1 == 0);
        open && around.count_ones() >= 2 && is_simple(around)
    }
}

/// Whether a set pixel with these neighbours can go without joining or parting anything: the number of its sides that
/// see a part of the set of their own is one \[Yok75\].
pub(super) fn is_simple(around: u8) -> bool {
    let off = |direction: usize| around >> (direction % 8) & 1 == 0;
    let parts = [0, 2, 4, 6].into_iter().filter(|&d| off(d) && !(off(d + 1) && off(d + 2))).count();
    parts == 1
}
