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
    let middle = cubic.end - cubic.start - cubic.leaving - cubic.arriving;
    let (second, third) = ((middle - cubic.leaving) * 3.0, cubic.arriving - middle * 2.0 + cubic.leaving);
    let bend = larger(norm(middle - cubic.leaving), norm(cubic.arriving - middle));
    let steps = (bend * FINENESS).sqrt().ceil().clamp(1.0, 4000.0);
    // Every chord is one part, and every border that is crossed begins another.
    let ways = taxi(cubic.leaving) + taxi(middle) + taxi(cubic.arriving);
    make_room(out, (steps + smaller(ways, MOST_WAYS)) as usize + 2);
    // A chord lies inside its arc, by h²|p″|/12 in the mean: its ends are moved outwards by as much, but for those of the piece.
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

/// Parts that are written over.
fn make_room(out: &mut Vec<Part>, count: usize) {
    const BLANK: Part = Part { pixel: NONE, row: 0, column: 0, t: 0.0, dx: 0.0, dy: 0.0, right: 0.0 };
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
    fn part(&self, share: [f64; 2], cell: [i32; 2], (pixel, right): (u32, f64)) -> Part {
        let (middle, extent) = (0.5 * (share[0] + share[1]), share[1] - share[0]);
        Part {
            pixel,
            row: cell[1] as u16,
            column: cell[0] as u16,
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

/// Where edges are drawn: the pixels of a field, from its corner. What it does is a part of one loop, and it is never in memory.
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

    /// The parts of an edge from one pixel to another, written behind those that are there already; how many there are then.
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
        edge.part(share, cell, (pixel, right))
    }

    /// An edge that leaves the frame: left of it it covers whole pixels; right of it, above and below nothing that is seen.
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
                let cell = [column, y as i32];
                if x < 0.0 {
                    out.push(edge.part([share, until], cell, (NONE, 1.0)));
                } else if x < columns {
                    out.push(self.part(&edge, [share, until], cell));
                }
            }
            share = until;
        }
        out.len()
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
    /// Changes of tiles, of which the first `slots` tell the tiles; the others are in nobody's use.
    changes: Vec<Change>,
    slots: Vec<u32>,
    /// Whether they have been covered already.
    covered: bool,
    /// The change of each tile of the field, or none.
    known: Vec<u32>,
    /// Places of tiles with a change or a stray.
    touched: Vec<u32>,
    strays: Vec<Stray>,
}

impl Sweep {
    /// Notes that parts come, with the sign 1, or go, with −1.
    pub(super) fn note(&mut self, field: &Field, parts: &[Part], sign: f32) {
        if self.covered {
            self.slots.clear();
            self.covered = false;
        }
        if self.known.len() < field.tiles() {
            self.known.resize(field.tiles(), NONE);
        }
        let mut rest = parts;
        while let Some(first) = rest.first() {
            let slot = first.pixel / AREA as u32;
            if first.pixel == NONE {
                self.stray(field, first, sign * first.dy);
                rest = &rest[1..];
                continue;
            }
            let mut at = self.known[slot as usize];
            if at == NONE {
                at = self.open(slot);
                self.known[slot as usize] = at;
                self.touched.push(field.place(slot as usize));
            }
            let Some(change) = self.changes.get_mut(at as usize) else { return };
            // Parts of one tile mostly follow each other.
            while let Some((part, others)) = rest.split_first()
                && part.pixel / AREA as u32 == slot
            {
                let height = sign * part.dy;
                change.add(part.pixel as usize, height * part.right, height);
                rest = others;
            }
        }
    }

    /// A change for a tile, which is nothing yet.
    fn open(&mut self, slot: u32) -> u32 {
        if self.slots.len() == self.changes.len() {
            if self.changes.len() == self.changes.capacity() {
                // Changes are large: doubling would take more than it saves.
                self.changes.reserve_exact(1 + self.changes.len() / 4);
            }
            self.changes.push(Change::default());
        }
        self.slots.push(slot);
        self.slots.len() as u32 - 1
    }

    fn stray(&mut self, field: &Field, part: &Part, height: f32) {
        let place = field.place_at(usize::from(part.column), usize::from(part.row));
        self.strays.push(Stray { place, row: usize::from(part.row) % SIDE, height });
        self.touched.push(place);
    }

    /// Covers what has been noted, tile by tile from the left: every tile goes on with the heights that those before it leave.
    pub(super) fn cover(&mut self, field: &mut Field) -> f64 {
        self.cover_rows(field, usize::MAX).0
    }

