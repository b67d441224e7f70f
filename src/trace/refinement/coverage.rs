//! Which part of every pixel near an outline it covers, exactly, and how that changes with its control points.

use super::field::{AREA, Change, Field, NONE, SIDE};
use crate::numerics::order::sort_in_place;
use crate::numerics::plane::{larger, norm, smaller, taxi};
use crate::trace::outline::cubic::Cubic;

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
/// Room for more parts than this is made when they come.
const MOST_WAYS: f64 = 4096.0;

/// Parts a piece at the borders of the pixels, rows and columns alike.
pub(super) fn parts(cubic: &Cubic, field: &Field, out: &mut Vec<Part>) {
    out.clear();
    let middle = cubic.end - cubic.start - cubic.leaving - cubic.arriving;
    let (second, third) = ((middle - cubic.leaving) * 3.0, cubic.arriving - middle * 2.0 + cubic.leaving);
    let bend = larger(norm(middle - cubic.leaving), norm(cubic.arriving - middle));
    let steps = (bend * FINENESS).sqrt().ceil().clamp(1.0, 4000.0);
    // Every chord is one part, and every border that is crossed begins another.
    let ways = taxi(cubic.leaving) + taxi(middle) + taxi(cubic.arriving);
    out.reserve((steps + smaller(ways, MOST_WAYS)) as usize + 2);
    // A chord lies inside its arc, by h²|p″|/12 in the mean: its ends are moved outwards by as much, but for those of the piece.
    let outwards = -1.0 / (6.0 * steps * steps);
    let first = cubic.leaving * 3.0 + third * (3.0 * outwards);
    let base = cubic.start + second * outwards;
    let frame = SIDE as f64;
    let place = |x: f64, y: f64| [x + frame, y + frame];
    let (length, count) = (1.0 / steps, steps as usize);
    let mut pen = Pen::new(field, place(cubic.start.x, cubic.start.y), out);
    for step in 1..=count {
        let t = step as f64 * length;
        let to = if step < count {
            let p = base + (first + (second + third * t) * t) * t;
            place(p.x, p.y)
        } else {
            place(cubic.end.x, cubic.end.y)
        };
        pen.draw_to(to, [t - length, length]);
    }
}

/// What writes parts down.
struct Pen<'a> {
    field: &'a Field,
    /// Columns and rows of the field.
    size: [f64; 2],
    /// Where it is, in the field's frame, and in which pixel if that is one of the field's.
    at: [f64; 2],
    cell: Option<[i32; 2]>,
    out: &'a mut Vec<Part>,
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
}

/// The borders that an edge crosses on one axis.
#[derive(Clone, Copy)]
struct Crossings {
    /// The pixel that the edge is in, the last one, and the way from one to the next.
    at: i32,
    last: i32,
    ahead: i32,
    /// The next border as a share of the edge, beyond its end if there is none, and how far it is from one to the next.
    next: f64,
    step: f64,
}

impl Crossings {
    #[inline(always)]
    fn new(at: i32, last: i32, from: f64, way: f64) -> Self {
        if at == last {
            return Self { at, last, ahead: 0, next: 2.0, step: 0.0 };
        }
        let (inverse, up) = (1.0 / way, last > at);
        let next = (f64::from(at + i32::from(up)) - from) * inverse;
        Self { at, last, ahead: if up { 1 } else { -1 }, next, step: inverse.abs() }
    }

    #[inline(always)]
    fn cross(&mut self) {
        self.at += self.ahead;
        self.next = if self.at == self.last { 2.0 } else { self.next + self.step };
    }
}

impl<'a> Pen<'a> {
    fn new(field: &'a Field, at: [f64; 2], out: &'a mut Vec<Part>) -> Self {
        let (columns, rows) = field.size();
        let mut pen = Self { field, size: [columns as f64, rows as f64], at, cell: None, out };
        pen.cell = pen.cell_of(at);
        pen
    }

    #[inline(always)]
    fn cell_of(&self, at: [f64; 2]) -> Option<[i32; 2]> {
        let inside = at[0] >= 0.0 && at[1] >= 0.0 && at[0] < self.size[0] && at[1] < self.size[1];
        inside.then(|| at.map(|v| v as i32))
    }

    /// A straight edge from where the pen is; `t` is its first parameter and the length of its range.
    #[inline(always)]
    fn draw_to(&mut self, to: [f64; 2], t: [f64; 2]) {
        let from = self.at;
        let edge = Edge { start: from, way: [to[0] - from[0], to[1] - from[1]], t };
        let cells = (self.cell, self.cell_of(to));
        (self.at, self.cell) = (to, cells.1);
        let (Some(cell), Some(last)) = cells else {
            return self.edge_beyond(&edge);
        };
        let mut across = Crossings::new(cell[0], last[0], from[0], edge.way[0]);
        let mut down = Crossings::new(cell[1], last[1], from[1], edge.way[1]);
        let mut share = 0.0;
        while across.at != last[0] || down.at != last[1] {
            let cell = [across.at, down.at];
            let downwards = down.next < across.next;
            let until = smaller(if downwards { down.next } else { across.next }, 1.0);
            if downwards {
                down.cross()
            } else {
                across.cross()
            }
            if until > share {
                self.part(&edge, [share, until], cell);
                share = until;
            }
        }
        if share < 1.0 {
            self.part(&edge, [share, 1.0], last);
        }
    }

