//! Which part of every pixel near an outline it covers, exactly, and how that changes with its control points.

use super::field::{BEYOND, Field, SIDE};
use crate::numerics::plane::{larger, norm, smaller};
use crate::trace::outline::Outline;
use crate::trace::outline::cubic::Cubic;

/// A part of a piece inside one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The pixel of the field; where it has none, the row.
    pub(super) pixel: u32,
    /// The parameter of its middle.
    pub(super) t: f32,
    /// Its extent.
    pub(super) dx: f32,
    pub(super) dy: f32,
    /// How far its middle is from the right border of the pixel.
    pub(super) right: f32,
}

/// Chords are nowhere farther from their curve than 1/200 of a pixel, and in the mean not at all: b·6/(12n²) with the
/// larger second difference b.
const FINENESS: f64 = 100.0;
/// Room for more parts than this is made when they come.
const MOST_WAYS: f64 = 4096.0;

/// Parts a piece at the borders of the pixels, rows and columns alike.
pub(super) fn parts(cubic: &Cubic, field: &Field, out: &mut Vec<Part>) {
    let middle = cubic.middle();
    let (second, third) = ((middle - cubic.leaving) * 3.0, cubic.arriving - middle * 2.0 + cubic.leaving);
    let bend = larger(norm(middle - cubic.leaving), norm(cubic.arriving - middle));
    let steps = (bend * FINENESS).sqrt().ceil().clamp(1.0, 4000.0);
    // Every chord is one part, and every border that is crossed begins another.
    make_room(out, (steps + smaller(cubic.taxi_length(), MOST_WAYS)) as usize + 2);
    // A chord lies inside its arc, by h²|p″|/12 in the mean: its ends are moved outwards by as much, but for those of
    // the piece.
    let outwards = -1.0 / (6.0 * steps * steps);
    let first = cubic.leaving * 3.0 + third * (3.0 * outwards);
    let base = cubic.start + second * outwards;
    let frame = SIDE as f64;
    let place = |x: f64, y: f64| [x + frame, y + frame];
    let (length, count) = (1.0 / steps, steps as usize);
    let frame = Frame::new(field);
    let (mut from, mut written) = (place(cubic.start.x, cubic.start.y), 0);
    let mut cell = frame.cell(from);
    for step in 1..=count {
        let t = step as f64 * length;
        let to = if step < count {
            let p = base + (first + (second + third * t) * t) * t;
            place(p.x, p.y)
        } else {
            place(cubic.end.x, cubic.end.y)
        };
        let edge = Edge { start: from, way: [to[0] - from[0], to[1] - from[1]], t: [t - length, length] };
        let last = frame.cell(to);
        written = match (cell, last) {
            (Some(cell), Some(last)) => frame.draw(&edge, [cell, last], out, written),
            _ => frame.draw_beyond(edge, out, written),
        };
        (from, cell) = (to, last);
    }
    out.truncate(written);
}

/// What pixels the first pieces of an outline cross.
pub(super) fn pieces(outline: &Outline, count: usize, field: &Field) -> impl Iterator<Item = Vec<Part>> {
    (0..count).map(move |i| {
        let mut list = Vec::new();
        parts(&outline.cubic(i), field, &mut list);
        list
    })
}

/// Parts that are written over.
fn make_room(out: &mut Vec<Part>, count: usize) {
    const BLANK: Part = Part { pixel: BEYOND, t: 0.0, dx: 0.0, dy: 0.0, right: 0.0 };
    if out.len() < count {
        // Doubling would leave half of the memory that all pieces take to nobody.
        out.reserve_exact(count + count / 8 - out.len());
        out.resize(count, BLANK);
    }
}

/// A straight edge in the field's frame.
#[derive(Clone, Copy)]
struct Edge {
    start: [f64; 2],
    way: [f64; 2],
    /// Its first parameter, and the length of its range.
    t: [f64; 2],
}

impl Edge {
    /// The place at a share of the edge.
    fn at(&self, share: f64) -> [f64; 2] {
        [self.start[0] + self.way[0] * share, self.start[1] + self.way[1] * share]
    }

    #[inline(always)]
    fn part(&self, share: [f64; 2], (pixel, right): (u32, f64)) -> Part {
        let (middle, extent) = (0.5 * (share[0] + share[1]), share[1] - share[0]);
        Part {
            pixel,
            t: (self.t[0] + self.t[1] * middle) as f32,
            dx: (self.way[0] * extent) as f32,
            dy: (self.way[1] * extent) as f32,
            right: right as f32,
        }
    }
}

/// The borders that an edge crosses on one axis.
#[derive(Clone, Copy)]
struct Crossings {
    /// The way from one pixel to the next.
    ahead: i32,
    /// The next border as a share of the edge, beyond its end if there is none, and how far it is from one to the next.
    next: f64,
    step: f64,
}