    /// The same for as many rows of tiles as have `most` of what has been noted; how much the sum of squares grows, and whether these
    /// rows were the last.
    pub(super) fn cover_rows(&mut self, field: &mut Field, most: usize) -> (f64, bool) {
        // Heights cancel to rounding behind what has changed.
        const NOTHING: f32 = 1e-5;
        let mut touched = core::mem::take(&mut self.touched);
        sort_in_place(&mut touched);
        touched.dedup();
        let (mut running, mut growth) = ([0.0_f32; SIDE], 0.0);
        let (mut before, mut end) = (0, 0);
        for (done, &place) in touched.iter().enumerate() {
            if place >= end {
                if done >= most {
                    self.touched = touched.split_off(done);
                    return (growth, false);
                }
                end = field.row_end(place);
                running = [0.0; SIDE];
            } else if running.iter().any(|height| height.abs() > NOTHING) {
                for between in before + 1..place {
                    growth += self.cover_tile(field, between, &mut running);
                }
            }
            before = place;
            for stray in self.strays.iter().filter(|stray| stray.place == place) {
                running[stray.row] += stray.height;
            }
            growth += self.cover_tile(field, place, &mut running);
        }
        touched.clear();
        self.touched = touched;
        self.strays.clear();
        self.covered = true;
        (growth, true)
    }

    /// Covers the tile at a place, if there is one.
    fn cover_tile(&mut self, field: &mut Field, place: u32, running: &mut [f32; SIDE]) -> f64 {
        let Some(slot) = field.slot(place) else { return 0.0 };
        let mut at = core::mem::replace(&mut self.known[slot], NONE);
        if at == NONE {
            at = self.open(slot as u32);
        }
        self.changes.get_mut(at as usize).map_or(0.0, |change| field.cover(slot, change, running))
    }

    /// All tiles are again what they were before the last time that something was covered.
    pub(super) fn take_back(&mut self, field: &mut Field) {
        if core::mem::take(&mut self.covered) {
            for (change, slot) in self.changes.iter().zip(self.slots.drain(..)) {
                field.take_back(slot as usize, change);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Part, Sweep, parts};
    use crate::error::Result;
    use crate::numerics::{Point, Vector};
    use crate::trace::Gray;
    use crate::trace::outline::cubic::Cubic;
    use crate::trace::refinement::field::{Field, Shading};
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// A wave across white paper, leaving it on the left.
    fn wave() -> Cubic {
        Cubic {
            start: Point::new(-12.0, 20.3),
            leaving: Vector::new(20.0, -25.0),
            arriving: Vector::new(15.0, -30.0),
            end: Point::new(37.4, 22.1),
        }
    }

    /// A field with a wave's tiles, and the wave's parts.
    fn waved() -> Result<(Field, Vec<Part>)> {
        let gray = Gray::from_bytes(40, 40, &[255; 1600])?;
        let shading = Shading { ink: 0.0, paper: 65_280.0, level: 32_640.0, inverted: false };
        let wave = wave();
        let places: Vec<Point> = (0..=50).map(|k| wave.point(f64::from(k) / 50.0)).collect();
        let mut field = Field::new(&gray, &shading, [places.as_slice()].into_iter(), 6.0)?;
        field.rest.iter_mut().enumerate().for_each(|(i, rest)| *rest = 1.0 / (i + 3) as f32);
        let mut list = Vec::new();
        parts(&wave, &field, &mut list);
        Ok((field, list))
    }

    #[test]
    fn what_is_covered_row_by_row_is_what_is_covered_at_once() -> Result<()> {
        let ((mut field, list), (mut other, _)) = (waved()?, waved()?);
        let [mut sweep, mut slow] = [Sweep::default(), Sweep::default()];
        sweep.note(&field, &list, 1.0);
        slow.note(&other, &list, 1.0);
        sweep.cover(&mut field);
        assert!(!slow.cover_rows(&mut other, 1).1, "the wave is in more than one row of tiles");
        while !slow.cover_rows(&mut other, 1).1 {}
        assert_eq!(field.rest, other.rest);
        Ok(())
    }

    #[test]
    fn what_is_taken_back_leaves_every_bit_as_it_was() -> Result<()> {
        let (mut field, list) = waved()?;
        let mut sweep = Sweep::default();
        let before = field.rest.clone();
        for _ in 0..2 {
            sweep.note(&field, &list, 1.0);
            sweep.cover(&mut field);
            assert_ne!(field.rest, before, "nothing was covered");
            sweep.take_back(&mut field);
            assert_eq!(field.rest, before);
        }
        Ok(())
    }

    #[test]
    fn a_trial_that_is_given_up_leaves_every_bit_as_it_was() -> Result<()> {
        let (mut field, list) = waved()?;
        let mut sweep = Sweep::default();
        sweep.note(&field, &list, 1.0);
        sweep.cover(&mut field);
        let before = field.rest.clone();
        field.begin_trial();
        for sign in [-1.0, 0.3, 0.3] {
            sweep.note(&field, &list, sign);
            sweep.cover(&mut field);
        }
        assert_ne!(field.rest, before, "nothing was covered");
        field.revert();
        assert_eq!(field.rest, before);
        // What was kept is not given up with the next.
        field.begin_trial();
        sweep.note(&field, &list, -1.0);
        sweep.cover(&mut field);
        field.keep();
        let kept = field.rest.clone();
        assert_ne!(kept, before, "nothing was covered");
        field.begin_trial();
        field.revert();
        assert_eq!(field.rest, kept);
        Ok(())
    }
}