    /// The part of an edge between two shares of it, which lies in one pixel of the frame.
    #[inline(always)]
    fn part(&mut self, edge: &Edge, share: [f64; 2], cell: [i32; 2]) {
        let [x, _] = edge.at(0.5 * (share[0] + share[1]));
        let right = f64::from(cell[0] + 1) - x;
        let pixel = self.field.pixel(cell[0] as usize, cell[1] as usize);
        self.write(edge, share, cell, (pixel, right));
    }

    #[inline(always)]
    fn write(&mut self, edge: &Edge, share: [f64; 2], cell: [i32; 2], (pixel, right): (u32, f64)) {
        let (middle, extent) = (0.5 * (share[0] + share[1]), share[1] - share[0]);
        self.out.push(Part {
            pixel,
            row: cell[1] as u16,
            column: cell[0] as u16,
            t: (edge.t[0] + edge.t[1] * middle) as f32,
            dx: (edge.way[0] * extent) as f32,
            dy: (edge.way[1] * extent) as f32,
            right: right as f32,
        });
    }

    /// An edge that leaves the frame: left of it it covers whole pixels; right of it, above and below nothing that is seen.
    #[cold]
    #[inline(never)]
    fn edge_beyond(&mut self, edge: &Edge) {
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
                let cell = [column, y as i32];
                if x < 0.0 {
                    self.write(edge, [share, until], cell, (NONE, 1.0));
                } else if x < columns {
                    self.part(edge, [share, until], cell);
                }
            }
            share = until;
        }
    }
}

/// Changes of height of an edge where no pixel is: they count for the pixels to the right.
#[derive(Clone, Copy, Debug)]
struct Stray {
    place: u32,
    row: usize,
    height: f32,
}

/// What parts change, tile by tile, until it is settled.
#[derive(Debug, Default)]
pub(super) struct Sweep {
    changes: Vec<Change>,
    /// The change of each tile of the field, or none.
    known: Vec<u32>,
    /// Places of tiles with a change or a stray.
    touched: Vec<u32>,
    strays: Vec<Stray>,
}

impl Sweep {
    /// Notes that parts come, with the sign 1, or go, with −1.
    pub(super) fn note(&mut self, field: &Field, parts: &[Part], sign: f32) {
        self.known.resize(field.tiles(), NONE);
        let mut rest = parts;
        while let Some(first) = rest.first() {
            // Parts of one tile mostly follow each other.
            let slot = first.pixel / AREA as u32;
            let count = rest.iter().position(|part| part.pixel / AREA as u32 != slot).unwrap_or(rest.len());
            let (run, others) = rest.split_at(count);
            rest = others;
            if first.pixel == NONE {
                run.iter().for_each(|part| self.stray(field, part, sign * part.dy));
                continue;
            }
            let at = self.open(field, slot as usize);
            if let Some(Change { areas, heights }) = self.changes.get_mut(at) {
                for part in run {
                    let (within, height) = (part.pixel as usize % AREA, sign * part.dy);
                    areas[within] += height * part.right;
                    heights[within] += height;
                }
            }
        }
    }

    /// The change of a tile; a new one, if it has none yet.
    fn open(&mut self, field: &Field, slot: usize) -> usize {
        if self.known[slot] == NONE {
            self.known[slot] = self.changes.len() as u32;
            self.changes.push(Change::default());
            self.touched.push(field.place(slot));
        }
        self.known[slot] as usize
    }

    fn stray(&mut self, field: &Field, part: &Part, height: f32) {
        let place = field.place_at(usize::from(part.column), usize::from(part.row));
        self.strays.push(Stray { place, row: usize::from(part.row) % SIDE, height });
        self.touched.push(place);
    }

    /// Covers what has been noted, tile by tile from the left: every tile goes on with the heights that those before it leave.
    pub(super) fn cover(&mut self, field: &mut Field) -> f64 {
        // Heights cancel to rounding behind what has changed.
        const NOTHING: f32 = 1e-5;
        sort_in_place(&mut self.touched);
        self.touched.dedup();
        let unchanged = Change::default();
        let (mut running, mut growth, mut before) = ([0.0_f32; SIDE], 0.0, 0);
        for &place in &self.touched {
            if field.tile_row(place) != field.tile_row(before) {
                running = [0.0; SIDE];
            } else if running.iter().any(|height| height.abs() > NOTHING) {
                for between in before + 1..place {
                    if let Some(slot) = field.slot(between) {
                        growth += field.cover(slot, &unchanged, &mut running);
                    }
                }
            }
            before = place;
            for stray in self.strays.iter().filter(|stray| stray.place == place) {
                running[stray.row] += stray.height;
            }
            if let Some(slot) = field.slot(place) {
                let at = core::mem::replace(&mut self.known[slot], NONE);
                let change = self.changes.get(at as usize).unwrap_or(&unchanged);
                growth += field.cover(slot, change, &mut running);
            }
        }
        self.changes.clear();
        self.touched.clear();
        self.strays.clear();
        growth
    }
}
