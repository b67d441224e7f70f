//! Which part of every pixel near an outline it covers, exactly, and how that changes with its control points.

use super::cubic::Cubic;
use super::field::{Field, NONE, SIDE};
use crate::numerics::Point;

/// A part of a piece inside one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The pixel of the field.
    pub(super) pixel: u32,
    row: u16,
    column: u16,
    /// The parameter of its middle.
    pub(super) t: f32,
    /// Its extent.
    pub(super) dx: f32,
    pub(super) dy: f32,
    /// How far its middle is from the right border of the pixel.
    right: f32,
}

/// Chords are nowhere farther from their curve than 1/200 of a pixel, and in the mean not at all: b·6/(12n²) with the larger second difference b.
const FINENESS: f64 = 100.0;

/// Parts a piece at the borders of the pixels, rows and columns alike.
pub(super) fn parts(cubic: &Cubic, field: &Field, out: &mut Vec<Part>) {
    out.clear();
    let middle = cubic.end - cubic.start - cubic.leaving - cubic.arriving;
    let bend = (middle - cubic.leaving).norm().max((cubic.arriving - middle).norm());
    let steps = (bend * FINENESS).sqrt().ceil().clamp(1.0, 4000.0);
    let mut before = cubic.start;
    // A chord lies inside its arc, by h²|p″|/12 in the mean: its ends are moved outwards by as much, but for those of the piece.
    let outwards = -1.0 / (12.0 * steps * steps);
    for step in 0..steps as usize {
        let (first, last) = (step as f64 / steps, (step + 1) as f64 / steps);
        let after =
            if last < 1.0 { cubic.point(last) + cubic.acceleration(last) * outwards } else { cubic.end };
        edge(before, after, [first, last], field, out);
        before = after;
    }
}

fn edge(from: Point, to: Point, t: [f64; 2], field: &Field, out: &mut Vec<Part>) {
    let frame = SIDE as f64;
    let start = [from.x + frame, from.y + frame];
    let way = [to.x - from.x, to.y - from.y];
    let floors = [start[0].floor(), start[1].floor()];
    if floors == [(to.x + frame).floor(), (to.y + frame).floor()] {
        part(start, way, [0.0, 1.0], t, field, out);
        return;
    }
    // The next border on each axis, as a share of the edge.
    let (mut next, mut step) = ([2.0; 2], [2.0; 2]);
    for k in 0..2 {
        if way[k].abs() > 1e-12 {
            step[k] = 1.0 / way[k].abs();
            let ahead = if way[k] > 0.0 {
                floors[k] + 1.0 - start[k]
            } else if floors[k] < start[k] {
                start[k] - floors[k]
            } else {
                1.0
            };
            next[k] = ahead * step[k];
        }
    }
    let mut share = 0.0;
    while share < 1.0 {
        let until: f64 = if next[0] < next[1] { next[0] } else { next[1] };
        let until = if until < 1.0 { until } else { 1.0 };
        if until > share {
            part(start, way, [share, until], t, field, out);
        }
        share = until;
        for k in 0..2 {
            if next[k] <= until {
                next[k] += step[k];
            }
        }
    }
}

/// The part of an edge between two shares of it, which lies in one pixel.
fn part(start: [f64; 2], way: [f64; 2], share: [f64; 2], t: [f64; 2], field: &Field, out: &mut Vec<Part>) {
    let (columns, rows) = field.size();
    let (middle, extent) = (0.5 * (share[0] + share[1]), share[1] - share[0]);
    let (x, y) = (start[0] + way[0] * middle, start[1] + way[1] * middle);
    if !(y >= 0.0 && y < rows as f64) {
        return;
    }
    // Left of the frame it covers whole pixels; right of it nothing that is seen.
    let column = (x.max(0.0) as usize).min(columns - 1);
    let right = if x < 0.0 { 1.0 } else { (column as f64 + 1.0 - x).max(0.0) };
    let row = y as usize;
    out.push(Part {
        pixel: if x < 0.0 { NONE } else { field.pixel(column, row) },
        row: row as u16,
        column: column as u16,
        t: (t[0] + (t[1] - t[0]) * middle) as f32,
        dx: (way[0] * extent) as f32,
        dy: (way[1] * extent) as f32,
        right: right as f32,
    });
}

