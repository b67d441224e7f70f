//! What a trial changes of a field, so that all can be again as it was, to the last bit.

use super::{AREA, Field, covered, tile};

/// The tiles that have been covered since a trial began, as they were before it.
#[derive(Debug, Default)]
pub(super) struct Journal {
    is_open: bool,
    slots: Vec<u32>,
    tiles: Vec<[[f32; 4]; AREA / 4]>,
    /// Whether each tile of the field is among them.
    noted: Vec<bool>,
}

impl Journal {
    /// A tile is about to be covered.
    #[inline(always)]
    pub(super) fn note(&mut self, slot: usize, pixels: &[[f32; 4]]) {
        if !self.is_open || self.noted[slot] {
            return;
        }
        self.noted[slot] = true;
        self.slots.push(slot as u32);
        let mut kept = [[0.0; 4]; AREA / 4];
        kept.copy_from_slice(pixels);
        self.tiles.push(kept);
    }

    fn close(&mut self) {
        self.is_open = false;
        self.slots.drain(..).for_each(|slot| self.noted[slot as usize] = false);
        self.tiles.clear();
    }
}

impl Field {
    /// What is covered from now on is a trial: it ends with `keep` or with `revert`.
    pub(in crate::trace::refinement) fn begin_trial(&mut self) {
        self.journal.noted.resize(self.tiles(), false);
        self.journal.is_open = true;
    }

    /// The trial was good.
    pub(in crate::trace::refinement) fn keep(&mut self) {
        self.journal.close();
    }

    /// All is as it was before the trial. Taking away what was put there would leave the rounding of sums.
    ///
    /// # Cost
    ///
    /// O(tiles that the trial covered).
    pub(in crate::trace::refinement) fn revert(&mut self) {
        let mut journal = core::mem::take(&mut self.journal);
        for (&slot, kept) in journal.slots.iter().zip(&mut journal.tiles) {
            tile(covered(&mut self.rest, &mut self.blur), slot as usize).swap_with_slice(kept);
            self.touch(slot as usize, kept);
        }
        self.settle();
        journal.close();
        self.journal = journal;
    }
}
