//! Strokes of about a pixel, alone or beside others: half-way from paper to ink they would break where they run between
//! two rows of pixels.

use super::gray::Gray;
use super::tones::Tones;
use crate::error::Result;
use crate::limits::with_room;

/// Ink that covers less than this of the pixels across is that of a thin stroke, or of a tip. Along it there may be
/// more.
pub(in crate::trace) const FULL: f64 = 0.98;
/// On both sides of it there is paper, within two pixels.
const CLEAR: f64 = 0.2;
/// It is followed as if there were so many times as much of it.
const TIMES: f64 = 2.0;

/// A picture whose thin strokes are lifted while contours are looked for: rows are kept for as long as they are needed.
#[derive(Debug)]
pub(in crate::trace) struct Lifting {
    paper: f64,
    /// From paper to ink.
    way: f64,
    done: usize,
    /// The last two rows.
    rows: [Vec<u16>; 2],
}

impl Lifting {
    /// # Errors
    ///
    /// `OutOfMemory` only.
    pub(in crate::trace) fn new(width: usize, tones: &Tones, inverted: bool) -> Result<Self> {
        let [ink, paper] = if inverted { [tones.paper, tones.ink] } else { [tones.ink, tones.paper] };
        Ok(Self { paper, way: ink - paper, done: 0, rows: [with_room(width)?, with_room(width)?] })
    }

    /// The next row, if there is one: the row before it, and itself. Beyond the picture rows are empty.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> [&[u16]; 2] {
        self.rows.swap(0, 1);
        self.rows[1].clear();
        if self.done < gray.height() {
            let row = self.done;
            for column in 0..gray.width() {
                let shade = self.lifted(gray, column, row);
                self.rows[1].push(shade);
            }
            self.done += 1;
        }
        let [before, here] = &self.rows;
        [before, here]
    }

    fn lifted(&self, gray: &Gray, column: usize, row: usize) -> u16 {
        let ink = |column: usize, row: usize| (gray.shade(column, row) - self.paper) / self.way;
        let here = ink(column, row);
        if here > 0.0 && here < FULL {
            // Beyond the border all is paper.
            let at =
                |x: usize, y: usize| if x >= gray.width() || y >= gray.height() { 0.0 } else { ink(x, y) };
            let back = usize::wrapping_sub;
            let across = |place: &dyn Fn(usize) -> [f64; 2]| {
                let ([a, b], [c, d]) = (place(1), place(2));
                a < FULL && b < FULL && (a < CLEAR || c < CLEAR) && (b < CLEAR || d < CLEAR)
            };
            if across(&|k| [at(back(column, k), row), at(column + k, row)])
                || across(&|k| [at(column, back(row, k)), at(column, row + k)])
            {
                return (self.paper + (TIMES * here).min(1.0) * self.way) as u16;
            }
        }
        gray.shade(column, row) as u16
    }
}
