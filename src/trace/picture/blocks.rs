//! Pictures that were scaled up by repeating pixels: squares of one colour each, which say no more than the pixels that they were. Where they are
//! one and a half times as large, every other column and row of pixels is there twice: these, too, are squares here.

/// Drawings of squares keep to palettes of as many colours, or fewer.
const MOST_COLORS: u32 = 32;
/// Their shades of gray are no more than this; four rows of four samples in a pixel are seventeen.
pub(super) const MOST_SHADES: u32 = 16;
/// Squares of two sizes come back after as many columns and rows at most: nine quarters and what is simpler.
const PERIOD: usize = 9;
/// The broadest runs of one shade that such squares may be.
const BROADEST: usize = PERIOD.div_ceil(2);
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
    /// The first column and the first row that were seen not to be like the one before; 0 for none.
    changed: [usize; 2],
    /// For each period, a bit for each of its columns and its rows that was once not like the one before.
    seen: [[u16; 2]; PERIOD + 1],
    /// How often shades between those on both sides have so many pixels along a row.
    runs: [usize; BROADEST + 1],
    /// Rows that are not like the one before, and changes along those.
    lines: usize,
    changes: usize,
    /// Kinds of colours that lie between those on both sides, a bit each: as many as there are such colours, or fewer.
    kinds: u64,
}

/// The squares of equal pixels that all of a picture is made of; the border may cut squares off, which are whole all the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Blocks {
    pub(in crate::trace) size: usize,
    /// Columns and rows that the first squares lack, `count` times.
    pub(in crate::trace) lead: [usize; 2],
    /// So many squares lie in `size` pixels.
    pub(in crate::trace) count: usize,
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
            changed: [0; 2],
            seen: [[0; 2]; PERIOD + 1],
            runs: [0; BROADEST + 1],
            lines: 0,
            changes: 0,
            kinds: 0,
        }
    }

    /// More rows of pixels of some bytes each, four at most.
    ///
    /// # Cost
    ///
    /// O(pixels) for pictures of squares; of others the first few rows with ink say that they are none.
    #[inline(never)]
    pub fn push(&mut self, rows: &[u8], each: usize) {
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
        if self.changed[axis] == 0 {
            self.changed[axis] = at;
        }
        for (period, seen) in self.seen.iter_mut().enumerate().skip(3) {
            seen[axis] |= 1 << (at % period);
        }
        let (mut a, mut b) = (self.size, at.abs_diff(self.changed[axis]));
        while b > 0 {
            (a, b) = (b, a % b);
        }
        self.size = a;
    }

    /// Whether no squares can be found any more.
    fn is_over(&self) -> bool {
        let is_full = |(period, seen): (usize, &[u16; 2])| seen[0].max(seen[1]) >= (1 << period) - 1;
        self.size == 1 && self.seen.iter().enumerate().skip(3).all(is_full)
    }

    /// Squares of two sizes by turns that all of the picture is made of: how many pixels have how many squares, and what the first ones lack.
    #[inline(never)]
    fn uneven(&self) -> Option<(usize, usize, [usize; 2])> {
        for count in 2..PERIOD {
            for size in count + count.div_ceil(4)..=PERIOD {
                if self.are_as_broad(size, count)
                    && let Some(column) = self.lead(0, size, count)
                    && let Some(row) = self.lead(1, size, count)
                {
                    return Some((size, count, [column, row]));
                }
            }
        }
        None
    }

    /// What the first of such squares lacks: nothing, if that may be.
    #[inline(never)]
    fn lead(&self, axis: usize, size: usize, count: usize) -> Option<usize> {
        let seen = self.seen[size][axis];
        let begins =
            |lead: &usize| (0..size).all(|at| seen >> at & 1 == 0 || (at * count + lead) % size < count);
        (0..size).map(|turn| (turn + (count - 1) / 2) % size).find(begins)
    }

    /// Whether shades between others are broad at least half as often as such squares: where columns are alike only because nothing is drawn
    /// there, as between the dots of a pattern, they are not.
    fn are_as_broad(&self, size: usize, count: usize) -> bool {
        let (mut all, mut pixels) = (0, 0);
        for (run, often) in self.runs.iter().enumerate().take(size.div_ceil(count) + 1) {
            all += often;
            pixels += run * often;
        }
        2 * count * pixels > (size + count) * all
    }

    /// Looks no further; what [`BlockScan::blocks`] says.
    pub fn end(&mut self) -> Option<Blocks> {
        let blocks = self.blocks();
        self.size = 1;
        self.seen = [[u16::MAX; 2]; PERIOD + 1];
        blocks
    }

    /// The squares that all of the picture is made of, if edges of shapes were drawn into them. Those of few colours were chosen, and are what
    /// was drawn.
    pub fn blocks(&self) -> Option<Blocks> {
        self.blocks_of(MOST_COLORS)
    }

    /// As [`BlockScan::blocks`], where so many kinds are few. Where more than half of the squares are not like the one to their left, each is
    /// a value of its own, as in a table that is shown in colours; below two pixels nobody could read it, and it is noise.
    #[inline(never)]
    pub(super) fn blocks_of(&self, few: u32) -> Option<Blocks> {
        let Self { size, extent, changed, .. } = *self;
        if size == 0 || self.kinds.count_ones() <= few {
            return None;
        }
        let (size, count, lead) = match size {
            1 => self.uneven()?,
            _ => (size, 1, changed.map(|at| (size - at % size) % size)),
        };
        if size >= 2 * count && 2 * self.changes * size > self.lines * extent[0] * count {
            return None;
        }
        let squares = [0, 1].map(|axis| ((extent[axis] - 1) * count + lead[axis]) / size + 1);
        Some(Blocks { size, count, lead, width: extent[0], squares })
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
        let at = |axis: usize, square: usize| {
            (square * self.size).saturating_sub(self.lead[axis]).div_ceil(self.count)
        };
        at(1, square / width) * self.width + at(0, square % width)
    }
}
