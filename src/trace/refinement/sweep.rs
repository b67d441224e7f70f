//! What parts that come and go change of the pixels that outlines cover, tile by tile.

use super::coverage::Part;
use super::field::{AREA, BEYOND, Change, Field, NONE, SIDE};
use crate::numerics::order::sort_in_place;

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
            if first.pixel >= BEYOND {
                self.stray(first.pixel - BEYOND, sign * first.dy);
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

    fn stray(&mut self, row: u32, height: f32) {
        let place = row / SIDE as u32;
        self.strays.push(Stray { place, row: row as usize % SIDE, height });
        self.touched.push(place);
    }

    /// Covers what has been noted, tile by tile from the left: every tile goes on with the heights that those before it
    /// leave.
    pub(super) fn cover(&mut self, field: &mut Field) -> f64 {
        self.cover_tiles(field, usize::MAX, true).0
    }

    /// The same for as many rows of tiles as have `most` of what has been noted, without taking note of what takes it
    /// back: all that an outline encloses is as much as the picture. Whether these rows were the last.
    pub(super) fn cover_rows(&mut self, field: &mut Field, most: usize) -> bool {
        let last = self.cover_tiles(field, most, false).1;
        if last {
            self.slots.clear();
            self.covered = false;
        }
        last
    }

    /// Covers rows of tiles, which can be taken back or not; how much the sum of squares grows, and whether these rows
    /// were the last.
    fn cover_tiles(&mut self, field: &mut Field, most: usize, revocable: bool) -> (f64, bool) {
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
                    growth += self.cover_tile(field, between, &mut running, revocable);
                }
            }
            before = place;
            for stray in self.strays.iter().filter(|stray| stray.place == place) {
                running[stray.row] += stray.height;
            }
            growth += self.cover_tile(field, place, &mut running, revocable);
        }
        touched.clear();
        self.touched = touched;
        self.strays.clear();
        self.covered = true;
        (growth, true)
    }

    /// Covers the tile at a place, if there is one.
    fn cover_tile(
        &mut self,
        field: &mut Field,
        place: u32,
        running: &mut [f32; SIDE],
        revocable: bool,
    ) -> f64 {
        let Some(slot) = field.slot(place) else { return 0.0 };
        let mut at = core::mem::replace(&mut self.known[slot], NONE);
        let passed = at == NONE;
        if passed {
            at = self.open(slot as u32);
        }
        let growth =
            self.changes.get_mut(at as usize).map_or(0.0, |change| field.cover(slot, change, running));
        if passed && !revocable {
            self.slots.pop();
        }
        growth
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
    use super::{Part, Sweep};
    use crate::error::Result;
    use crate::numerics::{Point, Vector};
    use crate::trace::Gray;
    use crate::trace::outline::cubic::Cubic;
    use crate::trace::refinement::coverage::parts;
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
        assert!(!slow.cover_rows(&mut other, 1), "the wave is in more than one row of tiles");
        while !slow.cover_rows(&mut other, 1) {}
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
