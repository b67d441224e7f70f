//! Whether a picture was compressed in squares of eight pixels, as JPEG is: where all of a square is of one colour it
//! stays even to the bit, and where an edge crosses it there are waves. So what is even ends where squares do.

use crate::error::Result;
use crate::limits::with_room;

/// Pixels along the side of a square.
const SIDE: usize = 8;
/// So many pixels that are the same, beside a first one, are even.
const EVEN: u8 = 6;
/// Ends that count in one column: the faint edge of something upright goes through many rows.
const MOST: u8 = 15;
/// Fewer ends say nothing.
const LEAST: u32 = 48;

/// What tells that a picture was compressed: squares, or hues that pixels share.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compression {
    pub(super) squares: bool,
    pub(super) shared_hues: bool,
}

/// How often what is even along a row ends in each column.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    ends: Vec<u8>,
}

impl Squares {
    pub(super) fn new(width: usize) -> Result<Self> {
        let mut ends = with_room(width)?;
        ends.resize(width, 0);
        Ok(Self { ends })
    }

    /// So many pixels that are the same end before a column, where all goes on nearly alike.
    pub(super) fn end(&mut self, column: usize, run: u8) {
        if run >= EVEN && self.ends[column] < MOST {
            self.ends[column] += 1;
        }
    }

    /// Whether most of it ends where squares do, wherever the first one begins. Hues that are shared by pixels reach
    /// one pixel farther.
    pub(super) fn are_there(&self) -> bool {
        let mut sums = [0; SIDE];
        for (column, &ends) in self.ends.iter().enumerate() {
            sums[column % SIDE] += u32::from(ends);
        }
        let all: u32 = sums.iter().sum();
        all >= LEAST && (0..SIDE).any(|k| 2 * (sums[k] + sums[(k + 1) % SIDE]) > all)
    }
}
