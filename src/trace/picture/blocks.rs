//! Pictures that were scaled up by repeating pixels: squares of one colour each, which say no more than the pixels that
//! they were. Where they are one and a half times as large, every other column and row of pixels is there twice: these,
//! too, are squares here.

use super::pitch::{Changes, MOST_TIMES, Pitch, uneven};

/// Drawings of squares keep to palettes of as many colours, or fewer.
const MOST_COLORS: u32 = 32;
/// Their shades of gray are no more than this; four rows of four samples in a pixel are seventeen.
pub(super) const MOST_SHADES: u32 = 16;
/// The broadest runs of one shade that squares of two sizes may be.
const BROADEST: usize = MOST_TIMES;
/// The golden ratio in 32 bits, by which colours are told apart as evenly as can be.
const GOLDEN: u32 = 0x9E37_79B1;

/// Looks for squares of equal pixels that all of a picture is made of, while its rows come.
#[derive(Clone, Debug)]
pub struct BlockScan {
    extent: [usize; 2],
    /// The last row that is not like the one before.
    above: Vec<u8>,
    /// The largest side of such squares by the rows until now; 0 before anything changes twice along a row or a column.
    size: usize,
    /// The columns and the rows that were seen not to be like the one before.
    changed: [Changes; 2],
    /// How often shades between those on both sides have so many pixels along a row.
    runs: [usize; BROADEST + 1],
    /// Rows that are not like the one before, and changes along those.
    lines: usize,
    changes: usize,
    /// Kinds of colours that lie between those on both sides, a bit each: as many as there are such colours, or fewer.
    kinds: u64,
}

/// The squares of equal pixels that all of a picture is made of; the border may cut squares off, which are whole all
/// the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Blocks {
    /// How columns and rows of pixels make columns and rows of squares.
    pub(in crate::trace) grid: [Pitch; 2],
    /// Columns of pixels.
    width: usize,
    /// Columns and rows of squares.
    squares: [usize; 2],
}

impl BlockScan {
    /// Begins a picture of that many columns.
    pub fn new(width: usize) -> Self {
        Self {
            extent: [width, 0],
            above: Vec::new(),
            size: 0,
            changed: Default::default(),
            runs: [0; BROADEST + 1],
            lines: 0,
            changes: 0,
            kinds: 0,
        }
    }

    /// More rows of pixels of one to four bytes each; of others nothing is looked at.
    ///
    /// # Cost
    ///
    /// O(pixels) for pictures of squares; of others the first few rows with ink say that they are none.
    pub fn push(&mut self, rows: &[u8], each: usize) {
        if (1..=4).contains(&each) && self.extent[0] <= usize::MAX / 4 {
            self.look(rows, each);
        }
    }

    /// The same of pixels that have so many bytes, and of a width that there is.
    #[inline(never)]
    pub(crate) fn look(&mut self, rows: &[u8], each: usize) {
        for row in rows.chunks_exact((each * self.extent[0]).max(1)) {
            if self.is_over() {
                return;
            }
            let at = self.extent[1];
            self.extent[1] += 1;
            if self.above == row {
                continue;
            }
            if at > 0 {
                self.change(1, at);
            }
            self.above.clear();
            self.above.extend_from_slice(row);
            self.along(row, each);
        }
    }

    /// Looks at a row that is not like the one before.
    fn along(&mut self, row: &[u8], each: usize) {
        self.lines += 1;
        let (mut last, mut before, mut start) = (0, 0, 0);
        for (column, pixel) in row.chunks_exact(each).enumerate() {
            let color = pixel.iter().fold(0, |color, &byte| color << 8 | u32::from(byte));
            if column == 0 {
                (last, before) = (color, color);
            }
            if color == before {
                continue;
            }
            self.change(0, column);
            self.changes += 1;
            if (last < before) == (before < color) && last != before {
                self.kinds |= 1 << (before.wrapping_mul(GOLDEN) >> 26);
                if let Some(run) = self.runs.get_mut(column - start) {
                    *run += 1;
                }
            }
            (last, before, start) = (before, color, column);
        }
    }

    /// A column or a row is not like the one before.
    #[inline(never)]
    fn change(&mut self, axis: usize, at: usize) {
        let Some(first) = self.changed[axis].note(at) else { return };
        let (mut a, mut b) = (self.size, at.abs_diff(first));
        while b > 0 {
            (a, b) = (b, a % b);
        }
        self.size = a;
    }

    /// Whether no squares can be found any more.
    fn is_over(&self) -> bool {
        self.changed.iter().any(Changes::is_over)
    }

    /// Whether shades between others are broad at least half as often as such squares: where columns are alike only
    /// because nothing is drawn there, as between the dots of a pattern, they are not.
    fn are_as_broad(&self, times: f64) -> bool {
        let (mut all, mut pixels) = (0, 0);
        for (run, often) in self.runs.iter().enumerate().take(times.ceil() as usize + 1) {
            all += often;
            pixels += run * often;
        }
        2.0 * pixels as f64 > (1.0 + times) * all as f64
    }

    /// Looks no further; what [`BlockScan::blocks`] says.
    pub fn end(&mut self) -> Option<Blocks> {
        let blocks = self.blocks();
        self.changed[0].end();
        blocks
    }

    /// The squares that all of the picture is made of, if edges of shapes were drawn into them. Those of few colours
    /// were chosen, and are what was drawn.
    pub fn blocks(&self) -> Option<Blocks> {
        self.blocks_of(MOST_COLORS)
    }

    /// As [`BlockScan::blocks`], where so many kinds are few. Where more than half of the squares are not like the one
    /// to their left, each is a value of its own, as in a table that is shown in colours; below two pixels nobody could
    /// read it, and it is noise.
    #[inline(never)]
    pub(super) fn blocks_of(&self, few: u32) -> Option<Blocks> {
        let Self { size, extent, ref changed, .. } = *self;
        if size == 0 || self.is_over() || self.kinds.count_ones() <= few {
            return None;
        }
        let grid = match size {
            1 => uneven(changed, extent, &|times| self.are_as_broad(times))?,
            _ => changed.each_ref().map(|changes| changes.even(size)),
        };
        let times = grid[0].times();
        if times >= 2.0 && 2.0 * times * self.changes as f64 > (self.lines * extent[0]) as f64 {
            return None;
        }
        let squares = [0, 1].map(|axis| grid[axis].square(extent[axis] - 1) + 1);
        Some(Blocks { grid, width: extent[0], squares })
    }
}

impl Blocks {
    /// Columns and rows of squares.
    pub fn extent(&self) -> [usize; 2] {
        self.squares
    }

    /// The first pixel of a square, both counted row by row.
    #[inline(never)]
    pub fn pixel(&self, square: usize) -> usize {
        let width = self.squares[0];
        self.grid[1].first(square / width) * self.width + self.grid[0].first(square % width)
    }
}