/// Room for one change after another.
#[derive(Debug, Default)]
pub(super) struct Sweep {
    /// The last part of each row, and the one before each part in its row.
    last: Vec<u32>,
    before: Vec<u32>,
    /// For each column of the row: the area to the right inside the pixel, and the height.
    cells: Vec<[f64; 2]>,
    marks: Vec<u64>,
}

impl Sweep {
    /// Takes parts out of the coverage and puts others in. Together they begin and end at the same places.
    /// How much the sum of squares grows, so far as it is known before the field settles.
    pub(super) fn exchange(&mut self, field: &mut Field, removed: &[Part], added: &[Part]) -> f64 {
        let (mut top, mut bottom) = (u16::MAX, 0);
        for part in removed.iter().chain(added) {
            (top, bottom) = (top.min(part.row), bottom.max(part.row));
        }
        if top > bottom {
            return 0.0;
        }
        self.last.clear();
        self.last.resize(usize::from(bottom - top) + 1, NONE);
        self.before.clear();
        for (i, part) in removed.iter().chain(added).enumerate() {
            let last = &mut self.last[usize::from(part.row - top)];
            self.before.push(*last);
            *last = i as u32;
        }
        let (columns, _) = field.size();
        self.cells.resize(columns, [0.0; 2]);
        self.marks.resize(columns.div_ceil(64), 0);
        let mut growth = 0.0;
        for row in top..=bottom {
            let (mut least, mut most) = (u16::MAX, 0);
            let mut at = self.last[usize::from(row - top)] as usize;
            while let Some(&before) = self.before.get(at) {
                let (part, sign) =
                    if at < removed.len() { (&removed[at], -1.0) } else { (&added[at - removed.len()], 1.0) };
                let height = sign * f64::from(part.dy);
                let cell = &mut self.cells[usize::from(part.column)];
                cell[0] += height * f64::from(part.right);
                cell[1] += height;
                self.marks[usize::from(part.column / 64)] |= 1 << (part.column % 64);
                (least, most) = (least.min(part.column), most.max(part.column));
                at = before as usize;
            }
            if least <= most {
                growth += self.row(field, usize::from(row), usize::from(least / 64), usize::from(most / 64));
            }
        }
        growth
    }

    /// Sums up one row, from one word of marks to another.
    fn row(&mut self, field: &mut Field, row: usize, first: usize, last: usize) -> f64 {
        // Heights cancel to rounding behind what has changed.
        const NOTHING: f64 = 1e-5;
        let (mut running, mut growth, mut next) = (0.0_f64, 0.0, 0);
        for word in first..=last {
            let mut marks = core::mem::take(&mut self.marks[word]);
            while marks != 0 {
                let column = 64 * word + marks.trailing_zeros() as usize;
                marks &= marks - 1;
                if running.abs() > NOTHING {
                    growth += fill(field, row, next, column, running);
                }
                let [area, height] = core::mem::take(&mut self.cells[column]);
                let pixel = field.pixel(column, row);
                if pixel != NONE {
                    growth += field.cover(pixel, -(running + area));
                }
                running += height;
                next = column + 1;
            }
        }
        growth
    }
}

/// Covers whole pixels between two columns.
fn fill(field: &mut Field, row: usize, from: usize, to: usize, height: f64) -> f64 {
    let (mut growth, mut column) = (0.0, from);
    while column < to {
        let pixel = field.pixel(column, row);
        if pixel == NONE {
            column = (column / SIDE + 1) * SIDE;
            continue;
        }
        growth += field.cover(pixel, -height);
        column += 1;
    }
    growth
}
