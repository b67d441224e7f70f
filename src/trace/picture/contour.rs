//! Iso-contours between pixel centres: closed polylines with the ink on one side.

use super::gray::Gray;
use crate::error::{Error, Result};
use crate::limits::with_room;
use crate::numerics::plane::cross;
use crate::numerics::{Point, Vector};

/// A closed polyline; ink lies on the right as x goes right and y down, so that ink has a positive area.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Where the contour crosses the lines between neighbouring pixel centres.
    pub points: Vec<Point>,
    /// The area inside in square pixels; negative for holes.
    pub area: f64,
}

/// Cells that are looked at together.
const BLOCK: usize = 8;

/// No crossing yet.
const NONE: u32 = u32::MAX;

/// Where a contour crosses a line between neighbouring centres, and the next crossing of that contour.
#[derive(Clone, Copy, Debug)]
struct Crossing {
    place: [f32; 2],
    next: u32,
}

impl Crossing {
    fn point(&self) -> Point {
        Point::new(f64::from(self.place[0]), f64::from(self.place[1]))
    }
}

/// Links of crossings: every crossing has one before and one after it.
#[derive(Debug)]
struct Crossings {
    list: Vec<Crossing>,
    most: usize,
}

impl Crossings {
    fn add(&mut self, x: f64, y: f64) -> Result<u32> {
        let count = self.list.len();
        if count >= self.most {
            return Err(Error::limit("data", "maxContourPoints", self.most, count as f64 + 1.0));
        }
        self.list.try_reserve(1).map_err(|_| Error::memory(24 * count))?;
        self.list.push(Crossing { place: [x as f32, y as f32], next: NONE });
        Ok(count as u32)
    }
}

/// All contours at `level` between `dark` ink and light paper (or light ink, if `inverted`) that enclose at least
/// `speckle` square pixels.
///
/// The picture is taken to lie on paper: ink at its border is closed along the border. Where two diagonal pixels are
/// ink, the mean of the four decides whether they are joined.
///
/// # Errors
///
/// A picture with more contour points than half of its pixels and 65,536: not a drawing.
///
/// # Cost
///
/// O(pixels), in two rows; 12 bytes for each point.
pub fn contours(gray: &Gray, level: f64, inverted: bool, speckle: f64) -> Result<Vec<Contour>> {
    let mut scan = ContourScan::new(gray, level, inverted);
    while scan.step(gray)? {}
    scan.contours(speckle)
}

/// A walk over all cells between four pixel centres, two rows at a time, with a frame of paper around.
#[derive(Debug)]
pub(in crate::trace) struct ContourScan {
    crossings: Crossings,
    level: f64,
    sign: f64,
    line: usize,
    /// Which pixels of the rows above and below are ink, with the frame.
    above: Vec<u8>,
    below: Vec<u8>,
    /// Which cells are partly ink: whole blocks.
    mixed: Vec<u8>,
    /// The crossing on the upper side of each cell. Where there is none, anything.
    upper: Vec<u32>,
}

impl ContourScan {
    pub(in crate::trace) fn new(gray: &Gray, level: f64, inverted: bool) -> Self {
        let most = gray.width() * gray.height() / 2 + 65_536;
        let crossings = Crossings { list: Vec::new(), most };
        let size = gray.width() + 2;
        Self {
            crossings,
            level,
            sign: if inverted { -1.0 } else { 1.0 },
            line: 0,
            above: vec![0; size],
            below: vec![0; size],
            mixed: vec![0; size.next_multiple_of(BLOCK)],
            upper: vec![NONE; size],
        }
    }

    /// The shade that is followed.
    pub(in crate::trace) fn level(&self) -> f64 {
        self.level
    }

    /// Rows that are done.
    pub(in crate::trace) fn rows(&self) -> usize {
        self.line
    }

    /// One row of cells of a picture; whether there are more.
    pub(in crate::trace) fn step(&mut self, gray: &Gray) -> Result<bool> {
        let line = self.line;
        self.step_between([
            if line > 0 { gray.row(line - 1) } else { &[] },
            if line < gray.height() { gray.row(line) } else { &[] },
        ])
    }

    /// The next row of cells, between two rows of pixels, which are empty beyond the border; whether there are more.
    pub(in crate::trace) fn step_between(&mut self, rows: [&[u16]; 2]) -> Result<bool> {
        let [_, row] = rows;
        if row.is_empty() {
            self.below.fill(0);
        } else {
            let below = self.below[1..].iter_mut().zip(row);
            // Shades are whole numbers: being beyond the level is a comparison of whole numbers.
            if self.sign > 0.0 {
                let bound = self.level.ceil().max(0.0) as u16;
                below.for_each(|(ink, &v)| *ink = u8::from(v < bound));
            } else {
                let bound = self.level.floor().max(0.0) as u16;
                below.for_each(|(ink, &v)| *ink = u8::from(v > bound));
            }
        }
        mix(&self.above, &self.below, &mut self.mixed);
        let mut on_left = NONE;
        for block in 0..self.mixed.len() / BLOCK {
            // The lowest byte that is not 0 is the first mixed cell of the block.
            let mut cells = u64::from_le_bytes(self.mixed.as_chunks::<BLOCK>().0[block]);
            while cells != 0 {
                let first = cells.trailing_zeros() as usize / 8;
                on_left = self.cell(rows, BLOCK * block + first, on_left)?;
                cells &= !(255 << (8 * first));
            }
        }
        core::mem::swap(&mut self.above, &mut self.below);
        self.line += 1;
        Ok(!row.is_empty())
    }

