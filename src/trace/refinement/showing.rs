//! How outlines come into the field and leave it, a bit at a time: one of a long way would keep a trace from being
//! stopped.

use super::Refinement;
use super::blocks::BLOCK;
use crate::trace::outline::Outline;

/// Tiles that an outline is put into in about one step.
const TILES: usize = 4096;

impl Refinement {
    /// Begins to put another outline in the place of this one.
    pub(super) fn exchange(&mut self, outline: Outline) {
        self.place.coming = Some(outline);
        self.place.arriving = true;
    }

    /// Takes the next pieces of an outline away that another takes the place of; whether they have all gone.
    pub(super) fn leave_on(&mut self) -> bool {
        let shape = &mut self.shapes[self.place.at];
        let Some(outline) = self.place.coming.take() else { return true };
        let end = (self.place.block + 2 * BLOCK).min(shape.parts.len());
        let going = &shape.parts[self.place.block..end];
        going.iter().for_each(|parts| self.refiner.sweep.note(&self.field, parts, -1.0));
        if end < shape.parts.len() {
            (self.place.coming, self.place.block) = (Some(outline), end);
            return false;
        }
        self.place.block = 0;
        shape.turn_into(outline);
        true
    }

    /// Puts the outline into the field: the next pieces of a long one, and when all have been noted the next rows;
    /// whether these were the last.
    pub(super) fn show_on(&mut self) -> bool {
        let shape = &mut self.shapes[self.place.at];
        let count = shape.outline.len();
        let end = (self.place.block + 2 * BLOCK).min(count);
        self.refiner.show(&self.field, shape, self.place.block..end);
        self.place.block = end;
        let done = end == count && self.refiner.sweep.cover_rows(&mut self.field, TILES);
        if done {
            self.place.block = 0;
        }
        done
    }
}