impl Crossings {
    #[inline(always)]
    fn new(at: i32, last: i32, from: f64, way: f64) -> Self {
        if at == last {
            return Self { ahead: 0, next: 2.0, step: 0.0 };
        }
        let (inverse, up) = (1.0 / way, last > at);
        let next = (f64::from(at + i32::from(up)) - from) * inverse;
        Self { ahead: if up { 1 } else { -1 }, next, step: inverse.abs() }
    }

    #[inline(always)]
    fn cross(&mut self, at: &mut i32, last: i32) {
        *at += self.ahead;
        self.next = if *at == last { 2.0 } else { self.next + self.step };
    }
}

/// Where edges are drawn: the pixels of a field, from its corner. What it does is a part of one loop, and it is never
/// in memory.
#[derive(Clone, Copy)]
struct Frame<'a> {
    field: &'a Field,
    /// Columns and rows.
    size: [f64; 2],
}

impl<'a> Frame<'a> {
    fn new(field: &'a Field) -> Self {
        let (columns, rows) = field.size();
        Self { field, size: [columns as f64, rows as f64] }
    }

    /// The pixel that a place is in, if it is one of the field's.
    #[inline(always)]
    fn cell(&self, at: [f64; 2]) -> Option<[i32; 2]> {
        let inside = at[0] >= 0.0 && at[1] >= 0.0 && at[0] < self.size[0] && at[1] < self.size[1];
        inside.then(|| at.map(|v| v as i32))
    }

    /// The parts of an edge from one pixel to another, written behind those that are there already; how many there are
    /// then.
    #[inline(always)]
    fn draw(
        &self,
        edge: &Edge,
        [mut cell, last]: [[i32; 2]; 2],
        out: &mut Vec<Part>,
        written: usize,
    ) -> usize {
        let crossed = last[0].abs_diff(cell[0]) + last[1].abs_diff(cell[1]);
        let end = written + crossed as usize + 1;
        if out.len() < end {
            make_room(out, end);
        }
        let (list, mut at) = (&mut out[..end], written);
        let mut across = Crossings::new(cell[0], last[0], edge.start[0], edge.way[0]);
        let mut down = Crossings::new(cell[1], last[1], edge.start[1], edge.way[1]);
        let mut share = 0.0;
        for _ in 0..crossed {
            let here = cell;
            let downwards = down.next < across.next;
            let until = smaller(if downwards { down.next } else { across.next }, 1.0);
            if downwards {
                down.cross(&mut cell[1], last[1]);
            } else {
                across.cross(&mut cell[0], last[0]);
            }
            if until > share {
                list[at] = self.part(edge, [share, until], here);
                at += 1;
                share = until;
            }
        }
        if share < 1.0 {
            list[at] = self.part(edge, [share, 1.0], last);
            at += 1;
        }
        at
    }

    /// The part of an edge between two shares of it, which lies in one pixel of the frame.
    #[inline(always)]
    fn part(&self, edge: &Edge, share: [f64; 2], cell: [i32; 2]) -> Part {
        let [x, _] = edge.at(0.5 * (share[0] + share[1]));
        let right = f64::from(cell[0] + 1) - x;
        let pixel = self.field.pixel(cell[0] as usize, cell[1] as usize);
        edge.part(share, (pixel, right))
    }

    /// An edge that leaves the frame: left of it it covers whole pixels; right of it, above and below nothing that is
    /// seen.
    #[cold]
    #[inline(never)]
    fn draw_beyond(self, edge: Edge, out: &mut Vec<Part>, written: usize) -> usize {
        out.truncate(written);
        let [columns, rows] = self.size;
        let mut share = 0.0;
        while share < 1.0 {
            // The next border on any axis; never the one where this part begins.
            let mut until = 1.0;
            for (k, at) in edge.at(share + 1e-9).into_iter().enumerate() {
                let border = if edge.way[k] > 0.0 { at.floor() + 1.0 } else { at.ceil() - 1.0 };
                let there = (border - edge.start[k]) / edge.way[k];
                if there > share && there < until {
                    until = there;
                }
            }
            let [x, y] = edge.at(0.5 * (share + until));
            if y >= 0.0 && y < rows {
                let column = smaller(larger(x, 0.0), columns - 1.0) as i32;
                if x < 0.0 {
                    out.push(
                        edge.part([share, until], (self.field.row_at(column as usize, y as usize), 1.0)),
                    );
                } else if x < columns {
                    out.push(self.part(&edge, [share, until], [column, y as i32]));
                }
            }
            share = until;
        }
        out.len()
    }
}