    /// The crossings on the right and the lower side of a mixed cell, joined with the others; the one on the right.
    fn cell(&mut self, rows: [&[u16]; 2], cell: usize, on_left: u32) -> Result<u32> {
        let (x, y) = (cell as f64 - 0.5, self.line as f64 - 0.5);
        // Positive is ink. Paper beyond the border is as far from the level as ink is.
        let value = |corner: usize| {
            let column = cell + usize::from(corner == 1 || corner == 2);
            let shade = rows[corner / 2].get(column.wrapping_sub(1));
            shade.map_or(f64::NAN, |&shade| self.sign * (self.level - f64::from(shade)))
        };
        let ink = [self.above[cell], self.above[cell + 1], self.below[cell + 1], self.below[cell]];
        let right = if ink[1] == ink[2] {
            NONE
        } else {
            self.crossings.add(x + 1.0, y + between(value(1), value(2)))?
        };
        let bottom = if ink[3] == ink[2] {
            NONE
        } else {
            self.crossings.add(x + between(value(3), value(2)), y + 1.0)?
        };
        join(&mut self.crossings, &value, ink, [self.upper[cell], right, bottom, on_left]);
        self.upper[cell] = bottom;
        Ok(right)
    }

    /// The contours, once all rows are done.
    pub(in crate::trace) fn contours(&mut self, speckle: f64) -> Result<Vec<Contour>> {
        walk(&mut self.crossings, speckle)
    }
}

/// Marks the cells whose four pixels are not of one tone.
fn mix(above: &[u8], below: &[u8], mixed: &mut [u8]) {
    let pairs = above.iter().zip(&above[1..]).zip(below.iter().zip(&below[1..]));
    for (mixed, ((a, b), (c, d))) in mixed.iter_mut().zip(pairs) {
        *mixed = (a ^ b) | (c ^ d) | (a ^ c);
    }
}

/// Where between two centres the level lies; half-way to the paper beyond the border.
fn between(first: f64, second: f64) -> f64 {
    if first.is_nan() || second.is_nan() { 0.5 } else { first / (first - second) }
}

/// Joins the crossings on a cell's four sides, with the ink on the right.
#[inline]
fn join(crossings: &mut Crossings, value: &dyn Fn(usize) -> f64, ink: [u8; 4], sides: [u32; 4]) {
    // Side i runs from corner i to corner i + 1 around the cell. Contours enter where ink ends, and leave where it
    // begins: bit i says so.
    let here = ink[0] | ink[1] << 1 | ink[2] << 2 | ink[3] << 3;
    let after = (here >> 1 | here << 3) & 15;
    let (enters, leaves) = (here & !after, after & !here);
    let mut link = |from: usize, to: usize| crossings.list[sides[from % 4] as usize].next = sides[to % 4];
    let (enter, leave) = (enters.trailing_zeros() as usize, leaves.trailing_zeros() as usize);
    if enters.count_ones() < 2 {
        return link(enter, leave);
    }
    // A saddle: the four together say whether the ink is joined through the middle; where they are even, it is.
    let mean = (0..4).map(value).filter(|value| !value.is_nan()).sum::<f64>();
    let turn = if mean >= 0.0 { 1 } else { 3 };
    [enter, enter + 2].into_iter().for_each(|from| link(from, from + turn));
}

/// Follows the links, round by round, in the order in which the crossings were met.
fn walk(crossings: &mut Crossings, speckle: f64) -> Result<Vec<Contour>> {
    let mut found = Vec::new();
    let list = crossings.list.as_mut_slice();
    for start in 0..list.len() {
        if list[start].next == NONE {
            continue;
        }
        let mut count = 0;
        let mut area = 0.0;
        let mut at = start;
        let first = list[start].point();
        let mut from = Vector::zeros();
        loop {
            at = list[at].next as usize;
            let to = list[at].point() - first;
            area += 0.5 * cross(from, to);
            count += 1;
            from = to;
            if at == start {
                break;
            }
        }
        let mut points: Vec<Point> = Vec::new();
        let kept = area.abs() >= speckle && count >= 4;
        if kept {
            points = with_room(count)?;
        }
        loop {
            if kept {
                points.push(list[at].point());
            }
            at = core::mem::replace(&mut list[at].next, NONE) as usize;
            if at == start {
                break;
            }
        }
        if kept {
            found.push(Contour { points, area });
        }
    }
    Ok(found)
}
